#include "fmg/line_batch.hpp"

#include <algorithm>
#include <type_traits>

#include "reynolds/flux.hpp"

namespace ehl::fmg {

using core::LaneMask;
using core::Lanes;

namespace {

/// The values of a batch of lines j, j+2, .. at one station, and of the lines beside them.
struct Beside {
  Lanes south, own, north;
};
Lanes own_lines(const core::Field& field, int i, int j) {
  const double* p = field.at_x(i) + j;
  return core::evens(core::load(p), core::load(p + core::lanes));
}
Beside with_neighbours(const core::Field& field, int i, int j) {
  const double* p = field.at_x(i) + j;
  const Lanes low = core::load(p);
  const Lanes high = core::load(p + core::lanes);
  return {core::evens(core::load(p - 1), core::load(p + core::lanes - 1)), core::evens(low, high),
          core::odds(low, high)};
}

/// What the film does at a station: rho_bar, rho_bar H and d(rho_bar)/dP H.
struct FilmStation {
  Lanes rho_bar, rho_H, slope_H;
};
FilmStation film_station(const Level& level, int i, int j) {
  const Lanes H = own_lines(level.H, i, j);
  const Lanes rho_bar = own_lines(level.rho_bar, i, j);
  return {rho_bar, rho_bar * H, own_lines(level.drho_bar, i, j) * H};
}

/// Lanes where the point itself or one of its four neighbours is dry.
LaneMask beside_dry(reynolds::Cavitation cavitation, const core::Field& P, int i, int j) {
  const Beside here = with_neighbours(P, i, j);
  const Lanes least = core::min(core::min(own_lines(P, i - 1, j), own_lines(P, i + 1, j)),
                                core::min(here.own, core::min(here.south, here.north)));
  return reynolds::dry(cavitation, least);
}

// Holds the distributed changes of a batch to what is there: no point gives more than its pressure. What goes below
// zero is cut off, while its neighbours keep what they were given: pressure out of nothing, which a strong squeeze
// answers by far more.
void hold_to_what_is_there(Level& level, int colour, int batch) {
  const int j = first_line(colour, batch);
  const int at = batch * core::lanes;
  for (int i = 1; i < level.grid.nx; ++i) {
    double* delta = level.changes.delta.at_x(i) + at;
    double* distributed = level.changes.distributed.at_x(i) + at;
    const Lanes P = own_lines(level.P, i, j);
    const Lanes asked = core::load(distributed);
    const LaneMask too_much = asked < -P;
    core::store(delta, too_much ? -P : core::load(delta));
    core::store(distributed, too_much ? -P : asked);
  }
}

}  // namespace

ThreadWork make_thread_work(const core::Patch& grid, const film::Model& film, const RelaxationParameters& parameters) {
  const auto points = static_cast<std::size_t>(grid.nodes_x());
  ThreadWork work{.film = film::make_buffers(film, grid.nodes_y()),
                  .followed = std::vector<double>(static_cast<std::size_t>(grid.nodes_y())),
                  .west = std::vector<Lanes>(points),
                  .south = std::vector<Lanes>(points),
                  .north = std::vector<Lanes>(points),
                  .distributive = std::vector<Lanes>(points + 2 * ThreadWork::margin),
                  .far_squeeze = std::vector<Lanes>(points),
                  .solver = {}};
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

template <int reach, LineSolver solver>
void LineBatch<reach, solver>::read_coefficients(const Hierarchy& hierarchy, const Level& level, int j) {
  const core::Patch& grid = level.grid;
  const reynolds::HalfInverseSquares half(grid.hx(), grid.hy());
  const core::Field& eps_across = fmg::eps_across(level);
  const auto read = [&](auto anisotropic) {
    Lanes before = own_lines(level.eps, 0, j);
    for (int i = 1; i <= grid.nx; ++i) {
      const Beside across = with_neighbours(eps_across, i, j);
      const Lanes eps = anisotropic ? own_lines(level.eps, i, j) : across.own;
      const auto k = static_cast<std::size_t>(i);
      work_.west[k] = reynolds::conductance(before, eps, half.X);
      work_.south[k] = reynolds::conductance(across.south, across.own, half.Y);
      work_.north[k] = reynolds::conductance(across.own, across.north, half.Y);
      before = eps;
    }
  };
  if (film::anisotropic(hierarchy.problem.film))
    read(std::true_type{});
  else
    read(std::false_type{});
  // The crossover is where the coupling by epsilon outweighs that by the film.
  const double crossover = how_.crossover * reynolds::relative_strength(hierarchy.transport, grid.hx());
  const double crossover2 = crossover * crossover;
  const double squeeze = hierarchy.transport.squeeze;
  const Lanes far_single = core::broadcast(how_.far_squeeze * level.film_terms.K[0] * squeeze);
  const Lanes far_beside = core::broadcast(how_.far_squeeze_beside * squeeze);
  const auto choose_for = [&](auto squeezed, auto above_crossover) {
    for (int i = 1; i < grid.nx; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const LaneMask by_epsilon = above_crossover(k);
      LaneMask single = by_epsilon;
      // Beside the cavitated region too: what is cut off at P = 0 would leave half of a distributed change standing.
      single |= beside_dry(hierarchy.problem.cavitation, level.P, i, j);
      if constexpr (squeezed) work_.far_squeeze[k] = by_epsilon ? far_single : single ? far_beside : Lanes{};
      work_.distributive[k + ThreadWork::margin] = single ? Lanes{} : core::broadcast(1.0);
    }
  };
  const auto choose = [&](auto above_crossover) {
    if (squeeze > 0.0)
      choose_for(std::true_type{}, above_crossover);
    else
      choose_for(std::false_type{}, above_crossover);
  };
  // e_max sqrt(e_max/e_min) > crossover, without root and division; e_min = 0 makes it single unless e_max = 0 too.
  const auto above = [crossover2](Lanes largest, Lanes smallest) {
    return largest * largest * largest > crossover2 * smallest;
  };
  if (!film::anisotropic(hierarchy.problem.film)) {
    choose([&](std::size_t k) {
      return above(core::max(core::max(work_.west[k], work_.west[k + 1]), core::max(work_.south[k], work_.north[k])),
                   core::min(core::min(work_.west[k], work_.west[k + 1]), core::min(work_.south[k], work_.north[k])));
    });
    return;
  }
  // That epsilon along X is another one than along Y is no jump: e_max and e_min in each direction by itself.
  choose([&](std::size_t k) {
    return above(core::max(work_.west[k], work_.west[k + 1]), core::min(work_.west[k], work_.west[k + 1])) |
           above(core::max(work_.south[k], work_.north[k]), core::min(work_.south[k], work_.north[k]));
  });
}

template <int reach, LineSolver solver>
template <class Take>
void LineBatch<reach, solver>::assemble(const Hierarchy& hierarchy, const Level& level, int j, Take take) {
  const core::Patch& grid = level.grid;
  const reynolds::Cavitation cavitation = hierarchy.problem.cavitation;
  const LaneMask outside = ~inside(j, grid);
  const Lanes* distributive = work_.distributive.data() + ThreadWork::margin;
  Lanes P_west = own_lines(level.P, 0, j);
  Beside P = with_neighbours(level.P, 1, j);
  FilmStation film2{};
  FilmStation film1 = film_station(level, 0, j);
  for (int i = 1; i < grid.nx; ++i) {
    const Beside P_east = with_neighbours(level.P, i + 1, j);
    const FilmStation film0 = film_station(level, i, j);
    const auto k = static_cast<std::size_t>(i);
    const reynolds::Faces<Lanes> e{work_.west[k], work_.west[k + 1], work_.south[k], work_.north[k]};
    const auto c = reynolds::transport_weights(hierarchy.transport, i, grid.hx());

    line_solvers::PointEquation point;
    point.c = {c[0] * film0.rho_bar, c[1] * film1.rho_bar, c[2] * film2.rho_bar};
    point.r = reynolds::transported(c, film0.rho_H, film1.rho_H, film2.rho_H) -
              reynolds::poiseuille(e, P_west, P_east.own, P.south, P.north, P.own);
    if (level.f.nodes_x() > 0) point.r += own_lines(level.f, i, j);

    // From the coefficients of the pressure changes (Poiseuille, and the density's part of the wedge) to those of the
    // deltas: the pressure change at k is delta_k - (distributed_{k-1} + distributed_{k+1})/4.
    const auto dr = reynolds::pressure_row(c, e, film0.slope_H, film1.slope_H, film2.slope_H);
    const Lanes* d = distributive + i;
    point.a[0] = 0.25 * d[-2] * dr.west - dr.far_west;
    point.a[1] = 0.25 * d[-1] * (dr.far_west + dr.own) - dr.west;
    point.a[2] =
        0.25 * d[0] * (dr.west + dr.east + dr.south + dr.north) - dr.own - work_.far_squeeze[k] * film0.rho_bar;
    point.a[3] = 0.25 * d[1] * dr.own - dr.east;
    point.a[4] = 0.25 * d[2] * dr.east;

    line_solvers::BandRow<reach> row = line_solvers::eliminate_film<reach>(level.film_terms, point, d);
    // delta_{i-3} reaches the density's part at i-2 through its distribution.
    row.a[line_solvers::BandRow<reach>::lower - 3] += 0.25 * d[-3] * dr.far_west;
    LaneMask fixed = outside;
    // Otherwise the solution is no fixed point.
    fixed |= reynolds::stays_dry(cavitation, P.own, point.r);
    line_solvers::make_identity(row, fixed);
    take(i, row);

    P_west = P.own;
    P = P_east;
    film2 = film1;
    film1 = film0;
  }
}

template <int reach, LineSolver solver>
void LineBatch<reach, solver>::keep(Level& level, int batch, int i, Lanes delta) const {
  const auto k = static_cast<std::size_t>(i);
  const Lanes low = core::min(core::min(work_.west[k], work_.west[k + 1]), core::min(work_.south[k], work_.north[k]));
  const Lanes high = core::max(core::max(work_.west[k], work_.west[k + 1]), core::max(work_.south[k], work_.north[k]));
  // Weight of a single change: from `steep` up to the full one as the coefficients of the four half points come within
  // a factor 2 of each other.
  const double steep = how_.weight_single_steep;
  const double range = how_.weight_single - steep;
  const Lanes smooth = 2.0 * low >= high ? core::broadcast(1.0) : 2.0 * low / high;
  const Lanes distributive = work_.distributive[k + ThreadWork::margin];
  const Lanes weight = distributive > 0.0 ? core::broadcast(how_.weight_distributed) : steep + range * smooth;
  const int at = batch * core::lanes;
  core::store(level.changes.delta.at_x(i) + at, weight * delta);
  core::store(level.changes.distributed.at_x(i) + at, distributive * weight * delta);
}

template <int reach, LineSolver solver>
line_solvers::SmallPivot LineBatch<reach, solver>::solve(const Hierarchy& hierarchy, Level& level, int colour,
                                                         int batch) {
  const int j = first_line(colour, batch);
  const bool cut_off = reynolds::ruptures(hierarchy.problem.cavitation) && hierarchy.transport.squeeze > 0.0;
  read_coefficients(hierarchy, level, j);
  if constexpr (solver == LineSolver::elimination) {
    line_solvers::Elimination<reach> elimination(std::get<EliminationFactors<reach>>(work_.solver).data());
    assemble(hierarchy, level, j, [&](int, const line_solvers::BandRow<reach>& row) { elimination.push(row); });
    elimination.back_substitute([&](int i, Lanes delta) { keep(level, batch, i, delta); });
    if (cut_off) hold_to_what_is_there(level, colour, batch);
    return elimination.small_pivot();
  } else {
    auto& decimation = std::get<line_solvers::Decimation<reach>>(work_.solver);
    assemble(hierarchy, level, j, [&](int i, const line_solvers::BandRow<reach>& row) { decimation.set(i, row); });
    const line_solvers::SmallPivot small = decimation.solve();
    for (int i = 1; i < level.grid.nx; ++i) keep(level, batch, i, decimation.delta(i));
    if (cut_off) hold_to_what_is_there(level, colour, batch);
    return small;
  }
}

template class LineBatch<1, LineSolver::elimination>;
template class LineBatch<2, LineSolver::elimination>;
template class LineBatch<3, LineSolver::elimination>;
template class LineBatch<1, LineSolver::decimation>;
template class LineBatch<2, LineSolver::decimation>;
template class LineBatch<3, LineSolver::decimation>;

}  // namespace ehl::fmg
