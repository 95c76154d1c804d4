#pragma once
// The elastic influence along a line of the relaxation.
#include <array>

namespace ehl::line_solvers {

/// Largest number of neighbours on each side whose elastic influence a line system can contain.
inline constexpr int max_reach = 3;

/// The elastic influence along a line, with the factor 2/pi^2, truncated after `reach` neighbours (2 reach + 1 terms).
struct FilmTerms {
  int reach = 1;
  std::array<double, max_reach + 1> K{};         ///< of a single change, by distance along the line
  std::array<double, max_reach + 1> delta_K{};   ///< of a distributed change
  std::array<double, max_reach + 1> K_across{};  ///< of a single change on the next lines; not in line contacts
};

/// Place of a pivot that is too small to divide by; point = -1: none.
struct SmallPivot {
  int point = -1;
  int lane = 0;
  double pivot = 0.0;
};

}  // namespace ehl::line_solvers
