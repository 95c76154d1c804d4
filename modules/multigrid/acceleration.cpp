#include "multigrid/acceleration.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "reynolds/row.hpp"

namespace ehl::multigrid {
namespace {

/// The pressure change that r asks for: r over its derivative by the node's own pressure; zero where the node stays
/// cavitated. (In r itself the line next to the boundary, whose epsilon is the largest, outweighs the edge of the
/// spike. Its error is removed by the next relaxation, and combinations return to the same state.)
void write_asked(const Hierarchy& hierarchy, const Level& level, core::Field& asked) {
  if (asked.nodes_x() == 0) asked = core::Field(level.grid);
  const core::Patch& grid = level.grid;
  const reynolds::NodeRows rows = multigrid::rows(hierarchy, level);
  for (int i = 1; i < grid.nx; ++i) {
    const double film = rows.wedge(i)[0] * film_response(level, 0);
    for (int j = 1; j <= grid.last_line(); ++j) {
      const bool stays = reynolds::stays_dry(hierarchy.problem.cavitation, level.P(i, j), level.r(i, j));
      asked(i, j) = stays ? 0.0 : level.r(i, j) / (reynolds::total(rows.faces(i, j)) + film * level.rho_bar(i, j));
    }
  }
}

}  // namespace

void Acceleration::remember(const Hierarchy& hierarchy, std::size_t l) {
  if (kept_.size() < static_cast<std::size_t>(hierarchy.parameters.tuning.krylov_states))
    kept_.emplace_back();
  else
    std::rotate(kept_.begin(), kept_.begin() + 1, kept_.end());
  Kept& last = kept_.back();
  last.state = state_of(hierarchy, l);
  write_asked(hierarchy, hierarchy.levels[l], last.asked);
}

bool Acceleration::combine(const Hierarchy& hierarchy, std::size_t l, State& combined) {
  if (kept_.empty()) return false;
  const Level& level = hierarchy.levels[l];
  const core::Patch& grid = level.grid;
  write_asked(hierarchy, level, asked_);
  const auto states = static_cast<int>(kept_.size());
  // The normal equations of the least squares, summed in one order for any number of threads.
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(states, states);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(states);
  std::vector<double> d(kept_.size());
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j)
      for (int k = 0; k < states; ++k) {
        d[static_cast<std::size_t>(k)] = kept_[static_cast<std::size_t>(k)].asked(i, j) - asked_(i, j);
        b(k) -= d[static_cast<std::size_t>(k)] * asked_(i, j);
        for (int m = 0; m <= k; ++m) A(k, m) += d[static_cast<std::size_t>(k)] * d[static_cast<std::size_t>(m)];
      }
  const Eigen::MatrixXd whole = A.selfadjointView<Eigen::Lower>();
  const Eigen::VectorXd alpha = whole.completeOrthogonalDecomposition().solve(b);
  if (!alpha.allFinite()) return false;
  combined = state_of(hierarchy, l);
  for (int k = 0; k < states; ++k) {
    const State& other = kept_[static_cast<std::size_t>(k)].state;
    combined.H00 += alpha(k) * (other.H00 - hierarchy.H00);
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) combined.P(i, j) += alpha(k) * (other.P(i, j) - level.P(i, j));
  }
  for (int i = 0; i <= grid.nx; ++i) {
    for (double& P : combined.P.station(i)) P = reynolds::projected(hierarchy.problem.cavitation, P);
    core::fill_ghosts(grid, combined.P.at_x(i));
  }
  return true;
}

}  // namespace ehl::multigrid
