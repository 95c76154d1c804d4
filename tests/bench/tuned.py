"""What a tuned number does on a map of contacts: solutions, work and convergence with other values of it.

python3 tests/bench/tuned.py EHL FOLDER MAP[,MAP...] [VALUES ...]
python3 tests/bench/tuned.py EHL FOLDER bars:MAP[,MAP...] [VALUES ...]   error bars on the map's cells, which it must
                                                                          give, against four times as many

VALUES: section.number=value, several joined by + ("steady.widest_step=400+newton.patience=40"), as `ehl keys tuning`
lists them. The first line is that of the defaults. Solves what FOLDER does not hold yet, with one thread. A map may be
thinned: lines/3 takes every third contact.
"""

import os
import pathlib
import statistics
import sys

import kept_runs

INPUTS = pathlib.Path(__file__).resolve().parents[2] / "inputs"
MAP, HEAT, HOT_LINE = "hard/stability_map.ini", "thermal/heat_map.ini", "thermal/line_map.ini"
M_OF_MAP, L_OF_MAP = (2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000), (0, 2, 5, 10, 15, 20, 25)
RATIOS = (0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 5, 20, 50, 100, 200)
LINE = "contact.kind=line"
RUBS = ("motion.srr=0.3", "contact.a_over_R=0.01", "friction.cavitated=striated")


def contacts(deck, *settings, **varied):
    """Every combination of the values of the keys; '__' in a key stands for the point."""
    found = [list(settings)]
    for key, values in varied.items():
        found = [one + [f"{key.replace('__', '.')}={value}"] for one in found for value in values]
    return [(deck, tuple(one)) for one in found]


MAPS = {
    "circles": contacts(MAP, contact__M=M_OF_MAP, contact__L=L_OF_MAP),
    "circles2": contacts(MAP, "discretization.wedge=upstream2", contact__M=M_OF_MAP, contact__L=L_OF_MAP),
    "coarse": contacts(MAP, contact__M=(5, 20, 100, 500, 2000), contact__L=(0, 5, 10, 20), grid__cells=(64, 128)),
    "zero": contacts(MAP, "domain.far_field=zero", contact__M=M_OF_MAP, contact__L=(0, 5, 10, 20)),
    "lines": contacts(MAP, LINE, contact__M=(1, *M_OF_MAP[:-1]), contact__L=L_OF_MAP),
    "heavy": contacts(MAP, LINE, contact__M=[round(150 * (3200 / 150) ** (k / 12)) for k in range(13)],
                      contact__L=range(16, 30, 2), grid__cells=(1024,)),
    "slender": contacts(MAP, contact__radius_ratio=RATIOS, contact__M=(20, 100, 1000), contact__L=(5, 10, 15)),
    "ellipses": contacts(MAP, contact__radius_ratio=(0.05, 0.2, 5, 20), contact__M=(2, 20, 100, 1000),
                         contact__L=(0, 10, 15), motion__angle=(0, 30), grid__cells=(128,)),
    "starved": contacts(MAP, "contact.L=10", contact__M=(20, 50, 200), supply__H_oil=(0.02, 0.1, 0.3, 0.6, 1, 2),
                        grid__cells=(128,)) +
               contacts(MAP, "contact.L=5", LINE, contact__M=(5, 20, 100), supply__H_oil=(0.05, 0.2, 0.5, 1)) +
               contacts(MAP, "contact.M=20", "supply.passes=4", contact__L=(2, 10), supply__H_oil=(0.05, 0.2), grid__cells=(128,)),
    "thin": contacts(MAP, "contact.L=10", "multigrid.tolerance=1e-9", contact__M=(20, 50, 200, 1000),
                     supply__H_oil=(0.003, 0.007, 0.02, 0.05), grid__cells=(64, 128)) +
            contacts(MAP, "contact.M=50", "domain.x_inlet=-2.5", "domain.x_outlet=1.5", "domain.y_half=2", "grid.cells=64",
                     contact__L=(0, 5, 10), supply__H_oil=(0.012, 0.025, 0.1), multigrid__tolerance=(1e-9,)) +
            contacts(MAP, "contact.M=20", "supply.passes=20", "grid.cells=96", contact__L=(0, 10), supply__H_oil=(0.04, 0.1)),
    "passes": contacts(MAP, "supply.passes=20", contact__M=(20, 100), contact__L=(0, 5, 10), supply__H_oil=(0.02, 0.05, 0.1),
                       grid__cells=(64,)),
    "hot": contacts(HEAT, contact__load=(4.59, 36.7, 123.9, 293.7, 573.6), motion__u_m=(20, 8, 3, 1, 0.3, 0.1),
                    motion__srr=(0, 0.1, 0.5, 1, 2)),
    "hot_lines": contacts(HOT_LINE, contact__load_per_length=(0.7e5, 2.78e5, 11e5), motion__u_m=(10, 3, 1), motion__srr=(0, 0.5, 2)),
    "transient": contacts(MAP, LINE, "transient.end_time=2", "transient.load_wave=0.3 2", contact__M=(1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000), contact__L=(0, 2, 5, 10, 15)),
    "points": contacts(MAP, contact__M=(10, 50, 200), contact__L=(5, 12), grid__errors=("adjoint", "levels"), grid__cells=(256,)),
    "layers": contacts(MAP, "grid.cells=128", contact__M=(10, 50, 200), contact__L=(5, 12), supply__H_oil=(0.05, 0.2, 0.6)) +
              contacts(MAP, "grid.cells=64", "supply.passes=4", contact__M=(20, 100), contact__L=(5,), supply__H_oil=(0.1, 0.4)),
    "line_bars": contacts(MAP, LINE, contact__M=(2, 10, 50, 200, 1000), contact__L=(0, 5, 10, 20), grid__cells=(128, 256)),
    "friction": contacts(MAP, *RUBS, contact__M=(10, 50, 200), contact__L=(5, 12), grid__cells=(64, 128)) +
                contacts(MAP, LINE, *RUBS, contact__M=(10, 50, 200), contact__L=(5, 12), grid__cells=(64, 128, 256)),
    "jumps": [(deck, (*settings, *drive)) for deck, settings in
              contacts(MAP, "transient.end_time=0.6", contact__M=(20, 200), contact__L=(5, 15), grid__cells=(64,)) +
              contacts(MAP, LINE, "transient.end_time=0.6", contact__M=(20, 200), contact__L=(5, 15))
              for drive in (("transient.load=0.3:1 0.3:3",), ("transient.load=0.3:1 0.3:0.2",), ("transient.load=0:3 1:3",),
                            ("transient.u1=0.3:1 0.3:0.2", "transient.u2=0.3:1 0.3:0.2"), ("transient.u1=0:0.1 1:0.1", "transient.u2=0:0.1 1:0.1"))],
    "newton": contacts(MAP, "multigrid.polish=always", contact__M=(5, 20, 100, 500), contact__L=(0, 5, 10, 20), grid__cells=(64, 128)) +
              contacts(MAP, "multigrid.polish=always", LINE, contact__M=(5, 20, 100, 500), contact__L=(0, 5, 10, 20)),
    "from_hertz": contacts(MAP, "tuning.multigrid.patience=1", "tuning.multigrid.hardly_less=5e-4", "continuation.path=off", contact__M=(20, 100, 500), contact__L=(0, 10, 20), grid__cells=(64, 128)) +
                  contacts(MAP, LINE, "tuning.multigrid.patience=1", "tuning.multigrid.hardly_less=5e-4", "continuation.path=off", contact__M=(20, 100, 500), contact__L=(0, 10, 20)),
    "accuracy": contacts(MAP, "domain.far_field=zero", contact__M=(20, 200), contact__L=(5, 10), grid__accuracy=(0.02,)) +
                contacts(MAP, LINE, "domain.far_field=zero", contact__M=(5, 20, 200), contact__L=(0, 10), grid__accuracy=(0.02, 0.005)),
    "hot_starved": contacts(HOT_LINE, contact__load_per_length=(0.7e5, 2.78e5), motion__u_m=(10, 3), supply__H_oil=(0.3, 1), grid__cells=(512, 2048)),
    "light": contacts(MAP, contact__M=(0.5, 1, 2, 3, 5), contact__L=(0, 5), domain__far_field=("zero", "closed")),
    "in_time": [(f"transient/{name}.ini", ("grid.cells=64", *more)) for name, *more in (
        ("bump", "transient.end_time=1"), ("load_step",), ("impact",), ("vibration",), ("start_stop",),
        ("load_sine", "transient.end_time=2"), ("load_ramp",))] +
        [("starved/start_stop.ini", ("grid.cells=64",)), ("starved/impact.ini", ("grid.cells=64",)),
         ("line/moving_ridge.ini", ()), ("line/tooth_load.ini", ())],
}


def map_of(name):
    name, _, every = name.partition("/")
    return MAPS[name][::int(every or 1)]


def solved(program, folder, case, values):
    deck, settings = case
    name = "_".join([deck.replace("/", "-"), *settings, *values]).replace("contact.", "")
    settings += tuple(f"tuning.{value}" for value in values)
    run = kept_runs.solved(program, INPUTS / deck, folder / f"{name}.json", *settings, output=folder / f"{os.getpid()}.h5")
    if not run and "[tuning]" in (said := (folder / f"{name}.err").read_text()):
        sys.exit(said)
    return run


def work_of(run):
    """Work units of all levels on the finest grid; passes with heat; cycles and Newton steps of a run in time."""
    if in_time := run.get("transient"):
        return in_time["cycles"] + in_time["newton_steps"]
    levels = run["thermal"]["levels"] if run.get("thermal") else run.get("levels") or []
    nodes = [(level["nx"] + 1) * (level["ny"] + 1) for level in levels]
    return sum(level.get("passes", level.get("work_units")) * n / nodes[-1] for level, n in zip(levels, nodes))


def value_of(run, name):
    """A number of the report; at the end of a run in time."""
    return {**run, **{key: value for part in ("friction", "thermal", "transient") for key, value in (run.get(part) or {}).items()}}.get(name)


def name_of(case):
    return " ".join(setting.split(".")[-1] for setting in case[1]) or case[0]


def compared(cases, before, now):
    """One line of what is solved, and of what differs from the runs before."""
    ok = [bool(run.get("converged")) for run in now]
    was = [bool(run.get("converged")) for run in before]
    both = [k for k in range(len(cases)) if ok[k] and was[k]]
    work = [work_of(now[k]) for k in both]
    words = [f"{sum(ok)}/{len(cases)} solved"]
    if both:
        total = sum(work_of(before[k]) for k in both)
        words.append(f"work {sum(work):.0f} ({100 * (sum(work) / max(total, 1e-9) - 1):+.1f} %), median {statistics.median(work):.1f}")
        first = sum(len(now[k].get("attempts") or []) <= 1 for k in both)
        words.append(f"first start {first}, seconds {sum(now[k].get('seconds') or 0 for k in both):.1f}")
        factors = [(now[k].get("cycle_factor") or 0, k) for k in both]
        words.append("factor {:.2f} ({})".format(*(lambda f: (f[0], name_of(cases[f[1]])))(max(factors))))
        rises = [(f - (before[k].get("cycle_factor") or f), k) for f, k in factors]
        if max(rises)[0] > 0.03:
            words.append("factor +{:.2f} ({}), {} above +0.03".format(max(rises)[0], name_of(cases[max(rises)[1]]), sum(r > 0.03 for r, _ in rises)))
        more = [(work_of(now[k]) / max(work_of(before[k]), 1e-9), k) for k in both]
        if max(more)[0] > 1.1 or min(more)[0] < 0.9:
            words.append("work x{:.2f} ({}) to x{:.2f} ({})".format(min(more)[0], name_of(cases[min(more)[1]]), max(more)[0], name_of(cases[max(more)[1]])))
        for name in ("Hc", "Hm_fitted", "mu"):
            values = [(value_of(before[k], name), value_of(now[k], name), value_of(before[k], "error_" + name), k) for k in both]
            moved = [(abs(new / old - 1), bar or 1, k) for old, new, bar, k in values if old and new]
            if moved and max(moved)[0] > 0:
                share, k = max((change / bar, k) for change, bar, k in moved)
                words.append(f"{name} moves in {sum(c > 0 for c, _, _ in moved)} by {max(moved)[0]:.1e}, {share:.2g} bars at most ({name_of(cases[k])})")
    lost = [name_of(cases[k]) for k in range(len(cases)) if was[k] and not ok[k]]
    gained = [name_of(cases[k]) for k in range(len(cases)) if ok[k] and not was[k]]
    for word, names in (("LOST", lost), ("gained", gained)):
        if names:
            words.append(f"{word} {len(names)}: " + "; ".join(names[:4]))
    return ", ".join(words)


BARS = {"Hc": "Hc", "Hm_fitted": "Hm_fitted", "Hc_extrapolated": "Hc", "Hm_extrapolated": "Hm_fitted", "P_max": "P_max",
        "mu": "mu", "T_film_max": "T_film_max"}


def finer(case):
    deck, settings = case
    return deck, tuple(f"grid.cells={4 * int(one.split('=')[1])}" if one.startswith("grid.cells") else one for one in settings)


def held(truths, now):
    """How many bars hold, of how many, and the median of bar over error."""
    words = []
    for name, true_name in BARS.items():
        rows = []
        for run, truth in zip(now, truths):
            value, bar, true = value_of(run, name), value_of(run, "error_" + name), value_of(truth, true_name)
            if run.get("converged") and truth.get("converged") and value and bar and true:
                rows.append((bar, abs(value / true - 1)))
        if rows:
            words.append(f"{name} {sum(error <= bar for bar, error in rows)}/{len(rows)} x{statistics.median(bar / max(error, 1e-9) for bar, error in rows):.2f}")
    return ", ".join(words)


def main(program, folder, maps, *variants):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    bars, maps = maps.startswith("bars:"), maps.removeprefix("bars:")
    for name in maps.split(","):
        cases = map_of(name)
        if bars:
            truths = [solved(program, folder, finer(case), ()) for case in cases]
            for variant in ("", *variants):
                now = [solved(program, folder, case, tuple(variant.split("+")) if variant else ()) for case in cases]
                print(f"{name}: {variant or 'defaults'}: {held(truths, now)}", flush=True)
            continue
        before = [solved(program, folder, case, ()) for case in cases]
        print(f"{name}: defaults: {compared(cases, before, before)}", flush=True)
        for variant in variants:
            now = [solved(program, folder, case, variant.split("+")) for case in cases]
            print(f"{name}: {variant}: {compared(cases, before, now)}", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
