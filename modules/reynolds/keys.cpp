#include "reynolds/keys.hpp"

namespace ehl::reynolds {

std::vector<deck::Key> keys() {
  return deck::in_section(
      "discretization",
      {{.name = "wedge",
        .default_text = "upstream3",
        .words = {"upstream1", "upstream2", "upstream3", "upstream3_inlet"},
        .meaning =
            "The discrete wedge term d(rho H)/dX: first order as in the paper; second order, ten times closer on "
            "the same grid; third order where the pressure couples the nodes (epsilon/h^2 above 1) and second "
            "elsewhere, five to twenty times closer again with its face; or third order upstream of X = 0 alone.",
        .source = "Venner and ten Napel 1992, eq. (4), use upstream1"},
       {.name = "face",
        .default_note = "logmean_bounded with the third-order wedges, mean with the others",
        .words = {"mean", "logmean", "logmean_bounded"},
        .meaning =
            "epsilon half-way between two nodes: the mean of the two; or rho H^3/eta of its own, with H from four "
            "nodes and the logarithmic mean of 1/eta, several times closer in the rim of the inlet; or that with at "
            "least 0.4 of the mean of 1/eta, with which steep pressures behind a spike converge faster.",
        .source = "Venner and ten Napel 1992, below eq. (4), use mean"}});
}

Wedge read(deck::Deck& deck) {
  return deck::Part{deck, "discretization"}.choice(
      "wedge", {Wedge::upstream1, Wedge::upstream2, Wedge::upstream3, Wedge::upstream3_inlet});
}

Face read_face(deck::Deck& deck) {
  const deck::Part part{deck, "discretization"};
  part.follow("face", std::string(third_order(read(deck)) ? "logmean_bounded" : "mean"),
              "measures best with the wedge");
  return part.choice("face", {Face::mean, Face::logmean, Face::logmean_bounded});
}

}  // namespace ehl::reynolds
