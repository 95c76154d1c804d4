#include "multigrid/across_relaxation.hpp"

#include <omp.h>

#include <algorithm>
#include <span>

#include "multigrid/line_batch.hpp"
#include "multigrid/relaxation.hpp"
#include "multigrid/thread_work.hpp"
#include "reynolds/row.hpp"

namespace ehl::multigrid {
namespace {

using reynolds::Faces;

class StationAcross {
 public:
  StationAcross(const Hierarchy& hierarchy, Level& level, const RelaxationParameters& how)
      : film_(hierarchy.problem.film),
        two_epsilons_(film::anisotropic(film_)),
        cavitation_(hierarchy.problem.cavitation),
        level_(level),
        rows_(rows(hierarchy, level)),
        stretch_(core::stretch(level.grid)),
        weight_single_(how.weight_single),
        most_change_(how.most_change),
        tuning_(hierarchy.parameters.tuning) {
    // For a change that is smooth along Y, K(0, 0) and K(0, 1) underestimate the response of the film more and more
    // with hx/hy (tests/convergence/test_model_problems.cpp). The criterion is e_max (e_max/e_min), where the X sweep
    // takes the root of the ratio: where epsilon varies by orders between nodes, its zones are thin.
    crossover_ =
        std::max(1.0, tuning_.y_sweep_crossover * stretch_ * stretch_) * crossover_on(hierarchy, level.grid, how);
  }

  /// Solves the tridiagonal system of column i, from the boundary to the last line.
  void relax(int i, ThreadWork& work) const {
    const core::Patch& grid = level_.grid;
    const int last = grid.last_line();
    if (!at_half_points(level_) && !film_.given_epsilon) make_slopes(i, work);
    const auto row = [&](int j) -> RowAcross& { return work.rows_across[static_cast<std::size_t>(j)]; };
    row(0) = {};
    for (int j = 1; j <= last; ++j) {
      row(j) = row_at(i, j, work);
      if (row(j).weight == 0.0) continue;
      if (j == grid.ny) row(j).south += row(j).north;  // the axis of symmetry: both neighbours are the same line
      const double factor = row(j).south / row(j - 1).own;
      row(j).own -= factor * row(j - 1).north;
      row(j).r -= factor * row(j - 1).r;
    }
    double* P = level_.P.at_x(i);
    double change = 0.0;  // of the next line
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
  /// Least and largest epsilon/(hx hy), as ThreadWork::range_of.
  std::pair<double, double> range_of(const Faces<double>& e) const {
    return {std::min(stretch_ * std::min(e.west, e.east), std::min(e.south, e.north) / stretch_),
            std::max(stretch_ * std::max(e.west, e.east), std::max(e.south, e.north) / stretch_)};
  }

  // The X sweep has already reduced this residual, and a spike along a diagonal would be corrected twice. Further
  // damping where epsilon at the nodes varies by orders (coarse grids): the mean of two nodes overshoots what the finer
  // grid lets through. It applies at half points, too, where the edge of a contact lies within a cell: the lines next
  // to the inlet would chatter.
  double weight_of(const Faces<double>& e) const {
    const auto [low, high] = range_of(e);
    const double steep = tuning_.y_sweep_damping_steep;
    if (at_half_points(level_))
      return weight_single_ * tuning_.y_sweep_damping * (low < tuning_.y_sweep_edge * high ? steep : 1.0);
    const double smooth = std::min(1.0, 2.0 * low / high);
    return weight_single_ * (steep + (1.0 - steep) * smooth);
  }

  RowAcross row_at(int i, int j, const ThreadWork& work) const {
    const core::Field& P = level_.P;
    const Faces<double> e = rows_.faces(i, j);
    if (!single(e)) return {};
    const std::array<double, 4> w = rows_.weights(i, j);
    RowAcross row{.r = reynolds::residual(w, e, rows_.Q(i, j), reynolds::cross_at(P, i, j))};
    if (level_.f.nodes_x() > 0) row.r += level_.f(i, j);
    if (reynolds::stays_dry(cavitation_, P(i, j), row.r)) return {};
    const double own = w[0];
    const double film = own * level_.rho_bar(i, j);
    row.weight = weight_of(e);
    row.own = reynolds::total(e) + own * level_.drho_bar(i, j) * level_.H(i, j) + film * film_response(level_, 0);
    row.south = film * film_response(level_, 0, 1) - e.south;
    row.north = film * film_response(level_, 0, 1) - e.north;
    if (at_half_points(level_)) {
      add_answers(i, j, e, row);
    } else {
      add_slopes(i, j, work, row);
      // All of the edge changes at once, and the kernels along it sum to about twice K(0, 0). (film_of_epsilon in
      // line_batch.cpp says why epsilon must follow the film.)
      row.own += tuning_.film_along_edge * film_response(level_, 0) * answer_to_film_of_edge(i, j, e);
    }
    return row;
  }

  // Derivative of r by the films of the cavitated nodes next to it, with epsilon proportional to H^3.
  double answer_to_film_of_edge(int i, int j, const Faces<double>& e) const {
    if (film_.given_epsilon) return 0.0;
    const auto of = [&](int k, int m, double face) {
      const double H = level_.H(k, m);
      return reynolds::dry(cavitation_, level_.P(k, m)) && H > 0.0 ? 3.0 * face * level_.P(i, j) / H : 0.0;
    };
    return of(i - 1, j, e.west) + of(i + 1, j, e.east) + of(i, j - 1, e.south) + of(i, j + 1, e.north);
  }

  // Epsilon at half points: the viscosity follows the pressures of the column.
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
    // The row of a line along Y: X and Y change places.
    const auto along_Y = viscosity_row<double>({e.south, e.north, e.west, e.east}, south, north, west, east);
    row.south += along_Y.west;
    row.own += along_Y.own;
    row.north += along_Y.east;
  }

  // Epsilon at the nodes: it follows the pressures of the column. Each node gives half of the e in e (P_other - P).
  void add_slopes(int i, int j, const ThreadWork& work, RowAcross& row) const {
    const core::Field& P = level_.P;
    const auto slope = [](const std::vector<double>& slopes, int m) { return slopes[static_cast<std::size_t>(m)]; };
    const std::vector<double>& across = two_epsilons_ ? work.eps_across_P : work.eps_P;
    const int north = j == level_.grid.ny ? j - 1 : j + 1;  // the axis of symmetry: both neighbours are the same line
    const double to_south = rows_.half().Y * (P(i, j) - P(i, j - 1)),
                 to_north = rows_.half().Y * (P(i, j) - P(i, j + 1));
    row.south += slope(across, j - 1) * to_south;
    row.north += slope(across, north) * to_north;
    row.own += slope(across, j) * (to_south + to_north) +
               slope(work.eps_P, j) * rows_.half().X * (2.0 * P(i, j) - P(i - 1, j) - P(i + 1, j));
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
  reynolds::NodeRows rows_;
  double stretch_;
  double weight_single_;
  double most_change_;
  const Tuning tuning_;
  double crossover_ = 0.0;
};

}  // namespace

bool can_relax_across(const Hierarchy& hierarchy, const Level& level) {
  return reynolds::flows_aside(level.grid) && !conserves_mass(level) && hierarchy.transport.squeeze == 0.0;
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

}  // namespace ehl::multigrid
