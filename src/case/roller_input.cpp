#include "case/roller_input.hpp"

#include <memory>
#include <utility>

#include "effects/roller/keys.hpp"
#include "steady/climb.hpp"

namespace ehl::program {

void settle_roller(deck::Deck& deck) {
  const deck::Part contact{deck, "contact"}, domain{deck, "domain"}, grid{deck, "grid"}, path{deck, "continuation"};
  if (!deck::given(deck, "roller", "profile"))
    contact.complain("kind", "needs a profile in [roller]: straight with rounded ends, crowned, logarithmic or a table");
  if (domain.given("far_field") && domain.word("far_field") == "closed")
    domain.complain("far_field", "closed is that of a contact without ends: zero, or remove it");
  domain.follow("far_field", std::string("zero"), "the roller ends at the sides of the domain");
  grid.refuse({"accuracy"}, "is not available for rollers in this version: give cells");
  if (path.given("path") && path.word("path") == "load")
    path.complain("path", "load is not available for rollers, whose length in half widths changes with the load: off, "
                          "or remove it");
  path.follow("path", std::string("off"), "the length in half widths changes with the load");
}

namespace {

// Good enough to begin with: a hundredth of a thin film.
constexpr double tolerance_of_start = 1e-4;

double begin_with(const dry::Problem& problem, core::Field& P) {
  const dry::Solution solution = dry::solve(problem);
  core::copy(core::on_patch(problem.grid, solution.P), P);
  return solution.H00;
}

}  // namespace

dry::Problem dry_roller(const steady::Scene& scene, const core::Patch& grid) {
  const fmg::Geometry geometry = steady::geometry_of(scene.shape);
  dry::Problem problem{.grid = grid,
                       .gap = core::Field(grid),
                       .load = contact::load(scene.shape),
                       .threads = scene.threads,
                       .elastic = geometry.elastic,
                       .outline = geometry.outline};
  scene.surface(grid, problem.gap);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) problem.gap(i, j) += fmg::rigid_gap(geometry, grid, 0.0, i, j);
  return problem;
}

void roller_input(Case& input) {
  deck::Deck& deck = input.deck;
  const contact::Ellipse& shape = input.physics.groups.shape;
  if (!deck::given(deck, "roller", "profile") || !contact::roller(shape) || !deck.errors.empty()) return;
  roller::Scales scales{.length = shape.length, .in_SI = input.physics.language == Language::si};
  if (input.physics.si) {
    scales.a = input.physics.si->hertz.a;
    scales.radius = input.physics.si->contact.radius;
    scales.load = deck::number(deck, "contact", "load");
  }
  const roller::Profile profile = roller::read(deck, scales);
  if (!deck.errors.empty()) return;
  input.roller = profile;
  steady::Scene& scene = input.scene;
  scene.use_symmetry = scene.use_symmetry && roller::symmetric(profile);
  scene.surface = [profile, carried = std::move(scene.surface)](const core::Patch& grid, core::Field& S) {
    if (carried)
      carried(grid, S);
    else
      S.fill(0.0);
    roller::add_gap(profile, grid, S);
  };
  scene.dry = [only = scene](const core::Patch& grid, core::Field& P) {
    dry::Problem problem = dry_roller(only, grid);
    problem.parameters.tolerance = tolerance_of_start;
    return begin_with(problem, P);
  };
}

}  // namespace ehl::program
