#include "mlmi/keys.hpp"

namespace ehl::mlmi {

std::vector<deck::Key> keys() {
  using deck::Type;
  const std::string chosen = "chosen for the grid";
  return deck::in_section(
      "deformation",
      deck::only_with(
          {.name = "method", .words = {"mlmi"}},
          {{.name = "method",
            .default_text = "mlmi",
            .words = {"mlmi", "fft", "direct"},
            .meaning = "How the elastic deformation is computed. mlmi: multilevel multi-integration. fft: fast Fourier "
                       "transform, exact. direct: double sum, exact and slow, for small grids only.",
            .source = "Brandt and Lubrecht 1990"},
           {.name = "order",
            .type = Type::integer,
            .default_note = chosen,
            .range = {4, 8},
            .meaning = "Order 2p of the transfers between grids: 4, 6 or 8.",
            .example = "6"},
           {.name = "patch_along",
            .type = Type::integer,
            .default_note = chosen,
            .range = {1, 64},
            .meaning = "Radius of the correction patch in the coarsening direction, in points.",
            .example = "9"},
           {.name = "patch_across",
            .type = Type::integer,
            .default_note = chosen,
            .range = {1, 64},
            .meaning = "Radius of the correction patch at right angles to the coarsening direction, in points.",
            .example = "3"},
           {.name = "coarsenings",
            .type = Type::integer,
            .default_note = chosen,
            .range = {0, 20},
            .meaning = "Number of semi-coarsenings, in x and y by turns, before the sum on the coarsest grid.",
            .example = "2"},
           {.name = "coarsest_sum",
            .default_text = "fft",
            .words = {"fft", "direct"},
            .meaning = "How the sum on the coarsest grid is computed."}}));
}

Parameters read(deck::Deck& deck) {
  const deck::Part deformation{deck, "deformation"};
  Parameters parameters;
  parameters.method = deformation.choice("method", {Method::mlmi, Method::fft, Method::direct});
  parameters.order = deformation.integer("order", parameters.order);
  if (parameters.order % 2 != 0) deformation.complain("order", "must be 4, 6 or 8");
  parameters.patch_along = deformation.integer("patch_along", parameters.patch_along);
  parameters.patch_across = deformation.integer("patch_across", parameters.patch_across);
  parameters.coarsenings = deformation.integer("coarsenings", parameters.coarsenings);
  parameters.coarsest_direct = deformation.choice("coarsest_sum", {false, true});
  return parameters;
}

}  // namespace ehl::mlmi
