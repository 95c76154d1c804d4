"""Ball on disc: film against speed with error bars and a formula, and traction against sliding with heat.

python3 ball_on_disc.py [PICTURE.png [CELLS]]
"""

import sys

import ehl
import matplotlib.pyplot as plt
import numpy as np

BALL = {
    "case": {"title": "steel ball on glass"},
    "contact": {"load": 20, "radius_x": 9.525e-3, "E1": 206e9, "nu1": 0.3, "E2": 81e9, "nu2": 0.208},
    "motion": {"u_m": 1.0},
    "lubricant": {"fluid": "pao40", "temperature": 40},
}
HEAT = {
    "thermal": {"T_oil": 40, "solid1": "steel", "solid2": "glass"},
    "shear": {"law": "eyring", "tau_0": 5e6},
    "friction": {"cavitated": "striated"},
}


def film_against_speed(axes, speeds, cells):
    for temperature in (40, 80):
        results = [
            ehl.run(BALL, motion={"u_m": u_m}, lubricant={"temperature": temperature}, grid={"cells": cells})
            for u_m in speeds
        ]
        for name, style in (("hc", "o-"), ("hm", "s--")):
            film = [1e9 * r[f"/summary/{name}"] for r in results]
            bars = [1e9 * (r[f"/summary/{name}"].bar or 0) for r in results]
            axes.errorbar(speeds, film, bars, fmt=style, capsize=3, label=f"{name}, {temperature} °C")
        formulas = [{one["name"]: one["hc_m"] for one in r.json["formulas"]} for r in results]
        axes.plot(speeds, [1e9 * one["Hamrock, Dowson 1977"] for one in formulas], "k:", linewidth=1,
                  label="hc, Hamrock and Dowson" if temperature == 40 else None)
    axes.set(xscale="log", yscale="log", xlabel="entrainment speed [m/s]", ylabel="film [nm]")


def traction_against_sliding(axes, ratios, cells):
    results = [ehl.run(BALL, motion={"srr": srr}, grid={"cells": cells}, **HEAT) for srr in ratios]
    axes.plot(ratios, [r.mu_isothermal for r in results], "k:", label="isothermal")
    axes.errorbar(ratios, [r.mu for r in results], [r.mu.bar or 0 for r in results], fmt="o-", capsize=3,
                  label="with heat")
    warm = axes.twinx()
    warm.plot(ratios, [r.T_film_max for r in results], "r--", label="hottest film")
    warm.set_ylabel("above the oil [K]", color="r")
    axes.set(xlabel="slide-roll ratio", ylabel="friction coefficient", ylim=(0, None))


def main(picture="ball_on_disc.png", cells=256):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4))
    film_against_speed(left, np.geomspace(0.1, 2, 5), int(cells))
    traction_against_sliding(right, [0.01, 0.05, 0.1, 0.3, 0.6, 1.0], int(cells))
    for axes in (left, right):
        axes.legend(fontsize=8)
    figure.suptitle(BALL["case"]["title"] + ", PAO 40, 20 N")
    figure.tight_layout()
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    main(*sys.argv[1:])
