#pragma once
// Assembly and solution of the line systems of a batch of lines of one colour.
#include <array>

#include "fmg/hierarchy.hpp"
#include "fmg/thread_work.hpp"

namespace ehl::fmg {

/// Colour 0 has the lines j = 1, 3, 5, .., colour 1 the lines 2, 4, ..; a batch has as many of them as there are lanes.
inline int first_line(int colour, int batch) { return 1 + colour + 2 * core::lanes * batch; }
/// Batches with at least one interior line.
inline int batches_of_colour(const core::Patch& grid, int colour) {
  return (grid.last_line() - colour + 2 * core::lanes - 1) / (2 * core::lanes);
}

/// The lines j0, j0 + 2, .. of a batch.
inline core::LaneMask lines_from(int j0) {
  return core::lanes_by([](int k) { return 2 * k; }) + j0;
}
/// Lanes whose line j0, j0 + 2, .. is a line of unknowns.
inline core::LaneMask inside(int j0, const core::Patch& grid) {
  const core::LaneMask j = lines_from(j0);
  return (j >= 1) & (j <= grid.last_line());
}

/// From the coefficients of the pressure changes in a row to those of the deltas delta_{i-2} .. delta_{i+2}: the
/// pressure change at k is delta_k - share (distributed_{k-1} + distributed_{k+1}), and the lines beside get the share
/// across of a distributed one. in: d(q), whether point i + q distributes its change; `squeezed`, what it squeezes out
/// of the film around it.
template <class Distributive>
inline std::array<core::Lanes, 5> coefficients_of_deltas(const DistributedShares& shares,
                                                         const reynolds::PressureRow<core::Lanes>& dr, Distributive d,
                                                         core::Lanes squeezed) {
  const double share = shares.along;
  const double across = shares.across / share;  // 1 but of stretched cells
  return {share * d(-2) * dr.west - dr.far_west, share * d(-1) * (dr.far_west + dr.own) - dr.west,
          share * d(0) * (dr.west + dr.east + across * dr.south + across * dr.north) - dr.own - squeezed,
          share * d(1) * dr.own - dr.east, share * d(2) * dr.east};
}

/// The under-relaxation weight of a change. in: 1 where it is distributed; the coefficients of the half points around.
/// Of a single one from `weight_single_steep` up to the full one as these come within a factor 2 of each other.
inline core::Lanes weight_of_change(const RelaxationParameters& how, core::Lanes distributive,
                                    const ThreadWork::Range& around) {
  const double range = how.weight_single - how.weight_single_steep;
  const core::Lanes smooth = 2.0 * around.low >= around.high ? core::broadcast(1.0) : 2.0 * around.low / around.high;
  return distributive > 0.0 ? core::broadcast(how.weight_distributed) : how.weight_single_steep + range * smooth;
}

/// A change of one pressure within RelaxationParameters::most_change.
inline core::Lanes bounded(const RelaxationParameters& how, core::Lanes change) {
  const core::Lanes most = core::broadcast(how.most_change);
  return core::max(-most, core::min(most, change));  // a NaN stays one
}

/// Holds a distributed change to what is there: no point gives more than its pressure. What goes below zero is cut off,
/// while its neighbours keep what they were given: pressure out of nothing, which a strong squeeze answers by far more.
inline void hold_to_what_is_there(core::Lanes P, core::Lanes& delta, core::Lanes& distributed) {
  const core::LaneMask too_much = distributed < -P;
  delta = too_much ? -P : delta;
  distributed = too_much ? -P : distributed;
}

/// Of the rows: with epsilon at the nodes and a wedge of three weights; the same where epsilon follows the film; with
/// everything; of the cavitation model that conserves mass.
enum class Form { plain, following_film, general, mass_conserving };

/// What the line systems are made of, into the work space of one thread.
class LineCoefficients {
 public:
  LineCoefficients(ThreadWork& work, const RelaxationParameters& how) : work_(work), how_(how) {}

  /// epsilon/h^2 at the half points, what the viscosity answers, and which points distribute their change.
  void read(const Hierarchy& hierarchy, const Level& level, int j);

 private:
  void read_answers(const Level& level, int j);

  ThreadWork& work_;
  const RelaxationParameters& how_;
};

/// The line systems of a batch of lines, on the work space of one thread.
template <int reach, LineSolver solver>
class LineBatch {
 public:
  /// in: work made for this reach and solver.
  LineBatch(ThreadWork& work, const RelaxationParameters& how) : work_(work), how_(how) {}

  /// Solves the line systems of one batch and leaves the changes, under-relaxed, in level.changes.
  line_solvers::SmallPivot solve(const Hierarchy& hierarchy, Level& level, int colour, int batch);

 private:
  template <Form form, class Take>
  void assemble(const Hierarchy& hierarchy, const Level& level, int j, Take take);
  core::Lanes weight_at(const Level& level, int i) const;
  void keep(Level& level, int batch, int i, core::Lanes delta, core::Lanes weight) const;
  void weigh_pressures(Level& level, int batch) const;

  ThreadWork& work_;
  const RelaxationParameters& how_;
};

}  // namespace ehl::fmg
