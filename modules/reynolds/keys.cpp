#include "reynolds/keys.hpp"

namespace ehl::reynolds {

std::vector<deck::Key> keys() {
  return deck::in_section(
      "discretization",
      {{.name = "wedge",
        .default_text = "upstream2",
        .words = {"upstream1", "upstream2"},
        .meaning = "The discrete wedge term d(rho H)/dX: first order as in the paper, or second order. The second is "
                   "ten times closer on the same grid.",
        .source = "Venner and ten Napel 1992, eq. (4), use upstream1"}});
}

Wedge read(deck::Deck& deck) {
  return deck::Part{deck, "discretization"}.choice("wedge", {Wedge::upstream1, Wedge::upstream2});
}

}  // namespace ehl::reynolds
