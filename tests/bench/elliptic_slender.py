"""Slender ellipses: cells, cost, cycles and bars of R_x/R_y = 0.005 to 200, and of twice the cells.

python3 tests/bench/elliptic_slender.py EHL FOLDER [ANGLE [RATIO ...]]      solves what FOLDER does not hold, one line each
python3 tests/bench/elliptic_slender.py EHL FOLDER bars RATIO,M,L,ANGLE ... the bars against a grid of twice the cells
python3 tests/bench/elliptic_slender.py EHL FOLDER drawn SEED N             likewise of N contacts drawn at random
"""

import json
import math
import pathlib
import random
import resource
import subprocess
import sys

RATIOS = (0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 1, 5, 20, 50, 100, 200)
LOADS = (20, 100, 1000)
DECK = """[contact]
M = {M}
L = {L}
{shape}
[lubricant]
viscosity = roelands
alpha = 2.2e-8
z = 0.68
density = dowson-higginson
"""
SECONDS = 900


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def solved(program, folder, case, *settings):
    """The JSON of a contact (ratio, M, L, angle), solved or read; what the program said where it gave none."""
    ratio, M, L, angle = case
    name = "_".join(f"{value:g}" for value in case)
    deck = folder / f"{name}.ini"
    shape = "" if ratio == 1 else f"radius_ratio = {ratio}\n[motion]\nangle = {angle}"
    deck.write_text(DECK.format(M=M, L=L, shape=shape))
    result = folder / ("_".join([name, *settings]) + ".json")
    if not result.exists():
        command = [program, "run", deck, "--json", "--quiet", "--overwrite", "--threads", "1"]
        command += ["--output", folder / "out.h5"]
        for setting in settings:
            command += ["--set", setting]
        before = processor_seconds()
        try:
            run = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS)
            found = json.loads(run.stdout) if run.stdout else {"said": " ".join(run.stderr.split())}
        except subprocess.TimeoutExpired:
            found = {"said": f"more than {SECONDS} s"}
        found["cpu"] = processor_seconds() - before
        result.write_text(json.dumps(found))
    return json.loads(result.read_text())


def percent(error):
    return "" if error is None else f"{100 * error:.2g}"


def row(program, folder, case):
    run = solved(program, folder, case)
    head = ",".join(f"{value:g}" for value in case)
    if not run.get("levels"):
        return f"{head},,,,,,,,{(run.get('said') or run['failed_check']).replace(',', ';')}"
    level = run["levels"][-1]
    tolerance = "1e-8" if level["nx"] * level["ny"] < 2e6 else "1e-6"
    cycled = solved(program, folder, case, f"multigrid.tolerance={tolerance}")
    left, cycles = cycled.get("cycle_factor"), (cycled.get("levels") or [{}])[-1].get("cycles")
    words = [] if run["converged"] else ["not converged: " + run["failed_check"].replace(",", ";")]
    if cycled.get("said") or not cycled.get("converged"):
        words.append(f"to {tolerance}: " + (cycled.get("said") or cycled["failed_check"]).replace(",", ";"))
    if run["method"] != "full multigrid" or len(run["attempts"]) > 1:
        words.append(run["method"].replace(",", ";") + f"; {len(run['attempts'])} attempts")
    if run["Hm_fitted"] < 0:
        words.append("negative film")
    return (f"{head},{level['nx']}x{level['ny']},{run.get('cpu', run['seconds']):.2g},{left or float('nan'):.2f},{cycles},"
            f"{run['Hc']:.5g};{percent(run['error_Hc'])},{run['Hm_fitted']:.5g};{percent(run['error_Hm_fitted'])},"
            f"{run['p_max_Pa'] / 1e9:.2g},{'; '.join(words)}")


def bars(program, folder, case, most_nodes):
    """Change of Hc and Hm to twice the cells both ways, over their bars; of more nodes but the cells."""
    run = solved(program, folder, case)
    level = run["levels"][-1]
    if level["nx"] * level["ny"] > most_nodes:
        return ",".join([*(f"{value:g}" for value in case), f"{level['nx']}x{level['ny']}", "", ""])
    finer = solved(program, folder, case, f"grid.cells={2 * level['nx']}")
    words = [",".join(f"{value:g}" for value in case), f"{level['nx']}x{level['ny']}"]
    for film, bar in (("Hc", "error_Hc"), ("Hm_fitted", "error_Hm_fitted")):
        change = abs(finer[film] / run[film] - 1)
        words.append(f"{percent(change)};{percent(run[bar])};{percent(finer[bar])};{change / run[bar]:.2g}")
    return ",".join(words)


def by_comma(case):
    return [float(value) for value in case.split(",")]


def drawn(seed, number):
    """Contacts (ratio, M, L, angle): ratio and M evenly by their logarithm, three of five at 0 degrees."""
    source = random.Random(seed)

    def between(low, high):
        return float(f"{math.exp(source.uniform(math.log(low), math.log(high))):.3g}")

    for _ in range(number):
        yield between(0.01, 100), between(10, 500), round(source.uniform(2, 18), 1), source.choice(
            [0, 0, 0, source.randint(1, 89), 45])


def main(program, folder, what="0", *rest):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    if what in ("bars", "drawn"):
        most_nodes = 2e6 if what == "drawn" else math.inf
        cases = drawn(int(rest[0]), int(rest[1])) if what == "drawn" else map(by_comma, rest)
        print("R_x/R_y,M,L,angle,cells,Hc: change;bar;finer bar;change/bar [%],Hm: change;bar;finer bar;change/bar [%]")
        for case in cases:
            print(bars(program, folder, case, most_nodes), flush=True)
        return
    print("R_x/R_y,M,L,angle,cells,seconds,convergence factor,cycles to 1e-8,Hc;bar [%],Hm;bar [%],p_max [GPa],explanation")
    for ratio in [float(value) for value in rest] or RATIOS:
        for M in LOADS:
            for L in (5, 10, 15):
                print(row(program, folder, [ratio, M, L, float(what)]), flush=True)


main(*sys.argv[1:])
