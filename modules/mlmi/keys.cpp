#include "mlmi/keys.hpp"

#include "deck/record.hpp"

namespace ehl::mlmi {

namespace {

deck::Records<Parameters> records() {
  using namespace deck::record;
  const auto chosen = otherwise("chosen for the grid");
  return deck::only_with<Parameters>(
      needs("method", {"mlmi"}),
      {key("method", &Parameters::method, {{"mlmi", Method::mlmi}, {"fft", Method::fft}, {"direct", Method::direct}},
           own_default,
           "How the elastic deformation is computed. mlmi: multilevel multi-integration. fft: fast "
           "Fourier transform, exact. direct: double sum, exact and slow, for small grids only.",
           source("Brandt and Lubrecht 1990")),
       key("order", &Parameters::order, even(4, 8), example("6"), chosen,
           "Order 2p of the transfers between grids: 4, 6 or 8."),
       key("patch_along", &Parameters::patch_along, Range{1, 64}, example("9"), chosen,
           "Radius of the correction patch in the coarsening direction, in points."),
       key("patch_across", &Parameters::patch_across, Range{1, 64}, example("3"), chosen,
           "Radius of the correction patch at right angles to the coarsening direction, in points."),
       key("coarsenings", &Parameters::coarsenings, Range{0, 20}, example("2"), chosen,
           "Number of semi-coarsenings, in x and y by turns, before the sum on the coarsest grid."),
       key("coarsest_sum", &Parameters::coarsest_direct, {{"fft", false}, {"direct", true}}, own_default,
           "How the sum on the coarsest grid is computed.")});
}

}  // namespace

std::vector<deck::Key> keys() { return deck::keys_of("deformation", records()); }

Parameters read(deck::Deck& deck) { return deck::read(deck::Part{deck, "deformation"}, records()); }

}  // namespace ehl::mlmi
