#pragma once
// Film of a point contact as a function of M, L* and R_x/R_y, fitted to solutions of this program.
#include <optional>
#include <string>

#include "contact/ellipse.hpp"

namespace ehl::contact {

/// Films in Moes' units based on R_x.
struct MappedFilm {
  double central;
  double minimum;
};

/// With B = nijenbanning_venner_moes() and its asymptotes, Chebyshev polynomials T, R_e along the entrainment, R_s
/// across:
///   ln(H_c/B), ln(H_m/H_c) = sum c_ijk T_i(u) T_j(v) T_k(w),
///   u = asinh(2 (ln(plateau/H_RI) - 0.3)), plateau^3 = (H_EI^-4 + H_00^-4)^(-3/4) + (H_RP^-8 + H_EP^-8)^(-3/8),
///   v = ln(1 + L*), w = ln(R_e/R_s), scaled to -1..1 on the range of the solutions.
/// L* is Moes' L with alpha*, 1/alpha* = int_0^inf eta0/eta dp, also in B and the asymptotes; with L* oils of different
/// viscosity laws have nearly the same film.
/// in: M > 0, L_star >= 0. out: nullopt outside M = 0.2 to 2000, L* = 0 to 23.4, R_e/R_s = 0.1 to 2.5 (all based on
/// R_e), for entrainment at an angle to the axes, and for lines and rollers. limits: smooth, isothermal, flooded;
/// fitted to one oil with Roelands' viscosity and Dowson and Higginson's density. Its density at the Hertz pressure is
/// a function of M and L*, p_h = alpha_bar*/alpha_star_of_film_map(); for an oil of another density the film differs by
/// up to the ratio of the densities. source: tests/bench/film_map.csv.gz, fitted by tests/bench/film_regression.py.
std::optional<MappedFilm> film_map(double M, double L_star, const Ellipse& shape);

/// Range of film_map() in words: "M = 0.2 to 2000, ...".
std::string range_of_film_map();

/// alpha* of the oil of the fit [1/Pa].
double alpha_star_of_film_map();

/// Root mean square and largest relative deviation of the fit from solutions not used in the fit.
struct MapScatter {
  double rms_central, largest_central;
  double rms_minimum, largest_minimum;
};
/// Deviations from solutions with the oil of the fit, including isoviscous ones (L* = 0).
MapScatter scatter_of_film_map();
/// Deviations from solutions with other compressible oils: named oils, data sheet oils, other laws. source:
/// tests/reference/film_map_oils.csv.
MapScatter scatter_of_other_oils();

}  // namespace ehl::contact
