#include "multigrid/line_relaxation.hpp"

#include <algorithm>
#include <array>

#include "core/store_lines.hpp"
#include "film/half_points.hpp"
#include "multigrid/line_batch.hpp"
#include "multigrid/line_contact.hpp"
#include "multigrid/relaxation.hpp"
#include "reynolds/row.hpp"

namespace ehl::multigrid {
namespace {

using core::LaneMask;
using core::Lanes;
using Values = LineSystem::Values;
using reynolds::WedgeWeights;

/// A vector of values, of node i and of those after it.
Lanes at(const Values& values, int i) { return core::load(&values[static_cast<std::size_t>(i + LineSystem::margin)]); }
void put(Values& values, int i, Lanes v) { core::store(&values[static_cast<std::size_t>(i + LineSystem::margin)], v); }
double& one(Values& values, int i) { return values[static_cast<std::size_t>(i + LineSystem::margin)]; }
std::span<double> nodes(Values& values, int first, int last) { return {&one(values, first), &one(values, last) + 1}; }

/// Calls action(i) for vectors of nodes that together cover first .. last; entries after last are scratch.
template <class Action>
void for_vectors(int first, int last, Action action) {
  for (int i = first; i <= last; i += core::lanes) action(i);
}

template <int reach>
class AlongLine {
 public:
  AlongLine(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how)
      : hierarchy_(hierarchy),
        level_(level),
        how_(how),
        cavitation_(hierarchy.problem.cavitation),
        in_time_(hierarchy.transport.squeeze > 0.0),
        half_points_(at_half_points(level)),
        transport_(transport_on(hierarchy, level)),
        shares_(distributed_shares(level.grid)),
        grid_(level.grid),
        work_(level.thread_work.front().line_system) {}

  line_solvers::SmallPivot relax() {
    gather();
    read_faces();
    if (half_points_) read_answers();
    choose_kind();
    const line_solvers::SmallPivot small = solve();
    distribute();
    apply();
    return small;
  }

 private:
  using Rows = line_solvers::BandRow<reach>;

  void gather();
  void read_faces();
  void read_answers();
  void choose_kind();
  template <Form form>
  Rows rows_from(int i, const WedgeWeights& c) const;
  template <Form form>
  line_solvers::SmallPivot solve_as();
  line_solvers::SmallPivot solve();
  void distribute();
  void apply();

  /// Least and largest epsilon/h^2 of the half points next to a node.
  ThreadWork::Range range_at(int i) const {
    const Lanes west = at(work_.west, i), east = at(work_.west, i + 1);
    return {core::min(west, east), core::max(west, east)};
  }

  Hierarchy& hierarchy_;
  Level& level_;
  const RelaxationParameters& how_;
  const reynolds::Cavitation cavitation_;
  const bool in_time_;
  const bool half_points_;
  const reynolds::Transport transport_;
  const DistributedShares shares_;
  const core::Patch& grid_;
  LineSystem& work_;
};

// Copies the fields into contiguous arrays, with zeros before the first node and after the last. What
// update_coefficients() has stored in contiguous arrays is taken from there.
template <int reach>
void AlongLine<reach>::gather() {
  const auto take = [this](const core::Field& field, Values& values) {
    core::load_line(field, nodes(values, 0, grid_.nx));
  };
  take(level_.P, work_.P);
  take(level_.H, work_.rho_H);
  if (level_.f.nodes_x() > 0) take(level_.f, work_.f);
  if (half_points_ || reynolds::third_order(level_.scheme.wedge)) take(level_.third_order, work_.third_order);
  if (along_one_line(hierarchy_, level_)) {
    const LineNodes& nodes = level_.thread_work.front().line_nodes;
    const auto copy = [](const std::vector<double>& made, Values& values) {
      std::ranges::copy(made, values.begin() + LineSystem::margin);
    };
    copy(nodes.rho_bar, work_.rho_bar);
    copy(nodes.drho_bar, work_.slope_H);
    copy(nodes.eps, work_.eps);
    if (half_points_) copy(nodes.fluidity, work_.fluidity), copy(nodes.log_viscosity, work_.log_viscosity);
  } else {
    take(level_.rho_bar, work_.rho_bar);
    take(level_.drho_bar, work_.slope_H);
    take(level_.eps, work_.eps);
    if (half_points_) take(level_.oil.fluidity, work_.fluidity), take(level_.oil.log_viscosity, work_.log_viscosity);
  }
  for_vectors(0, grid_.nx, [&](int i) {
    const Lanes H = at(work_.rho_H, i);
    put(work_.rho_H, i, at(work_.rho_bar, i) * H);
    put(work_.slope_H, i, at(work_.slope_H, i) * H);
  });
}

template <int reach>
void AlongLine<reach>::read_faces() {
  const reynolds::HalfInverseSquares half(grid_);
  for_vectors(1, grid_.nx, [&](int i) {
    put(work_.west, i, reynolds::conductance(level_.scheme.face, at(work_.eps, i - 1), at(work_.eps, i), half.X));
  });
}

template <int reach>
void AlongLine<reach>::read_answers() {
  const double least = reynolds::least_share(level_.scheme.face);
  for_vectors(1, grid_.nx, [&](int i) {
    const auto west = film::answers(least, at(work_.fluidity, i - 1), at(work_.fluidity, i),
                                    at(work_.log_viscosity, i - 1), at(work_.log_viscosity, i));
    put(work_.answer_before, i, west.before);
    put(work_.answer_behind, i, west.behind);
  });
}

template <int reach>
void AlongLine<reach>::choose_kind() {
  const KindRule rule(hierarchy_, level_, how_);
  for_vectors(1, grid_.nx - 1, [&](int i) {
    const auto [low, high] = range_at(i);
    const LaneMask by_epsilon = rule.single(high, low);
    const Lanes least = core::min(core::min(at(work_.P, i - 1), at(work_.P, i + 1)), at(work_.P, i));
    const LaneMask single = by_epsilon | reynolds::dry(cavitation_, least);
    put(work_.distributive, i, single ? Lanes{} : core::broadcast(1.0));
    if (in_time_) put(work_.far_squeeze, i, rule.squeezed(by_epsilon, single));
  });
  // Nothing is distributed after the last node.
  for (int i = grid_.nx; i < grid_.nx + core::lanes; ++i) one(work_.distributive, i) = 0.0;
}

// The rows of a vector of nodes from i on, with the wedge weights c. The steps are those of line_batch.cpp.
template <int reach>
template <Form form>
line_solvers::BandRow<reach> AlongLine<reach>::rows_from(int i, const WedgeWeights& c) const {
  constexpr bool plain = form == Form::plain;
  const reynolds::Faces<Lanes> e{at(work_.west, i), at(work_.west, i + 1), Lanes{}, Lanes{}};
  const Lanes P = at(work_.P, i);
  const auto around = [i](const Values& values) {
    return reynolds::Columns<Lanes>{at(values, i), at(values, i - 1), at(values, i - 2), at(values, i + 1)};
  };
  const auto theta = [&] {
    return reynolds::ThirdOrder<Lanes>{at(work_.third_order, i - 1), at(work_.third_order, i)};
  };
  const auto weights = reynolds::wedge_weights<!plain, Lanes>(c, transport_, grid_.hx(), theta);
  line_solvers::PointEquation<plain ? 3 : 4> point;
  reynolds::by_film(weights, around(work_.rho_bar), point.c);
  point.r = reynolds::residual(weights, e, around(work_.rho_H), {at(work_.P, i - 1), at(work_.P, i + 1), P, P, P});
  if (level_.f.nodes_x() > 0) point.r += at(work_.f, i);
  reynolds::PressureRow<Lanes> dr = reynolds::by_pressure(weights, e, around(work_.slope_H));
  if (!plain && half_points_) {
    const auto answers = [&](int k) {
      return film::Answers<Lanes>{at(work_.answer_before, k), at(work_.answer_behind, k)};
    };
    reynolds::add(viscosity_row(e, answers(i), answers(i + 1)), dr);
  }
  line_solvers::BandRow<reach> row = band_row<reach>(
      level_.film_terms, shares_, point, dr, [&](int q) { return at(work_.distributive, i + q); },
      at(work_.far_squeeze, i) * at(work_.rho_bar, i));
  line_solvers::make_identity(row, reynolds::stays_dry(cavitation_, P, point.r));
  return row;
}

// Assembles the next rows while the elimination of some rows, each of which waits for the one before, is in progress.
template <int reach>
template <Form form>
line_solvers::SmallPivot AlongLine<reach>::solve_as() {
  constexpr int block = LineSystem::block;
  const auto weights = [&](int i) { return reynolds::transport_weights(transport_, i, grid_.hx()); };
  using Block = line_solvers::RowBlock<reach, block>;
  const auto make = [&](int first, const WedgeWeights& c, Block& rows) {
    for (int k = 0; k < block; k += core::lanes) rows.put(k, rows_from<form>(first + k, c));
  };
  const int last = grid_.nx - 1;
  const int blocks = (last - 1 + block) / (2 * block);  // eliminated from the first end
  const int middle = 1 + blocks * block;
  const int steps = std::max(blocks, (last - middle + block - 1) / block);
  line_solvers::TwoEnded<reach> elimination(std::get<OneLineFactors<reach>>(work_.factors).data(), last);
  Block rows, rows_behind;
  make(1, weights(1), rows);  // the first node has its own wedge weights
  elimination.push_first(rows.row(0));
  const WedgeWeights c = weights(2);
  for (int step = 0; step < steps; ++step) {
    const int first = 2 + step * block, behind = last - (step + 1) * block + 1;
    make(first, c, rows);
    make(behind, c, rows_behind);
    auto here = elimination;  // a copy that stays in registers during this block
    for (int k = 0; k < block; ++k) {
      if (first + k <= middle) here.push_first(rows.row(k));
      if (behind + block - 1 - k > middle) here.push_last(rows_behind.row(block - 1 - k));
    }
    elimination = here;
  }
  elimination.substitute([&](int i, double delta) { one(work_.delta, i) = delta; });
  return elimination.small_pivot();
}

template <int reach>
line_solvers::SmallPivot AlongLine<reach>::solve() {
  const bool general = half_points_ || reynolds::third_order(level_.scheme.wedge);
  return general ? solve_as<Form::general>() : solve_as<Form::plain>();
}

// Splits off the distributed part of each change. In time both are under-relaxed and limited here, as in LineBatch,
// since a change must count the same at all of its points. In a steady problem apply() does it.
template <int reach>
void AlongLine<reach>::distribute() {
  for_vectors(1, grid_.nx - 1, [&](int i) {
    const Lanes distributive = at(work_.distributive, i);
    Lanes delta = at(work_.delta, i), distributed = distributive * delta;
    if (in_time_) {
      const Lanes weight = weight_of_change(how_, distributive, range_at(i));
      delta *= weight;
      distributed *= weight;
      if (reynolds::ruptures(cavitation_)) hold_to_what_is_there(at(work_.P, i), delta, distributed);
    }
    put(work_.delta, i, delta);
    put(work_.distributed, i, distributed);
  });
  for (int i = grid_.nx; i < grid_.nx + core::lanes; ++i) one(work_.distributed, i) = 0.0;
}

// Eq. (15) of a line contact: each neighbour gives up half of a distributed change. In a steady problem the weight
// multiplies the whole change of a pressure. A smooth change consists of distributed ones that are far larger. With a
// weight on each of these, and another one on single changes next to them, an error remains where they meet, and cycles
// stall. [bench: weight_of_pressures]
template <int reach>
void AlongLine<reach>::apply() {
  const double share = shares_.along;
  for_vectors(1, grid_.nx - 1, [&](int i) {
    Lanes change = at(work_.delta, i) - share * (at(work_.distributed, i - 1) + at(work_.distributed, i + 1));
    if (!in_time_) change *= weight_of_change(how_, at(work_.distributive, i), range_at(i));
    put(work_.delta, i, reynolds::projected(cavitation_, at(work_.P, i) + change));
  });
  core::store_line(nodes(work_.delta, 1, grid_.nx - 1), level_.P, 1);
}

}  // namespace

template <int reach>
line_solvers::SmallPivot relax_along_line(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how) {
  return AlongLine<reach>(hierarchy, level, how).relax();
}
template line_solvers::SmallPivot relax_along_line<1>(Hierarchy&, Level&, const RelaxationParameters&);
template line_solvers::SmallPivot relax_along_line<2>(Hierarchy&, Level&, const RelaxationParameters&);
template line_solvers::SmallPivot relax_along_line<3>(Hierarchy&, Level&, const RelaxationParameters&);

}  // namespace ehl::multigrid
