#include "steady/keys.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>

#include "deck/text.hpp"

namespace ehl::steady {

using deck::Type;

std::vector<deck::Key> path_keys() {
  const ContinuationParameters defaults;
  return deck::together(
      {deck::in_section(
           "multigrid",
           {{.name = "polish",
             .default_text = "rescue",
             .words = {"rescue", "always", "off"},
             .meaning = "Newton refinement (Newton-Krylov) on the finest grid. rescue: only if no other strategy finds "
                        "a solution. always: also after the cycles, down to rounding errors. off: never.",
             .source = "modules/steady/README.md"}}),
       deck::in_section(
           "continuation",
           deck::only_with(
               {.name = "path", .words = {"automatic", "load"}},
               {{.name = "path",
                 .default_text = "automatic",
                 .words = {"automatic", "load", "off"},
                 .meaning = "Load continuation from a lower load up to that of the deck. automatic: only if full "
                            "multigrid alone does not find a solution. load: always. off: never."},
                {.name = "M_start",
                 .default_note =
                     "a hundredth of the contact's M, but at least 20; a higher load if that one is not solved",
                 .range = {0.1, 1e5},
                 .meaning = "First load of the continuation, as Moes load number M. L does not depend on the load.",
                 .example = "20"},
                {.name = "load_start",
                 .default_note = "see M_start",
                 .unit = "N",
                 .range = {0.0, std::numeric_limits<double>::infinity(), true, true},
                 .meaning =
                     "First load of the continuation, for a contact in SI. For a line contact: in newtons per metre.",
                 .example = "10"},
                {.name = "step",
                 .default_text = deck::shortest(defaults.step),
                 .range = {1.0, 10.0, true, false},
                 .meaning = "Ratio of the second load to the first one. Later ratios follow from the number of cycles "
                            "that the solutions take."},
                {.name = "max_steps",
                 .type = Type::integer,
                 .default_text = std::to_string(defaults.max_steps),
                 .range = {1, 10000},
                 .meaning = "Largest number of loads to solve for, rejected steps included."}}))});
}

Polish read_polish(deck::Deck& deck) {
  return deck::Part{deck, "multigrid"}.choice("polish", {Polish::fallback, Polish::always, Polish::off});
}

ContinuationParameters read_continuation(deck::Deck& deck, double M, const deck::PlainUnit& newton) {
  const deck::Part continuation{deck, "continuation"};
  ContinuationParameters parameters;
  using Path = ContinuationParameters::Path;
  parameters.path = continuation.choice("path", {Path::automatic, Path::load, Path::off});
  const double M_start = continuation.number("M_start"), load_start = continuation.number("load_start");
  const bool by_M = continuation.given("M_start"), by_load = continuation.given("load_start");
  if (by_load && !newton.known)
    continuation.complain("load_start", "is in newtons, but the contact is not given in SI: use M_start");
  else if (by_load && by_M)
    continuation.complain("load_start", "the first load is already given by M_start: keep one of them");
  parameters.load_ratio = by_load && !by_M ? load_start / newton.in_SI : M_start / M;
  const deck::Key& first_M = *deck::find_key(deck.catalogue, "continuation", "M_start");
  if (const double first = parameters.load_ratio * M;
      by_load && !by_M && newton.known && !first_M.range.contains(first))
    continuation.complain("load_start",
                          fmt::format("means M_start = {:.3g}, which must be {}", first, deck::allowed(first_M)));
  if (parameters.load_ratio == 1.0)
    continuation.complain(by_M ? "M_start" : "load_start",
                          "is the load of the contact itself, so there is nothing to continue: give a lower load");
  parameters.step = continuation.number("step");
  parameters.max_steps = continuation.integer("max_steps", parameters.max_steps);
  return parameters;
}

}  // namespace ehl::steady
