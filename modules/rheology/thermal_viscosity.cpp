#include "rheology/thermal_viscosity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/errors.hpp"
#include "rheology/elementary.hpp"
#include "rheology/spans.hpp"

namespace ehl::rheology {
namespace {

constexpr double ln_10 = 2.302585092994045684;
// Temperature at which all of Roelands' oils have their pole [K].
constexpr double roelands_pole = 138.0;

struct Change {
  Lanes D, slope;  ///< slope: dD/dtheta
};

// Change of the viscosity at ambient pressure.
Change ambient_change(const Exponential& law, double T0, Lanes theta) {
  const double slope = -law.beta * T0;
  return {slope * theta, broadcast(slope)};
}
Change ambient_change(const Houpert& law, double T0, Lanes theta) {
  const double scale = T0 / (T0 - roelands_pole);
  const Lanes E = law.A * expm1(-law.S0 * log1p(scale * theta));
  return {E, -law.S0 * scale * (law.A + E) / (1.0 + scale * theta)};
}
Change ambient_change(const Vogel& law, double T0, Lanes theta) {
  const double scale = T0 / (T0 - law.C);
  const Lanes inverse = 1.0 / (1.0 + scale * theta);
  const double slope = -law.B / (T0 - law.C) * scale;
  const Lanes inside = scale * theta > -1.0 ? slope * theta * inverse : broadcast(NAN);
  return {inside, slope * inverse * inverse};
}

// nu with nu + 0.7 + exp(-1.47 - 1.84 nu - 0.51 nu^2) = Z; Z' = dZ/dnu.
struct Kinematic {
  Lanes nu, Z_slope;
};
Kinematic kinematic(Lanes Z) {
  Lanes nu = Z - 0.7, slope = broadcast(1.0);
  // Newton's method: the exponential is below 0.23 and decreases, so a few steps from nu = Z - 0.7 reach rounding.
  for (int step = 0; step < 4; ++step) {
    const Lanes term = exp(-1.47 - nu * (1.84 + 0.51 * nu));
    slope = 1.0 - term * (1.84 + 1.02 * nu);
    nu -= (nu + 0.7 + term - Z) / slope;
  }
  return {nu, slope};
}
Change ambient_change(const DataSheet& law, double T0, Lanes theta) {
  // Z = 10^(10^(A - B lg T)).
  const double log_Z0 = ln_10 * std::pow(10.0, law.walther.A - law.walther.B * std::log10(T0));
  const Lanes log_Z = log_Z0 * exp(-law.walther.B * log1p(theta));
  const Kinematic here = kinematic(exp(log_Z)), there = kinematic(exp(broadcast(log_Z0)));
  // rho15 exp[-x (1 + 0.8 x)], x = a (T - 15 C).
  const double a = 0.6278 / law.density15, x0 = a * (T0 - zero_celsius - 15.0);
  const Lanes dx = (a * T0) * theta;
  const Lanes expansion = -dx * (1.0 + 1.6 * x0 + 0.8 * dx);
  const Lanes D = log1p((here.nu - there.nu) / there.nu) + expansion;
  const Lanes Z_theta = -law.walther.B * log_Z / (1.0 + theta) * exp(log_Z);
  const Lanes slope = Z_theta / (here.Z_slope * here.nu) - (a * T0) * (1.0 + 1.6 * x0 + 1.6 * dx);
  return {theta == 0.0 ? Lanes{} : D, slope};
}

Change change(const BarusOfT& law, Lanes, Lanes, Lanes theta) {
  return std::visit([&](const auto& ambient) { return ambient_change(ambient, law.T0, theta); }, law.ambient);
}
Change change(const RoelandsOfT& law, Lanes, Lanes log_eta, Lanes theta) {
  const Change E = std::visit([&](const auto& a) { return ambient_change(a, law.T0, theta); }, law.ambient);
  const Lanes power = 1.0 + law.inverse_A * log_eta;  // (1 + p/p0)^z
  return {power * E.D, power * E.slope};
}

// With v = (1 + a dT)(1 - c), c = ln[1 + (1 + K0') u]/(1 + K0'), u = p/K0(T), R = R0 (1 + e dT):
//   ln eta_bar = B (R - R0 v)/[(v - R)(1 - R0)] = factor n/d,   n = R/R0 - v,   d = v - R.
Change change(const DoolittleOfT& law, Lanes P, Lanes log_eta, Lanes theta) {
  const Doolittle& at = law.at_T0;
  const double a = law.volume.a_V, e = law.occupied_expansion, K = 1.0 + at.K0_prime;
  const double factor = at.B / (1.0 - at.R0) * at.R0;
  const Lanes dT = law.T0 * theta;
  const Lanes u0 = at.p_h_over_K0 * P;
  const Lanes du = u0 * expm1(law.volume.beta_K * dT);
  const Lanes u = u0 + du;
  const Lanes c0 = log1p(K * u0) / K;
  const Lanes dc = log1p(K * du / (1.0 + K * u0)) / K;
  const Lanes volume = 1.0 + a * dT;
  // The changes of n and d vanish with theta.
  const Lanes n0 = c0, d0 = 1.0 - at.R0 - c0;
  const Lanes dn = dc * volume + (a * c0 - (a - e)) * dT;
  const Lanes dd = -dc + (a * (1.0 - c0 - dc) - at.R0 * e) * dT;
  const Lanes d = d0 + dd;
  const Lanes u_slope = law.volume.beta_K * u;  // du/dT
  const Lanes v_slope = a * (1.0 - c0 - dc) - volume * u_slope / (1.0 + K * u);
  const Lanes n_slope = e - v_slope, d_slope = v_slope - at.R0 * e;
  const Lanes fluid = factor * (dn * d0 - n0 * dd) / (d0 * d);
  const Lanes fluid_slope = factor * (n_slope * d - (n0 + dn) * d_slope) / (d * d);

  // Glass transition at this temperature: v_g with factor n/d = log_glass.
  const Lanes R = at.R0 * (1.0 + e * dT);
  const Lanes v_g = R + (1.0 + e * dT) / (at.log_glass / (at.B * at.R0) + 1.0 / (1.0 - at.R0));
  const Lanes K_u_g = expm1(K * (1.0 - v_g / volume));
  const Lanes u_g = K_u_g / K;
  // d ln eta_bar/dv = -factor (1 + e dT)(1 - R0)/d^2, dv/du = -volume/(1 + K u).
  const Lanes d_g = v_g - R;
  const Lanes slope_g = factor * (1.0 + e * dT) * (1.0 - at.R0) * volume / (d_g * d_g * (1.0 + K_u_g));
  const Lanes beyond = at.log_glass + slope_g * (u - u_g);
  // Derivative of u_g with T at constant ln eta, and rotation of the tangent.
  const Lanes v_g_slope = (at.R0 * e) + e * d_g / (1.0 + e * dT);
  const Lanes u_g_slope = (1.0 + K_u_g) * (v_g * a / volume - v_g_slope) / volume;
  const Lanes log_turn =
      e / (1.0 + e * dT) + a / volume - 2.0 * (v_g_slope - at.R0 * e) / d_g - K * u_g_slope / (1.0 + K_u_g);
  const Lanes beyond_slope = slope_g * (u_slope - u_g_slope + log_turn * (u - u_g));

  const auto glass_here = u > u_g, glass_at_T0 = u0 > at.u_glass;
  const Lanes liquid = glass_at_T0 ? factor * (n0 + dn) / d - log_eta : fluid;
  const Lanes D = glass_here ? beyond - log_eta : liquid;
  return {theta == 0.0 ? Lanes{} : D, law.T0 * (glass_here ? beyond_slope : fluid_slope)};
}

// x = (T - Tg) F, ln(eta/eta_g) = -ln(10) C1 x/(C2 + x).
Change change(const YasutomiOfT& law, Lanes P, Lanes log_eta, Lanes theta) {
  const Yasutomi& at = law.at_T0;
  const Lanes dT = law.T0 * theta;
  const Lanes p = at.p_h * P;
  const Lanes F = exp(at.b2 * log1p(at.b1 * p));
  const Lanes x_at_T0 = (at.x0 - at.A1 * log1p(at.A2 * p)) * F;
  const Lanes dx = dT * F;
  const Lanes before = at.C2 + x_at_T0, here = before + dx;
  const double factor = ln_10 * at.C1 * at.C2;
  const Lanes fluid = -factor * dx / (before * here);
  const Lanes fluid_slope = -factor * F / (here * here);

  // Glass transition at this temperature: x = 0, with d ln eta/dx = -ln(10) C1/C2 and dx/dp = -F dTg/dp.
  const Lanes A2_p_g = expm1((at.x0 + dT) / at.A1);
  const Lanes p_g = A2_p_g / at.A2;
  const Lanes F_g = exp(at.b2 * log1p(at.b1 * p_g));
  const Lanes slope_g = (ln_10 * at.C1 / at.C2 * at.A1 * at.A2) * F_g / (1.0 + A2_p_g);
  const Lanes beyond = at.log_glass + slope_g * (p - p_g);
  const Lanes p_g_slope = (1.0 + A2_p_g) / (at.A1 * at.A2);
  const Lanes log_turn = at.b1 * at.b2 / (1.0 + at.b1 * p_g) * p_g_slope - 1.0 / at.A1;
  const Lanes beyond_slope = slope_g * (log_turn * (p - p_g) - p_g_slope);

  const auto glass_here = p > p_g, glass_at_T0 = p > at.p_glass;
  // ln eta_bar = log_glass - ln(10) C1 x/(C2 + x).
  const Lanes liquid = glass_at_T0 ? at.log_glass - (ln_10 * at.C1) * (x_at_T0 + dx) / here - log_eta : fluid;
  const Lanes D = glass_here ? beyond - log_eta : liquid;
  return {theta == 0.0 ? Lanes{} : D, law.T0 * (glass_here ? beyond_slope : fluid_slope)};
}

[[noreturn]] void refuse(const char* law, const char* what) {
  throw core::InputError(std::string("viscosity = ") + law + ": a thermal film needs " + what);
}
const AmbientViscosity& ambient_of(const char* law, const TemperatureConstants& constants) {
  if (!constants.ambient)
    refuse(
        law,
        "the viscosity against temperature at ambient pressure: beta, two kinematic viscosities, or Vogel's B and C");
  return *constants.ambient;
}

}  // namespace

ThermalViscosity make_thermal_viscosity(const ViscosityLaw& law, const TemperatureConstants& constants) {
  const double T0 = constants.T0;
  if (std::holds_alternative<Barus>(law)) return BarusOfT{T0, ambient_of("barus", constants)};
  if (const auto* roelands = std::get_if<Roelands>(&law))
    return RoelandsOfT{T0, ambient_of("roelands", constants), 1.0 / roelands->alpha_p0_over_z};
  if (const auto* yasutomi = std::get_if<Yasutomi>(&law)) return YasutomiOfT{T0, *yasutomi};
  if (const auto* doolittle = std::get_if<Doolittle>(&law)) {
    if (!constants.volume) refuse("doolittle", "a_V and beta_K, the volume against temperature");
    return DoolittleOfT{T0, *doolittle, *constants.volume, constants.occupied_expansion};
  }
  if (std::holds_alternative<Isoviscous>(law)) refuse("isoviscous", "a viscosity that falls with temperature");
  refuse("table", "a viscosity that falls with temperature; a table against pressure has none");
}

ThermalViscosity rescaled(const ThermalViscosity& law, double factor) {
  ThermalViscosity result = law;
  if (auto* doolittle = std::get_if<DoolittleOfT>(&result))
    doolittle->at_T0 = std::get<Doolittle>(rescaled(ViscosityLaw{doolittle->at_T0}, factor));
  if (auto* yasutomi = std::get_if<YasutomiOfT>(&result))
    yasutomi->at_T0 = std::get<Yasutomi>(rescaled(ViscosityLaw{yasutomi->at_T0}, factor));
  return result;
}

Houpert make_houpert(double beta, double eta0, double T0) {
  const double A = roelands_log_ratio(eta0);
  return {beta * (T0 - roelands_pole) / A, A};
}

double log_ambient_change(const AmbientViscosity& ambient, double T0, double T) {
  const Lanes theta = broadcast((T - T0) / T0);
  return std::visit([&](const auto& law) { return ambient_change(law, T0, theta).D[0]; }, ambient);
}

void log_viscosity_change(const ThermalViscosity& law, std::span<const double> P, std::span<const double> log_eta,
                          std::span<const double> theta, std::span<double> D, std::span<double> dD) {
  constexpr std::size_t width = core::lanes;
  const auto one_register = [&](const auto& v, const double* p, const double* l, const double* t, double* d,
                                double* s) {
    const Change result = change(v, core::load(p), core::load(l), core::load(t));
    core::store(d, result.D);
    core::store(s, result.slope);
  };
  std::visit(
      [&](const auto& v) {
        const std::size_t whole = P.size() / width * width;
        for (std::size_t k = 0; k < whole; k += width) one_register(v, &P[k], &log_eta[k], &theta[k], &D[k], &dD[k]);
        if (whole == P.size()) return;
        std::array<double, width> p{}, l{}, t{}, d{}, s{};
        const std::size_t rest = P.size() - whole;
        std::copy_n(&P[whole], rest, p.data());
        std::copy_n(&log_eta[whole], rest, l.data());
        std::copy_n(&theta[whole], rest, t.data());
        one_register(v, p.data(), l.data(), t.data(), d.data(), s.data());
        std::copy_n(d.data(), rest, &D[whole]);
        std::copy_n(s.data(), rest, &dD[whole]);
      },
      law);
}

}  // namespace ehl::rheology
