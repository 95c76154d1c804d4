#pragma once
// The units that a report uses if the contact is given in SI.
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "results/content.hpp"

namespace ehl::program {

/// The scales of the dimensionless numbers; NaN if a scale is not known.
struct SiScales {
  double a = core::unknown;     ///< Hertz radius [m]
  double h = core::unknown;     ///< a^2/R [m]
  double p_h = core::unknown;   ///< Hertz pressure [Pa]
  double time = core::unknown;  ///< a/u_m [s]
  double load = core::unknown;  ///< F_0 [N], or F_0' of a line contact [N/m]
};

struct SiUnit {
  std::string name{};
  double factor = 1.0;  ///< a number in the unit of the contact times this factor is the number in `name`
};

/// The SI unit of a quantity: um for places, nm for films, GPa for pressures, ms for times, m/s for approach speeds,
/// N for forces, W for powers (of a line contact per m).
/// in: a unit of the result file, "a^2/R".
/// out: a unit that has no scale of the contact is returned unchanged; the factor is NaN if the scale is not known.
SiUnit si_unit(const std::string& unit, const SiScales& scales);

/// The units of fields and places in units without a prefix: Pa, m, s.
std::vector<results::InSi> plain_units(const SiScales& scales);

/// From an SI unit to one that people read: value * factor / divisor, of which one is 1, so that the bits do not depend
/// on how a power of ten is rounded.
struct Conversion {
  double factor = 1.0;
  double divisor = 1.0;
  bool none() const { return factor == 1.0 && divisor == 1.0; }
  double of(double value) const { return value * factor / divisor; }
};
/// in: "m", "nm". out: no conversion where the units are the same. errors: std::logic_error: there is none.
Conversion conversion(const std::string& from, const std::string& to);

/// A unit as the end of a column's name: "nm", "N_per_m", "per_GPa".
std::string unit_in_names(const std::string& unit);

/// A film thickness as text, "258.55 nm". in: H, dimensionless.
std::string film_text(double H, const SiScales& scales);
/// A place as text, "(42.0, -112.1) um". in: X and Y, dimensionless.
std::string place_text(double X, double Y, const SiScales& scales);

}  // namespace ehl::program
