#include "steady/starts.hpp"

#include <iterator>
#include <span>

#include "steady/multigrid_solve.hpp"

namespace ehl::steady {
namespace {

/// The first start is fast and works for most contacts. The later ones begin on a finer grid, which resolves the
/// contact better, keep a finer coarsest grid, and are more strongly damped.
constexpr Start starts[] = {
    {.cells = 64, .sweeps = 20, .cycles = 6, .coarsest = 32, .balances = 10, .damping_at_first = 0.7, .damping = 1.0},
    {.cells = 64, .sweeps = 40, .cycles = 10, .coarsest = 32, .balances = 30, .damping_at_first = 0.5, .damping = 1.0},
    {.cells = 128, .sweeps = 40, .cycles = 6, .coarsest = 32, .balances = 10, .damping_at_first = 0.7, .damping = 1.0},
    {.cells = 128, .sweeps = 40, .cycles = 6, .coarsest = 64, .balances = 30, .damping_at_first = 0.7, .damping = 1.0},
    {.cells = 128, .sweeps = 40, .cycles = 10, .coarsest = 64, .balances = 30, .damping_at_first = 0.7, .damping = 0.7},
    {.cells = 256, .sweeps = 80, .cycles = 10, .coarsest = 64, .balances = 30, .damping_at_first = 0.5, .damping = 0.7},
};
/// The first start to try if the first grid of the earlier ones does not resolve the contact.
constexpr std::size_t start_of_heavy = 2;

/// The first start of a line contact, for which a finer first grid costs little. [bench: start_of_line]
constexpr Start start_of_line = {
    .cells = 64, .sweeps = 40, .cycles = 6, .balances = 10, .damping_at_first = 0.5, .damping = 0.9, .coarseness = 9.0};

/// Heavily loaded line contacts with a steep edge: coarse grids do not resolve their film zones, so that the
/// corrections are poor and more relaxations are needed. [bench: starts_of_heavy_lines]
constexpr int most_relaxations = 4;
constexpr Start start_of_heavy_line(int pre, int post) {
  Start start = start_of_line;
  start.cycles = 4;
  start.damping_at_first = 0.4;
  start.damping = 0.7;
  start.pre = pre;
  start.post = post;
  return start;
}
constexpr Start starts_of_heavy_lines[] = {start_of_heavy_line(3, 2),
                                           start_of_heavy_line(most_relaxations, most_relaxations)};

/// Ellipses: the film beside a heavily loaded slender or oblique contact is too thin for the first grids of the other
/// starts. On a coarser grid the relaxations of the Hertz pressure themselves diverge.
constexpr Start start_of_ellipse(double damping_at_first) {
  return {.cells = 128,
          .sweeps = 20,
          .cycles = 12,
          .damping_at_first = damping_at_first,
          .damping = 0.7,
          .across = true,
          .coarseness = 4.5};
}
constexpr Start starts_of_ellipses[] = {start_of_ellipse(0.5), start_of_ellipse(0.35)};

}  // namespace

std::vector<Start> starts_of(const Scene& scene) {
  const std::span<const Start> all(starts);
  const bool held = held_by(starts[0].cells, scene);
  const auto usual = all.subspan(held ? 0 : start_of_heavy);
  std::vector<Start> list(usual.begin(), usual.end());
  if (!scene.grid.line) {
    if (!contact::circular(scene.contact.shape))
      list.insert(list.begin() + 1, std::begin(starts_of_ellipses), std::end(starts_of_ellipses));
  } else if (held || log_viscosity_at_edge(scene) < scene.tuning.steep_log_viscosity_of_line) {
    list.insert(list.begin(), start_of_line);
  } else {
    for (Start& start : list) start.pre = start.post = most_relaxations;
    list.insert(list.begin(), std::begin(starts_of_heavy_lines), std::end(starts_of_heavy_lines));
  }
  return list;
}

const Start& usual_start() { return starts[0]; }
const Start& safe_start() { return starts[3]; }

}  // namespace ehl::steady
