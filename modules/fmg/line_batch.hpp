#pragma once
// Assembly and solution of the line systems of eight lines of one colour.
#include <vector>

#include "fmg/hierarchy.hpp"
#include "line_solvers/decimation.hpp"
#include "line_solvers/elimination.hpp"

namespace ehl::fmg {

/// Colour 0 has the lines j = 1, 3, 5, .., colour 1 the lines 2, 4, ..; a batch has eight of them.
inline int first_line(int colour, int batch) { return 1 + colour + 2 * core::lanes * batch; }
/// Batches with at least one interior line.
inline int batches_of_colour(const core::Grid& grid, int colour) {
  return (grid.ny - 1 - colour + 2 * core::lanes - 1) / (2 * core::lanes);
}

/// Lanes whose line j0, j0 + 2, .. is an interior line.
inline core::LaneMask inside(int j0, int ny) {
  const core::LaneMask j = core::LaneMask{0, 2, 4, 6, 8, 10, 12, 14} + j0;
  return (j >= 1) & (j < ny);
}

/// Work space for eight lines at once; one per thread.
template <int reach, LineSolver solver>
class LineBatch {
 public:
  explicit LineBatch(int nx);

  /// Solves the line systems of one batch and leaves the changes, under-relaxed, in level.changes.
  line_solvers::SmallPivot solve(const Hierarchy& hierarchy, Level& level, int colour, int batch);

 private:
  struct Kinds;
  void read_coefficients(const Hierarchy& hierarchy, const Level& level, int j);
  template <class Take>
  void assemble(const Hierarchy& hierarchy, const Level& level, int j, Take take);
  void keep(const RelaxationParameters& parameters, Level& level, int batch, int i, core::Lanes delta) const;

  static constexpr int margin = line_solvers::max_reach + 2;
  /// epsilon/h^2 at the half point west of point i, i = 1..nx, and south and north of point i.
  std::vector<core::Lanes> west_, south_, north_;
  /// 1 where point i distributes its change; zero outside the line, with `margin` entries on both sides.
  std::vector<core::Lanes> distributive_;
  std::vector<typename line_solvers::Elimination<reach>::Factors> factors_;
  line_solvers::Decimation<reach> decimation_;
};

}  // namespace ehl::fmg
