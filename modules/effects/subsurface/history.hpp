#pragma once
// What the material of a body meets while it passes through a contact in time.
#include <vector>

#include "effects/subsurface/stress.hpp"

namespace ehl::subsurface {

/// Quantities of a history.
enum Met {
  largest_mises,  ///< largest von Mises stress
  largest_tau,    ///< largest of the largest shear stresses
  range_of_tau,   ///< range of the orthogonal shear stress tau_xz, largest less smallest value; far away it is 0
};
inline constexpr int met = 3;

/// The largest value of each quantity that every point of a body has met so far, in coordinates that move with the
/// body: x_body = X - displacement, the displacement being the integral of the body's speed since time 0.
class History {
 public:
  /// in: the grid and the depths of the stresses; the displacements between which the body will be, from <= to.
  History(const core::Grid& grid, const std::vector<double>& depths, double from, double to);

  /// Takes the stresses at one time: sigma_mises, tau_max and tau_xz on all planes (StressField::kept). A point of the
  /// body between two nodes gets its stress by cubic interpolation along X; a point outside the domain gets none.
  /// in: times in rising order. error: between two samples the stress moves over the material by the difference of the
  /// displacements, which should not exceed two cells.
  /// threads >= 1; the result does not depend on them.
  void add(const StressField& stresses, double displacement, int threads);

  const core::Grid& grid() const { return grid_; }  ///< in the coordinates of the body
  const std::vector<double>& depths() const { return depths_; }
  double longest_move() const { return longest_move_; }  ///< largest displacement between two samples, in cells
  Maximum largest(Met what) const;                       ///< of all nodes
  /// Over x_body (first index) and depth, along the line Y = 0 or the nearest one.
  core::Field section(Met what) const;

 private:
  double value(Met what, std::size_t plane, int i, int j) const;

  core::Grid of_stresses_, grid_;
  std::vector<double> depths_;
  /// One field per plane: largest sigma_mises, largest tau_max, largest and smallest tau_xz.
  std::vector<core::Field> mises_, tau_, high_, low_;
  double last_ = 0.0, longest_move_ = 0.0;
  bool begun_ = false;
};

/// Names and meanings of the quantities in the result.
const char* name(Met what);
const char* meaning(Met what);

}  // namespace ehl::subsurface
