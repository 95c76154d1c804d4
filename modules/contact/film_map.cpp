#include "contact/film_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/film_formulas.hpp"
#include "contact/film_map_coefficients.hpp"

namespace ehl::contact {

namespace data = film_map_data;

namespace {

constexpr double least_M = 0.2, most_M = 2000.0, most_L_star = 23.4, least_ratio = 0.1, most_ratio = 2.5;
constexpr double rounding = 1e-9;  // tolerance for bounds computed in the frame of the entrainment

constexpr int most_degree = std::max({data::degrees[0], data::degrees[1], data::degrees[2]});
using Polynomials = std::array<double, most_degree + 1>;

// T_0 to T_n of a variable, clamped to the range of the fit.
Polynomials chebyshev(int variable, double value) {
  const double low = data::low[variable], high = data::high[variable];
  const double t = std::clamp(2.0 * (value - low) / (high - low) - 1.0, -1.0, 1.0);
  Polynomials T{1.0, t};
  for (std::size_t n = 2; n < T.size(); ++n) T[n] = 2.0 * t * T[n - 1] - T[n - 2];
  return T;
}

// ln(plateau/H_RI): transition from the rigid isoviscous asymptote.
double beyond_rigid(const Asymptotes& H, double L) {
  const double elastic = std::pow(std::pow(H.elastic_isoviscous, -4.0) + std::pow(H.unloaded, -4.0), -0.75);
  const double piezoviscous =
      L > 0.0 ? std::pow(std::pow(H.rigid_piezoviscous, -8.0) + std::pow(H.elastic_piezoviscous, -8.0), -0.375) : 0.0;
  return std::log(std::cbrt(elastic + piezoviscous) / H.rigid_isoviscous);
}

}  // namespace

std::optional<MappedFilm> film_map(double M, double L_star, const Ellipse& shape) {
  if (line(shape) || roller(shape) || gap(shape).oblique()) return std::nullopt;
  const AlongEntrainment at = along_entrainment(shape, M, L_star);
  const auto within = [](double value, double least, double most) {
    return value >= least * (1.0 - rounding) && value <= most * (1.0 + rounding);
  };
  if (!within(at.M, least_M, most_M) || !within(at.L, 0.0, most_L_star) ||
      !within(at.radius_ratio, least_ratio, most_ratio))
    return std::nullopt;
  const Asymptotes H = asymptotes(at.M, at.L, at.radius_ratio);
  const Polynomials u = chebyshev(0, std::asinh(2.0 * (beyond_rigid(H, at.L) - 0.3)));
  const Polynomials v = chebyshev(1, std::log1p(at.L));
  const Polynomials w = chebyshev(2, std::log(at.radius_ratio));
  double log_central = 0.0, log_ratio = 0.0;
  int term = 0;
  for (int i = 0; i <= data::degrees[0]; ++i)
    for (int j = 0; j <= data::degrees[1]; ++j)
      for (int k = 0; k <= data::degrees[2]; ++k) {
        const double total = static_cast<double>(i) / data::degrees[0] + static_cast<double>(j) / data::degrees[1] +
                             static_cast<double>(k) / data::degrees[2];
        if (total > data::budget + 1e-12) continue;
        const double T =
            u[static_cast<std::size_t>(i)] * v[static_cast<std::size_t>(j)] * w[static_cast<std::size_t>(k)];
        log_central += data::of_Hc[term] * T;
        log_ratio += data::of_Hm[term] * T;
        ++term;
      }
  const double central = nijenbanning_venner_moes(M, L_star, shape) * std::exp(log_central);
  return MappedFilm{central, central * std::exp(log_ratio)};
}

std::string range_of_film_map() {
  return fmt::format("M = {:g} to {:g}, L* = 0 to {:g}, R_x/R_y = {:g} to {:g}", least_M, most_M, most_L_star,
                     least_ratio, most_ratio);
}

double alpha_star_of_film_map() { return data::alpha_star; }

MapScatter scatter_of_film_map() { return {data::rms_Hc, data::largest_Hc, data::rms_Hm, data::largest_Hm}; }

MapScatter scatter_of_other_oils() {
  return {data::oils_rms_Hc, data::oils_largest_Hc, data::oils_rms_Hm, data::oils_largest_Hm};
}

}  // namespace ehl::contact
