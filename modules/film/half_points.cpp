#include "film/half_points.hpp"

#include <algorithm>

#include "core/spans.hpp"

namespace ehl::film {
namespace {

using core::Lanes;

// Change of fluidity_between() with changes of the two ln eta_bar.
double fluidity_change(const AroundHalfPoint<double>& at, const AroundHalfPoint<double>& change, double least) {
  const auto [phi0, phi1] = at.fluidity;
  const auto [da0, da1] = change.log_viscosity;
  const double f = logarithmic_mean(at);
  const double share = followed(f, 0.5 * least * (phi0 + phi1));
  const double of_bound = -0.5 * least * (phi0 * da0 + phi1 * da1) * (1.0 - 0.5 * share * (1.0 + share));
  if (share == 0.0) return of_bound;
  const double d = at.log_viscosity[1] - at.log_viscosity[0];
  const bool close = d * d < series_below * series_below;
  const double f0 = close ? -phi0 * (0.5 - d * (1.0 / 6.0 - d / 24.0)) : (f - phi0) / d;
  const double f1 = close ? -phi1 * (0.5 + d * (1.0 / 6.0 + d / 24.0)) : (phi1 - f) / d;
  return share * (f0 * da0 + f1 * da1) + of_bound;
}

}  // namespace

double epsilon_change(const AroundHalfPoint<double>& at, const AroundHalfPoint<double>& change, const Between& how) {
  const double H = film_between(at.H);
  const bool limited = H == 0.25 * (at.H[1] + at.H[2]);
  const double dH = limited ? 0.25 * (change.H[1] + change.H[2])
                            : (9.0 * (change.H[1] + change.H[2]) - (change.H[0] + change.H[3])) / 16.0;
  const double rho = 0.5 * (at.rho_bar[0] + at.rho_bar[1]);
  const double drho = 0.5 * (change.rho_bar[0] + change.rho_bar[1]);
  const double f = fluidity_between(at, how.least);
  const double df = fluidity_change(at, change, how.least);
  return H * H / how.lambda * (drho * H * f + 3.0 * rho * dH * f + rho * H * df);
}

void epsilon_between_stations(const AroundLines& around, const Between& how, std::span<double> eps) {
  const auto& [H, rho, phi, a] = around;
  core::in_registers(
      std::array{H[0], H[1], H[2], H[3], rho[0], rho[1], phi[0], phi[1], a[0], a[1]}, std::array{eps},
      [&](Lanes H0, Lanes H1, Lanes H2, Lanes H3, Lanes rho0, Lanes rho1, Lanes phi0, Lanes phi1, Lanes a0, Lanes a1) {
        return std::array{epsilon_between<Lanes>({{H0, H1, H2, H3}, {rho0, rho1}, {phi0, phi1}, {a0, a1}}, how)};
      });
}

void epsilon_between_nodes(const AlongStation& along, const Between& how, std::span<double> eps) {
  const std::size_t faces = along.rho_bar.size() - 1;
  const auto from = [faces](std::span<const double> values, std::size_t k) { return values.subspan(k, faces); };
  const auto two = [&](std::span<const double> values) { return std::array{from(values, 0), from(values, 1)}; };
  epsilon_between_stations({{from(along.H, 0), from(along.H, 1), from(along.H, 2), from(along.H, 3)},
                            two(along.rho_bar),
                            two(along.fluidity),
                            two(along.log_viscosity)},
                           how, eps.first(faces));
}

}  // namespace ehl::film
