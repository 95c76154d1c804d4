"""Do the bars of runs in time hold? Every case against twice the cells with a tenth of the tolerance.

python3 tests/bench/bars_in_time.py EHL FOLDER

Solves what FOLDER does not hold yet; one line per case and number: the share of the times whose error is within the
bar, the median of bar/error, and the same of the extremes and the mean. A point, an ellipse and a line each meet a dent,
waves, a jump and a ramp of the load, a ramp of the speeds, and a reversal, with Eyring's oil and friction. Points and
ellipses on 96 cells, lines on 256.
"""

import bisect
import pathlib
import statistics
import subprocess
import sys

CELLS = {"point": 96, "ellipse": 96, "line": 256}
CONTACTS = {
    "point": ((30, 6, ""), (80, 9, "")),
    "ellipse": ((60, 8, "radius_ratio = 0.4\n"), (40, 5, "radius_ratio = 2.5\n")),
    "line": ((40, 7, "kind = line\n"), (120, 10, "kind = line\n")),
}
OIL = """a_over_R = 0.01
[lubricant]
viscosity = roelands
alpha = 2e-8
z = 0.6
density = dowson-higginson
[friction]
cavitated = striated
[shear]
law = eyring
tau_0 = 5e6
"""
RAMP = "[motion]\nsrr = 0.2\n[transient]\nend_time = 3\n"
EVENTS = {
    "dent": "[motion]\nsrr = 0.4\n[surface1]\nshape = {dent}\nwidth = 0.8\nx = -2\n[transient]\nend_time = 3\n",
    "waves": "[motion]\nsrr = -0.3\n[surface2]\nshape = waviness\nheight = {waves}\nwidth = 1.2\nx = -2\n"
    "[transient]\nend_time = 3.5\n",
    "jump": "[motion]\nsrr = 0.2\n[transient]\nend_time = 2.5\nload = 0:1 0.5:1 0.5:1.4\n",
    "speeds": RAMP + "u1 = 0:1.1 0.5:1.1 1.5:2.2\nu2 = 0:0.9 0.5:0.9 1.5:1.8\n",
    "load": RAMP + "load = 0:1 0.5:1 1.2:1.6\n",
    "reversal": "[motion]\nsrr = 0.2\n[domain]\nx_inlet = -3\nx_outlet = 3\n[transient]\nend_time = 5\n"
    "u1 = 0:1.1 1:1.1 3:-1.1\nu2 = 0:0.9 1:0.9 3:-0.9\n",
}
HEIGHTS = {"dent": ("dimple\nheight = 0.04", "groove\nheight = 0.02"), "waves": ("0.012", "0.006")}
NUMBERS = ("Hc", "Hm", "P_max", "mu")
FINER = 1e-5


def cases():
    count = 0
    for event, text in EVENTS.items():
        for kind, contacts in CONTACTS.items():
            M, L, shape = contacts[count % 2]
            count += 1
            heights = {name: of[kind == "line"] for name, of in HEIGHTS.items()}
            yield event, kind, f"[contact]\nM = {M}\nL = {L}\n{shape}{OIL}{text.format(**heights)}"


def solved(program, deck, name, *settings):
    """The columns of /transient, and the longest step of the run."""
    table, said = deck.with_name(f"{name}.txt"), deck.with_name(f"{name}.out")
    if not table.exists():
        result = deck.with_name("out.h5")
        command = [program, "run", deck, "--quiet", "--overwrite", "--threads", "1", "--output", result]
        command += [word for setting in settings for word in ("--set", setting)]
        said.write_text(subprocess.run(command, capture_output=True, text=True).stdout)
        table.write_text(subprocess.run([program, "extract", result, "transient"], capture_output=True, text=True).stdout)
    lines = table.read_text().splitlines()
    names = next(line for line in lines if line.startswith("# time"))[2:].split()
    rows = [[float(word) for word in line.split()] for line in lines if not line.startswith("#")]
    longest = said.read_text().split("longest allowed ")[1].split()[0]
    return {name: [row[k] for row in rows] for k, name in enumerate(names)}, float(longest)


def value_at(run, name, time):
    times, values = run["time"], run[name]
    k = bisect.bisect_left(times, time)
    if k in (0, len(times)) or times[min(k, len(times) - 1)] == time:
        return values[min(k, len(times) - 1)]
    share = (time - times[k - 1]) / (times[k] - times[k - 1])
    return values[k - 1] + share * (values[k] - values[k - 1])


def main(program, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    print("event,contact,number,times,times held [%],median bar/error,median error")
    ratios, held, times = {n: [] for n in NUMBERS}, {n: 0 for n in NUMBERS}, {n: 0 for n in NUMBERS}
    for event, kind, text in cases():
        deck = folder / f"{event}_{kind}.ini"
        deck.write_text(text)
        cells = CELLS[kind]
        own, longest = solved(
            program, deck, deck.stem + "_own", f"grid.cells={cells}", "transient.error=on"
        )
        fine, _ = solved(
            program,
            deck,
            deck.stem + "_fine",
            f"grid.cells={2 * cells}",
            f"transient.rtol={FINER}",
            f"transient.max_step={longest / 2}",
        )
        for number in NUMBERS:
            pairs = []
            for time, value, bar in zip(own["time"], own[number], own["error_" + number]):
                pairs.append((bar * abs(value), abs(value - value_at(fine, number, time))))
            within = sum(bar >= error for bar, error in pairs)
            of_case = [bar / max(error, 1e-12) for bar, error in pairs]
            ratios[number] += of_case
            held[number] += within
            times[number] += len(pairs)
            largest = max(abs(value) for value in own[number])
            print(
                f"{event},{kind},{number},{len(pairs)},{100 * within / len(pairs):.1f},"
                f"{statistics.median(of_case):.2g},{statistics.median(e for _, e in pairs) / largest:.1e}"
            )
    for number in NUMBERS:
        print(f"# {number}: {held[number]} of {times[number]} held, median {statistics.median(ratios[number]):.2g}")
    print(f"# all: {sum(held.values())} of {sum(times.values())} held, "
          f"median {statistics.median([r for of in ratios.values() for r in of]):.2g}")


if __name__ == "__main__":
    main(*sys.argv[1:])
