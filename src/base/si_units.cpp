#include "base/si_units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ehl::program {

SiUnit si_unit(const std::string& unit, const SiScales& scales) {
  const double u_m = scales.a / scales.time;
  if (unit == "a") return {"um", 1e6 * scales.a};
  if (unit == "a^2") return {"um^2", 1e12 * scales.a * scales.a};
  if (unit == "a^2/R") return {"nm", 1e9 * scales.h};
  if (unit == "p_h") return {"GPa", 1e-9 * scales.p_h};
  if (unit == "a/u_m") return {"ms", 1e3 * scales.time};
  if (unit == "a u_m/R") return {"m/s", scales.h / scales.time};
  if (unit == "F_0") return {"N", scales.load};
  if (unit == "F_0'") return {"N/m", scales.load};
  if (unit == "F_0 u_m") return {"W", scales.load * u_m};
  if (unit == "F_0' u_m") return {"W/m", scales.load * u_m};
  if (unit == "rho0 u_m a^3/R") return {"rho0 mm^3/s", 1e9 * scales.a * scales.h * u_m};
  if (unit == "rho0 u_m a^2/R") return {"rho0 mm^2/s", 1e6 * scales.h * u_m};
  return {unit, 1.0};
}

std::vector<results::InSi> plain_units(const SiScales& scales) {
  return {{"p_h", "Pa", scales.p_h}, {"a^2/R", "m", scales.h}, {"a", "m", scales.a}, {"a/u_m", "s", scales.time}};
}

Conversion conversion(const std::string& from, const std::string& to) {
  if (from == to) return {};
  const struct {
    const char* from;
    const char* to;
    Conversion by;
  } all[] = {{"m", "nm", {.divisor = 1e-9}},  {"m", "um", {.divisor = 1e-6}},     {"s", "ms", {.factor = 1e3}},
             {"Pa", "GPa", {.divisor = 1e9}}, {"Pa s", "mPa s", {.factor = 1e3}}, {"1/Pa", "1/GPa", {.factor = 1e9}}};
  for (const auto& one : all)
    if (from == one.from && to == one.to) return one.by;
  throw std::logic_error("no conversion from " + from + " to " + to);
}

std::string unit_in_names(const std::string& unit) {
  std::string text = unit.starts_with("1/") ? unit.substr(1) : unit;
  std::ranges::replace(text, ' ', '_');
  const std::size_t over = text.find('/');
  return over == std::string::npos ? text : text.replace(over, 1, over == 0 ? "per_" : "_per_");
}

std::string film_text(double H, const SiScales& scales) {
  const double nm = 1e9 * scales.h * H;
  return std::isfinite(nm) ? fmt::format("{:.2f} nm", nm) : "-";
}

std::string place_text(double X, double Y, const SiScales& scales) {
  // A coordinate that rounds to zero is printed without a minus sign.
  const auto um = [&](double x) { return std::abs(x * scales.a) < 0.05e-6 ? 0.0 : 1e6 * scales.a * x; };
  return fmt::format("({:.1f}, {:.1f}) um", um(X), um(Y));
}

}  // namespace ehl::program
