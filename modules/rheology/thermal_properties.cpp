#include "rheology/thermal_properties.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/errors.hpp"
#include "rheology/elementary.hpp"
#include "rheology/spans.hpp"

namespace ehl::rheology {
namespace {

struct Density {
  Lanes ratio, expansion;
};

Density change(const ThermalDensity& law, const Expansion& by, Lanes P, Lanes theta) {
  const Lanes e0 = broadcast(by.e0 * law.T0), e = by.decay == 0.0 ? e0 : e0 * exp(-by.decay * P);
  return {exp(-e * theta), e};
}

// Murnaghan: rho_bar = (1 + K0' u)^(1/K0')/(1 + a dT); Tait: 1/[(1 - c)(1 + a dT)]; u = p/K0(T).
Density change(const Murnaghan& at, const VolumeOfTemperature& volume, double T0, Lanes P, Lanes theta) {
  const Lanes dT = T0 * theta;
  const Lanes w0 = at.K0_prime * at.p_h_over_K0 * P;
  const Lanes dw = w0 * expm1(volume.beta_K * dT);
  const Lanes expanded = 1.0 + volume.a_V * dT;
  const Lanes ratio = exp(log1p(dw / (1.0 + w0)) / at.K0_prime) / expanded;
  const Lanes growth = (w0 + dw) * volume.beta_K / ((1.0 + w0 + dw) * at.K0_prime);
  return {ratio, T0 * (volume.a_V / expanded - growth)};
}
Density change(const Tait& at, const VolumeOfTemperature& volume, double T0, Lanes P, Lanes theta) {
  const double K = 1.0 + at.K0_prime;
  const Lanes dT = T0 * theta;
  const Lanes u0 = at.p_h_over_K0 * P;
  const Lanes du = u0 * expm1(volume.beta_K * dT);
  const Lanes c0 = log1p(K * u0) / K;
  const Lanes dc = log1p(K * du / (1.0 + K * u0)) / K;
  const Lanes expanded = 1.0 + volume.a_V * dT;
  const Lanes left = 1.0 - c0 - dc;
  const Lanes growth = (u0 + du) * volume.beta_K / ((1.0 + K * (u0 + du)) * left);
  return {(1.0 - c0) / (left * expanded), T0 * (volume.a_V / expanded - growth)};
}

// f(P, theta, k) for one register at a time from k on; the remainder uses padded copies.
template <class Function>
void in_registers(std::span<const double> P, std::span<const double> theta, std::span<double> out,
                  std::span<double> second, Function f) {
  constexpr std::size_t width = core::lanes;
  for (std::size_t k = 0; k < P.size(); k += width) {
    const std::size_t count = std::min(width, P.size() - k);
    if (count == width) {
      const Density result = f(core::load(&P[k]), core::load(&theta[k]));
      core::store(&out[k], result.ratio);
      if (!second.empty()) core::store(&second[k], result.expansion);
      continue;
    }
    std::array<double, width> p{}, t{}, a{}, b{};
    std::copy_n(&P[k], count, p.data());
    std::copy_n(&theta[k], count, t.data());
    const Density result = f(core::load(p.data()), core::load(t.data()));
    core::store(a.data(), result.ratio);
    core::store(b.data(), result.expansion);
    std::copy_n(a.data(), count, &out[k]);
    if (!second.empty()) std::copy_n(b.data(), count, &second[k]);
  }
}

}  // namespace

ThermalDensity make_thermal_density(const DensityLaw& law, double T0,
                                    std::variant<Expansion, EquationOfState> expansion) {
  const bool liquid = std::holds_alternative<Tait>(law) || std::holds_alternative<Murnaghan>(law);
  if (std::holds_alternative<EquationOfState>(expansion) && !liquid)
    throw core::InputError(
        "density: a_V and beta_K belong to density = tait or murnaghan; the other laws need a coefficient of thermal "
        "expansion");
  return {T0, law, expansion};
}

ThermalDensity rescaled(const ThermalDensity& law, double factor) {
  ThermalDensity result{law.T0, rescaled(law.at_T0, factor), law.expansion};
  if (auto* by = std::get_if<Expansion>(&result.expansion)) by->decay *= factor;
  return result;
}

void density_change(const ThermalDensity& law, std::span<const double> P, std::span<const double> theta,
                    std::span<double> ratio, std::span<double> expansion) {
  if (const auto* by = std::get_if<Expansion>(&law.expansion)) {
    in_registers(P, theta, ratio, expansion, [&](Lanes p, Lanes t) { return change(law, *by, p, t); });
    return;
  }
  const VolumeOfTemperature& volume = std::get<EquationOfState>(law.expansion).volume;
  if (const auto* tait = std::get_if<Tait>(&law.at_T0))
    in_registers(P, theta, ratio, expansion, [&](Lanes p, Lanes t) { return change(*tait, volume, law.T0, p, t); });
  else if (const auto* murnaghan = std::get_if<Murnaghan>(&law.at_T0))
    in_registers(P, theta, ratio, expansion,
                 [&](Lanes p, Lanes t) { return change(*murnaghan, volume, law.T0, p, t); });
}

HeatLaw rescaled(const HeatLaw& law, double factor) {
  HeatLaw result = law;
  if (auto* measured = std::get_if<LarssonAndersson>(&result)) measured->p_h_in_GPa *= factor;
  return result;
}

void conductivity(const HeatLaw& law, std::span<const double> P, std::span<double> k_bar) {
  const auto* measured = std::get_if<LarssonAndersson>(&law);
  apply(P, k_bar, [&](Lanes p) {
    if (!measured) return broadcast(1.0);
    const Lanes GPa = measured->p_h_in_GPa * p;
    return 1.0 + 1.72 * GPa / (1.0 + 0.54 * GPa);
  });
}

void heat_capacity(const HeatLaw& law, std::span<const double> P, std::span<const double> theta,
                   std::span<double> rho_c_bar) {
  const auto* measured = std::get_if<LarssonAndersson>(&law);
  in_registers(P, theta, rho_c_bar, {}, [&](Lanes p, Lanes t) {
    if (!measured) return Density{broadcast(1.0), {}};
    const Lanes GPa = measured->p_h_in_GPa * p;
    const Lanes b = (9.3e-4 * measured->T0) * (1.0 + GPa * (1.4 - 0.51 * GPa));
    return Density{(1.0 + 0.47 * GPa / (1.0 + 0.81 * GPa)) * (1.0 + b * t), {}};
  });
}

}  // namespace ehl::rheology
