"""Do the bars of contacts with heat hold? Contacts drawn by a seed, on coarse grids against a fine one.

python3 tests/bench/heat_bars.py EHL FOLDER [SEED [NUMBER]]         points: 128 and 256 cells against 512
python3 tests/bench/heat_bars.py EHL FOLDER [SEED [NUMBER]] line    lines: 128, 256 and 512 against 2048

Solves what FOLDER does not hold yet; one line per value. 0.5 to 1.6 GPa, 0.7 to 8 m/s, srr 0.05 to 1.8 in both
directions, discretization and domain as a deck has them by default.
"""

import math
import pathlib
import random
import sys

import kept_runs

E_PRIME = 226e9
HEAT = ("mu", "T_film_max", "T1_max", "T2_max")
# The value that each film is compared with; the smallest node lies above the minimum between the nodes.
FILM = {"Hc": "Hc", "Hm": "Hm_fitted", "Hm_fitted": "Hm_fitted", "Hc_extrapolated": "Hc", "Hm_extrapolated": "Hm_fitted"}
GRIDS = {"point": ((128, 256), 512), "line": ((128, 256, 512), 2048)}


def drawn(seed, number, kind):
    random.seed(seed)

    def log_between(low, high):
        return math.exp(random.uniform(math.log(low), math.log(high)))

    for _ in range(number):
        radius, p_h = log_between(5e-3, 2e-2), random.uniform(0.5e9, 1.6e9)
        if kind == "line":
            a = 4 * p_h * radius / E_PRIME
            load = f"kind = line\nload_per_length = {math.pi / 2 * a * p_h}"
        else:
            a = math.pi * p_h * radius / E_PRIME
            load = f"load = {2 / 3 * math.pi * a * a * p_h}"
        yield p_h, f"""[contact]
{load}
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
    return kept_runs.solved(program, folder / f"{name}.ini", result, f"grid.cells={cells}")


def with_bars(kind, now, fine):
    """Each value with its bar, and what the fine grid has for it."""
    for value in HEAT:
        yield value, now["thermal"][value], now["thermal"]["error_" + value], fine["thermal"][value]
    for value, other in FILM.items() if kind == "line" else ():
        if now.get(value) is not None:
            yield value, now[value], now["error_" + value], fine[other]


def main(program, folder, seed=1, number=16, kind="point"):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    grids, fine = GRIDS[kind]
    print("contact,value,cells,p_h [GPa],u_m,srr,bar,error,bar/error")
    for k, (p_h, deck) in enumerate(drawn(int(seed), int(number), kind), 1):
        name = f"{seed}_{k}" if kind == "point" else f"{kind}_{seed}_{k}"
        (folder / f"{name}.ini").write_text(deck)
        of = {cells: solved(program, folder, name, cells) for cells in (*grids, fine)}
        bad = [cells for cells, one in of.items() if not one.get("converged")]
        if bad:
            print(f"# {k}: not solved on", *bad)
        given = {key.strip(): value for key, _, value in (line.partition("=") for line in deck.splitlines())}
        for cells in grids if fine not in bad else ():
            for value, is_now, bar, true in with_bars(kind, of[cells], of[fine]) if cells not in bad else ():
                error = abs(is_now / true - 1)
                if bar is None:  # the coarser grids were not solved
                    print(f"# {k}: no bar of {value} on {cells}")
                    continue
                conditions = f"{p_h / 1e9:.2f},{float(given['u_m']):.2f},{float(given['srr']):.3f}"
                print(f"{seed}.{k},{value},{cells},{conditions},{bar:.1e},{error:.1e},{bar / max(error, 1e-9):.1f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
