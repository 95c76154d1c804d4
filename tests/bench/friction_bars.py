"""Do the bars of friction hold? Contacts drawn by a seed, each number against the same contact on four times the cells.

python3 tests/bench/friction_bars.py EHL FOLDER [SEED [NUMBER]]

Solves what FOLDER does not hold yet; one line per value. A third each points, ellipses (R_x/R_y 0.2 to 5, half of them
at an angle) and lines; M 5 to 500, L 1 to 18; a third each Newtonian, Eyring's and Carreau's oil, half of each with a
limiting stress. Points and ellipses on 128 and 256 cells, lines on 128, 256, 512 and 1024; discretization and domain
as a deck has them by default.
"""

import math
import pathlib
import random
import sys

import kept_runs

GRIDS = {"point": (128, 256), "ellipse": (128, 256), "line": (128, 256, 512, 1024)}
LAWS = ("", "law = eyring\ntau_0 = {stress}", "law = carreau\nG = {stress}\nn = {n}")
VALUES = ("mu", "mu_rolling")


def drawn(seed, number):
    random.seed(seed)

    def log_between(low, high):
        return math.exp(random.uniform(math.log(low), math.log(high)))

    for k in range(number):
        kind = ("point", "ellipse", "line")[k % 3]
        M, L, alpha = log_between(5, 500), random.uniform(1, 18), random.uniform(1.2e-8, 2.4e-8)
        shape = "kind = line\n" if kind == "line" else ""
        if kind == "ellipse":
            shape = f"radius_ratio = {log_between(0.2, 5)}\n"
        angle = f"angle = {random.uniform(10, 80)}\n" if kind == "ellipse" and k % 2 else ""
        law = LAWS[(k // 3) % 3].format(stress=log_between(2e6, 1e7), n=random.uniform(0.4, 0.8))
        limit = f"limit = {random.uniform(0.03, 0.1)}\n" if (k // 9) % 2 else ""
        yield kind, M, L, law, limit, f"""[contact]
{shape}M = {M}
L = {L}
a_over_R = {log_between(0.003, 0.03)}
[motion]
srr = {random.choice([-1, 1]) * log_between(0.003, 1.5)}
{angle}[lubricant]
viscosity = roelands
alpha = {alpha}
z = {random.uniform(0.45, 0.7)}
density = dowson-higginson
{"[shear]" if law else ""}
{law}
[friction]
cavitated = striated
{limit}"""


def solved(program, folder, name, cells):
    output = folder / f"out{seed_of(name)}.h5"
    result = folder / f"{name}_{cells}.json"
    return kept_runs.solved(program, folder / f"{name}.ini", result, f"grid.cells={cells}", output=output)


def seed_of(name):
    return name.split("_")[0]


def main(program, folder, seed=1, number=36):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    print("contact,kind,M,L,law,value,cells,bar,error,bar/error")
    for k, (kind, M, L, law, limit, deck) in enumerate(drawn(int(seed), int(number)), 1):
        name = f"{seed}_{k}"
        (folder / f"{name}.ini").write_text(deck)
        law = (law.split()[2] if law else "Newtonian") + (" limited" if limit else "")
        for cells in GRIDS[kind]:
            now, fine = (solved(program, folder, name, c) for c in (cells, 4 * cells))
            if not (now.get("converged") and fine.get("converged")):
                print(f"# {seed}.{k}: not solved on {cells} or {4 * cells} cells")
                continue
            for value in VALUES:
                bar, true = now["friction"]["error_" + value], fine["friction"][value]
                error = abs(now["friction"][value] / true - 1)
                if bar is None:
                    print(f"# {seed}.{k}: no bar of {value} on {cells} cells: the levels give no estimate")
                    continue
                print(
                    f"{seed}.{k},{kind},{M:.3g},{L:.3g},{law},{value},{cells},{bar:.1e},{error:.1e},"
                    f"{bar / max(error, 1e-9):.1f}"
                )


if __name__ == "__main__":
    main(*sys.argv[1:])
