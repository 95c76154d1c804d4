"""Do the bars of friction and temperatures hold? Contacts with heat drawn by a seed, on 128 and 256 cells against 512.

python3 tests/bench/heat_bars.py EHL FOLDER [SEED [NUMBER]]   solves what FOLDER does not hold yet; one line per value

0.5 to 1.6 GPa, 0.7 to 8 m/s, srr 0.05 to 1.8 in both directions, discretization and domain as a deck has them by
default.
"""

import json
import math
import pathlib
import random
import subprocess
import sys

VALUES = ("mu", "T_film_max", "T1_max", "T2_max")
E_PRIME = 226e9


def drawn(seed, number):
    random.seed(seed)

    def log_between(low, high):
        return math.exp(random.uniform(math.log(low), math.log(high)))

    for _ in range(number):
        radius, p_h = log_between(5e-3, 2e-2), random.uniform(0.5e9, 1.6e9)
        a = math.pi * p_h * radius / E_PRIME
        yield f"""[contact]
load = {2 / 3 * math.pi * a * a * p_h}
radius_x = {radius}
E_prime = {E_PRIME}
[motion]
u_m = {log_between(0.7, 8)}
srr = {random.choice([-1, 1]) * log_between(0.05, 1.8)}
[lubricant]
eta0 = {log_between(0.015, 0.09)}
alpha = {random.uniform(13e-9, 23e-9)}
[shear]
law = eyring
tau_0 = {log_between(2e6, 9e6)}
[thermal]
T_oil = {random.uniform(30, 90)}
beta = {random.uniform(0.03, 0.05)}
solid1 = {random.choice(["steel", "steel", "si3n4"])}
solid2 = {random.choice(["steel", "steel", "bk7"])}
"""


def solved(program, folder, name, cells):
    result = folder / f"{name}_{cells}.json"
    if not result.exists():
        command = [program, "run", folder / f"{name}.ini", "--set", f"grid.cells={cells}", "--json", "--quiet"]
        command += ["--overwrite", "--threads", "1", "--output", folder / "out.h5"]
        result.write_text(subprocess.run(command, capture_output=True, text=True).stdout or "{}")
    return json.loads(result.read_text())


def main(program, folder, seed=1, number=16):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    print("contact,value,cells,p_h [GPa],u_m,srr,bar,error,bar/error")
    for k, deck in enumerate(drawn(int(seed), int(number)), 1):
        name = f"{seed}_{k}"
        (folder / f"{name}.ini").write_text(deck)
        of = {cells: solved(program, folder, name, cells) for cells in (128, 256, 512)}
        if not all(one.get("converged") for one in of.values()):
            print(f"# {k}: not solved on", *[cells for cells, one in of.items() if not one.get("converged")])
            continue
        told = {key.strip(): value for key, _, value in (line.partition("=") for line in deck.splitlines())}
        for cells in (128, 256):
            for value in VALUES:
                heat = of[cells]["thermal"]
                error, bar = abs(heat[value] / of[512]["thermal"][value] - 1), heat["error_" + value]
                p_h = E_PRIME / math.pi * (1.5 * float(told["load"]) / E_PRIME / float(told["radius_x"]) ** 2) ** (1 / 3)
                conditions = f"{p_h / 1e9:.2f},{float(told['u_m']):.2f},{float(told['srr']):.3f}"
                print(f"{k},{value},{cells},{conditions},{bar:.1e},{error:.1e},{bar / max(error, 1e-9):.1f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
