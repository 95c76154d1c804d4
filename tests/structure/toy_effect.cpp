#include "structure/toy_effect.hpp"

#include <algorithm>
#include <cmath>

#include "case/effects.hpp"
#include "case/numbers/number.hpp"
#include "deck/text.hpp"
#include "steady/solve.hpp"

namespace ehl::program {

ToyCalls& toy_calls() {
  static ToyCalls calls;
  return calls;
}

double steepest(const steady::Solution& solution) {
  const core::Grid& grid = solution.grid;
  double slope = 0.0;
  for (int i = 1; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j)
      slope = std::max(slope, std::abs(solution.P(i, j) - solution.P(i - 1, j)) / grid.hx());
  return slope;
}

namespace {

bool on(const Case& input) { return deck::given(input.deck, "toy", "steepest"); }

FilmSolver film(const Case&) {
  return [](const Case& input, const steady::ProgressCallback& progress, Computed& computed) {
    ++toy_calls().film;
    computed.solution = steady::solve(input.scene, progress);
  };
}

void after_solution(const Case& input, RunSettings&, Computed& computed) {
  ++toy_calls().after_solution;
  if (steepest(computed.solution) > deck::number(input.deck, "toy", "steepest"))
    computed.outcome.warnings.push_back({"steep", "the pressure is steeper than [toy] steepest"});
}

numbers::Group toy_numbers() {
  numbers::Group group{.name = "toy"};
  group.asked = [](const deck::Deck& deck) { return deck::given(deck, "toy", "steepest"); };
  group.on = [](numbers::Of s) { return on(s.input); };
  group.numbers = {{.name = "steepest_slope",
                    .unit = "p_h/a",
                    .meaning = "largest slope of the pressure along x",
                    .value = [](numbers::Of s) { return steepest(s.computed.solution); },
                    .column = {.place = 799}}};
  return group;
}

}  // namespace

Effect toy_effect() {
  return {.name = "toy",
          .meaning = "The steepest pressure.",
          .sections = {{.name = "toy", .called_by = {"steepest"}}},
          .keys =
              [] {
                return deck::in_section("toy", {{.name = "steepest",
                                                 .range = {.lower = 0.0},
                                                 .meaning = "Slope of the pressure above which the run warns.",
                                                 .example = "10"}});
              },
          .numbers = toy_numbers,
          .stages = {.scene = [](Case& input) { toy_calls().scene += on(input) ? 1 : 0; },
                     .film = film,
                     .after_solution = after_solution,
                     .from = Extent::row},
          .on = on,
          .what = [](const Case&) { return std::string("the steepest pressure"); },
          .add_content =
              [](const Case& input, const Computed& computed, results::Content& content) {
                numbers::append("toy", {input, computed}, content.summary);
              },
          .example = {"toy.steepest=10"}};
}

}  // namespace ehl::program
