"""Errors of the default settings against an unbounded domain.

python3 tests/bench/infinite_domain.py EHL FOLDER [M,L ...]

Solves what FOLDER does not hold yet; one line per load and grid. The reference of a load is extrapolated (order 2) from
two meshes on a domain of twice the length and width: the mesh size of 512 cells on the default domain and half of it.
"""

import pathlib
import re
import subprocess
import sys

import kept_runs

LOADS = ((5, 5), (50, 10), (1000, 10))
CELLS = (128, 256, 512)
SIDES = ("x_inlet", "x_outlet", "y_half")
DECK = """[contact]
M = {M}
L = {L}
[lubricant]
viscosity = roelands
alpha = 2.2e-8
z = 0.68
density = dowson-higginson
"""


def solved(program, folder, M, L, cells, domain=()):
    deck = folder / f"{M}_{L}.ini"
    deck.write_text(DECK.format(M=M, L=L))
    result = folder / f"{M}_{L}_{cells}{'_twice' if domain else ''}.json"
    settings = [f"grid.cells={cells}", "output.fields=P", *domain]
    return kept_runs.solved(program, deck, result, *settings, output=result.with_suffix(".h5"))


def twice_as_long(program, file):
    """Settings of a domain of twice the sides."""
    deck = subprocess.run([program, "extract", file, "deck"], capture_output=True, text=True).stdout
    chosen = dict(re.findall(r"^(\w+) = (\S+)", deck, re.MULTILINE))
    return [f"domain.{side}={2 * float(chosen[side])!r}" for side in SIDES]


def main(program, folder, *loads):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    print("M,L,cells,Hc [%],Hm of the nodes [%],Hm fitted [%],seconds")
    for M, L in [load.split(",") for load in loads] or LOADS:
        on = {cells: solved(program, folder, M, L, cells) for cells in CELLS}
        domain = twice_as_long(program, folder / f"{M}_{L}_128.h5")
        coarse, fine = (solved(program, folder, M, L, cells, domain) for cells in (1024, 2048))
        true = {film: fine[film] + (fine[film] - coarse[film]) / 3 for film in ("Hc", "Hm_fitted")}
        for cells in CELLS:
            errors = [
                f"{100 * (on[cells][film] / true[of] - 1):+.4f}"
                for film, of in (("Hc", "Hc"), ("Hm", "Hm_fitted"), ("Hm_fitted", "Hm_fitted"))
            ]
            print(M, L, cells, *errors, f"{on[cells]['seconds']:.3g}", sep=",", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
