#include "asperities/laws.hpp"

#include <cmath>

#include "asperities/gap_table.hpp"
#include "asperities/gauss_moments.hpp"

namespace ehl::asperities {
namespace {

using Made = std::variant<PressureCurve, std::string>;

// p = scale F_n(h/sigma) with its exact slopes dp/dh = -n scale F_(n-1)/sigma.
PressureCurve gaussian_curve(double scale, double n, double sigma) {
  constexpr double lowest = -4.0, highest = 10.0, step = 0.0625;
  std::vector<double> gaps, pressures, slopes;
  for (double l = lowest; l <= highest; l += step) {
    gaps.push_back(l * sigma);
    pressures.push_back(scale * gauss_moment(n, l));
    slopes.push_back(-n * scale * gauss_moment(n - 1.0, l) / sigma);
  }
  return pressure_curve(gaps, pressures, slopes);
}

// Two rough surfaces, whose asperities of radius beta meet beside their summits.
Made greenwood_tripp(const LawParameters& p) {
  const double scale = 16.0 * std::sqrt(2.0) * core::pi / 15.0 * p.eta_beta_sigma * p.eta_beta_sigma *
                       std::sqrt(p.sigma_over_beta) * 0.5 * p.E_prime;
  return gaussian_curve(scale, 2.5, p.sigma);
}

// A rough surface against a smooth one.
Made greenwood_williamson(const LawParameters& p) {
  const double scale = 4.0 / 3.0 * p.eta_beta_sigma * std::sqrt(p.sigma_over_beta) * 0.5 * p.E_prime;
  return gaussian_curve(scale, 1.5, p.sigma);
}

Made tabulated(const LawParameters& p) {
  const std::variant<GapTable, std::string> read = read_gap_table(p.table);
  if (const auto* wrong = std::get_if<std::string>(&read)) return *wrong;
  const auto& table = std::get<GapTable>(read);
  const std::size_t touching = table.touching();
  return pressure_curve(std::span(table.gap).first(touching), std::span(table.pressure).first(touching));
}

}  // namespace

const std::vector<Law>& laws() {
  static const std::vector<Law> all{
      {"greenwood-tripp", "(16 sqrt(2) pi/15) (eta beta sigma)^2 sqrt(sigma/beta) (E'/2) F_5/2(h/sigma)",
       "Greenwood and Tripp 1970", false, greenwood_tripp},
      {"greenwood-williamson", "(4/3) eta beta sigma sqrt(sigma/beta) (E'/2) F_3/2(h/sigma)",
       "Greenwood and Williamson 1966", false, greenwood_williamson},
      {"table", "a table of gaps and pressures, as of `ehl asperities`", "", true, tabulated}};
  return all;
}

double area_greenwood_tripp(double eta_beta_sigma, double h_over_sigma) {
  return core::pi * core::pi * eta_beta_sigma * eta_beta_sigma * gauss_moment(2.0, h_over_sigma);
}
double area_greenwood_williamson(double eta_beta_sigma, double h_over_sigma) {
  return core::pi * eta_beta_sigma * gauss_moment(1.0, h_over_sigma);
}

}  // namespace ehl::asperities
