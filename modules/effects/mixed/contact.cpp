#include "effects/mixed/contact.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace ehl::mixed {
namespace {

// Counts the regions by filling one after the other.
int patches_of(const core::Grid& grid, const core::Field& P_c, int first_line, int last_line) {
  const auto lines = static_cast<std::size_t>(grid.nodes_y());
  std::vector<char> seen(static_cast<std::size_t>(grid.nodes_x()) * lines, 0);
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int i, int j) {
    if (i < 0 || i > grid.nx || j < first_line || j > last_line || !(P_c(i, j) > 0.0)) return false;
    char& mark = seen[static_cast<std::size_t>(i) * lines + static_cast<std::size_t>(j)];
    if (mark != 0) return false;
    mark = 1;
    open.emplace_back(i, j);
    return true;
  };
  int patches = 0;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = first_line; j <= last_line; ++j) {
      if (visit(i, j)) ++patches;
      while (!open.empty()) {
        const auto [at_i, at_j] = open.back();
        open.pop_back();
        for (int di = -1; di <= 1; ++di)
          for (int dj = -1; dj <= 1; ++dj) visit(at_i + di, at_j + dj);
      }
    }
  return patches;
}

}  // namespace

Contact contact_of(const core::Grid& grid, const core::Field& P_c, double load, double area) {
  const int first_line = grid.line ? 1 : 0, last_line = grid.line ? 1 : grid.ny;
  Contact found;
  double sum = 0.0, nodes = 0.0;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = first_line; j <= last_line; ++j) {
      const double P = P_c(i, j);
      if (!(P > 0.0)) continue;
      sum += P;
      nodes += 1.0;
      if (P > found.P_c_max) {
        found.P_c_max = P;
        found.X = grid.X(i);
        found.Y = grid.Y(j);
      }
    }
  const double cell = grid.hx() * grid.hy();
  found.share = sum * cell / load;
  found.area = nodes * cell / area;
  found.patches = patches_of(grid, P_c, first_line, last_line);
  return found;
}

}  // namespace ehl::mixed
