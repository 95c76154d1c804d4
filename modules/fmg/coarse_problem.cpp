#include "fmg/coarse_problem.hpp"

#include <array>

#include "transfer/transfer.hpp"

namespace ehl::fmg {
namespace {

/// The part of a point's coupling to its neighbours that the elastic film provides, in units of epsilon/h^2.
constexpr double elastic_coupling = 0.5;
// epsilon on a coarse grid follows a falling film only down to this share of the finer grid's: a coarse film that
// touches zero would cut the contact off from its surroundings.
constexpr double coarse_film_floor = 0.9;

/// Shares of a residual that go to the four neighbours.
struct Shares {
  double west, east, south, north;
};

class Coupling {
 public:
  Coupling(const Level& level, double elastic)
      : eps_(level.eps),
        eps_across_(eps_across(level)),
        elastic_(elastic),
        half_over_hx2_(0.5 / (level.grid.hx() * level.grid.hx())),
        half_over_hy2_(0.5 / (level.grid.hy() * level.grid.hy())) {}

  double west(int i, int j) const { return elastic_ + (eps_(i - 1, j) + eps_(i, j)) * half_over_hx2_; }
  double east(int i, int j) const { return elastic_ + (eps_(i + 1, j) + eps_(i, j)) * half_over_hx2_; }
  double south(int i, int j) const { return elastic_ + (eps_across_(i, j - 1) + eps_across_(i, j)) * half_over_hy2_; }
  double north(int i, int j) const { return elastic_ + (eps_across_(i, j + 1) + eps_across_(i, j)) * half_over_hy2_; }

  Shares to_all(int i, int j) const {
    const Shares e{west(i, j), east(i, j), south(i, j), north(i, j)};
    const double total = e.west + e.east + e.south + e.north;
    return {e.west / total, e.east / total, e.south / total, e.north / total};
  }
  double share_west(int i, int j) const { return west(i, j) / (west(i, j) + east(i, j)); }
  double share_east(int i, int j) const { return east(i, j) / (west(i, j) + east(i, j)); }
  double share_south(int i, int j) const { return south(i, j) / (south(i, j) + north(i, j)); }
  double share_north(int i, int j) const { return north(i, j) / (south(i, j) + north(i, j)); }

 private:
  const core::Field& eps_;
  const core::Field& eps_across_;
  double elastic_;
  double half_over_hx2_;
  double half_over_hy2_;
};

// Sets a residual or a correction to zero where a point is cavitated or has a cavitated one among its eight neighbours:
// the edge of the cavitated region is left to the relaxation of its own grid.
void drop_near_cavitation(const core::Grid& grid, const core::Field& P, int threads, core::Field& r) {
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int i = 1; i < grid.nx; ++i) {
    const double* here = P.at_x(i);
    // The boundary's zero is no cavitation: beside it the row itself is looked at twice.
    const double* west = i > 1 ? P.at_x(i - 1) : here;
    const double* east = i < grid.nx - 1 ? P.at_x(i + 1) : here;
    double* out = r.at_x(i);
    const auto dry = [&](int j) { return west[j] <= 0.0 || here[j] <= 0.0 || east[j] <= 0.0; };
    bool south = dry(1);
    bool own = south;
    const int last = grid.last_line();
    for (int j = 1; j <= last; ++j) {
      const bool north = j < last ? dry(j + 1) : own;  // behind the axis comes the image of the line to the south
      if (south || own || north) out[j] = 0.0;
      south = own;
      own = north;
    }
    core::make_images(grid, out);
  }
}

// By how much a cavitated point of the fine grid is away from carrying pressure, with the sign turned. The coarse point
// must be as far away: with no slack it would be on the edge, and the coarse correction would rise there and never
// fall.
void take_slack(const Level& fine, core::Field& minus_slack) {
  const core::Grid coarse = core::coarsened(fine.grid);
  for (int I = 1; I < coarse.nx; ++I)
    for (int J = 1; J <= coarse.last_line(); ++J)
      if (fine.P(2 * I, 2 * J) <= 0.0 && fine.r(2 * I, 2 * J) > 0.0) minus_slack(I, J) = -fine.r(2 * I, 2 * J);
}

void restrict_pressure(const core::Field& fine, bool cavitation, const core::Grid& grid, core::Field& coarse) {
  if (!cavitation) {
    transfer::restrict_full_weighting(grid, fine, coarse);
    core::make_images(grid, coarse);
    return;
  }
  transfer::restrict_injection(fine, coarse);
  for (int I = 1; I < grid.nx; ++I) {
    const std::array<const double*, 3> rows{fine.at_x(2 * I - 1), fine.at_x(2 * I), fine.at_x(2 * I + 1)};
    double* to = coarse.at_x(I);
    for (int J = 1; J <= grid.last_line(); ++J) {
      const int j = 2 * J;
      double weighted = 0.0;
      bool all_carry = true;
      for (int a = 0; a < 3; ++a) {
        const double* row = rows[static_cast<std::size_t>(a)];
        all_carry = all_carry && row[j - 1] > 0.0 && row[j] > 0.0 && row[j + 1] > 0.0;
        weighted += (a == 1 ? 2.0 : 1.0) * (row[j - 1] + 2.0 * row[j] + row[j + 1]);
      }
      if (all_carry) to[J] = weighted / 16.0;
    }
    core::make_images(grid, to);
  }
}

}  // namespace

void restrict_residual(const Level& fine, const reynolds::Transport& transport, int threads, core::Field& coarse) {
  const Coupling coupling(fine, elastic_coupling * transport.strength(fine.grid.hx()));
  const core::Field& r = fine.r;
  const core::Grid grid = core::coarsened(fine.grid);
  const int last_J = grid.last_line();
  // Residual of a point between two coarse columns, with what the centre points of its column give it.
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

void restrict_problem(Hierarchy& hierarchy, Level& fine, Level& coarse) {
  const Problem& problem = hierarchy.problem;
  const int threads = hierarchy.threads_on(fine.grid);
  update_residual(hierarchy, fine);
  {
    const core::ScopedTimer timer(hierarchy.times, core::Part::transfer);
    restrict_pressure(fine.P, problem.cavitation, coarse.grid, coarse.P);
    core::copy(coarse.P, coarse.P_restricted);
    transfer::restrict_injection(fine.H, coarse.H_restricted);
    coarse.f.fill(0.0);
    if (problem.cavitation) {
      take_slack(fine, coarse.f);
      drop_near_cavitation(fine.grid, fine.P, threads, fine.r);
    }
    coarse.H_floor = coarse_film_floor;
  }
  // F = injected H - (H00 + geometry + K*P): the coarse film equation then gives the injected film at the restricted P.
  {
    const core::ScopedTimer timer(hierarchy.times, core::Part::deformation);
    coarse.deformation.evaluate(coarse.P, coarse.F);
    ++coarse.evaluations;
  }
  const core::Grid& grid = coarse.grid;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j)
      coarse.F(i, j) =
          coarse.H_restricted(i, j) - (rigid_gap(problem.geometry, grid, hierarchy.H00, i, j) + coarse.F(i, j));
  core::copy(coarse.H_restricted, coarse.H);
  update_coefficients(hierarchy, coarse);
  // f = L(restricted P) + restricted residual + slack: the residual with f = -slack is -slack - L.
  update_residual(hierarchy, coarse);
  const core::ScopedTimer timer(hierarchy.times, core::Part::transfer);
  restrict_residual(fine, problem.transport, threads, coarse.f);
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) coarse.f(i, j) -= coarse.r(i, j);
  coarse.load = fine.load - carried_load(fine) + carried_load(coarse);
}

void correct_from_coarse(Hierarchy& hierarchy, Level& coarse, Level& fine) {
  {
    const core::ScopedTimer timer(hierarchy.times, core::Part::transfer);
    const bool cavitation = hierarchy.problem.cavitation;
    core::Field& correction = coarse.r;
    for (int i = 0; i <= coarse.grid.nx; ++i)
      for (int j = 0; j <= coarse.grid.ny; ++j) correction(i, j) = coarse.P(i, j) - coarse.P_restricted(i, j);
    transfer::prolong_bilinear(correction, fine.r, hierarchy.threads_on(fine.grid));
    // Where no residual went down, no correction comes up.
    if (cavitation) drop_near_cavitation(fine.grid, fine.P, hierarchy.threads_on(fine.grid), fine.r);
    for (int i = 1; i < fine.grid.nx; ++i) {
      double* P = fine.P.at_x(i);
      const double* change = fine.r.at_x(i);
      for (int j = 1; j <= fine.grid.last_line(); ++j) {
        const double corrected = P[j] + change[j];
        P[j] = cavitation && corrected < 0.0 ? 0.0 : corrected;
      }
      core::make_images(fine.grid, P);
    }
  }
  update_film(hierarchy, fine);
}

}  // namespace ehl::fmg
