#include "rheology/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "core/errors.hpp"
#include "rheology/elementary.hpp"
#include "rheology/spans.hpp"

namespace ehl::rheology {
namespace {

// Dowson and Higginson: the density increases by 34 % at infinite pressure.
constexpr double compression = 0.34;
// Values per block of the loops below: a block fits into the first-level cache.
constexpr std::size_t chunk = 64;

void log_eta(Isoviscous, std::span<const double> P, std::span<double> out) {
  apply(P, out, [](Lanes) { return Lanes{}; });
}
void log_eta(const Barus& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes p) { return law.alpha_bar * p; });
}
// In two loops: iterations of a loop with one elementary function overlap in the processor, those with a chain of two
// or three do not.
void log_eta(const Roelands& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes p) {
    const Lanes u = law.p_h_over_p0 * p;
    // At the pole the power is 0, and the formula would give a number that looks valid.
    return u > -1.0 ? law.z * log1p(u) : broadcast(NAN);
  });
  apply(out, out, [&](Lanes power) { return law.alpha_p0_over_z * expm1(power); });
}

void log_eta_slope(Isoviscous, std::span<const double> P, std::span<double> out) {
  apply(P, out, [](Lanes) { return Lanes{}; });
}
void log_eta_slope(const Barus& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes) { return broadcast(law.alpha_bar); });
}
void log_eta_slope(const Roelands& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes p) {
    const Lanes u = law.p_h_over_p0 * p;
    return u > -1.0 ? (law.z - 1.0) * log1p(u) : broadcast(NAN);
  });
  const double factor = law.alpha_p0_over_z * law.z * law.p_h_over_p0;
  apply(out, out, [&](Lanes power) { return factor * exp(power); });
}

void rho(Incompressible, std::span<const double> P, std::span<double> out) {
  apply(P, out, [](Lanes) { return broadcast(1.0); });
}
void rho(const DowsonHigginson& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes p) {
    const Lanes v = law.p_h_over_B * p;
    return (1.0 + (1.0 + compression) * v) / (1.0 + v);
  });
}

void rho_slope(Incompressible, std::span<const double> P, std::span<double> out) {
  apply(P, out, [](Lanes) { return Lanes{}; });
}
void rho_slope(const DowsonHigginson& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes p) {
    const Lanes denominator = 1.0 + law.p_h_over_B * p;
    return (compression * law.p_h_over_B) / (denominator * denominator);
  });
}

template <class Law>
void reciprocal_eta(const Law& law, std::span<const double> P, std::span<double> out) {
  log_eta(law, P, out);
  apply(out, out, [](Lanes exponent) { return exp(-exponent); });
}
void reciprocal_eta(Isoviscous, std::span<const double>, std::span<double> out) { std::ranges::fill(out, 1.0); }

bool all_zero(std::span<const double> P) {
  Bits seen{};
  const std::size_t whole = P.size() / core::lanes * core::lanes;
  // Shifted by one bit to ignore the sign of a zero.
  for (std::size_t k = 0; k < whole; k += core::lanes) seen |= bits_of(core::load(&P[k])) << 1;
  bool zero = true;
  for (int lane = 0; lane < core::lanes; ++lane) zero = zero && seen[lane] == 0;
  for (std::size_t k = whole; k < P.size(); ++k) zero = zero && P[k] == 0.0;
  return zero;
}

// Calls f(P, out) block by block.
template <class Function>
void in_chunks(std::span<const double> P, std::span<double> out, Function f) {
  for (std::size_t k = 0; k < P.size(); k += chunk) {
    const std::size_t count = std::min(chunk, P.size() - k);
    f(P.subspan(k, count), out.subspan(k, count));
  }
}

}  // namespace

Barus make_barus(double alpha, double p_h) { return {alpha * p_h}; }

Roelands make_roelands(double alpha, double p0, double z, double p_h) { return {alpha * p0 / z, p_h / p0, z}; }

double roelands_log_ratio(double eta0) { return std::log(eta0) + 9.67; }

double roelands_z(double alpha, double p0, double eta0) {
  const double log_ratio = roelands_log_ratio(eta0);
  if (!(log_ratio > 0.0)) {
    throw core::InputError("lubricant.eta0 = " + std::to_string(eta0) +
                           " Pa s: Roelands' law needs more than 6.3e-5 Pa s, or a given z");
  }
  return alpha * p0 / log_ratio;
}

DowsonHigginson make_dowson_higginson(double p_h) { return {p_h / dowson_higginson_B}; }

void fluidity(const ViscosityLaw& law, std::span<const double> P, std::span<double> fluidity) {
  std::visit([&](const auto& v) { in_chunks(P, fluidity, [&](auto p, auto out) { reciprocal_eta(v, p, out); }); }, law);
}

ViscosityLaw rescaled(const ViscosityLaw& law, double factor) {
  ViscosityLaw result = law;
  if (auto* barus = std::get_if<Barus>(&result)) barus->alpha_bar *= factor;
  if (auto* roelands = std::get_if<Roelands>(&result)) roelands->p_h_over_p0 *= factor;
  if (auto* doolittle = std::get_if<Doolittle>(&result)) doolittle->p_h_over_K0 *= factor;
  if (auto* yasutomi = std::get_if<Yasutomi>(&result)) yasutomi->p_h *= factor;
  if (auto* table = std::get_if<TabulatedViscosity>(&result)) table->p_h *= factor;
  return result;
}

DensityLaw rescaled(const DensityLaw& law, double factor) {
  DensityLaw result = law;
  if (auto* compressible = std::get_if<DowsonHigginson>(&result)) compressible->p_h_over_B *= factor;
  if (auto* tait = std::get_if<Tait>(&result)) tait->p_h_over_K0 *= factor;
  if (auto* murnaghan = std::get_if<Murnaghan>(&result)) murnaghan->p_h_over_K0 *= factor;
  if (auto* table = std::get_if<TabulatedDensity>(&result)) table->p_h *= factor;
  return result;
}

void log_viscosity(const ViscosityLaw& law, std::span<const double> P, std::span<double> log_eta_bar) {
  std::visit([&](const auto& v) { in_chunks(P, log_eta_bar, [&](auto p, auto out) { log_eta(v, p, out); }); }, law);
}

double log_viscosity_at(const ViscosityLaw& law, double P) {
  double log_eta_bar = 0.0;
  log_viscosity(law, {&P, 1}, {&log_eta_bar, 1});
  return log_eta_bar;
}

void log_viscosity_slope(const ViscosityLaw& law, std::span<const double> P, std::span<double> slope) {
  std::visit([&](const auto& v) { in_chunks(P, slope, [&](auto p, auto out) { log_eta_slope(v, p, out); }); }, law);
}

void density(const DensityLaw& law, std::span<const double> P, std::span<double> rho_bar) {
  std::visit([&](const auto& d) { rho(d, P, rho_bar); }, law);
}

void density_slope(const DensityLaw& law, std::span<const double> P, std::span<double> drho_bar) {
  std::visit([&](const auto& d) { rho_slope(d, P, drho_bar); }, law);
}

namespace {

// fluidity_of(law, p, first, count): values of the nodes first .. first + count - 1, p their pressures; p empty: P = 0.
template <class Fluidity>
void properties_in_chunks(const ViscosityLaw& viscosity, const DensityLaw& density, std::span<const double> P,
                          std::span<double> rho_bar, Fluidity fluidity_of) {
  // The density is visited block by block, because instantiating all pairs of laws would multiply the code.
  std::visit(
      [&](const auto& v) {
        for (std::size_t k = 0; k < P.size(); k += chunk) {
          const std::size_t count = std::min(chunk, P.size() - k);
          const auto p = P.subspan(k, count);
          const auto rho_out = rho_bar.subspan(k, count);
          // Downstream of the outlet everything is cavitated and needs no exponentials.
          if (all_zero(p)) {
            fluidity_of(v, std::span<const double>{}, k, count);
            std::ranges::fill(rho_out, 1.0);
          } else {
            fluidity_of(v, p, k, count);
            std::visit([&](const auto& d) { rho(d, p, rho_out); }, density);
          }
        }
      },
      viscosity);
}

}  // namespace

void film_properties(const ViscosityLaw& viscosity, const DensityLaw& density, std::span<const double> P,
                     std::span<double> fluidity, std::span<double> rho_bar) {
  properties_in_chunks(viscosity, density, P, rho_bar,
                       [&](const auto& law, std::span<const double> p, std::size_t first, std::size_t count) {
                         const auto out = fluidity.subspan(first, count);
                         if (p.empty())
                           std::ranges::fill(out, 1.0);
                         else
                           reciprocal_eta(law, p, out);
                       });
}

void film_properties(const ViscosityLaw& viscosity, const DensityLaw& density, std::span<const double> P,
                     std::span<double> log_eta_bar, std::span<double> fluidity, std::span<double> rho_bar) {
  properties_in_chunks(viscosity, density, P, rho_bar,
                       [&](const auto& law, std::span<const double> p, std::size_t first, std::size_t count) {
                         const auto exponent = log_eta_bar.subspan(first, count);
                         const auto out = fluidity.subspan(first, count);
                         if (p.empty()) {
                           std::ranges::fill(exponent, 0.0);
                           std::ranges::fill(out, 1.0);
                         } else {
                           log_eta(law, p, exponent);
                           apply(exponent, out, [](Lanes a) { return exp(-a); });
                         }
                       });
}

void thin_log_viscosity(std::span<const double> oil_fluidity, std::span<const double> fluidity,
                        std::span<double> log_eta_bar) {
  for (std::size_t first = 0; first < fluidity.size(); first += chunk) {
    const std::size_t count = std::min(chunk, fluidity.size() - first);
    std::array<double, chunk> more{};
    for (std::size_t k = 0; k < count; ++k)
      more[k] = oil_fluidity[first + k] > 0.0 ? fluidity[first + k] / oil_fluidity[first + k] - 1.0 : 0.0;
    const std::span<double> logarithm(more.data(), count);
    apply(logarithm, logarithm, [](Lanes x) { return log1p(x); });
    for (std::size_t k = 0; k < count; ++k) log_eta_bar[first + k] -= more[k];
  }
}

}  // namespace ehl::rheology
