"""Do the bars of line contacts hold? The loads of a map of lines against four times the cells.

python3 tests/bench/line_bars.py EHL FOLDER

Solves what FOLDER does not hold yet; one line per value: M = 1 to 2000, L = 0 to 25 on 128 to 1024 cells,
discretization and domain as a deck has them by default.
"""

import pathlib
import sys

import kept_runs

LOADS = [(M, L) for M in (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000) for L in (0, 2, 5, 10, 15, 20, 25)]
CELLS = (128, 256, 512, 1024)
# Of a film the node's least lies above the least between the nodes.
VALUES = {"Hc": "Hc", "Hm": "Hm_fitted", "Hm_fitted": "Hm_fitted"}
DECK = """[contact]
kind = line
M = {M}
L = {L}
[lubricant]
viscosity = roelands
alpha = 2.2e-8
z = 0.68
density = dowson-higginson
"""


def solved(program, folder, M, L, cells):
    deck = folder / f"{M}_{L}.ini"
    deck.write_text(DECK.format(M=M, L=L))
    return kept_runs.solved(program, deck, folder / f"{M}_{L}_{cells}.json", f"grid.cells={cells}")


def main(program, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    print("M,L,cells,value,bar,error,bar/error")
    for M, L in LOADS:
        for cells in CELLS:
            now, fine = (solved(program, folder, M, L, c) for c in (cells, 4 * cells))
            if not (now.get("converged") and fine.get("converged")):
                print(f"# ({M}; {L}): not solved on {cells} or {4 * cells} cells")
                continue
            for value, other in VALUES.items():
                if now["error_" + value] is None:
                    print(f"# ({M}; {L}): no bar of {value} on {cells} cells: the grids below it do not see the film")
                    continue
                bar, error = now["error_" + value], abs(now[value] / fine[other] - 1)
                print(f"{M},{L},{cells},{value},{bar:.1e},{error:.1e},{bar / max(error, 1e-9):.1f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
