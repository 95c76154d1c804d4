#include "multigrid/coarse_problem.hpp"

#include <algorithm>

#include "multigrid/boundary.hpp"
#include "reynolds/content.hpp"
#include "transfer/transfer.hpp"

namespace ehl::multigrid {
namespace {

/// Shares of a residual that go to the four neighbours.
using Shares = reynolds::Faces<double>;

template <reynolds::Face face>
class Coupling {
 public:
  Coupling(const Level& level, double elastic)
      : eps_(level.eps),
        eps_across_(eps_across(level)),
        elastic_(elastic),
        elastic_across_(elastic * core::stretch(level.grid)),
        half_(level.grid) {}

  double west(int i, int j) const { return along(i - 1, j); }
  double east(int i, int j) const { return along(i, j); }
  double south(int i, int j) const { return across(i, j - 1); }
  double north(int i, int j) const { return across(i, j); }

  Shares to_all(int i, int j) const {
    const Shares e{west(i, j), east(i, j), south(i, j), north(i, j)};
    const double all = reynolds::total(e);
    return {e.west / all, e.east / all, e.south / all, e.north / all};
  }
  double share_west(int i, int j) const { return west(i, j) / (west(i, j) + east(i, j)); }
  double share_east(int i, int j) const { return east(i, j) / (west(i, j) + east(i, j)); }
  double share_south(int i, int j) const { return south(i, j) / (south(i, j) + north(i, j)); }
  double share_north(int i, int j) const { return north(i, j) / (south(i, j) + north(i, j)); }

 private:
  double along(int i, int j) const {
    return elastic_ + reynolds::conductance(face, eps_(i, j), eps_(i + 1, j), half_.X);
  }
  double across(int i, int j) const {
    return elastic_across_ + reynolds::conductance(face, eps_across_(i, j), eps_across_(i, j + 1), half_.Y);
  }

  const core::Field& eps_;
  const core::Field& eps_across_;
  double elastic_, elastic_across_;
  reynolds::HalfInverseSquares half_;
};

// The column of the finer grid that is column I of a coarser one.
int finer_station(const Level& fine, const Level& coarse, int I) { return fine.grid.nx == coarse.grid.nx ? I : 2 * I; }

// The points next to cavitated ones that are left to relaxation: without residual and correction.
reynolds::Neighbours left_to_relaxation(const Level& fine, const Level& coarse) {
  const bool across_alone = fine.grid.nx == coarse.grid.nx;
  return across_alone ? reynolds::Neighbours::across : reynolds::Neighbours::all;
}

// f of the coarse grid begins as minus the slack of the fine one; the other terms are added later.
void take_slack(reynolds::Cavitation cavitation, const Level& fine, Level& coarse) {
  coarse.f.fill(0.0);
  for (int I = 1; I < coarse.grid.nx; ++I)
    for (int J = 1; J <= coarse.grid.last_line(); ++J) {
      const int i = finer_station(fine, coarse, I);
      const int j = coarse.grid.finer_line(J);
      coarse.f(I, J) = 0.0 - reynolds::slack(cavitation, fine.P(i, j), fine.r(i, j));
    }
}

// Q is injected where a node is not full, as the pressure is where it is full. f then makes the coarse grid's march
// along X give this Q, and the slack of such a point is how far it is from being full.
void restrict_content(const Level& fine, Level& coarse) {
  for (int J = 0; J <= coarse.grid.ny; ++J) {
    const int j = coarse.grid.finer_line(J);
    coarse.content->supply[static_cast<std::size_t>(J)] = fine.content->supply[static_cast<std::size_t>(j)];
    for (int I = 0; I <= coarse.grid.nx; ++I) {
      const int i = finer_station(fine, coarse, I);
      const double Q = fine.content->Q(i, j);
      const double full = coarse.rho_bar(I, J) * coarse.H(I, J);
      const bool lacks = Q < fine.rho_bar(i, j) * fine.H(i, j);
      coarse.content->Q(I, J) = lacks ? std::min(Q, full) : full;
    }
  }
}

template <reynolds::Face face>
void restrict_by_coupling(const Level& fine, double elastic, int threads, core::Field& coarse) {
  const Coupling<face> coupling(fine, elastic);
  const core::Field& r = fine.r;
  const bool across_alone = coarse.nodes_x() == r.nodes_x();
  const core::Patch grid = across_alone ? core::coarsened_across(fine.grid) : core::coarsened(fine.grid);
  const int last_J = grid.last_line();
  if (across_alone) {
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (int i = 1; i < grid.nx; ++i)
      for (int J = 1; J <= last_J; ++J) {
        const int j = 2 * J;
        coarse(i, J) = 0.5 * (r(i, j) + coupling.share_north(i, j - 1) * r(i, j - 1) +
                              coupling.share_south(i, j + 1) * r(i, j + 1));
      }
    return;
  }
  if (grid.finer_line(1) == 1) {  // coarser along X alone
    for (int I = 1; I < grid.nx; ++I) {
      const int i = 2 * I;
      coarse(I, 1) =
          0.5 * (r(i, 1) + coupling.share_east(i - 1, 1) * r(i - 1, 1) + coupling.share_west(i + 1, 1) * r(i + 1, 1));
    }
    return;
  }
  // Residual of a point between two coarse columns, with the shares that it gets from the centre points of its column.
  const auto column_point = [&](int i, int j) {
    return r(i, j) + coupling.to_all(i, j - 1).north * r(i, j - 1) + coupling.to_all(i, j + 1).south * r(i, j + 1);
  };
  const auto row_point = [&](int i, int j) {
    return r(i, j) + coupling.to_all(i - 1, j).east * r(i - 1, j) + coupling.to_all(i + 1, j).west * r(i + 1, j);
  };
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int I = 1; I < grid.nx; ++I) {
    const int i = 2 * I;
    for (int J = 1; J <= last_J; ++J) {
      const int j = 2 * J;
      coarse(I, J) = 0.25 * (r(i, j) + coupling.share_east(i - 1, j) * column_point(i - 1, j) +
                             coupling.share_west(i + 1, j) * column_point(i + 1, j) +
                             coupling.share_north(i, j - 1) * row_point(i, j - 1) +
                             coupling.share_south(i, j + 1) * row_point(i, j + 1));
    }
  }
}

// The part of a point's coupling to its neighbours that the elastic film provides.
double elastic_coupling(const Hierarchy& hierarchy, const Level& fine) {
  return hierarchy.parameters.tuning.elastic_coupling *
         reynolds::relative_strength(hierarchy.transport, fine.grid.hx());
}

// Interpolation weighted by face conductances. Columns that hold coarse points are interpolated along Y. In the columns
// between, points on a line with coarse points are interpolated along X, the others from their four neighbours.
template <reynolds::Face face>
void prolong_by_coupling(const Level& fine, double elastic, const core::Field& coarse, int threads,
                         core::Field& correction) {
  const Coupling<face> coupling(fine, elastic);
  const core::Patch& grid = fine.grid;
  const int step = coarse.nodes_x() == correction.nodes_x() ? 1 : 2;  // between columns with coarse points
  const int end_of_between = step == 1 ? 0 : grid.nx;                 // none between if all hold some
#pragma omp parallel num_threads(threads) if (threads > 1)
  {
#pragma omp for schedule(static)
    for (int i = 0; i <= grid.nx; i += step) {
      const double* from = coarse.at_x(i / step);
      double* to = correction.at_x(i);
      for (int j = 0; j <= grid.ny; ++j)
        to[j] = j % 2 == 0 ? from[j / 2]
                           : coupling.share_south(i, j) * from[j / 2] + coupling.share_north(i, j) * from[j / 2 + 1];
    }
#pragma omp for schedule(static)
    for (int i = 1; i < end_of_between; i += 2) {
      const double* west = correction.at_x(i - 1);
      const double* east = correction.at_x(i + 1);
      double* to = correction.at_x(i);
      for (int j = 0; j <= grid.ny; j += 2)
        to[j] = coupling.share_west(i, j) * west[j] + coupling.share_east(i, j) * east[j];
      for (int j = 1; j < grid.ny; j += 2) {
        const Shares share = coupling.to_all(i, j);
        to[j] = share.west * west[j] + share.east * east[j] + share.south * to[j - 1] + share.north * to[j + 1];
      }
    }
  }
}

// Bilinear; weighted by face conductances (linear where epsilon is constant) where the top of a spike may have its
// flank on the next line: on stretched cells, in oblique contacts, and where cycles were slow (`weighted`). There the
// coarse grid changes points at the top of the spike by large amounts, since their own equations hardly respond. Half
// of such a change is far too much for a point next to them whose epsilon is orders larger. [bench:
// weighted_interpolation]
void prolong_correction(const Hierarchy& hierarchy, const Level& fine, const core::Field& coarse, bool weighted,
                        core::Field& correction) {
  const int threads = hierarchy.threads_on(fine.grid);
  const double elastic = elastic_coupling(hierarchy, fine);
  const bool across_alone = coarse.nodes_x() == correction.nodes_x();
  if (!reynolds::flows_aside(fine.grid) || !(weighted || across_alone || hierarchy.problem.geometry.gap.oblique()))
    transfer::prolong_bilinear(coarse, correction, threads);
  else if (at_half_points(fine))
    prolong_by_coupling<reynolds::Face::logmean>(fine, elastic, coarse, threads, correction);
  else
    prolong_by_coupling<reynolds::Face::mean>(fine, elastic, coarse, threads, correction);
}

}  // namespace

void restrict_residual(const Hierarchy& hierarchy, const Level& fine, core::Field& coarse) {
  const double elastic = elastic_coupling(hierarchy, fine);
  const int threads = hierarchy.threads_on(fine.grid);
  if (at_half_points(fine))
    restrict_by_coupling<reynolds::Face::logmean>(fine, elastic, threads, coarse);
  else
    restrict_by_coupling<reynolds::Face::mean>(fine, elastic, threads, coarse);
}

void restrict_problem(Hierarchy& hierarchy, Level& fine, Level& coarse) {
  const Problem& problem = hierarchy.problem;
  const int threads = hierarchy.threads_on(fine.grid);
  update_residual(hierarchy, fine);
  {
    const core::ScopedTimer timer(hierarchy.times, core::Part::transfer);
    reynolds::restrict_pressure(problem.cavitation, fine.P, coarse.grid, coarse.P);
    core::copy(coarse.P, coarse.finer->P);
    transfer::restrict_injection(fine.H, coarse.finer->H);
    if (conserves_mass(fine))
      coarse.f.fill(0.0);
    else
      take_slack(problem.cavitation, fine, coarse);
    reynolds::drop_beside_dry(problem.cavitation, fine.grid, fine.P, threads, fine.r, left_to_relaxation(fine, coarse));
    coarse.role = Role::corrects;
    coarse.H00_of_boundary = fine.H00_of_boundary;
    coarse.scheme = coarse_scheme_of(problem);
  }
  // F = injected H - (H00 + geometry + K*P): the coarse film equation then gives the injected film at the restricted P.
  {
    const core::ScopedTimer timer(hierarchy.times, core::Part::deformation);
    coarse.deformation.evaluate(pressure_on_bodies(coarse), coarse.F);
    ++coarse.evaluations;
  }
  const core::Patch& grid = coarse.grid;
  core::set_nodes(grid, coarse.F, [&](int i, int j) {
    return coarse.finer->H(i, j) - (rigid_gap(problem.geometry, grid, hierarchy.H00, i, j) + coarse.F(i, j));
  });
  core::copy(coarse.finer->H, coarse.H);
  update_coefficients(hierarchy, coarse);
  // f = L(restricted P) + restricted residual + slack: the residual with f = -slack is -slack - L.
  if (conserves_mass(fine)) {
    restrict_content(fine, coarse);
    reynolds::residual_of_content(grid, fields(coarse), {coarse.content->Q, coarse.content->supply},
                                  transport_on(hierarchy, coarse), hierarchy.threads_on(grid), coarse.r);
  } else {
    update_residual(hierarchy, coarse);
  }
  const core::ScopedTimer timer(hierarchy.times, core::Part::transfer);
  restrict_residual(hierarchy, fine, coarse.f);
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) coarse.f(i, j) -= coarse.r(i, j);
  coarse.load = fine.load - carried_load(fine) + carried_load(coarse);
}

void correct_from_coarse(Hierarchy& hierarchy, Level& coarse, Level& fine, bool weighted) {
  {
    const core::ScopedTimer timer(hierarchy.times, core::Part::transfer);
    const reynolds::Cavitation cavitation = hierarchy.problem.cavitation;
    core::Field& correction = coarse.correction;
    core::set_nodes(coarse.grid, correction, [&](int i, int j) { return coarse.P(i, j) - coarse.finer->P(i, j); });
    prolong_correction(hierarchy, fine, correction, weighted, fine.correction);
    // Points whose residual was not restricted get no correction.
    reynolds::drop_beside_dry(cavitation, fine.grid, fine.P, hierarchy.threads_on(fine.grid), fine.correction,
                              left_to_relaxation(fine, coarse));
    for (int i = 1; i < fine.grid.nx; ++i) {
      double* P = fine.P.at_x(i);
      const double* change = fine.correction.at_x(i);
      for (int j = 1; j <= fine.grid.last_line(); ++j) P[j] = reynolds::corrected(cavitation, P[j], change[j]);
      core::fill_ghosts(fine.grid, P);
    }
  }
  follow_H00(hierarchy, fine);
  update_film(hierarchy, fine);
}

}  // namespace ehl::multigrid
