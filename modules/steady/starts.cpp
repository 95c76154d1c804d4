#include "steady/starts.hpp"

#include <iterator>
#include <span>

#include "steady/climb.hpp"

namespace ehl::steady {
namespace {

/// The first start is fast and right for most contacts. The later ones begin on a grid that holds the contact better,
/// keep the coarsest grid finer, and are more cautious.
constexpr Start starts[] = {
    {.cells = 64, .sweeps = 20, .cycles = 6, .coarsest = 32, .balances = 10, .caution_at_first = 0.7, .caution = 1.0},
    {.cells = 64, .sweeps = 40, .cycles = 10, .coarsest = 32, .balances = 30, .caution_at_first = 0.5, .caution = 1.0},
    {.cells = 128, .sweeps = 40, .cycles = 6, .coarsest = 32, .balances = 10, .caution_at_first = 0.7, .caution = 1.0},
    {.cells = 128, .sweeps = 40, .cycles = 6, .coarsest = 64, .balances = 30, .caution_at_first = 0.7, .caution = 1.0},
    {.cells = 128, .sweeps = 40, .cycles = 10, .coarsest = 64, .balances = 30, .caution_at_first = 0.7, .caution = 0.7},
    {.cells = 256, .sweeps = 80, .cycles = 10, .coarsest = 64, .balances = 30, .caution_at_first = 0.5, .caution = 0.7},
};
/// The first of them where the grid of the others does not hold the contact.
constexpr std::size_t start_of_heavy = 2;

/// The first of a line contact, where a finer first grid costs little: 128 cells are too wide for most of M = 1000 and
/// 2000, L = 25. Of 77 loads on 1024 cells 73 begin at once, 64 without it, and take 0.9 of the work.
constexpr Start start_of_line = {
    .cells = 64, .sweeps = 40, .cycles = 6, .balances = 10, .caution_at_first = 0.5, .caution = 0.9, .coarseness = 9.0};

/// Of a heavy line, whose zones coarse grids do not hold, with a steep edge: what these send up is far off, and takes
/// more relaxations than usual. Of 91 such loads, M = 150 to 3200, L = 16 to 28 on 1024 cells, V(2,1) cycles with the
/// start above begin 31 at once, all in 3.9 s; V(3,2) begin 77, V(4,4) 9 of the others, all in 1.2 s. Of the 42 with
/// M = 250 to 2500, L = 17 to 26, one needs another start by V(3,4) with 16, 17 and 18 of ln eta_bar, three and four
/// with 19 and 20.
constexpr double steep_log_viscosity_of_line = 18.0;
constexpr int most_relaxations = 4;
constexpr Start start_of_heavy_line(int pre, int post) {
  Start start = start_of_line;
  start.cycles = 4;
  start.caution_at_first = 0.4;
  start.caution = 0.7;
  start.pre = pre;
  start.post = post;
  return start;
}
constexpr Start starts_of_heavy_lines[] = {start_of_heavy_line(3, 2),
                                           start_of_heavy_line(most_relaxations, most_relaxations)};

/// For ellipses, where the film beside a slender or oblique heavy contact is too thin for the first grids of those:
/// begun on a coarser one, the relaxations of the Hertz pressure themselves diverge.
constexpr Start start_of_ellipse(double caution_at_first) {
  return {.cells = 128,
          .sweeps = 20,
          .cycles = 12,
          .caution_at_first = caution_at_first,
          .caution = 0.7,
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
    if (!contact::circular(scene.shape))
      list.insert(list.begin() + 1, std::begin(starts_of_ellipses), std::end(starts_of_ellipses));
  } else if (held || log_viscosity_at_edge(scene) < steep_log_viscosity_of_line) {
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
