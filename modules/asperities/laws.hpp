#pragma once
// The laws of asperity pressure that a user can name.
#include <string>
#include <variant>
#include <vector>

#include "asperities/pressure.hpp"
#include "core/constants.hpp"

namespace ehl::asperities {

/// What the laws need. All heights are of both surfaces together.
struct LawParameters {
  double sigma = core::unknown;            ///< root mean square height [m]; of the summits in Greenwood-Williamson
  double eta_beta_sigma = core::unknown;   ///< density of the asperities times their radius times sigma
  double sigma_over_beta = core::unknown;  ///< sigma over the radius of the asperities
  double E_prime = core::unknown;          ///< [Pa]; the E* of the sources is E'/2
  std::string table{};                     ///< file of gaps and pressures
};

/// A law: its name, its formula as text, where it is published, and what makes its curve. The curve of a table may be
/// an error message instead: "p_a.csv:3: ...". errors: core::FileError if the table cannot be read.
struct Law {
  std::string name{};
  std::string formula{};
  std::string source{};
  bool of_table = false;  ///< needs `table`; else the four numbers
  std::variant<PressureCurve, std::string> (*curve)(const LawParameters& parameters) = nullptr;
};

/// All laws. The distance h is that of the mean planes; of the mean plane of the summits in Greenwood-Williamson.
/// limits: -4 < h/sigma < 10, beyond which -ln p is continued linearly; the models hold for h/sigma above about 0.5.
const std::vector<Law>& laws();

/// Share of the area in contact: A_c/A = pi^2 (eta beta sigma)^2 F_2(h/sigma) of Greenwood and Tripp, and
/// pi eta beta sigma F_1(h/sigma) of Greenwood and Williamson.
double area_greenwood_tripp(double eta_beta_sigma, double h_over_sigma);
double area_greenwood_williamson(double eta_beta_sigma, double h_over_sigma);

}  // namespace ehl::asperities
