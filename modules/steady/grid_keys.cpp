// Domain and grid: their keys, how the deck is read, and the choices for what it leaves open.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "deck/record.hpp"
#include "steady/domain_error.hpp"
#include "steady/keys.hpp"
#include "steady/resolution.hpp"

namespace ehl::steady {

std::vector<deck::Key> grid_keys() {
  using namespace deck::record;
  const auto contains = remedy("the domain must contain the contact; a circular contact has radius 1");
  return deck::together(
      {deck::in_section(
           "domain",
           {key("x_inlet", Range{-1000.0, 0.0, false, true}, example("-4.5"),
                otherwise("chosen so that the end of the domain changes the film by less than about 0.6 %, with "
                          "far_field = closed far less"),
                "Position of the inlet boundary in Hertz radii. It must lie outside the contact. Light loads need a "
                "longer inlet.",
                contains),
            key("x_outlet", up_to(1000.0), example("1.5"),
                otherwise("1.5 half lengths of the contact; 3 or more for light loads"),
                "Position of the outlet boundary in Hertz radii. It must lie outside the contact.", contains,
                source("Venner and ten Napel 1992: -4.5 to 1.5")),
            key("y_half", up_to(1e6), example("3"),
                otherwise("circle: half the length of the domain, or 1.25 times that with far_field = closed; ellipse: "
                          "to where the gap is as wide as at the inlet; roller: half of its length"),
                "Half width of the domain in Hertz radii. The sides must lie outside the contact.", contains,
                source("Venner and ten Napel 1992: -3 to 3")),
            key("far_field", by_default("closed"), words({"closed", "zero"}),
                "Pressure on the boundary of the domain, and load outside of it. closed: those of nearly rigid bodies, "
                "in closed form. zero: none, as in the paper. A load that jumps in time, or changes by more than twice "
                "its size within a/u_m, requires zero; so do rollers, line contacts in time, and a conserved oil "
                "content ([supply]). If the key is left out, zero is taken there, for [body], and for an ellipse whose "
                "load changes by more than half of its size within a/u_m.",
                source("modules/reynolds/README.md"))}),
       deck::in_section(
           "grid",
           {key("cells", integer, Range{16, 1048576}, example("256"),
                otherwise(
                    "the first of 256, 512 and 1024 that resolves the film; line contacts and ellipses may get more"),
                "Number of cells along x of the finest grid: that of the coarsest grid times a power of two. The "
                "number along y follows from the domain so that the cells are nearly square. If the contact is more "
                "than 7 times as wide (y) as long (x), the cells are twice as wide as long; if it is at least 6 times "
                "as long as wide and not oblique, they are 4, 8 or 16 times as long as wide.",
                remedy("the number of cells along x of the finest grid, e.g. 256")),
            key("coarsest", integer, Range{4, 4096}, example("32"), otherwise("chosen for the case"),
                "Number of cells along x of the coarsest grid."),
            key("errors", by_default("adjoint"), words({"adjoint", "levels"}),
                "How the discretization errors of Hc and Hm are estimated. adjoint: truncation error of a coarser "
                "grid, weighted by the adjoint solutions of Hc and Hm; only with wedge = upstream3 and without "
                "[supply]. levels: from the results of the sequence of grids. Line contacts always use levels; for "
                "them, adjoint adds only the maps error_Hc and error_Hm of [output] fields.",
                source("modules/adjoint/README.md")),
            key("accuracy", Range{1e-6, 0.5}, example("0.01"), otherwise("none: the grid is given or chosen"),
                "Relative error of Hc and Hm to reach, instead of cells. The run refines the grid until the estimated "
                "error is below this value, up to 8192 cells and half of the free memory. With far_field = zero it "
                "also extends the domain, unless x_inlet or y_half is given; the error of a given domain is reported, "
                "but not counted.",
                remedy("a relative error, e.g. 0.01"), source("modules/steady/README.md"))})});
}

namespace {

// The multigrid halves a grid down to this many cells along x.
constexpr int smallest_coarsest = 32;

constexpr int fewest_chosen_cells = 256;
constexpr int most_chosen_cells = 1024;
constexpr int most_cells_of_line = 8192;
constexpr double most_nodes_of_ellipse = 5.0 * most_chosen_cells * most_chosen_cells;

bool closed(const deck::Part& domain) { return domain.choice("far_field", {true, false}); }

void choose_domain(const Tuning& tuning, const deck::Part& domain, double accuracy, const ContactScales& contact,
                   double wider) {
  std::optional<double> far_field;
  // With an error in the contact the domain has no meaning.
  const bool known = contact.M > 0.0 && contact.L >= 0.0;
  if (closed(domain) && known)
    // fmin() ignores an accuracy that is NaN.
    far_field = std::fmin(tuning.error_of_closed_domain, tuning.share_of_accuracy * accuracy);
  const bool roller = contact::roller(contact.shape);
  if (contact::line(contact.shape))
    domain.refuse({"y_half"},
                  roller ? "is half of the roller's length, where the gap ends: remove it"
                         : "has no influence on a line contact, which has no sides: remove it",
                  deck::Cause::idle);
  domain.fill("x_outlet", wider * chosen_outlet(tuning, contact, far_field), "downstream of the cavitation boundary");
  const double x_outlet = domain.number("x_outlet");
  domain.fill("x_inlet", wider * chosen_inlet(tuning, contact, x_outlet / wider, far_field),
              far_field ? "far_field = closed: a domain of half this length would change the film by less than 0.2 %"
                        : "the inlet boundary changes the film by less than about 1 %, or lies 200 radii upstream");
  if (roller) domain.follow("y_half", contact.shape.kappa, "the ends of the roller");
  if (contact::line(contact.shape)) return;
  domain.fill("y_half",
              chosen_half_width(tuning, domain.number("x_inlet"), x_outlet, contact.shape, far_field.has_value()),
              !contact::circular(contact.shape) ? "the gap at the sides is as wide as at the inlet"
              : far_field                       ? "1.25 times half the length of the domain"
                                                : "half the length of the domain");
}

// Least number of cells along x for an oblique ellipse: as many along its shorter axis in both directions as resolve
// it, with one grid below the finest for the estimate of the mesh error. [bench: cells_on_circle]
double fewest_oblique(const Tuning& tuning, double length, const ContactScales& contact) {
  const double sizes = length / contact.size;
  return std::max(tuning.cells_on_circle, tuning.cells_per_contact_size * sizes) * contact.slenderness;
}

// Chooses the level that resolves the film if the deck leaves the cells open.
void choose_cells(const Tuning& tuning, const deck::Part& grid, const deck::Part& domain, const ContactScales& contact,
                  reynolds::Wedge wedge) {
  if (grid.given("cells")) return;
  const double length = domain.number("x_outlet") - domain.number("x_inlet");
  if (std::isnan(length)) return;
  int fewest = std::max(grid.integer("coarsest", fewest_chosen_cells), 1);
  // A slender or oblique contact needs more cells along X to be resolved at all.
  const double least = contact::gap(contact.shape).oblique() ? fewest_oblique(tuning, length, contact)
                                                             : 0.5 * fewest_chosen_cells * contact.slenderness;
  const double stretch = std::max(1.0, 1.0 / cell_aspect(tuning, contact.shape));
  while (fewest < fewest_chosen_cells || fewest <= least / stretch) fewest *= 2;
  int most = fewest * (most_chosen_cells / fewest_chosen_cells);
  if (contact::line(contact.shape) && !contact::roller(contact.shape)) {
    most = most_cells_of_line;
  } else if (!contact::circular(contact.shape)) {
    const double most_along = std::sqrt(most_nodes_of_ellipse * cell_aspect(tuning, contact.shape) * length /
                                        (2.0 * domain.number("y_half")));
    for (most = fewest; 2 * most <= most_along;) most *= 2;
  }
  const int cells = resolving_cells(stretch * resolving_step(tuning, contact, wedge), length, fewest, most);
  grid.choose("cells", cells, cells < most ? "resolves the film" : "the largest number that is chosen automatically");
}

// How often the cells can be halved; -1 if that does not end at a coarse enough grid.
int halvings(int cells, int coarsest) {
  int count = 0;
  const auto goes_on = [&] { return coarsest > 0 ? cells > coarsest : cells / 2 >= smallest_coarsest; };
  for (; cells % 2 == 0 && goes_on(); ++count) cells /= 2;
  const bool coarse_enough = coarsest > 0 ? cells == coarsest : cells < 2 * smallest_coarsest;
  return coarse_enough ? count : -1;
}

// The largest number of cells, if possible not above `most`, that can be halved down to a coarsest grid.
double good_cells(double most, int coarsest) {
  double cells = coarsest > 0 ? coarsest : 16.0;
  while (2.0 * cells <= most) cells *= 2.0;
  return cells;
}

}  // namespace

AccuracyTarget read_accuracy(deck::Deck& deck) {
  const deck::Part grid{deck, "grid"};
  AccuracyTarget target{.error = grid.number("accuracy")};
  if (!grid.given("accuracy")) return target;
  if (grid.given("cells"))
    grid.complain("accuracy",
                  "cells is given as well: keep one of them. accuracy chooses the cells itself; --unset grid.cells "
                  "removes the key from the deck");
  // The part of the domain that the deck leaves open may grow.
  const deck::Part domain{deck, "domain"};
  target.domain_is_free = domain.given_of({"x_inlet", "y_half"}).empty() && !closed(domain);
  return target;
}

void choose_grid(deck::Deck& deck, const Tuning& tuning, const ContactScales& contact, reynolds::Wedge wedge,
                 double wider) {
  const deck::Part domain{deck, "domain"};
  choose_domain(tuning, domain, deck::Part{deck, "grid"}.number("accuracy"), contact, wider);
  choose_cells(tuning, {deck, "grid"}, domain, contact, wedge);
  if (!deck::given(deck, "grid", "accuracy")) return;
  // The chosen grid is only the first to be tried: marked as following, since an accuracy beside a given grid is
  // refused.
  mark_following(deck, "grid", "cells");
  for (const char* key : {"x_inlet", "x_outlet", "y_half"}) mark_following(deck, "domain", key);
}

void check_contains(deck::Deck& deck, const contact::Ellipse& shape) {
  const deck::Part domain{deck, "domain"};
  const contact::Extent reach = contact::extent(shape);
  const auto check = [&](const char* key, double extent) {
    // A refused value is NaN and passes this comparison.
    if (domain.given(key) && std::abs(domain.number(key)) <= extent)
      domain.complain(key,
                      fmt::format("the domain must contain the contact, which reaches to {:.4g} Hertz radii", extent));
  };
  check("x_inlet", reach.X);
  check("x_outlet", reach.X);
  if (!contact::line(shape)) check("y_half", reach.Y);
}

GridInput read_grid(deck::Deck& deck, std::optional<double> size, double aspect, bool line) {
  const deck::Part part{deck, "grid"}, domain{deck, "domain"};
  const int cells = part.integer("cells", 0), coarsest = part.integer("coarsest", 0);
  GridInput input{.coarsest = coarsest};
  core::Grid& grid = input.finest;
  grid.nx = cells;
  grid.X_a = domain.number("x_inlet");
  grid.X_b = domain.number("x_outlet");
  if (line) {
    grid = core::line_grid(grid.nx, grid.X_a, grid.X_b);
    grid.ny = 0;  // no error so far
  } else {
    grid.Y_b = domain.number("y_half");
    grid.Y_a = -grid.Y_b;
  }
  // A missing or wrong value has already been reported.
  if (cells == 0 || std::isnan(grid.X_b - grid.X_a) || std::isnan(grid.Y_b)) return input;
  const int levels = halvings(cells, coarsest);
  if (levels < 0) {
    const std::string of = coarsest > 0 ? "a multiple of the coarsest grid's " + std::to_string(coarsest) + " cells"
                                        : "a multiple of a coarsest grid of 32 to 63 cells";
    const double below = good_cells(cells, coarsest);
    part.complain("cells", "must be " + of + " by a power of two, e.g. " + deck::shortest(below) + " or " +
                               deck::shortest(2.0 * below));
    return input;
  }
  // A domain chosen for a contact with an error in it has no meaning.
  if (!size && !domain.given("x_inlet")) return input;
  // ny is even on the coarsest grid too, so that y = 0 is a line of every grid. Cells shorter along y are square cells
  // divided along y; the multigrid merges them again.
  const double along_y = cells * (grid.Y_b - grid.Y_a) / (grid.X_b - grid.X_a) / std::max(1.0, aspect);
  const double pairs = std::max(1.0, std::round(std::ldexp(along_y, -levels - 1)));
  const double ny = std::ldexp(pairs, levels + 1) * std::max(1.0, 1.0 / aspect);
  if (line)
    grid.ny = core::line_grid(cells, grid.X_a, grid.X_b).ny;
  else if (ny > 1 << 21)
    domain.complain("y_half", "means " + deck::shortest(ny) + " cells along y: use a narrower domain");
  else
    grid.ny = static_cast<int>(ny);
  const double coarsest_step = 0.5 * size.value_or(1.0);
  if (grid.hx() > coarsest_step) {
    const double fewest = (grid.X_b - grid.X_a) / coarsest_step;
    const double below = good_cells(fewest, coarsest);
    part.complain("cells", fmt::format("too coarse for {:.4g} <= x <= {:.4g}: a cell is {:.3g} Hertz radii wide, and "
                                       "the limit is {:g}; use e.g. {} cells, or a shorter domain",
                                       grid.X_a, grid.X_b, grid.hx(), coarsest_step,
                                       deck::shortest(below < fewest ? 2.0 * below : below)));
  }
  return input;
}

bool read_far_field(deck::Deck& deck, const Tuning& tuning, const contact::Ellipse& shape, double steepest_load,
                    const std::string& why_zero) {
  // The oil outside the domain carries a change of load by squeeze, with boundary pressures at which the bodies are no
  // longer rigid. Ellipses across the motion have a short inlet beside their width. [bench: too_steep]
  const bool steep = steepest_load > tuning.too_steep;
  const bool unsure = contact::circular(shape) ? steep : steepest_load > tuning.too_steep_for_ellipses;
  const deck::Part domain{deck, "domain"};
  if (steep && domain.given("far_field") && closed(domain))
    domain.complain("far_field",
                    fmt::format("the load of [transient] {}, and far_field = closed allows at most {:g} times the "
                                "contact's load within a/u_m, because the oil outside the domain would carry it by "
                                "squeeze: set zero",
                                std::isinf(steepest_load) ? "jumps" : fmt::format("changes by {:.3g}", steepest_load),
                                tuning.too_steep));
  if (unsure || !why_zero.empty())
    domain.follow("far_field", std::string("zero"), unsure ? "the load changes fast in time" : why_zero);
  return closed(domain);
}

bool read_adjoint_errors(deck::Deck& deck) { return deck::Part{deck, "grid"}.choice("errors", {true, false}); }

}  // namespace ehl::steady
