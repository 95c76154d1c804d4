#pragma once
// Assembly and solution of the line systems of a batch of lines of one colour.
#include <array>

#include "film/half_points.hpp"
#include "multigrid/hierarchy.hpp"
#include "multigrid/relaxation.hpp"
#include "multigrid/thread_work.hpp"

namespace ehl::multigrid {

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

/// Converts the coefficients of the pressure changes in a row into those of delta_{i-2} .. delta_{i+2}. The pressure
/// change at k is delta_k - share (distributed_{k-1} + distributed_{k+1}); the neighbouring lines give up the Y share
/// of a distributed change. in: d(q), 1 if point i + q distributes its change, else 0; `squeezed`, how much single
/// changes around the point squeeze out of its film, per change of its own (ThreadWork::far_squeeze).
template <class Distributive>
inline std::array<core::Lanes, 5> coefficients_of_deltas(const DistributedShares& shares,
                                                         const reynolds::PressureRow<core::Lanes>& dr, Distributive d,
                                                         core::Lanes squeezed) {
  const double share = shares.along;
  const double across = shares.across / share;  // 1 except on stretched cells
  return {share * d(-2) * dr.west - dr.far_west, share * d(-1) * (dr.far_west + dr.own) - dr.west,
          share * d(0) * (dr.west + dr.east + across * dr.south + across * dr.north) - dr.own - squeezed,
          share * d(1) * dr.own - dr.east, share * d(2) * dr.east};
}

/// What a row has in addition as epsilon at half points follows the viscosity at the nodes. in: e; the derivatives of
/// the viscosity (film::answers) at the faces along X.
template <class Number>
reynolds::PressureRow<Number> viscosity_row(const reynolds::Faces<Number>& e, const film::Answers<Number>& west,
                                            const film::Answers<Number>& east) {
  return {.far_west = Number{},
          .west = e.west * (1.0 - west.before),
          .own = e.west * (west.behind - 1.0) + e.east * (east.before - 1.0),
          .east = e.east * (1.0 - east.behind),
          .south = Number{},
          .north = Number{}};
}
/// What a row has in addition from the faces along X and along Y.
template <class Number>
reynolds::PressureRow<Number> viscosity_row(const reynolds::Faces<Number>& e, const film::Answers<Number>& west,
                                            const film::Answers<Number>& east, const film::Answers<Number>& south,
                                            const film::Answers<Number>& north) {
  reynolds::PressureRow<Number> row = viscosity_row(e, west, east);
  row.own = row.own + e.south * (south.behind - 1.0) + e.north * (north.before - 1.0);
  row.south = e.south * (1.0 - south.before);
  row.north = e.north * (1.0 - north.behind);
  return row;
}

/// The row of the line system of a point. in: c and r of its equation; the derivatives of r by the pressures; d and
/// `squeezed` of coefficients_of_deltas().
template <int reach, std::size_t films, class Distributive>
line_solvers::BandRow<reach> band_row(const line_solvers::FilmTerms& film, const DistributedShares& shares,
                                      line_solvers::PointEquation<films>& point,
                                      const reynolds::PressureRow<core::Lanes>& dr, Distributive d,
                                      core::Lanes squeezed) {
  point.a = coefficients_of_deltas(shares, dr, d, squeezed);
  line_solvers::BandRow<reach> row = line_solvers::eliminate_film<reach>(film, point, d);
  // delta_{i-3} changes the density at i-2 by its distribution.
  row.a[line_solvers::BandRow<reach>::lower - 3] += shares.along * d(-3) * dr.far_west;
  return row;
}

/// Under-relaxation weight of a change: weight_distributed, or weight_single where the coefficients of the half points
/// around are within a factor of 2, down to weight_single_steep as their ratio falls. in: 1 where the change is
/// distributed, else 0; the range of the coefficients.
inline core::Lanes weight_of_change(const RelaxationParameters& how, core::Lanes distributive,
                                    const ThreadWork::Range& around) {
  const double range = how.weight_single - how.weight_single_steep;
  const core::Lanes smooth = 2.0 * around.low >= around.high ? core::broadcast(1.0) : 2.0 * around.low / around.high;
  return distributive > 0.0 ? core::broadcast(how.weight_distributed) : how.weight_single_steep + range * smooth;
}

/// A change of one pressure, limited to RelaxationParameters::most_change.
inline core::Lanes bounded(const RelaxationParameters& how, core::Lanes change) {
  const core::Lanes most = core::broadcast(how.most_change);
  return core::max(-most, core::min(most, change));  // keeps a NaN
}

/// Limits a distributed change so that no point gives away more than its pressure. Otherwise the projection cuts off
/// what falls below zero, while the neighbours keep what they received: pressure from nothing, which a strong squeeze
/// term amplifies.
inline void hold_to_what_is_there(core::Lanes P, core::Lanes& delta, core::Lanes& distributed) {
  const core::LaneMask too_much = distributed < -P;
  delta = too_much ? -P : delta;
  distributed = too_much ? -P : distributed;
}

/// Which points of a level have a single change.
class KindRule {
 public:
  KindRule(const Hierarchy& hierarchy, const Level& level, const RelaxationParameters& how)
      : crossover_(crossover_on(hierarchy, level.grid, how)),
        crossover2_(crossover_ * crossover_),
        stretched_(core::stretched(level.grid)) {
    const double squeeze = hierarchy.transport.squeeze;
    far_single_ =
        core::broadcast(how.far_squeeze * film_response(level, 0) * squeeze + how.far_squeeze_of_zone * squeeze);
    far_beside_ = core::broadcast(how.far_squeeze_beside * squeeze);
  }
  /// True where e_max sqrt(e_max/e_min) > crossover, written without root and division; e_min = 0 makes a point single
  /// unless e_max = 0 too. On stretched cells without the root: the top of a spike that runs along the lines would
  /// distribute half of its change to the flank next to it, where epsilon takes that back, and the film changes far
  /// more than the row assumes. [bench: kind_on_stretched_cells]
  core::LaneMask single(core::Lanes largest, core::Lanes smallest) const {
    const core::Lanes squared = largest * largest;
    return stretched_ ? squared > crossover_ * smallest : squared * largest > crossover2_ * smallest;
  }
  /// ThreadWork::far_squeeze. in: single by single(); single for any reason.
  core::Lanes squeezed(core::LaneMask by_epsilon, core::LaneMask single) const {
    return by_epsilon ? far_single_ : single ? far_beside_ : core::Lanes{};
  }

 private:
  double crossover_, crossover2_;
  bool stretched_;
  core::Lanes far_single_, far_beside_;
};

/// Kinds of rows: epsilon at the nodes and a wedge of three weights; the same with epsilon following the film; all
/// terms; the mass-conserving cavitation model.
enum class Form { plain, following_film, general, mass_conserving };

/// Reads the coefficients of the line systems of a batch into the work space of one thread.
class LineCoefficients {
 public:
  LineCoefficients(ThreadWork& work, const RelaxationParameters& how) : work_(work), how_(how) {}

  /// Reads epsilon/h^2 at the half points and the derivatives of the viscosity, and chooses the points that distribute
  /// their change.
  void read(const Hierarchy& hierarchy, const Level& level, int j);

 private:
  void read_answers(const Tuning& tuning, const Level& level, int j);

  ThreadWork& work_;
  const RelaxationParameters& how_;
};

/// The line systems of a batch of lines, on the work space of one thread.
template <int reach, LineSolver solver>
class LineBatch {
 public:
  /// in: work made for this reach and solver.
  LineBatch(ThreadWork& work, const RelaxationParameters& how) : work_(work), how_(how) {}

  /// Solves the line systems of one batch and writes the under-relaxed changes to level.changes.
  line_solvers::SmallPivot solve(const Hierarchy& hierarchy, Level& level, int colour, int batch);

 private:
  template <Form form, class Take>
  void assemble(const Hierarchy& hierarchy, const Level& level, int j, Take take);
  core::Lanes weight_at(int i) const;
  void keep(Level& level, int batch, int i, core::Lanes delta, core::Lanes weight) const;
  void weigh_pressures(Level& level, int batch) const;

  ThreadWork& work_;
  const RelaxationParameters& how_;
};

}  // namespace ehl::multigrid
