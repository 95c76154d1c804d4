"""The package `ehl` against the program: the same bits; errors, warnings, memory, Ctrl-C."""

import copy
import gc
import json
import os
import pathlib
import pickle
import resource
import runpy
import signal
import subprocess
import sys
import threading
import time

import ehl
import numpy as np
import pandas
import pytest

PROGRAM = os.environ["EHL_PROGRAM"]
INPUTS = pathlib.Path(os.environ["EHL_INPUTS"])
CIRCLE = {
    "contact": {"M": 20, "L": 5},
    "lubricant": {"alpha": 2.2e-8},
    "grid": {"cells": 128},
    "output": {"fields": ["P", "H"]},
}
BALL = INPUTS / "rigs" / "ball_on_glass.ini"


def program(*arguments, cwd):
    return subprocess.run([PROGRAM, *map(str, arguments)], cwd=cwd, capture_output=True, text=True, check=False)


def same(a, b):
    """JSON of two runs but for what a clock or the memory of the process says."""
    if isinstance(a, dict):
        other = {"seconds", "peak_memory_bytes", "parts"}
        assert a.keys() == b.keys()
        return all(same(a[key], b[key]) for key in a.keys() - other)
    if isinstance(a, list):
        return len(a) == len(b) and all(map(same, a, b))
    return a == b


def test_the_same_bits_as_the_program(tmp_path):
    deck = tmp_path / "circle.ini"
    deck.write_text("[contact]\nM = 20\nL = 5\n[lubricant]\nalpha = 2.2e-8\n[grid]\ncells = 128\n")
    ended = program("run", deck, "--json", "--output", "circle.h5", "--threads", 1, cwd=tmp_path)
    assert ended.returncode == 0
    result = ehl.run(deck, threads=1)
    assert same(result.json, json.loads(ended.stdout))
    kept = ehl.open(tmp_path / "circle.h5")
    assert kept.Hc == result.Hc and np.array_equal(kept.P, result.P) and np.array_equal(kept.H, result.H)
    assert kept.Hc.error == result.Hc.error and kept.Hc.unit == "a^2/R"
    result.save(tmp_path / "again.h5")
    assert np.array_equal(ehl.open(tmp_path / "again.h5").H, kept.H)
    assert np.array_equal(ehl.run(deck, threads=2).H, result.H)


def test_ways_to_give_a_deck(tmp_path):
    deck = tmp_path / "circle.ini"
    deck.write_text("[contact]\nM = 10\nL = 5\n[lubricant]\nalpha = 2.2e-8\n[grid]\ncells = 128\n")
    ways = [
        ehl.run(CIRCLE),
        ehl.run(deck, contact={"M": 20}),
        ehl.run(str(deck), **{"contact.M": 20}),
        ehl.run(deck.read_text(), contact={"M": np.float64(20), "L": 5}),
    ]
    assert len({float(one.Hc) for one in ways}) == 1
    assert ehl.run(deck).Hc != ways[0].Hc
    assert ehl.run(CIRCLE, output={"fields": None}).Hc == ways[0].Hc
    with pytest.raises(ehl.InputError, match="the deck does not give this key"):
        ehl.run(CIRCLE, contact={"W": None})
    with pytest.raises(TypeError, match="section.key"):
        ehl.run(deck, M=20)
    with pytest.raises(ValueError, match="one line"):
        ehl.run(CIRCLE, case={"title": "a\nb"})


def test_numbers_have_units_and_bars():
    result = ehl.run(BALL, grid={"cells": 128})
    assert result.hc.unit == "m" and 1e-9 < result.hc < 1e-5 and 0 < result.hc.error < 0.5
    assert result.hc.bar == pytest.approx(result.hc * result.hc.error)
    assert result.p_max == pytest.approx(result.P_max * result.p_h)
    assert "m +- " in str(result.hc) and "hc = " in repr(result.hc)
    assert result.quantities["hc"] == result.hc and isinstance(result.json, dict)
    assert result["/levels"] and list(result.table("levels")["nx"])[-1] == 128
    assert "NOT CONVERGED" not in repr(result) and result.converged and not result.messages
    with pytest.raises(AttributeError, match="list\\(result\\)"):
        result.no_such_number
    with pytest.raises(KeyError):
        result["/fields/no_such_field"]
    for copied in (copy.deepcopy(result.hc), pickle.loads(pickle.dumps(result.hc))):
        assert copied == result.hc and copied.unit == "m" and copied.error == result.hc.error


def test_fields_are_views_that_keep_their_memory():
    result = ehl.run(CIRCLE, domain={"far_field": "zero"})
    P, x, y = result.P, result.x, result.y
    assert P.shape == (len(y), len(x)) and not P.flags.owndata and not P.flags.writeable
    assert np.shares_memory(P, result.fields["P"])
    load = P.sum() * (x[1] - x[0]) * (y[1] - y[0])
    print(f"load of the view over 2 pi/3, less 1: {load / (2 * np.pi / 3) - 1:.1e}")
    assert load == pytest.approx(2 * np.pi / 3, rel=1e-4)
    assert np.allclose(P, P[::-1], rtol=0, atol=1e-9)
    before = P.copy()
    del result
    gc.collect()
    ehl.run(CIRCLE, contact={"M": 50})
    assert np.array_equal(P, before)


def test_a_run_in_time():
    keys = {"transient": {"end_time": 0.5, "load": "1:1 1:1.2", "output_interval": 0.25}, "domain": {"far_field": "zero"}}
    result = ehl.run(CIRCLE, **keys)
    P = result["/transient/frames/P"]
    assert P.ndim == 3 and P.shape[1:] == result.P.shape and len(result["/transient/frames/time"]) == len(P)
    assert len(result.table("transient")) > 2


def test_all_errors_of_a_deck_at_once():
    with pytest.raises(ehl.InputError) as error:
        ehl.run(CIRCLE, contact={"M": -3}, grid={"cels": 64})
    assert len(error.value.messages) == 2 and "cells" in str(error.value) and isinstance(error.value, ValueError)
    assert pickle.loads(pickle.dumps(error.value)).messages == error.value.messages
    with pytest.raises(ehl.InputError, match="no_such.ini"):
        ehl.run("no_such.ini")
    with pytest.raises(ehl.FileError, match="no_such.h5"):
        ehl.open("no_such.h5")
    with pytest.raises(ehl.InputError, match="srr"):
        ehl.check(CIRCLE, motion={"srr": "much"})


def test_files_that_are_no_results(tmp_path):
    ehl.run(CIRCLE).save(tmp_path / "good.h5")
    with pytest.raises(ehl.FileError, match="good.h5"):
        ehl.run(CIRCLE).save(tmp_path / "good.h5")
    whole = (tmp_path / "good.h5").read_bytes()
    (tmp_path / "cut.h5").write_bytes(whole[: len(whole) // 2])
    (tmp_path / "text.h5").write_text("no result")
    for name in ("cut.h5", "text.h5"):
        with pytest.raises(ehl.FileError, match=name):
            ehl.open(tmp_path / name)
    with pytest.raises(ehl.FileError):
        ehl.open(tmp_path)


def test_what_did_not_converge_is_told(tmp_path):
    with pytest.raises(ehl.NotConverged) as error:
        ehl.run(CIRCLE, multigrid={"max_cycles": 1}, continuation={"path": "off"}, contact={"M": 500})
    result = error.value.result
    assert result is not None and not result.converged and "NOT CONVERGED" in repr(result)
    result.save(tmp_path / "not.h5")
    with pytest.warns(ehl.EhlWarning, match="not converged"):
        assert not ehl.open(tmp_path / "not.h5").converged


def test_warnings_are_those_of_python():
    with pytest.warns(ehl.EhlWarning, match="single level"):
        ehl.run(CIRCLE, grid={"cells": 32})


def test_warnings_are_all_that_the_report_prints(tmp_path):
    """Of the contact and of each effect: here heat, whose Newtonian oil shears as no oil does, friction and stresses."""
    ball = dict(
        contact={"load": 100, "radius_x": 0.01, "E_prime": 226e9},
        motion={"u_m": 2, "srr": 0.5},
        lubricant={"eta0": 0.05, "alpha": 2e-8},
        grid={"cells": 64},
        thermal={"T_oil": 40, "beta": 0.04, "solid1": "steel", "solid2": "steel"},
        friction={"cavitated": "striated"},
        subsurface={"depth": 1, "planes": 5, "cells": 32},
    )

    def printed(result):
        return [line[len("warning: ") :] for line in result.report.splitlines() if line.startswith("warning: ")]

    with pytest.warns(ehl.EhlWarning):
        result = ehl.run({}, **ball)
    assert result.warnings == printed(result)
    assert any("[shear-stress]" in one for one in result.warnings)
    result.save(tmp_path / "all.h5")
    assert sorted(ehl.open(tmp_path / "all.h5").warnings) == sorted(result.warnings)
    del ball["thermal"]
    checked = ehl.check({}, **{**ball, "motion": {"u_m": 2, "srr": 2.5}})
    assert checked.warnings == printed(checked) and "[backwards]" in checked.warnings[0]


def test_progress_and_stopping():
    heard = []
    ehl.run(CIRCLE, progress=lambda fraction, text: heard.append((fraction, text)))
    assert len(heard) > 3 and heard[-1][0] > heard[0][0] and "residual" in heard[-1][1]
    with pytest.raises(ehl.Interrupted):
        ehl.run(CIRCLE, progress=lambda *_: False)

    def fails(*_):
        raise ZeroDivisionError("in the user's function")

    with pytest.raises(ZeroDivisionError):
        ehl.run(CIRCLE, progress=fails)
    assert ehl.run(CIRCLE).converged


def test_the_interpreter_is_free_meanwhile():
    counted = [0]
    done = threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(1e-4)

    thread = threading.Thread(target=count)
    thread.start()
    ehl.run(CIRCLE, grid={"cells": 256}, threads=1)
    done.set()
    thread.join()
    print(f"another thread counted to {counted[0]} during a run")
    assert counted[0] > 20


def test_two_threads_solve_two_cases():
    expected = [ehl.run(CIRCLE, contact={"M": M}).Hc for M in (10, 30)]
    found = [[], []]

    def solve(k):
        for _ in range(5):
            found[k].append(float(ehl.run(CIRCLE, contact={"M": (10, 30)[k]}, threads=1).Hc))

    threads = [threading.Thread(target=solve, args=(k,)) for k in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [[float(one)] * 5 for one in expected]


LONG = """
import ehl, sys
print("begins", flush=True)
try:
    ehl.run({deck!r}, grid={{"cells": 1024}}, threads=1)
except KeyboardInterrupt:
    print("interrupted", ehl.run({deck!r}).converged)
"""


def test_ctrl_c_ends_a_run_and_not_the_session():
    process = subprocess.Popen([sys.executable, "-c", LONG.format(deck=CIRCLE)], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begins\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate(timeout=120)
    assert out == "interrupted True\n" and process.returncode == 0


def test_a_hundred_runs_leak_nothing():
    def resident():
        return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()

    for _ in range(20):
        ehl.run(CIRCLE, threads=1)
    grown = []
    for _ in range(4):
        before = resident()
        for _ in range(25):
            ehl.run(CIRCLE, threads=1)
        gc.collect()
        grown.append((resident() - before) / 1e6)
    print("25 runs, four times:", grown, "MB more")
    # The heap of the process may grow irregularly; a kept result would make it grow in every round.
    assert min(grown) < 0.5


def test_keys_and_stubs():
    assert {"contact", "lubricant", "grid", "thermal"} <= ehl.sections().keys()
    (M,) = ehl.keys("contact.M")
    assert M.type == "number" and "Moes" in M.meaning and "default" in str(M)
    assert all(key.section == "grid" for key in ehl.keys("grid")) and len(ehl.keys()) > 100
    with pytest.raises(KeyError, match="no such section"):
        ehl.keys("grids")
    from ehl import _stubs

    written = pathlib.Path(ehl.__file__).with_name("__init__.pyi").read_text()
    assert written == _stubs.stubs(), "the keys have changed: run `python3 -m ehl._stubs`"


def test_check_solves_nothing():
    checked = ehl.check(BALL)
    assert "Hertz" in checked.report and checked.a.unit == "m" and checked.json is None
    assert "/summary/Hc" not in checked
    with pytest.raises(ehl.InputError, match="no result"):
        checked.save("nothing.h5")


def test_a_sweep_is_a_table(tmp_path):
    table = ehl.sweep(CIRCLE, {"contact.M": [10, 20], "contact.L": "2:5:2"}, output=tmp_path / "t.csv")
    assert list(table["status"]) == ["converged"] * 4 and list(table["contact.M"]) == [10, 10, 20, 20]
    row = table[(table["contact.M"] == 20) & (table["contact.L"] == 5)].iloc[0]
    assert row["Hc"] == pytest.approx(ehl.run(CIRCLE).Hc, rel=1e-8)
    more = ehl.sweep(CIRCLE, {"contact.M": [10, 20, 30], "contact.L": "2:5:2"}, output=tmp_path / "t.csv")
    assert len(more) == 6 and more.attrs["header"]
    joint = ehl.sweep(CIRCLE, {("contact.M", "contact.L"): [(10, 2), (20, 5)]})
    assert list(joint["Hc"]) == [table["Hc"][0], row["Hc"]]
    cases = ehl.sweep(CIRCLE, cases=table[["contact.M", "contact.L"]])
    assert list(cases["Hc"]) == list(table["Hc"])
    assert ehl.read_table(tmp_path / "t.csv").equals(more)
    with pytest.raises(ehl.InputError, match="unknown key"):
        ehl.sweep(CIRCLE, {"contact.N": [1, 2]})


@pytest.mark.parametrize("heading, words", [
    (["contact.N", "contact.L"], "cases.csv:1: .*unknown key"),
    (["Contact.M", "contact.L"], "cases.csv:1: .*did you mean \\[?contact"),
    (["M", "contact.L"], "cases.csv:1: M: a column is named by its key, section.key"),
    (["contact.L", "contact.L"], "cases.csv:1: contact.L: stands twice"),
    (["contact.M [kN]", "contact.L"], "the unit 'kN' must be"),
    ([0, 1], "has no cases"),
])
def test_a_bad_heading_of_cases_is_an_error(heading, words):
    with pytest.raises(ehl.InputError, match=words):
        ehl.sweep(CIRCLE, cases=pandas.DataFrame([[10, 2], [20, 5]], columns=heading))


def test_a_sweep_that_keeps_its_results(tmp_path):
    table = ehl.sweep(CIRCLE, {"contact.M": [10, 20]}, output=tmp_path / "t.csv", keep=True)
    for k, M in enumerate((10, 20)):
        kept, alone = ehl.open(tmp_path / "t.h5", case=k), ehl.run(CIRCLE, contact={"M": M}, threads=1)
        assert kept.M == M and np.array_equal(kept.H, alone.H) and kept.Hc == alone.Hc == pytest.approx(table["Hc"][k])
    with pytest.raises(ehl.FileError, match="choose a case"):
        ehl.open(tmp_path / "t.h5")
    with pytest.raises(ehl.FileError, match="no case 2"):
        ehl.open(tmp_path / "t.h5", case=2)


def test_the_example_runs(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "argv", ["ball_on_disc.py", str(tmp_path / "film.png"), "64"])
    monkeypatch.setenv("MPLBACKEND", "Agg")
    example = pathlib.Path(ehl.__file__).parents[1] / "examples" / "ball_on_disc.py"
    runpy.run_path(str(example), run_name="__main__")
    assert (tmp_path / "film.png").stat().st_size > 20000


NULL_CALLS = """
import ctypes
from ehl import _library
lib = _library.library()
entry = _library.Entry()
run = lambda *a: lib.ehl_run(*a, 1, _library.Progress(0), None)
def ended(handle, words):
    handle = ctypes.c_void_p(handle)
    assert lib.ehl_status(handle) == 2, lib.ehl_status(handle)
    assert words in lib.ehl_message(handle, 0).decode(), lib.ehl_message(handle, 0)
    assert lib.ehl_find(handle, b"/summary/Hc", ctypes.byref(entry)) == 0
    lib.ehl_free(handle)
ended(run(None, None, None, 0), "NULL")
ended(run(b"[contact]", b"d", None, 3), "overrides is NULL")
ended(run(b"[contact]", b"d", (ctypes.c_char_p * 2)(b"contact.M=3", None), 2), "overrides[1] is NULL")
ended(lib.ehl_check(None, None, None, 0, 1), "NULL")
ended(lib.ehl_open(None), "path is NULL")
ended(lib.ehl_open_case(None, 0), "path is NULL")
# A result that is NULL, and a result without the other arguments.
good = ctypes.c_void_p(lib.ehl_check(b"[contact]\\nM = 5\\nL = 5\\n[lubricant]\\nalpha = 2e-8\\n", None, None, 0, 1))
assert lib.ehl_status(good) == 0
for result in (None, good):
    assert lib.ehl_find(result, None, ctypes.byref(entry)) == 0
    assert lib.ehl_find(result, b"/deck", None) == 0
    assert lib.ehl_entry_at(result, 0, None) == 0
    assert lib.ehl_attribute(result, None, None) is None
    assert lib.ehl_save(result, None, 0) in (1, 2)
assert lib.ehl_status(None) == 1 and lib.ehl_entry_count(None) == 0
assert lib.ehl_report(None) == b"" and lib.ehl_json(None) == b""
assert lib.ehl_message(None, 0) is None and lib.ehl_warning(None, 0) is None
lib.ehl_free(good), lib.ehl_free(None)
print("all of them")
"""


def test_null_is_an_error_and_no_crash():
    done = subprocess.run([sys.executable, "-c", NULL_CALLS], capture_output=True, text=True)
    assert done.stdout == "all of them\n", done.stderr


def test_the_library_shows_its_functions_alone():
    shown = subprocess.run(["nm", "-D", "--defined-only", os.environ["EHL_LIBRARY"]], capture_output=True, text=True)
    names = [line.split()[-1] for line in shown.stdout.splitlines()]
    assert len(names) >= 18
    assert [name for name in names if not name.startswith("ehl_")] == []


def test_a_nul_character_is_refused_and_cuts_nothing(tmp_path):
    deck = "[contact]\nM = 5\n\0L = 5\n"
    for call in (lambda: ehl.check(deck), lambda: ehl.check({"contact": {"M": "5\0", "L": 5}}),
                 lambda: ehl.check("[contact]\nM = 5\nL = 5\n", **{"case.title": "a\0b"}),
                 lambda: ehl.check("a\0.ini"), lambda: ehl.open("a\0.h5")):
        with pytest.raises(ValueError, match="NUL"):
            call()
    (tmp_path / "d.ini").write_text(deck)
    with pytest.raises(ehl.InputError, match="d.ini: not a text file"):
        ehl.check(tmp_path / "d.ini")


def test_values_of_numpy_and_awkward_names(tmp_path):
    small = {"contact": {"M": np.float32(20), "L": np.int64(10)}, "lubricant": {"alpha": np.float64(2.2e-8)},
             "grid": {"cells": np.int64(32)}, "output": {"fields": np.array(["P", "H"])}}
    assert ehl.check(small).report == ehl.check({**CIRCLE, "contact": {"M": 20, "L": 10}, "grid": {"cells": 32}}).report
    folder = tmp_path / "a=b, c"
    folder.mkdir()
    (folder / "d=1.ini").write_text("[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\n[grid]\ncells = 32\n")
    assert ehl.check(str(folder / "d=1.ini")).report
    table = ehl.sweep(str(folder / "d=1.ini"), {"contact.M": np.array([20.0, 30.0])}, output=folder / "t=1.csv")
    assert list(table["contact.M"]) == [20, 30]
    for value in ("a,b", "1:2", None, ""):
        with pytest.raises(ValueError, match="cannot stand in a list"):
            ehl.sweep(str(folder / "d=1.ini"), {"case.title": [value]})


def test_sigint_to_python_alone_stops_a_sweep(tmp_path):
    script = (f"import ehl\nehl.sweep({{'contact': {{'M': 20, 'L': 10}}, 'lubricant': {{'alpha': 2.2e-8}}, 'grid': {{'cells': 128}}}}, "
              f"{{'contact.M': '20:1000:400'}}, output={str(tmp_path / 't.csv')!r}, threads=1)")
    process = subprocess.Popen([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True)
    table = tmp_path / "t.csv"
    for _ in range(600):
        if table.is_file() and table.read_text().count("\n") > 12:
            break
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in process.communicate(timeout=120)[1]
    rows = [line for line in table.read_text().splitlines() if not line.startswith("#")]
    assert 1 < len(rows) < 401, "the sweep was stopped before its end, and what it had is kept"
