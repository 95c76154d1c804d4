// The coefficients of the line systems of a batch, and which points are relaxed singly.
#include <algorithm>
#include <type_traits>

#include "film/half_points.hpp"
#include "multigrid/line_batch.hpp"
#include "multigrid/line_lanes.hpp"
#include "multigrid/line_relaxation.hpp"
#include "multigrid/relaxation.hpp"
#include "reynolds/row.hpp"

namespace ehl::multigrid {

using core::LaneMask;
using core::Lanes;

namespace {

/// Lanes where the point itself or one of its four neighbours is cavitated.
LaneMask beside_dry(reynolds::Cavitation cavitation, const core::Field& P, int i, int j) {
  const Beside here = with_neighbours(P, i, j);
  const Lanes least = core::min(core::min(own_lines(P, i - 1, j), own_lines(P, i + 1, j)),
                                core::min(here.own, core::min(here.south, here.north)));
  return reynolds::dry(cavitation, least);
}

}  // namespace

LineSystem make_line_system(const core::Patch& grid, int reach) {
  const LineSystem::Values zero(static_cast<std::size_t>(grid.nodes_x() + 2 * LineSystem::margin));
  const auto points = static_cast<std::size_t>(grid.nodes_x());
  LineSystem system;
  for (LineSystem::Values* values :
       {&system.P, &system.rho_bar, &system.rho_H, &system.slope_H, &system.eps, &system.third_order, &system.f,
        &system.fluidity, &system.log_viscosity, &system.west, &system.answer_before, &system.answer_behind,
        &system.distributive, &system.far_squeeze, &system.delta, &system.distributed})
    *values = zero;
  switch (reach) {
    case 1: system.factors.emplace<OneLineFactors<1>>(points); break;
    case 2: system.factors.emplace<OneLineFactors<2>>(points); break;
    default: system.factors.emplace<OneLineFactors<3>>(points); break;
  }
  return system;
}

bool relaxes_along_line(const core::Patch& grid, const RelaxationParameters& parameters,
                        reynolds::Cavitation cavitation) {
  return grid.domain.line && parameters.line_solver == LineSolver::elimination && !reynolds::conserves(cavitation);
}

ThreadWork make_thread_work(const core::Patch& grid, const film::Model& film, const RelaxationParameters& parameters,
                            reynolds::Cavitation cavitation) {
  const std::vector<double> across(static_cast<std::size_t>(grid.nodes_y()));
  const bool line = grid.domain.line;
  ThreadWork work{.film = film::make_buffers(film, line ? grid.nodes_x() : grid.nodes_y()),
                  .line_nodes = line ? make_line_nodes(grid, film::anisotropic(film)) : LineNodes{},
                  .line_system = {},
                  .followed = std::vector<double>(static_cast<std::size_t>(grid.nodes_y()) + 2),
                  .followed_behind = std::vector<double>(static_cast<std::size_t>(grid.nodes_y())),
                  .rows_across = std::vector<RowAcross>(across.size()),
                  .eps_P = across,
                  .eps_H = across,
                  .eps_across_P = film::anisotropic(film) ? across : std::vector<double>{},
                  .eps_across_H = film::anisotropic(film) ? across : std::vector<double>{},
                  .flows_aside = reynolds::flows_aside(grid),
                  .stretch = core::stretch(grid),
                  .west = {},
                  .south = {},
                  .north = {},
                  .answers = {},
                  .answers_west = {},
                  .distributive = {},
                  .far_squeeze = {},
                  .solver = {}};
  if (relaxes_along_line(grid, parameters, cavitation)) {
    work.line_system = make_line_system(grid, parameters.reach);
    return work;
  }
  const auto points = static_cast<std::size_t>(grid.nodes_x());
  work.west = work.south = work.north = work.far_squeeze = std::vector<Lanes>(points);
  work.distributive = std::vector<Lanes>(points + 2 * ThreadWork::margin);
  const auto prepare = [&]<int reach>(std::integral_constant<int, reach>) {
    if (parameters.line_solver == LineSolver::elimination)
      work.solver.emplace<EliminationFactors<reach>>(points);
    else
      work.solver.emplace<line_solvers::Decimation<reach>>(grid.nx - 1);
  };
  switch (parameters.reach) {
    case 1: prepare(std::integral_constant<int, 1>{}); break;
    case 2: prepare(std::integral_constant<int, 2>{}); break;
    default: prepare(std::integral_constant<int, 3>{}); break;
  }
  return work;
}

void LineCoefficients::read_answers(const Tuning& tuning, const Level& level, int j) {
  const double least = reynolds::least_share(level.scheme.face);
  const OilFields& oil = level.oil;
  const bool thinned = oil.fluidity_across.nodes_x() > 0;
  const core::Field& phi_across = thinned ? oil.fluidity_across : oil.fluidity;
  const core::Field& a_across = thinned ? oil.log_viscosity_across : oil.log_viscosity;
  // Along a line, whose points are solved together, the row has all of the viscosity's derivatives; across it, a share
  // of them. A point at the top of a spike depends so little on its own pressure, and so much on those of its
  // neighbours, that lines with the whole derivative across them diverge.
  const double across = tuning.share_of_lines_beside;
  Lanes phi = own_lines(oil.fluidity, 1, j);
  Lanes a = own_lines(oil.log_viscosity, 1, j);
  auto west = film::answers(least, own_lines(oil.fluidity, 0, j), phi, own_lines(oil.log_viscosity, 0, j), a);
  for (int i = 1; i < level.grid.nx; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Lanes phi_east = own_lines(oil.fluidity, i + 1, j);
    const Lanes a_east = own_lines(oil.log_viscosity, i + 1, j);
    const auto east = film::answers(least, phi, phi_east, a, a_east);
    const Beside phi_here = with_neighbours(phi_across, i, j);
    const Beside a_here = with_neighbours(a_across, i, j);
    const auto south = film::answers(least, phi_here.south, phi_here.own, a_here.south, a_here.own);
    const auto north = film::answers(least, phi_here.own, phi_here.north, a_here.own, a_here.north);
    work_.answers[k] = viscosity_row<Lanes>(
        {work_.west[k], work_.west[k + 1], across * work_.south[k], across * work_.north[k]}, west, east, south, north);
    work_.answers_west[k] = work_.west[k] * (west.behind - 1.0);
    west = east;
    phi = phi_east;
    a = a_east;
  }
}

void LineCoefficients::read(const Hierarchy& hierarchy, const Level& level, int j) {
  const core::Patch& grid = level.grid;
  const reynolds::HalfInverseSquares half(grid);
  const core::Field& eps_across = multigrid::eps_across(level);
  const auto read = [&](auto face, auto two) {
    Lanes before = own_lines(level.eps, 0, j);
    for (int i = 1; i <= grid.nx; ++i) {
      const Beside across = with_neighbours(eps_across, i, j);
      const Lanes eps = two ? own_lines(level.eps, i, j) : across.own;
      const auto k = static_cast<std::size_t>(i);
      work_.west[k] = reynolds::conductance(face, before, eps, half.X);
      work_.south[k] = reynolds::conductance(face, across.south, across.own, half.Y);
      work_.north[k] = reynolds::conductance(face, across.own, across.north, half.Y);
      before = eps;
    }
  };
  using reynolds::Face;
  if (at_half_points(level)) {
    read(std::integral_constant<Face, Face::logmean>{}, std::true_type{});
    read_answers(hierarchy.parameters.tuning, level, j);
  } else if (film::anisotropic(hierarchy.problem.film)) {
    read(std::integral_constant<Face, Face::mean>{}, std::true_type{});
  } else {
    read(std::integral_constant<Face, Face::mean>{}, std::false_type{});
  }
  const double stretch = core::stretch(grid);
  const KindRule rule(hierarchy, level, how_);
  const auto choose_for = [&](auto squeezed, auto above_crossover) {
    for (int i = 1; i < grid.nx; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const LaneMask by_epsilon = above_crossover(k);
      LaneMask single = by_epsilon;
      // Next to the cavitated region, too: where P is cut off at 0, the neighbours would keep their part of the change.
      single |= beside_dry(hierarchy.problem.cavitation, level.P, i, j);
      if constexpr (squeezed) work_.far_squeeze[k] = rule.squeezed(by_epsilon, single);
      work_.distributive[k + ThreadWork::margin] = single ? Lanes{} : core::broadcast(1.0);
    }
  };
  const auto choose = [&](auto above_crossover) {
    if (hierarchy.transport.squeeze > 0.0)
      choose_for(std::true_type{}, above_crossover);
    else
      choose_for(std::false_type{}, above_crossover);
  };
  if (!film::anisotropic(hierarchy.problem.film)) {
    choose([&](std::size_t k) {
      const auto [low, high] = work_.range_of(k);
      return rule.single(high, low);
    });
    return;
  }
  // With shear thinning epsilon along X differs from that along Y, which is no jump: e_max and e_min are taken in each
  // direction separately.
  choose([&](std::size_t k) {
    const auto along = [&](Lanes e) { return stretch * e; };
    const auto across = [&](Lanes e) { return e / stretch; };
    return rule.single(along(core::max(work_.west[k], work_.west[k + 1])),
                       along(core::min(work_.west[k], work_.west[k + 1]))) |
           rule.single(across(core::max(work_.south[k], work_.north[k])),
                       across(core::min(work_.south[k], work_.north[k])));
  });
}

}  // namespace ehl::multigrid
