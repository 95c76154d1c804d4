#pragma once
// The units that a person reads who gave the contact in SI.
#include <limits>
#include <string>

namespace ehl::program {

/// What dimensionless numbers are made with; NaN where it is not known.
struct SiScales {
  double a = std::numeric_limits<double>::quiet_NaN();     ///< Hertz radius [m]
  double h = std::numeric_limits<double>::quiet_NaN();     ///< a^2/R [m]
  double p_h = std::numeric_limits<double>::quiet_NaN();   ///< Hertz pressure [Pa]
  double time = std::numeric_limits<double>::quiet_NaN();  ///< a/u_m [s]
};

struct SiUnit {
  std::string name{};
  double factor = 1.0;  ///< a number in the contact's unit times this is one in `name`
};

/// um for places, nm for films, GPa for pressures, ms for times, um/s for what approaches. in: a unit of the result
/// file, "a^2/R". out: a unit of no scale of the contact as it is; a factor of NaN where the scale is not known.
SiUnit si_unit(const std::string& unit, const SiScales& scales);

/// A film, a place: "258.55 nm", "(42.0, -112.1) um". in: H, X and Y.
std::string film_text(double H, const SiScales& scales);
std::string place_text(double X, double Y, const SiScales& scales);

}  // namespace ehl::program
