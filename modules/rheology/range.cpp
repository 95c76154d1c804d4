#include "rheology/range.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace ehl::rheology {
namespace {

std::string text(const char* format, double value) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

std::string gigapascals(double p) { return text("%.3g GPa", 1e-9 * p); }

// "at p_max = 1.2 GPa"
std::string state_of_pressure(const Loading& loading) {
  const double p_max = loading.P_max * loading.p_h;
  return "at " + (std::isfinite(p_max) ? "p_max = " + gigapascals(p_max) : text("P = %.3g p_h", loading.P_max));
}

// "at p_max = 1.2 GPa ln(eta/eta0) = 26 (alpha_bar P = 26)"
std::string state_of_oil(const Loading& loading, double log_eta, double alpha_bar) {
  return state_of_pressure(loading) + text(" ln(eta/eta0) = %.3g", log_eta) +
         text(" (alpha_bar P = %.3g)", alpha_bar * loading.P_max);
}

void judge(Isoviscous, const Loading&, std::vector<std::string>&) {}

void judge(const Barus& law, const Loading& loading, std::vector<std::string>& found) {
  const double log_eta = law.alpha_bar * loading.P_max;
  const double p_max = loading.P_max * loading.p_h;
  const bool known = std::isfinite(p_max);
  if (known ? !(p_max > barus_pressure) : !(log_eta > barus_log_viscosity)) return;
  const std::string range = known ? "up to about " + gigapascals(barus_pressure)
                                  : "up to ln(eta/eta0) of about " + text("%.2g", barus_log_viscosity) + ", " +
                                        gigapascals(barus_pressure) + " for a mineral oil,";
  found.push_back("Barus' viscosity beyond its range: " + state_of_oil(loading, log_eta, law.alpha_bar) +
                  "; it follows measured viscosities " + range +
                  " and is far too viscous above; viscosity = roelands is closer");
}

void judge(const Roelands& law, const Loading& loading, std::vector<std::string>& found) {
  const double log_eta = log_viscosity(law, loading.P_max);
  const double p_max = loading.P_max * loading.p_h;
  const double alpha_bar = law.alpha_p0_over_z * law.z * law.p_h_over_p0;
  const bool known = std::isfinite(loading.eta0);
  const double glass = known ? std::log(glass_viscosity / loading.eta0) : glass_log_viscosity;
  const std::string state = state_of_oil(loading, log_eta, alpha_bar);
  const std::string oil = known ? "eta0 = " + text("%.3g", loading.eta0) : std::string("an eta0 of 0.1");
  if (log_eta > glass)
    found.push_back(
        "Roelands' viscosity beyond its range: " + state + "; with " + oil + " Pa s the oil is a glass (" +
        text("%.0e Pa s) above ", glass_viscosity) + text("%.3g", glass) +
        " and shears as a solid: the film, made in the inlet, suffers little, friction cannot be had from it");
  else if (p_max > roelands_pressure)
    found.push_back("Roelands' viscosity extrapolated: " + state +
                    "; viscosities were measured up to about 1 GPa, and " + gigapascals(roelands_pressure) +
                    " is twice that");
}

// From the glass on a law goes along its tangent, and says so.
void judge_glass(const char* law, double P_glass, double log_eta, const Loading& loading,
                 std::vector<std::string>& found) {
  if (!(loading.P_max > P_glass)) return;
  found.push_back(std::string(law) + " viscosity beyond its range: " + state_of_pressure(loading) +
                  text(" ln(eta/eta0) = %.3g", log_eta) + "; the oil is a glass above " +
                  gigapascals(P_glass * loading.p_h) +
                  ", where the law is continued along its tangent: the film, made in the inlet, suffers little, "
                  "friction cannot be had from it");
}

void judge(const Doolittle& law, const Loading& loading, std::vector<std::string>& found) {
  judge_glass("Doolittle's", law.u_glass / law.p_h_over_K0, log_viscosity(law, loading.P_max), loading, found);
}

void judge(const Yasutomi& law, const Loading& loading, std::vector<std::string>& found) {
  judge_glass("Yasutomi's", law.p_glass / law.p_h, log_viscosity(law, loading.P_max), loading, found);
}

void judge_table(const char* what, const Curve& curve, double p_h, const Loading& loading,
                 std::vector<std::string>& found) {
  const double p_max = p_h * loading.P_max;
  if (!(p_max > curve.x.back())) return;
  found.push_back(std::string("the table of the ") + what + " was left: p_max = " + gigapascals(p_max) +
                  ", and it ends at " + gigapascals(curve.x.back()) + "; above it goes on along its last slope");
}

void judge(const TabulatedViscosity& law, const Loading& loading, std::vector<std::string>& found) {
  judge_table("viscosity", *law.curve, law.p_h, loading, found);
}

void judge(const TabulatedDensity& law, const Loading& loading, std::vector<std::string>& found) {
  judge_table("density", *law.curve, law.p_h, loading, found);
}

// Equations of state of liquids hold far beyond the pressures of contacts.
void judge(const Tait&, const Loading&, std::vector<std::string>&) {}
void judge(const Murnaghan&, const Loading&, std::vector<std::string>&) {}

void judge(Incompressible, const Loading&, std::vector<std::string>&) {}

void judge(const DowsonHigginson& law, const Loading& loading, std::vector<std::string>& found) {
  const double p_max = law.p_h_over_B * dowson_higginson_B * loading.P_max;
  if (!(p_max > dowson_higginson_pressure)) return;
  std::array<double, 1> rho_bar{};
  density(law, std::array{loading.P_max}, rho_bar);
  found.push_back("Dowson and Higginson's density extrapolated: at p_max = " + gigapascals(p_max) +
                  text(" rho/rho0 = %.3g", rho_bar[0]) +
                  ", and never above 1.34; it was fitted up to 0.4 GPa, and above " +
                  gigapascals(dowson_higginson_pressure) +
                  " a typical oil is at least 5 % denser, and the film there thinner by as much");
}

}  // namespace

std::vector<std::string> out_of_range(const ViscosityLaw& viscosity, const DensityLaw& density,
                                      const Loading& loading) {
  std::vector<std::string> found;
  std::visit([&](const auto& law) { judge(law, loading, found); }, viscosity);
  std::visit([&](const auto& law) { judge(law, loading, found); }, density);
  return found;
}

}  // namespace ehl::rheology
