#pragma once
// The film of a point contact as a function of M, L and R_x/R_y, fitted to our own solutions.
#include <optional>

#include "contact/ellipse.hpp"

namespace ehl::contact {

/// Films in Moes' units with R_x.
struct MappedFilm {
  double central;
  double minimum;
};

/// With B of nijenbanning_venner_moes() and its asymptotes, Chebyshev's T, R_e along the entrainment and R_s across it:
///   ln(H_c/B), ln(H_m/H_c) = sum c_ijk T_i(u) T_j(v) T_k(w),
///   u = asinh(2 (ln(plateau/H_RI) - 0.3)), plateau^3 = (H_EI^-4 + H_00^-4)^(-3/4) + (H_RP^-8 + H_EP^-8)^(-3/8),
///   v = ln(1 + L), w = ln(R_e/R_s), scaled to -1..1 on the range of the solutions.
/// in: M > 0, L >= 0. out: nothing outside M = 0.2 to 2000, L = 0 to 25, R_e/R_s = 0.1 to 2.5 (all with R_e), for an
/// entrainment at an angle to the axes, and for lines and rollers. limits: smooth, isothermal, flooded; oils of
/// Roelands with z = 0.68 and of Dowson and Higginson with alpha = 22/GPa, on which the film hardly depends beyond M
/// and L. source: tests/bench/film_map.csv.gz, fitted by tests/bench/film_regression.py.
std::optional<MappedFilm> film_map(double M, double L, const Ellipse& shape);

/// Root mean square and largest deviation of the fit from solutions that it has not seen, relative.
struct MapScatter {
  double rms_central, largest_central;
  double rms_minimum, largest_minimum;
};
MapScatter scatter_of_film_map();

}  // namespace ehl::contact
