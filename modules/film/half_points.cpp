#include "film/half_points.hpp"

#include <algorithm>
#include <cstddef>

#include "core/simd.hpp"

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

// epsilon at a vector of faces; `read` loads the values of a span for them.
template <class Read>
Lanes epsilon_of(const AroundLines& around, const Between& how, Read read) {
  const auto& [H, rho, phi, a] = around;
  return epsilon_between<Lanes>({{read(H[0]), read(H[1]), read(H[2]), read(H[3])},
                                 {read(rho[0]), read(rho[1])},
                                 {read(phi[0]), read(phi[1])},
                                 {read(a[0]), read(a[1])}},
                                how);
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
  constexpr std::size_t width = core::lanes;
  const std::size_t whole = eps.size() / width * width;
  for (std::size_t k = 0; k < whole; k += width)
    core::store(&eps[k],
                epsilon_of(around, how, [k](std::span<const double> values) { return core::load(&values[k]); }));
  if (whole == eps.size()) return;
  std::array<double, width> last{};
  core::store(last.data(), epsilon_of(around, how, [whole](std::span<const double> values) {
                std::array<double, width> padded{};
                std::copy(values.begin() + static_cast<std::ptrdiff_t>(whole), values.end(), padded.begin());
                return core::load(padded.data());
              }));
  for (std::size_t k = whole; k < eps.size(); ++k) eps[k] = last[k - whole];
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
