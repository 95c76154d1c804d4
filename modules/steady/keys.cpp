#include "steady/keys.hpp"

#include <fmt/format.h>

#include "deck/record.hpp"

namespace ehl::steady {

namespace {

deck::Records<ContinuationParameters> records() {
  using namespace deck::record;
  using Path = ContinuationParameters::Path;
  return deck::only_with<ContinuationParameters>(
      needs("path", {"automatic", "load"}),
      {key("path", &ContinuationParameters::path,
           {{"automatic", Path::automatic}, {"load", Path::load}, {"off", Path::off}}, own_default,
           "Load continuation from a lower load up to that of the deck. automatic: only if full multigrid "
           "alone does not find a solution. load: always. off: never."),
       key("M_start", Range{0.1, 1e5}, example("20"),
           otherwise("a hundredth of the contact's M, but at least 20; a higher load if that one is not solved"),
           "First load of the continuation, as Moes load number M. L does not depend on the load."),
       key("load_start", instead_of({"M_start"}), unit("N"), positive, example("10"), otherwise("see M_start"),
           "First load of the continuation, for a contact in SI. For a line contact: in newtons per metre."),
       key("step", &ContinuationParameters::step, Range{1.0, 10.0, true, false}, own_default,
           "Ratio of the second load to the first one. Later ratios follow from the number of cycles that the "
           "solutions take."),
       key("max_steps", &ContinuationParameters::max_steps, Range{1, 10000}, own_default,
           "Largest number of loads to solve for, rejected steps included.")});
}

}  // namespace

std::vector<deck::Key> path_keys() {
  using namespace deck::record;
  const deck::Key polish =
      key("polish", by_default("rescue"), words({"rescue", "always", "off"}),
          "Newton refinement (Newton-Krylov) on the finest grid. rescue: only if no other strategy "
          "finds a solution. always: also after the cycles, down to rounding errors. off: never.",
          source("modules/steady/README.md"));
  return deck::together({deck::in_section("multigrid", {polish}), deck::keys_of("continuation", records())});
}

Polish read_polish(deck::Deck& deck) {
  return deck::Part{deck, "multigrid"}.choice("polish", {Polish::fallback, Polish::always, Polish::off});
}

ContinuationParameters read_continuation(deck::Deck& deck, double M, const deck::PlainUnit& newton) {
  const deck::Part continuation{deck, "continuation"};
  ContinuationParameters parameters = deck::read(continuation, records());
  const double M_start = continuation.number("M_start"), load_start = continuation.number("load_start");
  const bool by_M = continuation.given("M_start"), by_load = continuation.given("load_start");
  if (by_load && !newton.known)
    continuation.complain("load_start", "is in newtons, but the contact is not given in SI: use M_start");
  parameters.load_ratio = by_load && !by_M ? load_start / newton.in_SI : M_start / M;
  const deck::Key& first_M = continuation.key("M_start");
  if (const double first = parameters.load_ratio * M;
      by_load && !by_M && newton.known && !first_M.range.contains(first))
    continuation.complain("load_start",
                          fmt::format("means M_start = {:.3g}, which must be {}", first, deck::allowed(first_M)));
  if (parameters.load_ratio == 1.0)
    continuation.complain(by_M ? "M_start" : "load_start",
                          "is the load of the contact itself, so there is nothing to continue: give a lower load");
  return parameters;
}

}  // namespace ehl::steady
