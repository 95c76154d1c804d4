"""Solved point contacts in SI with oils that the fit of the film does not know: tests/reference/film_map_oils.csv.

python3 tests/bench/film_map_oils.py EHL      in an empty folder; EHL is the program. About five minutes on two cores.

Random loads, radii, moduli and speeds (a fixed seed) of oils by name, of data sheets and of other laws, inside the range
of the fit. Each is refined until the error bars of both films are below one per cent. film_regression.py compares its
fit with them: these deviations are the accuracy that a report prints.
"""

import csv
import json
import math
import pathlib
import random
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TABLE = HERE.parent / "reference" / "film_map_oils.csv"
PER_OIL = 8
COLUMNS = ["oil", "keys", "load", "radius_x", "radius_y", "E_prime", "u_m", "M", "radius_ratio", "L_star", "Hc", "error_Hc", "Hm", "error_Hm"]
YASUTOMI = "viscosity=yasutomi temperature=60 Tg0=-83.2 A1=188.95 A2=0.719e-9 b1=8.2e-9 b2=-0.53 C1=16.09 C2=17.38 eta_g=1e12"
OILS = {
    "mineral-vg32 at 40 C": "fluid=mineral-vg32 temperature=40",
    "mineral-vg100 at 70 C": "fluid=mineral-vg100 temperature=70",
    "mineral-vg320 at 100 C": "fluid=mineral-vg320 temperature=100",
    "pao4 at 40 C": "fluid=pao4 temperature=40",
    "pao40 at 80 C": "fluid=pao40 temperature=80",
    "squalane": "fluid=squalane",
    "mourier": "fluid=mourier",
    "Roelands 12/GPa": "eta0=0.02 alpha=1.2e-8",
    "Roelands 16/GPa": "eta0=0.05 alpha=1.6e-8",
    "Roelands 26/GPa": "eta0=0.01 alpha=2.6e-8",
    "Roelands 20/GPa with Tait": "eta0=0.03 alpha=2e-8 density=tait K0=1.2e9 K0_prime=11",
    "Barus 18/GPa": "viscosity=barus eta0=0.05 alpha=1.8e-8",
    "Yasutomi at 60 C with Tait": YASUTOMI + " density=tait K0=1.3e9 K0_prime=10.5",
}


def contacts():
    """Endless: load, radius_x, radius_y, E_prime, u_m."""
    draw = random.Random(51)
    while True:
        load, radius = 10 ** draw.uniform(0.0, 2.5), 10 ** draw.uniform(-2.3, -1.5)
        ratio = draw.choice([1.0, 1.0, 0.15, 0.3, 0.5, 0.8, 1.5, 2.4])
        yield [float(f"{one:.4g}") for one in (load, radius, radius / ratio, draw.choice([6e10, 1.2e11, 2.3e11]), 10 ** draw.uniform(-1.3, 1.0))]


def deck(contact, oil):
    load, radius_x, radius_y, E_prime, u_m = contact
    bodies = f"[contact]\nload = {load:g}\nradius_x = {radius_x:g}\nradius_y = {radius_y:g}\nE_prime = {E_prime:g}\n"
    return bodies + f"[motion]\nu_m = {u_m:g}\n[lubricant]\n" + oil.replace(" ", "\n") + "\n[grid]\naccuracy = 1e-2\n"


def main(ehl):
    rows = []
    source = contacts()
    for oil, keys in OILS.items():
        solved = 0
        while solved < PER_OIL:
            contact = next(source)
            pathlib.Path("oil.ini").write_text(deck(contact, keys))
            said = subprocess.run([ehl, "check", "oil.ini"], capture_output=True, text=True)
            groups = re.search(r"M = (\S+), L = ([0-9.e+-]+)", said.stdout)
            if not groups or not 0.3 < float(groups[1]) < 1000.0 or float(groups[2]) > 23.0:
                continue
            run = subprocess.run([ehl, "run", "oil.ini", "--json", "--quiet", "--overwrite"], capture_output=True, text=True)
            solved += 1
            if run.returncode != 0:
                print("left out:", oil, contact, "status", run.returncode, flush=True)
                continue
            of = json.loads(run.stdout)
            if max(of["error_Hc_best"] or 1.0, of["error_Hm_best"] or 1.0) > 0.01:
                print("left out:", oil, contact, "error bars above one per cent", flush=True)
                continue
            L_star = of["L"] * of["alpha_star"] * of["p_h_Pa"] / of["alpha_bar"]
            rows.append([oil, keys, *(f"{one:g}" for one in contact), *(f"{one:.9g}" for one in (
                of["M"], contact[1] / contact[2], L_star, of["Hc_best"], of["error_Hc_best"], of["Hm_best"], of["error_Hm_best"]))])
            print(oil, len(rows), flush=True)
    with open(TABLE, "w", encoding="utf-8", newline="") as file:
        file.write("# Solved point contacts in SI with oils that the fit of the film does not know; made by tests/bench/film_map_oils.py.\n")
        file.write("# SI units; H = h R_x/a^2, L_star is L with alpha* = 1/int eta0/eta dp, errors relative.\n")
        csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
