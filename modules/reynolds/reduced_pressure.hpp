#pragma once
// The reduced pressure q, dq = dP/eta_bar, which obeys the isoviscous Reynolds equation.
#include <vector>

#include "rheology/laws.hpp"

namespace ehl::reynolds {

/// The pressure P as a function of q, by cubic Hermite interpolation in a table. [bench: reduced_pressure_intervals]
class ReducedPressure {
 public:
  ReducedPressure() = default;
  explicit ReducedPressure(const rheology::ViscosityLaw& viscosity);

  /// P of q. in: q >= 0. out: NaN above the table, which ends at P = 1 or where q hardly rises any more.
  double P(double q) const;

 private:
  struct Knot {
    double q, P, slope;
  };
  std::vector<Knot> knots_;  ///< none: isoviscous, P = q
};

}  // namespace ehl::reynolds
