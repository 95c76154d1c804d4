#include "multigrid/line_batch.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "multigrid/line_lanes.hpp"
#include "reynolds/content.hpp"

namespace ehl::multigrid {

using core::LaneMask;
using core::Lanes;

namespace {

/// The film in the columns of a row: rho_bar, rho_bar H and d(rho_bar)/dP H.
struct FilmAround {
  reynolds::Columns<Lanes> rho_bar{}, rho_H{}, slope_H{};

  /// Goes on to the next row, whose eastern column is i.
  void go_on(const Level& level, int i, int j) {
    const Lanes H = own_lines(level.H, i, j);
    const Lanes rho = own_lines(level.rho_bar, i, j);
    rho_bar = {rho_bar.east, rho_bar.own, rho_bar.west, rho};
    rho_H = {rho_H.east, rho_H.own, rho_H.west, rho * H};
    slope_H = {slope_H.east, slope_H.own, slope_H.west, own_lines(level.drho_bar, i, j) * H};
  }
};

/// Derivatives of r by the films in epsilon, which is proportional to H^3: the film of the column itself, of the
/// columns next to it, and of the two lines next to this one.
struct FilmOfEpsilon {
  Lanes own, west, east, across;
};

/// Derivatives of r by the film through epsilon. On coarse grids the flux through the side of an elongated contact is
/// the mean epsilon, that of a thick film outside, times nearly all of the pressure inside: that pressure is flux over
/// epsilon, and epsilon follows the film that it makes. Relaxed with epsilon held, it overshoots by 3 P dH/dP/H, and
/// the coarsest grid diverges. [bench: epsilon_follows_film]
/// in: beside, the share of the derivatives by the films of the neighbouring lines that the rows use, since these lines
/// change in turn; the pressures of the column and of its neighbours.
FilmOfEpsilon film_of_epsilon(double beside, const Level& level, int i, int j, const reynolds::HalfInverseSquares& half,
                              const reynolds::Cross<Lanes>& P) {
  const Beside H = with_neighbours(level.H, i, j);
  const Beside eps = with_neighbours(eps_across(level), i, j);
  const auto slope = [](Lanes e, Lanes h) {
    return h > 0.0 ? 3.0 * e / (h > 0.0 ? h : core::broadcast(1.0)) : Lanes{};
  };
  const auto at = [&](int k) { return slope(own_lines(level.eps, k, j), own_lines(level.H, k, j)); };
  const Lanes to_west = half.X * (P.own - P.west);
  const Lanes to_east = half.X * (P.own - P.east);
  const Lanes to_south = half.Y * (P.own - P.south), to_north = half.Y * (P.own - P.north);
  return {.own = at(i) * (to_west + to_east) + slope(eps.own, H.own) * (to_south + to_north),
          .west = at(i - 1) * to_west,
          .east = at(i + 1) * to_east,
          .across = beside * (slope(eps.south, H.south) * to_south + slope(eps.north, H.north) * to_north)};
}

/// True on the correcting grids of smooth steady ellipses. It slows down circular contacts with waves, and very hot
/// ones and some line contacts find no solution with it. [bench: epsilon_follows_film]
bool epsilon_follows_film(const Hierarchy& hierarchy, const Level& level) {
  const Problem& problem = hierarchy.problem;
  return corrects_finer(level) && problem.geometry.gap.closed() && !problem.geometry.gap.round() && !problem.surface &&
         hierarchy.transport.squeeze == 0.0 && !problem.film.given_epsilon;
}

void hold_batch(Level& level, int colour, int batch) {
  const int j = first_line(colour, batch);
  const int at = batch * core::lanes;
  for (int i = 1; i < level.grid.nx; ++i) {
    double* to_delta = level.changes.delta.at_x(i) + at;
    double* to_distributed = level.changes.distributed.at_x(i) + at;
    Lanes delta = core::load(to_delta), distributed = core::load(to_distributed);
    hold_to_what_is_there(own_lines(level.P, i, j), delta, distributed);
    core::store(to_delta, delta);
    core::store(to_distributed, distributed);
  }
}

}  // namespace

template <int reach, LineSolver solver>
template <Form form, class Take>
void LineBatch<reach, solver>::assemble(const Hierarchy& hierarchy, const Level& level, int j, Take take) {
  constexpr bool follows = form == Form::following_film;
  constexpr bool plain = form == Form::plain || follows;
  const core::Patch& grid = level.grid;
  const reynolds::Cavitation cavitation = hierarchy.problem.cavitation;
  const LaneMask outside = ~inside(j, grid);
  const Lanes* distributive = work_.distributive.data() + ThreadWork::margin;
  Lanes P_west = own_lines(level.P, 0, j);
  Beside P = with_neighbours(level.P, 1, j);
  FilmAround film;
  film.go_on(level, 0, j);
  film.go_on(level, 1, j);
  const reynolds::Transport transport = transport_on(hierarchy, level);
  const DistributedShares shares = distributed_shares(grid);
  const double film_beside = hierarchy.parameters.tuning.share_of_lines_beside;
  const reynolds::HalfInverseSquares half(grid);
  std::optional<reynolds::March<Lanes>> march;
  if constexpr (form == Form::mass_conserving) {
    Lanes supply{};
    for (int lane = 0; lane < core::lanes; ++lane)
      supply[lane] = level.content->supply[static_cast<std::size_t>(std::min(j + 2 * lane, grid.ny))];
    march.emplace(transport, grid.hx(), core::min(supply, film.rho_H.own), film.rho_H.own);
  }
  for (int i = 1; i < grid.nx; ++i) {
    const auto k = static_cast<std::size_t>(i);
    film.go_on(level, i + 1, j);
    const Beside P_east = with_neighbours(level.P, i + 1, j);
    const reynolds::Cross<Lanes> pressures{P_west, P_east.own, P.south, P.north, P.own};
    const reynolds::Faces<Lanes> e{work_.west[k], work_.west[k + 1], work_.south[k], work_.north[k]};
    const Lanes f = level.f.nodes_x() > 0 ? own_lines(level.f, i, j) : Lanes{};
    const auto theta = [&] {
      return reynolds::ThirdOrder<Lanes>{own_lines(level.third_order, i - 1, j), own_lines(level.third_order, i, j)};
    };
    Lanes r;
    const auto weights = [&] {
      if constexpr (form == Form::mass_conserving) {
        r = march->residual(film.rho_H.own, film.rho_H.east,
                            reynolds::third_order(transport.wedge) ? theta() : reynolds::ThirdOrder<Lanes>{},
                            reynolds::poiseuille(e, pressures) - f);
        return march->weights();
      } else {
        return reynolds::wedge_weights<!plain, Lanes>(reynolds::transport_weights(transport, i, grid.hx()), transport,
                                                      grid.hx(), theta);
      }
    }();
    if constexpr (form != Form::mass_conserving) r = reynolds::residual(weights, e, film.rho_H, pressures) + f;
    // By the pressure changes: Poiseuille terms, and the wedge through the density.
    reynolds::PressureRow<Lanes> dr = reynolds::by_pressure(weights, e, film.slope_H);
    if (!plain && at_half_points(level)) reynolds::add(work_.answers[k], dr);
    if constexpr (form == Form::mass_conserving) {
      const Lanes back = at_half_points(level) ? e.west + work_.answers_west[k] : e.west;
      dr.own -= march->behind_dry() ? march->part_that_returns() * back : Lanes{};
      march->go_on(film.rho_H.own, P.own <= 0.0, r, own_lines(level.content->chatters, i, j) > 0.0);
    }

    FilmOfEpsilon of_epsilon{};
    line_solvers::PointEquation<form == Form::plain ? 3 : 4> point;
    if constexpr (follows) {
      std::array<Lanes, 3> by_film;
      reynolds::by_film(weights, film.rho_bar, by_film);
      of_epsilon = film_of_epsilon(film_beside, level, i, j, half, pressures);
      point.c = {by_film[0] + of_epsilon.own, by_film[1] + of_epsilon.west, by_film[2], of_epsilon.east};
    } else {
      reynolds::by_film(weights, film.rho_bar, point.c);
    }
    point.r = r;
    const Lanes* d = distributive + i;
    line_solvers::BandRow<reach> row = band_row<reach>(
        level.film_terms, shares, point, dr, [d](int q) { return d[q]; }, work_.far_squeeze[k] * film.rho_bar.own);
    if constexpr (follows)
      for (int q = -reach; q <= reach; ++q)
        row.a[static_cast<std::size_t>(line_solvers::BandRow<reach>::lower + q)] -=
            (1.0 - d[q]) * of_epsilon.across * film_response(level, q, 1);
    // Without these identity rows the solution would be no fixed point of the relaxation.
    line_solvers::make_identity(row, outside | reynolds::stays_dry(cavitation, P.own, r));
    take(i, row);

    P_west = P.own;
    P = P_east;
  }
}

template <int reach, LineSolver solver>
Lanes LineBatch<reach, solver>::weight_at(int i) const {
  const auto k = static_cast<std::size_t>(i);
  return weight_of_change(how_, work_.distributive[k + ThreadWork::margin], work_.range_of(k));
}

template <int reach, LineSolver solver>
void LineBatch<reach, solver>::keep(Level& level, int batch, int i, Lanes delta, Lanes weight) const {
  const Lanes distributive = work_.distributive[static_cast<std::size_t>(i) + ThreadWork::margin];
  const int at = batch * core::lanes;
  const Lanes change = bounded(how_, weight * delta);
  core::store(level.changes.delta.at_x(i) + at, change);
  core::store(level.changes.distributed.at_x(i) + at, distributive * change);
}

// Steady line contacts: the weight goes on the whole change of each pressure, and nothing remains to be distributed
// (see apply() in line_relaxation.cpp).
template <int reach, LineSolver solver>
void LineBatch<reach, solver>::weigh_pressures(Level& level, int batch) const {
  const int at = batch * core::lanes;
  const double share = distributed_shares(level.grid).along;
  Lanes west{}, here = core::load(level.changes.distributed.at_x(1) + at);
  for (int i = 1; i < level.grid.nx; ++i) {
    const Lanes east = core::load(level.changes.distributed.at_x(i + 1) + at);
    double* delta = level.changes.delta.at_x(i) + at;
    core::store(delta, weight_at(i) * (core::load(delta) - share * (west + east)));
    core::store(level.changes.distributed.at_x(i) + at, Lanes{});
    west = here;
    here = east;
  }
}

template <int reach, LineSolver solver>
line_solvers::SmallPivot LineBatch<reach, solver>::solve(const Hierarchy& hierarchy, Level& level, int colour,
                                                         int batch) {
  const int j = first_line(colour, batch);
  const bool in_time = hierarchy.transport.squeeze > 0.0;
  const bool by_pressures = level.grid.domain.line && !in_time;
  const auto keep_one = [&](int i, Lanes delta) {
    keep(level, batch, i, delta, by_pressures ? core::broadcast(1.0) : weight_at(i));
  };
  const auto end = [&] {
    if (by_pressures) weigh_pressures(level, batch);
    if (in_time && reynolds::ruptures(hierarchy.problem.cavitation)) hold_batch(level, colour, batch);
  };
  LineCoefficients(work_, how_).read(hierarchy, level, j);
  const auto assemble_by_scheme = [&](auto take) {
    if (conserves_mass(level))
      assemble<Form::mass_conserving>(hierarchy, level, j, take);
    else if (at_half_points(level) || reynolds::third_order(level.scheme.wedge))
      assemble<Form::general>(hierarchy, level, j, take);
    else if (epsilon_follows_film(hierarchy, level))
      assemble<Form::following_film>(hierarchy, level, j, take);
    else
      assemble<Form::plain>(hierarchy, level, j, take);
  };
  if constexpr (solver == LineSolver::elimination) {
    line_solvers::Elimination<reach> elimination(std::get<EliminationFactors<reach>>(work_.solver).data());
    assemble_by_scheme([&](int, const line_solvers::BandRow<reach>& row) { elimination.push(row); });
    elimination.back_substitute(keep_one);
    end();
    return elimination.small_pivot();
  } else {
    auto& decimation = std::get<line_solvers::Decimation<reach>>(work_.solver);
    assemble_by_scheme([&](int i, const line_solvers::BandRow<reach>& row) { decimation.set(i, row); });
    const line_solvers::SmallPivot small = decimation.solve();
    for (int i = 1; i < level.grid.nx; ++i) keep_one(i, decimation.delta(i));
    end();
    return small;
  }
}

template class LineBatch<1, LineSolver::elimination>;
template class LineBatch<2, LineSolver::elimination>;
template class LineBatch<3, LineSolver::elimination>;
template class LineBatch<1, LineSolver::decimation>;
template class LineBatch<2, LineSolver::decimation>;
template class LineBatch<3, LineSolver::decimation>;

}  // namespace ehl::multigrid
