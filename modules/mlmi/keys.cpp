#include "mlmi/keys.hpp"

namespace ehl::mlmi {

std::vector<deck::Key> keys() {
  using deck::Key;
  using deck::Type;
  const deck::Condition multilevel{.name = "method", .words = {"mlmi"}};
  const std::string chosen = "chosen for the grid";
  return {
      Key{.section = "deformation",
          .name = "method",
          .type = Type::word,
          .default_text = "mlmi",
          .words = {"mlmi", "fft", "direct"},
          .meaning =
              "How the elastic deformation is summed: multilevel multi-integration, exact by FFT, or the direct double "
              "sum (exact, slow: small grids only).",
          .source = "Brandt and Lubrecht 1990"},
      Key{.section = "deformation",
          .name = "order",
          .type = Type::integer,
          .default_note = chosen,
          .range = {4, 8},
          .meaning = "Transfer order 2p: 4, 6 or 8.",
          .needs = multilevel,
          .example = "6"},
      Key{.section = "deformation",
          .name = "patch_along",
          .type = Type::integer,
          .default_note = chosen,
          .range = {1, 64},
          .meaning = "Radius of the correction patch along the coarsening direction [points].",
          .needs = multilevel,
          .example = "9"},
      Key{.section = "deformation",
          .name = "patch_across",
          .type = Type::integer,
          .default_note = chosen,
          .range = {1, 64},
          .meaning = "Radius of the correction patch across the coarsening direction [points].",
          .needs = multilevel,
          .example = "3"},
      Key{.section = "deformation",
          .name = "coarsenings",
          .type = Type::integer,
          .default_note = chosen,
          .range = {0, 20},
          .meaning = "Number of semi-coarsenings (x and y in turn) before the coarsest sum.",
          .needs = multilevel,
          .example = "2"},
      Key{.section = "deformation",
          .name = "coarsest_sum",
          .type = Type::word,
          .default_text = "fft",
          .words = {"fft", "direct"},
          .meaning = "How the coarsest grid is summed.",
          .needs = multilevel},
  };
}

}  // namespace ehl::mlmi
