#include "dry/keys.hpp"

#include "deck/record.hpp"
#include "dry/solve.hpp"

namespace ehl::dry {
namespace {

deck::Records<Parameters> records() {
  using namespace deck::record;
  return deck::only_with<Parameters>(
      {.name = "kind", .words = {"dry"}, .section = "case"},
      {key("tolerance", &Parameters::tolerance, Range{1e-12, 1e-2}, own_default,
           "Accuracy of the dry contact: largest gap inside the contact and largest overlap outside it, in a^2/R.",
           source("modules/dry/README.md")),
       key("max_iterations", &Parameters::max_iterations, Range{1, 1000000}, own_default,
           "Largest number of iterations on each grid.")});
}

}  // namespace

std::vector<deck::Key> keys() { return deck::keys_of("dry", records()); }

std::optional<Parameters> read(deck::Deck& deck) {
  if (deck::word(deck, "case", "kind") != "dry") return std::nullopt;
  return deck::read(deck::Part{deck, "dry"}, records());
}

}  // namespace ehl::dry
