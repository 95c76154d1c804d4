#!/usr/bin/env python3
"""Keeps the tuned numbers of the modules in one place: modules/<module>/tuning.hpp.

It checks, with exit status 1 and one line per finding: every number and every rule has its row in
tests/bench/tuning.csv; there are no more numbers than counted below; and no other file of these modules has a constant
that the lists below do not name.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

# How many tuned numbers a module has. These counts may only fall.
MOST = {"multigrid": 39, "judgement": 23, "steady": 95, "newton": 10, "transient": 25, "heat": 19}

# Constants that are not tuned, per module: what each is. These lists may only become shorter.
NOT_TUNED = {
    "multigrid": {
        "step": "difference quotient", "faster": "difference quotient",
        "rounding_residual": "rounding", "rounding": "rounding", "share_of_planned": "display", "block": "size of blocks",
        "margin": "size of blocks",
    },
    "judgement": {
        "reach": "definition of the fitted minimum", "most_steps": "definition of the fitted minimum",
        "longest_step": "definition of the fitted minimum", "at_rest": "rounding",
        "contact_reach": "definition of the mass flow", "of_rim": "definition of the spike's pressure",
        "rounding": "rounding", "rounding_of_content": "rounding", "by_powers": "differences",
        "fewest_first_cycles": "definition of a settled start",
    },
    "steady": {
        "step_of_size": "step of a search", "too_much": "limit of an input", "step": "difference quotient",
        "grubin": "published formula", "parts": "quadrature", "smallest_coarsest": "limit of an input",
        "fewest_chosen_cells": "cost", "most_chosen_cells": "cost", "most_cells_of_line": "cost",
        "most_nodes_of_ellipse": "cost", "in_proportion": "no better derivative", "fewest_cells": "symmetric half",
        "tolerance_at_rounding": "rounding", "tolerance_of_rounding": "rounding",
        "levels_of_an_estimate": "grids of an estimate", "restart": "a start", "faster": "difference quotient",
        "share_of_line": "fit of the expected film", "share_of_flooded": "display", "usual": "a start",
        "finer": "a start", "finer_coarsest": "a start", "damped": "a start",
        "of_line": "a start", "most_relaxations": "a start", "of_heavy_line": "a start",
        "of_ellipse": "a start", "hardly_an_error": "definition of a warning",
        "unresolved_film": "definition of a warning", "cut_off_pressure": "definition of a warning",
        "cells_to_meniscus": "definition of a warning", "starvation_above_one": "definition of a warning",
        "roller_end": "definition of a warning", "most_nodes_of_newton": "memory",
        "most_nodes_of_second_newton": "time", "most_steps": "time", "share_of_apart": "display",
        "share_of_oil": "a start", "directions": "quadrature", "steps": "quadrature",
    },
    "newton": {
        "krylov_vectors": "memory", "restarts": "memory", "leaf": "size of blocks", "most_dense": "time",
    },
    "transient": {
        "a_little": "difference quotient", "not_tested": "IDA needs weights above zero", "closed": "rounding",
        "samples": "check of an input", "unlimited": "IDA's", "tolerance": "IDA's", "rounding_of_time": "rounding", "rounding": "rounding",
        "most_periods": "memory", "exact_of_line": "exact", "rigid": "definition", "widest_range": "check of an input",
        "parts_of_a_ramp": "definition of a ramp", "time_of_a_jump": "definition of a jump",
        "steep": "definition of a jump", "parts_of_a_period": "definition of a wave", "short_ramp": "definition of a ramp",
        "window": "definition of rest", "halvings": "bisection",
    },
    "heat": {
        "usual": "display", "share_of_isothermal": "display", "share_of_starved": "display", "grids_below": "grids of an estimate",
    },
}

# Modules whose rows begin with their name. A row has the name of its number unless [bench: ...] says otherwise.
WITH_PREFIX = ("newton", "transient", "heat")

NUMBER = re.compile(r"^  core::(Share|Reduction|Growth|Positive|Count) (\w+) = ([^;]+);\s*///< (.*)$")
BENCH = re.compile(r"\s*\[bench: (\w+)\]")
RULE = re.compile(r'^    \{"(\w+)",', re.M)
CONSTANT = re.compile(
    r"^\s*(?:inline |static )*constexpr (?:double|float|int|long|unsigned|std::size_t|Start)(?:<[^>]*>)? (.*)$")


def numbers_of(header):
    """The numbers of a tuning.hpp: kind, name, default, meaning, row."""
    found = []
    for line in re.sub(r" =\n\s+", " = ", header.read_text()).splitlines():  # a long line is wrapped before its value
        if match := NUMBER.match(line):
            found.append(list(match.groups()))
    module = header.parent.name
    result = []
    for kind, name, default, comment in found:
        row = BENCH.search(comment)
        own = f"{module}_{name}" if module in WITH_PREFIX else name
        result.append((kind, name, default, BENCH.sub("", comment), row.group(1) if row else own))
    return result


def rows_of_bench():
    """The rows of tuning.csv: name and place."""
    lines = (ROOT / "tests/bench/tuning.csv").read_text().splitlines()
    return {cells[0]: cells[1] for cells in (line.split(",") for line in lines if not line.startswith("#"))}


def constants_in(folder):
    """Names of the numbers that are constants of the code in this folder, each with its place."""
    for path in sorted(folder.glob("*.[ch]pp")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = CONSTANT.match(line)
            if not match or path.name.startswith("tuning.") or "numeric_limits" in line:
                continue
            yield re.match(r"\w+", match.group(1)).group(0), f"{path.relative_to(ROOT)}:{number}"
            for further in re.findall(r"[\w)}], (\w+) = ", match.group(1).split("//")[0]):
                yield further, f"{path.relative_to(ROOT)}:{number}"


def findings(header):
    module = header.parent.name
    numbers = numbers_of(header)
    place = str(header.relative_to(ROOT / "modules"))
    declared = len(re.findall(r"^  core::\w+ \w+ =", header.read_text(), re.M))
    if declared != len(numbers):
        yield f"{place}: {declared - len(numbers)} numbers cannot be read: write kind, name, value and meaning on a line"
    rows = rows_of_bench()
    for _, name, _, _, row in numbers:
        if rows.get(row) != place:
            yield f"{place}: {name}: tests/bench/tuning.csv has no row {row} of this file"
    if len(numbers) > MOST[module]:
        yield f"{place}: {len(numbers)} tuned numbers, {MOST[module]} are allowed: remove one"
    allowed = NOT_TUNED[module]
    found = list(constants_in(header.parent))
    for name, where in found:
        if name not in allowed:
            yield f"{where}: {name} is a constant: a tuned number belongs to {place}"
    for path in sorted(header.parent.glob("*.cpp")):  # tables of rules whose names are rows
        for name in RULE.findall(path.read_text()) if "The names are rows of" in path.read_text() else []:
            if name not in rows:
                yield f"{path.relative_to(ROOT)}: rule {name}: tests/bench/tuning.csv has no such row"
    for name in allowed.keys() - {name for name, _ in found}:
        yield f"tests/structure/tuning.py: {name} of {module} is gone: remove it from NOT_TUNED"


def main():
    headers = sorted(ROOT.glob("modules/**/tuning.hpp"))
    headers = [header for header in headers if header.parent.name != "core"]
    found = [text for header in headers for text in findings(header)]
    for text in found:
        print(text)
    print(f"{sum(len(numbers_of(header)) for header in headers)} tuned numbers in {len(headers)} modules, "
          f"{sum(len(names) for names in NOT_TUNED.values())} other constants; {len(found)} findings")
    return 1 if found else 0


sys.exit(main())
