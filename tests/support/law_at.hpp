#pragma once
// Evaluates a law of viscosity or density at one pressure.
#include <span>

#include "rheology/laws.hpp"

namespace support {

using OfViscosity = void (*)(const ehl::rheology::ViscosityLaw&, std::span<const double>, std::span<double>);
using OfDensity = void (*)(const ehl::rheology::DensityLaw&, std::span<const double>, std::span<double>);

inline double value(OfViscosity f, const ehl::rheology::ViscosityLaw& law, double P) {
  double out = 0.0;
  f(law, {&P, 1}, {&out, 1});
  return out;
}
inline double value(OfDensity f, const ehl::rheology::DensityLaw& law, double P) {
  double out = 0.0;
  f(law, {&P, 1}, {&out, 1});
  return out;
}

}  // namespace support
