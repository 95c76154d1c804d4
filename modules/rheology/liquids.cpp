#include "rheology/liquids.hpp"

#include <cmath>

#include "rheology/elementary.hpp"
#include "rheology/range.hpp"
#include "rheology/spans.hpp"

namespace ehl::rheology {
namespace {

constexpr double ln_10 = 2.302585092994045684;

// 1 - v of Tait's equation at u = p/K0; NaN for u <= -1/(1 + K0').
Lanes compression(Lanes u, double K0_prime) {
  const double factor = 1.0 + K0_prime;
  return log1p(factor * u) / factor;
}

// d ln eta_bar/d(p/K0) of Doolittle's law at Tait's relative volume v.
template <class Number>
Number doolittle_slope(double B, double R0, double K0_prime, Number u, Number v) {
  return B * R0 / ((v - R0) * (v - R0) * (1.0 + (1.0 + K0_prime) * u));
}

}  // namespace

Tait make_tait(double K0, double K0_prime, double p_h) { return {K0_prime, p_h / K0}; }
Murnaghan make_murnaghan(double K0, double K0_prime, double p_h) { return {K0_prime, p_h / K0}; }

Doolittle make_doolittle(const DoolittleConstants& c, double p_h) {
  Doolittle law{c.B, c.R0, c.K0_prime, p_h / c.K0, 0.0, 0.0, 0.0};
  law.log_glass = std::log(glass_viscosity / c.eta0);
  const double v = c.R0 + 1.0 / (law.log_glass / (c.B * c.R0) + 1.0 / (1.0 - c.R0));
  law.u_glass = std::expm1((1.0 + c.K0_prime) * (1.0 - v)) / (1.0 + c.K0_prime);
  law.slope_glass = doolittle_slope(c.B, c.R0, c.K0_prime, law.u_glass, v);
  return law;
}

double yasutomi_eta0(const YasutomiConstants& c) {
  const double x0 = c.T - c.Tg0;
  return c.eta_g * std::exp(-ln_10 * c.C1 * x0 / (c.C2 + x0));
}

Yasutomi make_yasutomi(const YasutomiConstants& c, double p_h) {
  Yasutomi law{c.T - c.Tg0, c.A1, c.A2, c.b1, c.b2, c.C1, c.C2, p_h, 0.0, 0.0, 0.0};
  law.p_glass = std::expm1(law.x0 / c.A1) / c.A2;
  law.log_glass = ln_10 * c.C1 * law.x0 / (c.C2 + law.x0);
  law.slope_glass =
      ln_10 * c.C1 / c.C2 * c.A1 * c.A2 / (1.0 + c.A2 * law.p_glass) * std::exp(c.b2 * std::log1p(c.b1 * law.p_glass));
  return law;
}

// ln eta_bar = B R0 (1 - v)/[(v - R0)(1 - R0)]: accurate for v near one.
void log_eta(const Doolittle& law, std::span<const double> P, std::span<double> out) {
  const double factor = law.B * law.R0 / (1.0 - law.R0);
  apply(P, out, [&](Lanes p) {
    const Lanes u = law.p_h_over_K0 * p;
    const Lanes compressed = compression(u, law.K0_prime);
    const Lanes below = factor * compressed / (1.0 - law.R0 - compressed);
    return u > law.u_glass ? law.log_glass + law.slope_glass * (u - law.u_glass) : below;
  });
}

void log_eta_slope(const Doolittle& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes p) {
    const Lanes u = law.p_h_over_K0 * p;
    const Lanes below = doolittle_slope(law.B, law.R0, law.K0_prime, u, 1.0 - compression(u, law.K0_prime));
    return law.p_h_over_K0 * (u > law.u_glass ? broadcast(law.slope_glass) : below);
  });
}

// With y = x0 - x: ln eta_bar = ln(10) C1 C2 y/[(C2 + x0)(C2 + x0 - y)], accurate for small y.
void log_eta(const Yasutomi& law, std::span<const double> P, std::span<double> out) {
  const double factor = ln_10 * law.C1 * law.C2 / (law.C2 + law.x0);
  apply(P, out, [&](Lanes P_here) {
    const Lanes p = law.p_h * P_here;
    const Lanes F_less_one = expm1(law.b2 * log1p(law.b1 * p));
    const Lanes rise = law.A1 * log1p(law.A2 * p);  // Tg - Tg0
    const Lanes y = rise + (rise - law.x0) * F_less_one;
    const Lanes below = factor * y / (law.C2 + law.x0 - y);
    return p > law.p_glass ? law.log_glass + law.slope_glass * (p - law.p_glass) : below;
  });
}

void log_eta_slope(const Yasutomi& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes P_here) {
    const Lanes p = law.p_h * P_here;
    const Lanes F = exp(law.b2 * log1p(law.b1 * p));
    const Lanes above_Tg = law.x0 - law.A1 * log1p(law.A2 * p);  // T - Tg
    const Lanes fall = F * (law.A1 * law.A2 / (1.0 + law.A2 * p) - above_Tg * (law.b1 * law.b2) / (1.0 + law.b1 * p));
    const Lanes denominator = law.C2 + above_Tg * F;
    const Lanes below = (ln_10 * law.C1 * law.C2) * fall / (denominator * denominator);
    return law.p_h * (p > law.p_glass ? broadcast(law.slope_glass) : below);
  });
}

void rho(const Tait& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes p) { return 1.0 / (1.0 - compression(law.p_h_over_K0 * p, law.K0_prime)); });
}

void rho_slope(const Tait& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes p) {
    const Lanes u = law.p_h_over_K0 * p;
    const Lanes v = 1.0 - compression(u, law.K0_prime);
    return law.p_h_over_K0 / (v * v * (1.0 + (1.0 + law.K0_prime) * u));
  });
}

void rho(const Murnaghan& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes p) { return exp(log1p(law.K0_prime * law.p_h_over_K0 * p) / law.K0_prime); });
}

void rho_slope(const Murnaghan& law, std::span<const double> P, std::span<double> out) {
  apply(P, out, [&](Lanes p) {
    const Lanes w = law.K0_prime * law.p_h_over_K0 * p;
    return law.p_h_over_K0 * exp(log1p(w) * (1.0 / law.K0_prime - 1.0));
  });
}

}  // namespace ehl::rheology
