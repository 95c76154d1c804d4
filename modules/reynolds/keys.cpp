#include "reynolds/keys.hpp"

#include "deck/record.hpp"

namespace ehl::reynolds {

std::vector<deck::Key> keys() {
  using namespace deck::record;
  return deck::in_section(
      "discretization",
      {key("wedge", by_default("upstream3"), words({"upstream1", "upstream2", "upstream3", "upstream3_inlet"}),
           "Discretization of the wedge term d(rho H)/dX. upstream1: first order, as in the paper. upstream2: second "
           "order. upstream3: third order where the pressure couples the nodes (epsilon/h^2 above 1), second order "
           "elsewhere. upstream3_inlet: third order upstream of X = 0, second order downstream.",
           source("Venner and ten Napel 1992, eq. (4), use upstream1")),
       key("face", words({"mean", "logmean", "logmean_bounded"}),
           otherwise("logmean_bounded with the third-order wedge terms, mean with the others"),
           "Value of epsilon half-way between two nodes. mean: mean of the two nodes. logmean: rho H^3/eta of the half "
           "point, with H from four nodes and the logarithmic mean of 1/eta; more accurate at the edge of the contact "
           "in the inlet. logmean_bounded: as logmean, but at least 0.4 of the mean of 1/eta; it converges faster at "
           "steep pressures behind a spike.",
           source("Venner and ten Napel 1992, below eq. (4), use mean"))});
}

Wedge read(deck::Deck& deck) {
  return deck::Part{deck, "discretization"}.choice(
      "wedge", {Wedge::upstream1, Wedge::upstream2, Wedge::upstream3, Wedge::upstream3_inlet});
}

Face read_face(deck::Deck& deck) {
  const deck::Part part{deck, "discretization"};
  part.follow("face", std::string(third_order(read(deck)) ? "logmean_bounded" : "mean"),
              "the most accurate with this wedge term");
  return part.choice("face", {Face::mean, Face::logmean, Face::logmean_bounded});
}

}  // namespace ehl::reynolds
