#pragma once
// The units that a report uses if the contact is given in SI.
#include <limits>
#include <string>

namespace ehl::program {

/// The scales of the dimensionless numbers; NaN if a scale is not known.
struct SiScales {
  double a = std::numeric_limits<double>::quiet_NaN();     ///< Hertz radius [m]
  double h = std::numeric_limits<double>::quiet_NaN();     ///< a^2/R [m]
  double p_h = std::numeric_limits<double>::quiet_NaN();   ///< Hertz pressure [Pa]
  double time = std::numeric_limits<double>::quiet_NaN();  ///< a/u_m [s]
};

struct SiUnit {
  std::string name{};
  double factor = 1.0;  ///< a number in the unit of the contact times this factor is the number in `name`
};

/// The SI unit of a quantity: um for places, nm for films, GPa for pressures, ms for times, um/s for approach speeds.
/// in: a unit of the result file, "a^2/R".
/// out: a unit that has no scale of the contact is returned unchanged; the factor is NaN if the scale is not known.
SiUnit si_unit(const std::string& unit, const SiScales& scales);

/// A film thickness as text, "258.55 nm". in: H, dimensionless.
std::string film_text(double H, const SiScales& scales);
/// A place as text, "(42.0, -112.1) um". in: X and Y, dimensionless.
std::string place_text(double X, double Y, const SiScales& scales);

}  // namespace ehl::program
