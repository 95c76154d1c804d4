#include "base/si_units.hpp"

namespace ehl::program {

SiUnit si_unit(const std::string& unit, const SiScales& scales) {
  const double u_m = scales.a / scales.time;
  if (unit == "a") return {"um", 1e6 * scales.a};
  if (unit == "a^2") return {"um^2", 1e12 * scales.a * scales.a};
  if (unit == "a^2/R") return {"nm", 1e9 * scales.h};
  if (unit == "p_h") return {"GPa", 1e-9 * scales.p_h};
  if (unit == "a/u_m") return {"ms", 1e3 * scales.time};
  if (unit == "a u_m/R") return {"um/s", 1e6 * scales.h / scales.time};
  if (unit == "rho0 u_m a^3/R") return {"rho0 mm^3/s", 1e9 * scales.a * scales.h * u_m};
  return {unit, 1.0};
}

}  // namespace ehl::program
