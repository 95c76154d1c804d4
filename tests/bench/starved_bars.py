"""Do the error bars of starved contacts hold? Contacts drawn by a seed, on 128, 256 and 512 cells against 1024.

python3 tests/bench/starved_bars.py EHL FOLDER [SEED [NUMBER]]   solves what FOLDER does not hold yet; prints the table

M 5 to 500, L 2 to 18, supply .2 to 1.8 of what the flooded film carries; discretization and domain as a deck has them
by default. The truth of 128 and 256 cells is extrapolated from 512 and 1024; 512 is asked for the change to 1024.
"""

import pathlib
import random
import sys

import kept_runs

CELLS = (128, 256, 512, 1024)
VALUES = ("Hc", "Hm_fitted")
DECK = """[contact]
M = {M}
L = {L}
[lubricant]
viscosity = roelands
alpha = 2.2e-8
z = 0.68
density = dowson-higginson
"""


def drawn(seed, number):
    rng = random.Random(seed)
    for _ in range(number):
        M, L = round(10 ** rng.uniform(0.7, 2.7), 2), round(rng.uniform(2, 18), 2)
        yield M, L, round(10 ** rng.uniform(-0.7, 0.25), 3)


def solved(program, folder, name, *settings):
    deck = folder / (name.split("_")[0] + ".ini")
    return kept_runs.solved(program, deck, folder / f"{name}.json", *settings)


def supply_of(program, folder, name, share):
    """H_oil that is this share of what the flooded film carries at the centre."""
    flooded = solved(program, folder, name + "_flooded", "grid.cells=128")
    wanted = 1.25 * flooded["Hc"]
    for cells in (64, 128):
        report = solved(program, folder, f"{name}_scale{cells}", f"grid.cells={cells}", f"supply.H_oil={wanted:.12g}")
        if report.get("starvation"):
            return share * wanted / report["starvation"]["supply_ratio"]
    return None


def main(program, folder, seed=99, number=16):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    print("contact,M,L,supply ratio,value,cells,error,bar,bar/error")
    for k, (M, L, share) in enumerate(drawn(int(seed), int(number)), 1):
        name = f"{seed}-{k}"
        (folder / f"{name}.ini").write_text(DECK.format(M=M, L=L))
        supply = supply_of(program, folder, name, share)
        if supply is None:
            print(f"# {k}: M {M}, L {L}: no solution with the supply of the flooded film", flush=True)
            continue
        of = {
            cells: solved(program, folder, f"{name}_{cells}", f"grid.cells={cells}", f"supply.H_oil={supply:.12g}")
            for cells in CELLS
        }
        missing = [cells for cells in CELLS if not of[cells].get("converged")]
        if {512, 1024} & set(missing):
            print(f"# {k}: not solved on", *missing, flush=True)
            continue
        for value in VALUES:
            finest, next_to_it = of[1024][value], of[512][value]
            for cells in (128, 256, 512):
                if cells in missing:
                    print(f"# {k}: not solved on", cells)
                    continue
                truth = finest if cells == 512 else finest + (finest - next_to_it) / 3
                error, bar = abs(of[cells][value] / truth - 1), of[cells]["error_" + value]
                ratio = bar / max(error, 1e-9)
                print(f"{k},{M},{L},{share},{value},{cells},{error:.1e},{bar:.1e},{ratio:.1f}", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
