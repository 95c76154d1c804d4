#include "fmg/across_relaxation.hpp"

#include <omp.h>

#include <algorithm>
#include <span>

#include "fmg/relaxation.hpp"
#include "fmg/thread_work.hpp"
#include "reynolds/flux.hpp"

namespace ehl::fmg {
namespace {

using reynolds::Faces;

/// The hybrid relaxation's crossover grows by this times (hx/hy)^2 where that is more than 1: of a change that is
/// smooth across, K(0, 0) and K(0, 1) foretell ever less of what the film answers. With one epsilon everywhere cycles
/// leave 0.3 at most; from a tenth of it on they diverge at hx = 8 hy (tests/convergence/test_model_problems.cpp).
/// Where epsilon falls by orders from node to node zones of it are thin: e_max times e_max/e_min counts, where lines
/// along X take its root. (20, 10) and (100, 15) at R_x/R_y = 20, (20, 15) at 50: 0.26, 0.43, 0.42 are left; with the
/// root 0.25, 0.72, 0.34.
constexpr double share_of_stretch = 0.25;

/// Lines along X have answered to the same residual just before, and a spike along a diagonal would be corrected twice.
/// Of 1, 0.7, 0.5 and 0.3 cycles leave 0.21, 0.19, 0.22 and 0.25 of (1000, 15) at R_x/R_y = 5 and 45 degrees, 0.28,
/// 0.32, 0.19 and 0.23 of (100, 15) at 20. Of 0.7 and 0.5 0.11 and 0.17 of (1000, 10) at 20, 0.20 and 0.25 at 50. Along
/// the motion, on stretched cells, of 1 and 0.7 0.50 and 0.44 of (100, 15) at 20, when they are not accelerated.
constexpr double weight_at_half_points = 0.7;
/// Where epsilon at the nodes falls by orders to the next, on coarse grids, the mean of two overshoots what the finer
/// grid lets through: of 0.7 and 0.5 0.72 and 0.61 are left of (20, 15) at 50, likewise. Where it does not, of 0.7
/// 0.31 is left of the model problem at e = 30 on cells of hx = 8 hy, of 1 0.27.
constexpr double weight_where_steep = 0.5;
/// At half points there likewise where it falls to less than this beside one node: the edge of a contact within a cell.
/// With the whole weight (100, 15) at R_x/R_y = 200 and 45 degrees stood still at 1e-5, the lines beside its inlet
/// swinging to and fro; now 0.24 is left per cycle.
constexpr double fall_of_edge = 1e-4;

/// On coarse grids the flux through the edge of a contact is the mean epsilon of a thick film outside times nearly all
/// of the pressure inside, and follows the film that this pressure makes (line_batch.cpp). All of the edge changes at
/// once: K(0, 0) and the kernels of some ten neighbours along it on both sides are twice K(0, 0). With epsilon held
/// each relaxation of 128 cells left -3 of it: at 45 degrees cycles left 0.57 of (1000, 15) at R_x/R_y = 50, 0.40 at
/// 100 and 0.58 at 200, with twice the relaxations of now, which leave 0.22, 0.21 and 0.21.
constexpr double film_along_edge = 2.0;

class StationAcross {
 public:
  StationAcross(const Hierarchy& hierarchy, Level& level, const RelaxationParameters& how)
      : film_(hierarchy.problem.film),
        two_epsilons_(film::anisotropic(film_)),
        cavitation_(hierarchy.problem.cavitation),
        level_(level),
        transport_(transport_on(hierarchy, level)),
        half_(level.grid.hx(), level.grid.hy()),
        stretch_(core::stretch(level.grid)),
        weight_single_(how.weight_single),
        most_change_(how.most_change) {
    crossover_ = std::max(1.0, share_of_stretch * stretch_ * stretch_) * crossover_on(hierarchy, level.grid, how);
  }

  /// The tridiagonal system of station i, from the side to the last line.
  void relax(int i, ThreadWork& work) const {
    const core::Patch& grid = level_.grid;
    const int last = grid.last_line();
    if (!at_half_points(level_) && !film_.given_epsilon) make_slopes(i, work);
    const auto row = [&](int j) -> RowAcross& { return work.rows_across[static_cast<std::size_t>(j)]; };
    row(0) = {};
    for (int j = 1; j <= last; ++j) {
      row(j) = row_at(i, j, work);
      if (row(j).weight == 0.0) continue;
      if (j == grid.ny) row(j).south += row(j).north;  // the axis: its neighbours are one
      const double factor = row(j).south / row(j - 1).own;
      row(j).own -= factor * row(j - 1).north;
      row(j).r -= factor * row(j - 1).r;
    }
    double* P = level_.P.at_x(i);
    double change = 0.0;  // of the line behind
    for (int j = last; j >= 1; --j) {
      const double north = j == last ? 0.0 : row(j).north;
      change = -(row(j).r + north * change) / row(j).own;
      P[j] = reynolds::projected(cavitation_, P[j] + std::clamp(row(j).weight * change, -most_change_, most_change_));
    }
    core::fill_ghosts(grid, P);
  }

 private:
  bool single(const Faces<double>& e) const {
    const auto [low, high] = range_of(e);
    return high * high > crossover_ * low;
  }
  /// As ThreadWork::range_of: epsilon/(hx hy).
  std::pair<double, double> range_of(const Faces<double>& e) const {
    return {std::min(stretch_ * std::min(e.west, e.east), std::min(e.south, e.north) / stretch_),
            std::max(stretch_ * std::max(e.west, e.east), std::max(e.south, e.north) / stretch_)};
  }

  double weight_of(const Faces<double>& e) const {
    const auto [low, high] = range_of(e);
    if (at_half_points(level_))
      return weight_single_ * weight_at_half_points * (low < fall_of_edge * high ? weight_where_steep : 1.0);
    const double smooth = std::min(1.0, 2.0 * low / high);
    return weight_single_ * (weight_where_steep + (1.0 - weight_where_steep) * smooth);
  }

  RowAcross row_at(int i, int j, const ThreadWork& work) const {
    const core::Field& P = level_.P;
    const Faces<double> e = reynolds::faces_at(level_.scheme.face, level_.eps, eps_across(level_), i, j, half_);
    if (!single(e)) return {};
    const auto c = reynolds::transport_weights(transport_, i, level_.grid.hx());
    const auto Q = [&](int k) { return level_.rho_bar(k, j) * level_.H(k, j); };
    const int far_west = std::max(i - 2, 0);
    double own = c[0], net;
    if (reynolds::third_order(transport_.wedge)) {
      const auto w = reynolds::third_order_weights<double>(c, transport_, level_.grid.hx(),
                                                           {level_.third_order(i - 1, j), level_.third_order(i, j)});
      own = w[0];
      net = reynolds::transported(w, Q(i), Q(i - 1), Q(far_west), Q(i + 1));
    } else {
      net = reynolds::transported(c, Q(i), Q(i - 1), Q(far_west));
    }
    RowAcross row{.r = net - reynolds::poiseuille_at(e, P, i, j)};
    if (level_.f.nodes_x() > 0) row.r += level_.f(i, j);
    if (reynolds::stays_dry(cavitation_, P(i, j), row.r)) return {};
    const double film = own * level_.rho_bar(i, j);
    row.weight = weight_of(e);
    row.own = reynolds::total(e) + own * level_.drho_bar(i, j) * level_.H(i, j) + film * level_.film_terms.K[0];
    row.south = film * level_.film_terms.K_across[0] - e.south;
    row.north = film * level_.film_terms.K_across[0] - e.north;
    if (at_half_points(level_)) {
      add_answers(i, j, e, row);
    } else {
      add_slopes(i, j, work, row);
      row.own += film_along_edge * level_.film_terms.K[0] * answer_to_film_of_edge(i, j, e);
    }
    return row;
  }

  // What r answers to the films of the dry nodes beside, by which epsilon goes as H^3.
  double answer_to_film_of_edge(int i, int j, const Faces<double>& e) const {
    if (film_.given_epsilon) return 0.0;
    const auto of = [&](int k, int m, double face) {
      const double H = level_.H(k, m);
      return reynolds::dry(cavitation_, level_.P(k, m)) && H > 0.0 ? 3.0 * face * level_.P(i, j) / H : 0.0;
    };
    return of(i - 1, j, e.west) + of(i + 1, j, e.east) + of(i, j - 1, e.south) + of(i, j + 1, e.north);
  }

  // The viscosity follows the pressures of the station, with epsilon at half points.
  void add_answers(int i, int j, const Faces<double>& e, RowAcross& row) const {
    const OilFields& oil = level_.oil;
    const bool thinned = oil.fluidity_across.nodes_x() > 0;
    const core::Field& phi = thinned ? oil.fluidity_across : oil.fluidity;
    const core::Field& a = thinned ? oil.log_viscosity_across : oil.log_viscosity;
    const double least = reynolds::least_share(level_.scheme.face);
    const auto between = [&](const core::Field& f, const core::Field& ln_eta, int k, int m, int to_k, int to_m) {
      return film::answers<film::LeastShare::follows>(least, f(k, m), f(to_k, to_m), ln_eta(k, m), ln_eta(to_k, to_m));
    };
    const auto south = between(phi, a, i, j - 1, i, j), north = between(phi, a, i, j, i, j + 1);
    const auto west = between(oil.fluidity, oil.log_viscosity, i - 1, j, i, j);
    const auto east = between(oil.fluidity, oil.log_viscosity, i, j, i + 1, j);
    row.south += e.south * (1.0 - south.before);
    row.north += e.north * (1.0 - north.behind);
    row.own += e.south * (south.behind - 1.0) + e.north * (north.before - 1.0) + e.west * (west.behind - 1.0) +
               e.east * (east.before - 1.0);
  }

  // The same with epsilon at the nodes: of e (P_other - P) the half of it that the node gives.
  void add_slopes(int i, int j, const ThreadWork& work, RowAcross& row) const {
    const core::Field& P = level_.P;
    const auto slope = [](const std::vector<double>& slopes, int m) { return slopes[static_cast<std::size_t>(m)]; };
    const std::vector<double>& across = two_epsilons_ ? work.eps_across_P : work.eps_P;
    const int north = j == level_.grid.ny ? j - 1 : j + 1;  // the axis: its neighbours are one
    const double to_south = half_.Y * (P(i, j) - P(i, j - 1)), to_north = half_.Y * (P(i, j) - P(i, j + 1));
    row.south += slope(across, j - 1) * to_south;
    row.north += slope(across, north) * to_north;
    row.own += slope(across, j) * (to_south + to_north) +
               slope(work.eps_P, j) * half_.X * (2.0 * P(i, j) - P(i - 1, j) - P(i + 1, j));
  }

  void make_slopes(int i, ThreadWork& work) const {
    const auto of = [i](const core::Field& field) { return field.station(i); };
    film::slopes(film_, {level_.grid, i, of(level_.P), of(level_.H)},
                 {.eps = of(level_.eps),
                  .eps_across = two_epsilons_ ? of(level_.eps_across) : std::span<const double>{},
                  .rho_bar = of(level_.rho_bar),
                  .drho_bar = of(level_.drho_bar)},
                 work.film,
                 {.eps_P = work.eps_P,
                  .eps_H = work.eps_H,
                  .eps_across_P = work.eps_across_P,
                  .eps_across_H = work.eps_across_H});
  }

  const film::Model& film_;
  bool two_epsilons_;
  reynolds::Cavitation cavitation_;
  Level& level_;
  reynolds::Transport transport_;
  reynolds::HalfInverseSquares half_;
  double stretch_;
  double weight_single_;
  double most_change_;
  double crossover_ = 0.0;
};

}  // namespace

bool can_relax_across(const Hierarchy& hierarchy, const Level& level) {
  return !level.grid.domain.line && !conserves_mass(level) && hierarchy.transport.squeeze == 0.0;
}

void relax_across(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how) {
  const core::ScopedTimer timer(hierarchy.times, core::Part::line_solve);
  const StationAcross station(hierarchy, level, how);
  const int threads = hierarchy.threads_on(level.grid);
  for (int first = 1; first <= 2; ++first) {
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (int i = first; i < level.grid.nx; i += 2)
      station.relax(i, level.thread_work[static_cast<std::size_t>(omp_get_thread_num())]);
  }
}

}  // namespace ehl::fmg
