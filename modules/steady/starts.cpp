#include "steady/starts.hpp"

namespace ehl::steady {
namespace {

/// Fast, and sufficient for most contacts.
constexpr Start usual = {
    .cells = 64, .sweeps = 20, .cycles = 6, .coarsest = 32, .balances = 10, .damping_at_first = 0.7};
/// These begin on a finer grid, which resolves the contact better; the later ones keep a finer coarsest grid, and the
/// last is more strongly damped. [bench: later_starts]
constexpr Start finer = {
    .cells = 128, .sweeps = 40, .cycles = 6, .coarsest = 32, .balances = 10, .damping_at_first = 0.7};
constexpr Start finer_coarsest = {
    .cells = 128, .sweeps = 40, .cycles = 6, .coarsest = 64, .balances = 30, .damping_at_first = 0.7};
constexpr Start damped = {
    .cells = 128, .sweeps = 40, .cycles = 10, .coarsest = 64, .balances = 30, .damping_at_first = 0.7, .damping = 0.7};

/// Line contacts, for which a finer first grid costs little. [bench: start_of_line]
constexpr Start of_line = {
    .cells = 64, .sweeps = 40, .cycles = 6, .balances = 10, .damping_at_first = 0.5, .damping = 0.9, .coarseness = 9.0};
/// Heavily loaded line contacts with a steep edge: coarse grids do not resolve their film zones, so that the
/// corrections are poor and more relaxations are needed. [bench: starts_of_heavy_lines]
constexpr int most_relaxations = 4;
constexpr Start of_heavy_line(int pre, int post) {
  Start start = of_line;
  start.cycles = 4;
  start.damping_at_first = 0.4;
  start.damping = 0.7;
  start.pre = pre;
  start.post = post;
  return start;
}
/// Ellipses: the film beside a heavily loaded slender or oblique contact is too thin for the first grids of the other
/// starts. On a coarser grid the relaxations of the Hertz pressure themselves diverge.
constexpr Start of_ellipse = {.cells = 128,
                              .sweeps = 20,
                              .cycles = 12,
                              .damping_at_first = 0.5,
                              .damping = 0.7,
                              .across = true,
                              .coarseness = 4.5};

bool always(const Features&) { return true; }
bool resolved(const Features& is) { return is.resolved; }
bool not_resolved(const Features& is) { return !is.resolved; }
bool ellipse(const Features& is) { return !is.line && !is.circular; }
bool heavy_line(const Features& is) { return is.line && !is.resolved && is.steep_for_line; }
bool other_line(const Features& is) { return is.line && !heavy_line(is); }

// The table of starts. Those whose condition holds are tried from top to bottom until one succeeds.
struct Row {
  bool (*when)(const Features& is);
  Start start;
};
constexpr Row table[] = {
    {other_line, of_line},
    {heavy_line, of_heavy_line(3, 2)},
    {heavy_line, of_heavy_line(most_relaxations, most_relaxations)},
    {resolved, usual},
    {not_resolved, finer},
    {ellipse, of_ellipse},
    {always, damped},
};

/// True if a later start begins on a finer grid than the scene has: it does not differ from the earlier ones.
bool beyond_finest_grid(const Scene& scene, const Start& start) {
  return start.coarseness == 0.0 && start.cells * scene.contact.slenderness > scene.grid.nx * core::stretch(scene.grid);
}

}  // namespace

std::vector<Start> starts_of(const Scene& scene) {
  const Features is = features_of(scene);
  std::vector<Start> list;
  for (const auto& [when, start] : table) {
    if (!when(is)) continue;
    if (list.size() >= 2 && beyond_finest_grid(scene, start)) break;
    list.push_back(start);
    if (heavy_line(is) && start.pre == 0) list.back().pre = list.back().post = most_relaxations;
  }
  return list;
}

const Start& usual_start() { return usual; }
const Start& safe_start() { return finer_coarsest; }

}  // namespace ehl::steady
