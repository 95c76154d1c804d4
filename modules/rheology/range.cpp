#include "rheology/range.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace ehl::rheology {
namespace {

std::string gigapascals(double p) { return fmt::format("{:.3g} GPa", 1e-9 * p); }

// "at p_max = 1.2 GPa"
std::string state_of_pressure(const Loading& loading) {
  const double p_max = loading.P_max * loading.p_h;
  return std::isfinite(p_max) ? "at p_max = " + gigapascals(p_max) : fmt::format("at P = {:.3g} p_h", loading.P_max);
}

// "at p_max = 1.2 GPa ln(eta/eta0) = 26 (alpha_bar P = 26)"
std::string state_of_oil(const Loading& loading, double log_eta, double alpha_bar) {
  return fmt::format("{} ln(eta/eta0) = {:.3g} (alpha_bar P = {:.3g})", state_of_pressure(loading), log_eta,
                     alpha_bar * loading.P_max);
}

void judge(Isoviscous, const Loading&, core::Warnings&) {}

// False if the viscosity rises too little with pressure for Roelands' law, which refuses such a liquid.
bool has_roelands_z(const Barus& law, const Loading& loading) {
  const double z = law.alpha_bar / loading.p_h * roelands_p0 / roelands_log_ratio(loading.eta0);
  return !(z < least_z);  // also for an unknown oil
}

void judge(const Barus& law, const Loading& loading, core::Warnings& found) {
  const double log_eta = law.alpha_bar * loading.P_max;
  const double p_max = loading.P_max * loading.p_h;
  const bool known = std::isfinite(p_max);
  if (known ? !(p_max > barus_pressure) : !(log_eta > barus_log_viscosity)) return;
  const std::string range = known ? "up to about " + gigapascals(barus_pressure)
                                  : fmt::format("up to ln(eta/eta0) of about {:.2g}, {} for a mineral oil,",
                                                barus_log_viscosity, gigapascals(barus_pressure));
  found.push_back(
      {"viscosity-range", fmt::format("Barus' law is used outside its range: {}; it follows measured viscosities {} "
                                      "and gives far too high ones above. Use viscosity = {}",
                                      state_of_oil(loading, log_eta, law.alpha_bar), range,
                                      has_roelands_z(law, loading) ? "roelands" : "table")});
}

double log_viscosity_of_glass(const Loading& loading) {
  return std::isfinite(loading.eta0) ? std::log(glass_viscosity / loading.eta0) : glass_log_viscosity;
}

bool is_glass(const Roelands& law, const Loading& loading) {
  return log_viscosity_at(law, loading.P_max) > log_viscosity_of_glass(loading);
}
bool is_glass(const Doolittle& law, const Loading& loading) { return loading.P_max > law.u_glass / law.p_h_over_K0; }
bool is_glass(const Yasutomi& law, const Loading& loading) { return loading.P_max > law.p_glass / law.p_h; }

void judge(const Roelands& law, const Loading& loading, core::Warnings& found) {
  const double log_eta = log_viscosity_at(law, loading.P_max);
  const double p_max = loading.P_max * loading.p_h;
  const double alpha_bar = law.alpha_p0_over_z * law.z * law.p_h_over_p0;
  const bool known = std::isfinite(loading.eta0);
  const std::string state = state_of_oil(loading, log_eta, alpha_bar);
  const std::string oil = known ? fmt::format("eta0 = {:.3g}", loading.eta0) : "an eta0 of 0.1";
  if (is_glass(law, loading))
    found.push_back(
        {"viscosity-range", fmt::format("Roelands' law is used outside its range: {}; with {} Pa s the oil is a glass "
                                        "({:.0e} Pa s) above {:.3g} and shears as a solid. The film is formed in the "
                                        "inlet and changes little, but friction cannot be computed from this law",
                                        state, oil, glass_viscosity, log_viscosity_of_glass(loading))});
  else if (p_max > roelands_pressure)
    found.push_back(
        {"viscosity-range",
         fmt::format(
             "Roelands' law is extrapolated: {}; viscosities were measured up to about 1 GPa, and {} is twice that",
             state, gigapascals(roelands_pressure))});
}

// Warns of a law that is continued along its tangent beyond the glass transition.
void warn_of_glass(const char* law, double P_glass, double log_eta, const Loading& loading, core::Warnings& found) {
  found.push_back(
      {"viscosity-range", fmt::format("{} law is used outside its range: {} ln(eta/eta0) = {:.3g}; the oil is a glass "
                                      "above {}, where the law is continued along its tangent. The film is formed in "
                                      "the inlet and changes little, but friction cannot be computed from this law",
                                      law, state_of_pressure(loading), log_eta, gigapascals(P_glass * loading.p_h))});
}

void judge(const Doolittle& law, const Loading& loading, core::Warnings& found) {
  if (is_glass(law, loading))
    warn_of_glass("Doolittle's", law.u_glass / law.p_h_over_K0, log_viscosity_at(law, loading.P_max), loading, found);
}

void judge(const Yasutomi& law, const Loading& loading, core::Warnings& found) {
  if (is_glass(law, loading))
    warn_of_glass("Yasutomi's", law.p_glass / law.p_h, log_viscosity_at(law, loading.P_max), loading, found);
}

void judge_table(const char* what, const Curve& curve, double p_h, const Loading& loading, core::Warnings& found) {
  const double p_max = p_h * loading.P_max;
  if (!(p_max > curve.x.back())) return;
  found.push_back({"table-range", fmt::format("the pressure exceeds the table of the {}: p_max = {}, and the table "
                                              "ends at {}; it is continued along its last slope. Extend the table",
                                              what, gigapascals(p_max), gigapascals(curve.x.back()))});
}

void judge(const TabulatedViscosity& law, const Loading& loading, core::Warnings& found) {
  judge_table("viscosity", *law.curve, law.p_h, loading, found);
}

void judge(const TabulatedDensity& law, const Loading& loading, core::Warnings& found) {
  judge_table("density", *law.curve, law.p_h, loading, found);
}

// Equations of state of liquids hold far beyond contact pressures.
void judge(const Tait&, const Loading&, core::Warnings&) {}
void judge(const Murnaghan&, const Loading&, core::Warnings&) {}

void judge(Incompressible, const Loading&, core::Warnings&) {}

void judge(const DowsonHigginson& law, const Loading& loading, core::Warnings& found) {
  const double p_max = law.p_h_over_B * dowson_higginson_B * loading.P_max;
  if (!(p_max > dowson_higginson_pressure)) return;
  std::array<double, 1> rho_bar{};
  density(law, std::array{loading.P_max}, rho_bar);
  found.push_back(
      {"density-range", fmt::format("Dowson and Higginson's density is extrapolated: at p_max = {} rho/rho0 = {:.3g}, "
                                    "and it never exceeds 1.34; it was fitted up to 0.4 GPa. Above {} a typical oil is "
                                    "at least 5 % denser, and the film there thinner by as much",
                                    gigapascals(p_max), rho_bar[0], gigapascals(dowson_higginson_pressure))});
}

}  // namespace

core::Warnings out_of_range(const ViscosityLaw& viscosity, const DensityLaw& density, const Loading& loading) {
  core::Warnings found;
  std::visit([&](const auto& law) { judge(law, loading, found); }, viscosity);
  std::visit([&](const auto& law) { judge(law, loading, found); }, density);
  return found;
}

}  // namespace ehl::rheology
