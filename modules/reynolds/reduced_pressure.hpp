#pragma once
// The reduced pressure q, dq = dP/eta_bar, which obeys an isoviscous Reynolds equation.
#include <vector>

#include "rheology/laws.hpp"

namespace ehl::reynolds {

/// P of q, by cubics through a table with its slopes: 1e-9 at alpha_bar = 12.
class ReducedPressure {
 public:
  ReducedPressure() = default;
  explicit ReducedPressure(const rheology::ViscosityLaw& viscosity);

  /// in: q >= 0. out: NaN above the table, which ends at P = 1, or where q hardly rises any more.
  double P(double q) const;

 private:
  struct Knot {
    double q, P, slope;
  };
  std::vector<Knot> knots_;  ///< none: isoviscous, P = q
};

}  // namespace ehl::reynolds
