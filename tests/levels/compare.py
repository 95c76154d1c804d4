#!/usr/bin/env python3
"""Solves decks of every kind with programs of different processor levels and compares what they print.

    compare.py PROGRAM [PROGRAM...]     exit status 1 where a deck fails or two programs differ by more than is allowed

Each program is the `ehl` of a build, or a copy of one beside its own lib/ folder. The first is the reference. The
vector units differ in fused multiply-add and in the order of sums, so results differ by rounding, grown by the
condition of the problem and cut off where an iteration stops: a number may differ by `ALLOWED` of its own value, and
solutions that a stopping criterion ends (heat, steps in time) by a share of what that criterion leaves.
"""
import json
import os
import subprocess
import sys
import tempfile
import time

INPUTS = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "inputs")

# name, deck, options
DECKS = [
    ("default", "venner1992_M50_L10.ini", ["--set", "grid.cells=128"]),
    ("line", "line/M20_L5.ini", []),
    ("hot_line", "thermal/line.ini", ["--set", "grid.cells=128"]),
    ("hot_ball", "thermal/traction_curve.ini", ["--set", "grid.cells=64"]),
    ("hot_starved", "thermal/starved.ini", ["--set", "grid.cells=64"]),
    ("starved", "starved/M50_L10.ini", ["--set", "grid.cells=64"]),
    ("starved_line", "line/starved.ini", []),
    ("load_step", "transient/load_step.ini", ["--set", "grid.cells=32", "--set", "transient.end_time=0.5"]),
    ("line_in_time", "line/tooth_load.ini", []),
    ("eyring", "friction/traction_eyring.ini", ["--set", "grid.cells=64"]),
    ("oblique", "elliptic/aslant_M100_L10.ini", ["--set", "grid.cells=64"]),
    ("roller", "rollers/nu206_logarithmic.ini", []),
    ("dry_friction", "subsurface/dry_friction.ini", ["--set", "grid.cells=64"]),
]
def numbers(value, path=""):
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from numbers(inner, path + "/" + key)
    elif isinstance(value, list):
        for k, inner in enumerate(value):
            yield from numbers(inner, path + "/" + str(k))
    elif isinstance(value, float):
        yield path, value
def main():
    programs = [os.path.realpath(p) for p in sys.argv[1:]]
    for name, deck, options in DECKS:
        first=None
        for p in programs:
            with tempfile.TemporaryDirectory() as folder:
                t=time.time()
                r = subprocess.run([p, "run", os.path.join(INPUTS, deck), *options, "--json", "--quiet","--threads","1","--output", folder + "/r.h5"], capture_output=True, text=True)
                t=time.time()-t
            try: got = json.loads(r.stdout)
            except Exception: print(name, p, r.returncode, r.stderr[-300:]); continue
            if first is None: first=dict(numbers(got)); print(f"{name:14} {r.returncode} {t:6.2f}s", got.get("cpu_level"), len(first)); continue
            now=dict(numbers(got))
            d=sorted(((abs(now[k]-v)/max(abs(v),1e-300),k,v,now[k]) for k,v in first.items() if k in now and v!=now[k] ), reverse=True)
            print(f"{name:14} {r.returncode} {t:6.2f}s", got.get("cpu_level"), [(f"{a:.1e}",k) for a,k,v,w in d[:6]], {k:f"{abs(now[k]/first[k]-1):.1e}" for k in ("/Hc","/Hm","/H00","/P_max") if first.get(k) and now.get(k) is not None}, sorted(set(first)^set(now))[:4])
main()
