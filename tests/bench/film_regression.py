"""The film of a point contact as a function of M, L* and R_x/R_y: fitted to our own solutions, for modules/contact.

L* is Moes' L with alpha*, 1/alpha* = int_0^inf eta0/eta dp: one number for any viscosity law. The solutions to fit were
made with one oil of Roelands, whose L is its slope at ambient pressure; alpha* of that oil converts it.

python3 tests/bench/film_regression.py collect TABLE.csv...   the tables of `ehl sweep inputs/campaigns/film_map.ini`
                                                              into film_map.csv.gz (cases to fit)
python3 tests/bench/film_regression.py hold-out TABLE.csv...  likewise into ../reference/film_map_held_out.csv (never
                                                              fitted)
python3 tests/bench/film_regression.py                        fits, and writes the coefficients of
                                                              modules/contact/film_map_coefficients.hpp, the deviations
                                                              film_regression.csv, the picture film_regression.png

With B the film of Nijenbanning, Venner and Moes (1994) and H_RI, H_EI, H_00, H_RP, H_EP its asymptotes,
    ln(H_c/B), ln(H_m/H_c) = sum c_ijk T_i(u) T_j(v) T_k(w),   i/n_u + j/n_v + k/n_w <= 1.2
    u = asinh(2 (ln(plateau/H_RI) - 0.3)), plateau^3 = (H_EI^-4 + H_00^-4)^(-3/4) + (H_RP^-8 + H_EP^-8)^(-3/8),
    v = ln(1 + L*), w = ln(R_x/R_y), each scaled to -1..1 on the range of the data and held at its ends beyond: there
the film follows the powers of the asymptotes. In Moes' units.
"""

import csv
import gzip
import io
import math
import pathlib
import sys

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
HOUSE = HERE.parents[1]
OILS = HERE.parent / "reference" / "film_map_oils.csv"  # other oils: film_map_oils.py
FITTED, HELD_OUT = HERE / "film_map.csv.gz", HERE.parent / "reference" / "film_map_held_out.csv"
DEGREES = (12, 6, 4)
BUDGET = 1.2
SLOPE, EXPONENT, P0 = 2.2e-8, 0.68, 1.96e8  # for the oil of the fit: alpha, z and p0 of inputs/campaigns/film_map.ini
COLUMNS = ["M", "radius_ratio", "L", "Hc", "error_Hc", "Hm", "error_Hm"]
LARGEST_ERROR = 0.01
NOTE = {
    FITTED: "# Solved point contacts, entrainment along R_x: inputs/campaigns/film_map.ini. H = h R_x/a^2, errors relative.\n",
    HELD_OUT: "# Solved point contacts that no fit has seen, a Sobol sequence: inputs/campaigns/film_map_held_out.csv.\n",
}


def collect(path, tables):
    """The solved cases of sweeps whose error bars of both films are below one per cent."""
    rows, left = {}, 0
    for table in tables:
        lines = [line for line in pathlib.Path(table).read_text().splitlines() if not line.startswith("#")]
        for row in csv.DictReader(lines):
            bars = [float(row[f"error_{film}_best"] or "nan") for film in ("Hc", "Hm")]
            if row["status"] != "converged" or not max(bars) <= LARGEST_ERROR:
                left += 1
                continue
            key = tuple(float(row[f"contact.{part}"]) for part in ("M", "radius_ratio", "L"))
            rows[key] = [float(row["Hc_best"]), bars[0], float(row["Hm_best"]), bars[1]]
    text = io.StringIO()
    text.write(NOTE[path] + ",".join(COLUMNS) + "\n")
    for key in sorted(rows):
        text.write(",".join(f"{value:.9g}" for value in [*key, *rows[key]]) + "\n")
    data = text.getvalue().encode()
    path.write_bytes(gzip.compress(data, mtime=0) if path.suffix == ".gz" else data)
    print(f"{path.name}: {len(rows)} cases; {left} left out: not solved, or an error bar above {LARGEST_ERROR:g}")


def alpha_star(slope, z, p0):
    """1/int eta0/eta dp of Roelands' law, by the trapezoidal rule in ln of the pressure: exact to rounding."""
    at = np.linspace(-45.0, 15.0, 6001)
    p = np.exp(at) / slope
    fluidity = np.exp(-slope * p0 / z * np.expm1(z * np.log1p(p / p0)))
    return 1.0 / float(np.sum(fluidity * p) * (at[1] - at[0]))


def rows_of(path):
    data = path.read_bytes()
    text = (gzip.decompress(data) if path.suffix == ".gz" else data).decode()
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def read(path, L="L"):
    """L is L*: as the table has it, or converted from the slope of the oil of the fit."""
    rows = rows_of(path)
    data = {column: np.array([float(row[L if column == "L" else column]) for row in rows]) for column in COLUMNS}
    if L == "L":
        data["L"] *= alpha_star(SLOPE, EXPONENT, P0) / SLOPE
    return data


def moes_over_H(M, q):
    """Film in Moes' units over H = h R_x/a^2: (3 M/2)^(2/3) of Hertz' ellipse in a/R_x = a_1 (3W/2)^(1/3)."""
    return (1.5 * M) ** (2.0 / 3.0) * np.vectorize(lambda one: hertz(one)[1])(q) ** 2


def elliptic(m):
    """Complete elliptic integrals K(m), E(m), m < 1 also below 0, by the arithmetic-geometric mean."""
    a, b, c, power, total = 1.0, math.sqrt(1.0 - m), None, 0.5, m / 2.0
    while abs(a - b) > 1e-15 * a:
        a, b, c = (a + b) / 2.0, math.sqrt(a * b), (a - b) / 2.0
        power *= 2.0
        total += power * c * c
    K = math.pi / (2.0 * a)
    return K, K * (1.0 - total)


def hertz(q):
    """kappa = b/a, and a/R_x over (3 W/2)^(1/3), of the gap x^2/2R_x + q y^2/2R_x; W = F/(E' R_x^2)."""

    def curvatures(kappa):  # of the deformation by the Hertz pressure along x and y, in a common unit
        if abs(kappa - 1.0) < 1e-9:
            return math.pi / 4.0, math.pi / 4.0
        m = 1.0 - kappa**2 if kappa < 1.0 else 1.0 - kappa**-2
        K, E = elliptic(m)
        if kappa < 1.0:
            return (K - E) / m, (E / kappa**2 - K) / m
        return (E * kappa**2 - K) / m / kappa**3, (K - E) / m / kappa**3

    low, high = 1e-4, 2e4
    for _ in range(200):
        kappa = math.sqrt(low * high)
        along, across = curvatures(kappa)
        low, high = (kappa, high) if across / along > q else (low, kappa)
    return kappa, (4.0 / math.pi * along) ** (1.0 / 3.0)


def asymptotes(M, L, q):
    elastic = 1.0 + 0.006 * np.log(q) + 0.63 * q ** (4 / 7)
    return (
        145.0 * (1.0 + 0.796 * q ** (14 / 15)) ** (-15 / 7) / q / M**2,
        1.29 * (1.0 + 0.691 * q) ** (-2 / 3) * L ** (2 / 3),
        3.18 * elastic ** (-14 / 25) * q ** (-1 / 15) * M ** (-2 / 15),
        1.48 * elastic ** (-7 / 20) * q ** (-1 / 24) * M ** (-1 / 12) * L**0.75,
        1.8 / q,
    )


def base_and_place(M, L, q):
    """B, and ln(plateau/H_RI)."""
    RI, RP, EI, EP, H0 = asymptotes(M, np.maximum(L, 1e-9), q)
    elastic = (EI**-4 + H0**-4) ** (-1 / 4)
    piezoviscous = np.where(L > 0, (RP**-8 + EP**-8) ** (-1 / 8), 0.0)
    s = np.where(L > 0, 1.5 * (1.0 + np.exp(-1.2 * EI / EP)), 1.5)
    B = ((RI**1.5 + elastic**1.5) ** (2 * s / 3) + piezoviscous**s) ** (1 / s)
    return B, np.log((elastic**3 + piezoviscous**3) ** (1 / 3) / RI)


def places(M, L, q):
    """B and the three variables u, v, w, not yet scaled."""
    B, x = base_and_place(M, L, q)
    return B, (np.arcsinh(2.0 * (x - 0.3)), np.log1p(L), np.log(q))


TERMS = [
    (i, j, k)
    for i in range(DEGREES[0] + 1)
    for j in range(DEGREES[1] + 1)
    for k in range(DEGREES[2] + 1)
    if i / DEGREES[0] + j / DEGREES[1] + k / DEGREES[2] <= BUDGET + 1e-12
]


def matrix(variables, ranges):
    T = []
    for value, (low, high), degree in zip(variables, ranges, DEGREES):
        at = np.clip(2.0 * (value - low) / (high - low) - 1.0, -1.0, 1.0)
        T.append(np.polynomial.chebyshev.chebvander(at, degree))
    return np.stack([T[0][:, i] * T[1][:, j] * T[2][:, k] for i, j, k in TERMS], axis=1)


def solve(A, target):
    return np.linalg.lstsq(A, target, rcond=1e-10)[0]


def scatter(deviation):
    return float(np.sqrt(np.mean(deviation**2))), float(np.max(np.abs(deviation)))


def targets(data):
    B, variables = places(data["M"], data["L"], data["radius_ratio"])
    scale = moes_over_H(data["M"], data["radius_ratio"])
    return variables, np.log(data["Hc"] * scale / B), np.log(data["Hm"] / data["Hc"])


def cross_validated(A, target, folds=10):
    """Deviation of every case from a fit made without it."""
    fold = np.random.default_rng(1).integers(0, folds, len(target))
    left = np.empty_like(target)
    for f in range(folds):
        out = fold == f
        left[out] = target[out] - A[out] @ solve(A[~out], target[~out])
    return left


def hamrock_dowson(M, L, q):
    """Films in H of the formula, entrainment along the smaller radius; U = 1e-11, on which it hardly depends."""
    U = 1e-11
    W, G = M * (2 * U) ** 0.75, L / (2 * U) ** 0.25
    k = np.vectorize(lambda one: hertz(one)[0])(q)
    central = 2.69 * U**0.67 * G**0.53 * W**-0.067 * (1.0 - 0.61 * np.exp(-0.73 * k))
    minimum = 3.63 * U**0.68 * G**0.49 * W**-0.073 * (1.0 - np.exp(-0.68 * k))
    return central / np.sqrt(2 * U), minimum / np.sqrt(2 * U)  # Moes' units


def header(ranges, of_Hc, of_Hm, scatters, oils):
    def numbers(values):
        lines = [", ".join(f"{value:.9g}" for value in values[n : n + 6]) for n in range(0, len(values), 6)]
        return ",\n    ".join(lines)

    text = "#pragma once\n// Written by tests/bench/film_regression.py, which has the formula.\nnamespace ehl::contact::film_map_data {\n\n"
    text += f"inline constexpr int degrees[3] = {{{', '.join(map(str, DEGREES))}}};\n"
    text += f"inline constexpr double budget = {BUDGET};\n"
    text += "// Ranges of u, v, w.\ninline constexpr double low[3] = {" + ", ".join(f"{a:.17g}" for a, _ in ranges) + "};\n"
    text += "inline constexpr double high[3] = {" + ", ".join(f"{b:.17g}" for _, b in ranges) + "};\n"
    text += "// alpha* of the oil of the fit [1/Pa].\n"
    text += f"inline constexpr double alpha_star = {alpha_star(SLOPE, EXPONENT, P0):.9g};\n"
    for what, deviations in (("from solutions with the oil of the fit that were not used in it", scatters), ("of solutions with other oils", oils)):
        text += f"// Root mean square and largest deviation {what}.\n"
        of = "" if deviations is scatters else "oils_"
        for name, (rms, most) in deviations.items():
            text += f"inline constexpr double {of}rms_{name} = {rms:.4f}, {of}largest_{name} = {most:.4f};\n"
    for name, values in (("of_Hc", of_Hc), ("of_Hm", of_Hm)):
        text += f"// clang-format off\ninline constexpr double {name}[{len(values)}] = {{\n    {numbers(values)}}};\n// clang-format on\n"
    return text + "\n}  // namespace ehl::contact::film_map_data\n"


def picture(data, left_c, left_m):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(2, 3, figsize=(11, 6), sharey=True, constrained_layout=True)
    for row, (left, name) in enumerate(((left_c, "$H_c$"), (left_m, "$H_m$"))):
        for column, (of, label, log) in enumerate((("M", "M", True), ("L", "L*", False), ("radius_ratio", "$R_x/R_y$", True))):
            at = axes[row][column]
            at.scatter(data[of], 100.0 * left, s=4, c=np.log(data["radius_ratio"]), cmap="viridis", linewidths=0)
            at.axhline(0.0, color="k", linewidth=0.5)
            if log:
                at.set_xscale("log")
            at.set_xlabel(label)
        axes[row][0].set_ylabel(f"{name}: fit without it\nless the solution [%]")
    figure.suptitle("Deviation of the fitted film against position; colour: $R_x/R_y$")
    figure.savefig(HERE / "film_regression.png", dpi=110)


def main():
    data, held = read(FITTED), read(HELD_OUT)
    variables, of_Hc, of_ratio = targets(data)
    ranges = [(float(value.min()), float(value.max())) for value in variables]
    A = matrix(variables, ranges)
    left_c, left_ratio = cross_validated(A, of_Hc), cross_validated(A, of_ratio)
    coefficients = solve(A, of_Hc), solve(A, of_ratio)
    held_variables, held_c, held_ratio = targets(held)
    H = matrix(held_variables, ranges)
    off_c, off_ratio = held_c - H @ coefficients[0], held_ratio - H @ coefficients[1]
    rows = [("fit", "fitted", len(of_Hc), *scatter(of_Hc - A @ coefficients[0]),
             *scatter(of_Hc + of_ratio - A @ (coefficients[0] + coefficients[1]))),
            ("fit", "cross-validated", len(of_Hc), *scatter(left_c), *scatter(left_c + left_ratio)),
            ("fit", "held out", len(held_c), *scatter(off_c), *scatter(off_c + off_ratio))]
    others, names = read(OILS, "L_star"), [row["oil"] for row in rows_of(OILS)]
    others_variables, others_c, others_ratio = targets(others)
    O = matrix(others_variables, ranges)
    others_c, others_m = others_c - O @ coefficients[0], others_c + others_ratio - O @ (coefficients[0] + coefficients[1])
    oils = {"Hc": scatter(others_c), "Hm": scatter(others_m)}
    rows.append(("fit", "other oils", len(names), *oils["Hc"], *oils["Hm"]))
    for oil in dict.fromkeys(names):
        of = np.array([name == oil for name in names])
        rows.append(("fit", oil, int(of.sum()), *scatter(others_c[of]), *scatter(others_m[of])))
    scale = moes_over_H(held["M"], held["radius_ratio"])
    # The published formulas use the slope alpha, as in a report.
    slope_L = held["L"] * SLOPE / alpha_star(SLOPE, EXPONENT, P0)
    B, _ = places(held["M"], slope_L, held["radius_ratio"])
    published = np.log(held["Hc"] * scale / B)
    along = held["radius_ratio"] <= 1.0
    nan = (float("nan"), float("nan"))
    rows.append(("Nijenbanning Venner Moes 1994", "held out with R_x <= R_y", int(along.sum()), *scatter(published[along]), *nan))
    hard = along & (held["M"] >= 20) & (held["M"] <= 1000) & (slope_L >= 5) & (slope_L <= 20)
    for name, chosen in (("held out with R_x <= R_y, L >= 1", along & (slope_L >= 1)),
                         ("those with M 20 to 1000, L 5 to 20", hard)):
        films = hamrock_dowson(held["M"], slope_L, held["radius_ratio"])
        off = [np.log(held[film] * scale / of)[chosen] for film, of in zip(("Hc", "Hm"), films)]
        rows.append(("Hamrock Dowson 1977", name, int(chosen.sum()), *scatter(off[0]), *scatter(off[1])))
        rows.append(("fit", name, int(chosen.sum()), *scatter(off_c[chosen]), *scatter((off_c + off_ratio)[chosen])))
    with open(HERE / "film_regression.csv", "w", encoding="utf-8") as file:
        file.write("# Films by the fit to our own solutions and by published formulas, against solutions\n")
        file.write("# command: python3 tests/bench/film_regression.py\n")
        file.write("# ln(solution/formula): root mean square and largest; cases: film_map.csv.gz, held out: film_map_held_out.csv, other oils: film_map_oils.csv\n")
        file.write("formula,cases,number,rms_Hc,largest_Hc,rms_Hm,largest_Hm\n")
        for row in rows:
            file.write(",".join([row[0], row[1].replace(",", ""), str(row[2]), *(f"{value:.4f}" for value in row[3:])]) + "\n")
    scatters = {"Hc": rows[2][3:5], "Hm": rows[2][5:7]}
    (HOUSE / "modules/contact/film_map_coefficients.hpp").write_text(header(ranges, *coefficients, scatters, oils))
    picture(data, -left_c, -(left_c + left_ratio))
    print((HERE / "film_regression.csv").read_text())


if __name__ == "__main__":
    if len(sys.argv) > 2 and sys.argv[1] == "collect":
        collect(FITTED, sys.argv[2:])
    elif len(sys.argv) > 2 and sys.argv[1] == "hold-out":
        collect(HELD_OUT, sys.argv[2:])
    elif len(sys.argv) == 1:
        main()
    else:
        sys.exit(__doc__)
