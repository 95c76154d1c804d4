#include "multigrid/chattering.hpp"

#include <cmath>

#include "multigrid/relaxation.hpp"

namespace ehl::multigrid {

// changes_of_kind: one more than the number of changes, negative while the node is not full; 0 before its first visit.
int mark_chattering(const Tuning& tuning, Level& level) {
  if (!conserves_mass(level)) return 0;
  int marked = 0;
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) {
      double& changes = level.content->changes_of_kind(i, j);
      const bool dry = level.content->Q(i, j) < level.rho_bar(i, j) * level.H(i, j);
      const double count = std::abs(changes) + (changes == 0.0 || dry != (changes < 0.0) ? 1.0 : 0.0);
      changes = dry ? -count : count;
      if (count <= tuning.changes_of_chattering || level.content->chatters(i, j) > 0.0) continue;
      level.content->chatters(i, j) = 1.0;
      ++marked;
    }
  return marked;
}

int find_chattering(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how) {
  if (!conserves_mass(level)) return 0;
  const Tuning& tuning = hierarchy.parameters.tuning;
  const int relaxations = 2 * tuning.changes_of_chattering;
  const core::Field unrelaxed = level.P;
  level.content->changes_of_kind.fill(0.0);
  int marked = mark_chattering(tuning, level);
  for (int k = 0; k < relaxations; ++k) {
    relax(hierarchy, level, how);
    update_residual(hierarchy, level);
    marked += mark_chattering(tuning, level);
  }
  if (marked == 0) {
    level.P = unrelaxed;
    update_film(hierarchy, level);
    update_residual(hierarchy, level);
  }
  return marked;
}

void forget_chattering(Level& level) {
  if (!conserves_mass(level)) return;
  level.content->chatters.fill(0.0);
  level.content->changes_of_kind.fill(0.0);
}

int chattering_nodes(const Level& level) {
  double count = 0.0;
  if (conserves_mass(level))
    for (int i = 1; i < level.grid.nx; ++i)
      for (int j = 1; j <= level.grid.last_line(); ++j) count += level.grid.lines(j) * level.content->chatters(i, j);
  return static_cast<int>(std::lround(count));
}

}  // namespace ehl::multigrid
