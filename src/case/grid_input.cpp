#include "case/grid_input.hpp"

#include <algorithm>
#include <cmath>

#include "deck/text.hpp"
#include "report/text_format.hpp"
#include "steady/domain_error.hpp"
#include "steady/resolution.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;

// The multigrid halves a grid as long as this many cells along x are left.
constexpr int smallest_coarsest = 32;

constexpr int fewest_chosen_cells = 256;
constexpr int most_chosen_cells = 1024;
constexpr double most_nodes_of_ellipse = 5.0 * most_chosen_cells * most_chosen_cells;

void choose_domain(deck::Deck& deck, const contact::Groups& groups) {
  if (!given(deck, "domain", "x_outlet"))
    deck::choose(deck, "domain", "x_outlet", steady::chosen_outlet(groups.M, groups.L, groups.shape),
                 "behind the cavitation boundary");
  const double x_outlet = deck::number(deck, "domain", "x_outlet");
  if (!given(deck, "domain", "x_inlet"))
    deck::choose(deck, "domain", "x_inlet", steady::chosen_inlet(groups.M, groups.L, x_outlet, groups.shape),
                 "cuts off less than about 1 % of the film where 200 radii are enough for that");
  if (!given(deck, "domain", "y_half"))
    deck::choose(deck, "domain", "y_half",
                 steady::chosen_half_width(deck::number(deck, "domain", "x_inlet"), x_outlet, groups.shape),
                 contact::circular(groups.shape) ? "as wide as long" : "as wide a gap at the sides as along x");
}

// The level that resolves the film, for a deck that leaves it to the program.
void choose_cells(deck::Deck& deck, const contact::Groups& groups, reynolds::Wedge wedge) {
  if (given(deck, "grid", "cells")) return;
  const double length = deck::number(deck, "domain", "x_outlet") - deck::number(deck, "domain", "x_inlet");
  if (std::isnan(length)) return;
  int fewest = std::max(deck::integer(deck, "grid", "coarsest", fewest_chosen_cells), 1);
  // A contact that is slender, or aslant, needs more along X to be seen as well.
  const double least = fewest_chosen_cells * steady::slenderness(groups.M, groups.L, groups.shape);
  while (fewest < fewest_chosen_cells || 2 * fewest <= least) fewest *= 2;
  int most = fewest * (most_chosen_cells / fewest_chosen_cells);
  if (!contact::circular(groups.shape)) {
    const double width = 2.0 * deck::number(deck, "domain", "y_half");
    const double most_along = std::sqrt(most_nodes_of_ellipse * length / width);
    for (most = fewest; 2 * most <= most_along;) most *= 2;
  }
  const double step = steady::resolving_step(groups.M, groups.L, wedge, groups.shape);
  const int cells = steady::resolving_cells(step, length, fewest, most);
  deck::choose(deck, "grid", "cells", cells, cells < most ? "resolves the film" : "the most that is chosen unasked");
}

// How often the cells are halved, -1 when that does not lead to a coarse enough grid.
int halvings(int cells, int coarsest) {
  int count = 0;
  const auto goes_on = [&] { return coarsest > 0 ? cells > coarsest : cells / 2 >= smallest_coarsest; };
  for (; cells % 2 == 0 && goes_on(); ++count) cells /= 2;
  const bool coarse_enough = coarsest > 0 ? cells == coarsest : cells < 2 * smallest_coarsest;
  return coarse_enough ? count : -1;
}

// The largest number of cells, not above `most` where that is possible, that surely can be halved down far enough.
double good_cells(double most, int coarsest) {
  double cells = coarsest > 0 ? coarsest : 16.0;
  while (2.0 * cells <= most) cells *= 2.0;
  return cells;
}

}  // namespace

void choose_grid(deck::Deck& deck, const contact::Groups& groups, reynolds::Wedge wedge) {
  choose_domain(deck, groups);
  choose_cells(deck, groups, wedge);
}

core::Grid grid_input(deck::Deck& deck, bool contact_known) {
  const int cells = deck::integer(deck, "grid", "cells", 0);
  const int coarsest = deck::integer(deck, "grid", "coarsest", 0);
  core::Grid grid;
  grid.nx = cells;
  grid.X_a = deck::number(deck, "domain", "x_inlet");
  grid.X_b = deck::number(deck, "domain", "x_outlet");
  grid.Y_b = deck::number(deck, "domain", "y_half");
  grid.Y_a = -grid.Y_b;
  if (cells == 0 || std::isnan(grid.X_b - grid.X_a) || std::isnan(grid.Y_b)) return grid;  // complained about already
  const int levels = halvings(cells, coarsest);
  if (levels < 0) {
    const std::string of = coarsest > 0 ? "a multiple of the coarsest grid's " + std::to_string(coarsest) + " cells"
                                        : "a multiple of a coarsest grid of 32 to 63 cells";
    const double below = good_cells(cells, coarsest);
    complain(
        deck, "grid", "cells",
        "must be " + of + " by a power of two, e.g. " + deck::shortest(below) + " or " + deck::shortest(2.0 * below));
    return grid;
  }
  // Even on the coarsest grid, so that the line y = 0 is a line of every grid.
  const double along_y = cells * (grid.Y_b - grid.Y_a) / (grid.X_b - grid.X_a);
  const double pairs = std::max(1.0, std::round(std::ldexp(along_y, -levels - 1)));
  const double ny = std::ldexp(pairs, levels + 1);
  if (ny > 1 << 21)
    complain(deck, "domain", "y_half", "means " + deck::shortest(ny) + " cells along y: take a narrower domain");
  else
    grid.ny = static_cast<int>(ny);
  constexpr double coarsest_step = 0.5;
  // The domain that was chosen for a contact with an error in it tells nothing.
  const bool meant = contact_known || given(deck, "domain", "x_inlet");
  if (meant && grid.hx() > coarsest_step) {
    const double fewest = (grid.X_b - grid.X_a) / coarsest_step;
    const double below = good_cells(fewest, coarsest);
    complain(deck, "grid", "cells",
             formatted("too coarse for %.4g <= x <= %.4g: a cell is %.3g Hertz radii wide and must be at most %g",
                       grid.X_a, grid.X_b, grid.hx(), coarsest_step) +
                 ": take e.g. " + deck::shortest(below < fewest ? 2.0 * below : below) + " cells, or a shorter domain");
  }
  return grid;
}

void check_domain(deck::Deck& deck, const steady::Scene& scene) {
  constexpr double too_much = 0.5;
  if (given(deck, "domain", "x_inlet")) return;
  const double error = steady::rough_domain_error(scene);
  if (error > too_much)
    complain(
        deck, "domain", "x_inlet",
        "is open, and the longest that is chosen, " + formatted("%.4g", scene.grid.X_a) + ", cuts off about " +
            formatted("%.0f %%", 100.0 * error) +
            " of the film: so light a load is carried far from the contact. Give x_inlet, as far as the oil reaches");
}

}  // namespace ehl::program
