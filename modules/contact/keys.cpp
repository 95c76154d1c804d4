#include "contact/keys.hpp"

namespace ehl::contact {
namespace {

using deck::Key;
using deck::Type;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr deck::Range positive{0.0, infinity, true, true};

std::vector<Key> dimensionless_keys() {
  return {
      Key{.section = "contact",
          .name = "M",
          .range = {0.1, 1e5},
          .remedy = "outside it the contact is rigid or dry for every grid",
          .meaning = "Moes load number M = W (2U)^(-3/4). First language: M and L.",
          .source = "Moes; Venner and ten Napel 1992 use M = 50, L = 10",
          .example = "50",
          .example_is_active = true},
      Key{.section = "contact",
          .name = "L",
          .range = {0.0, 100.0},
          .meaning = "Moes material number L = G (2U)^(1/4); 0 for an isoviscous lubricant.",
          .example = "10",
          .example_is_active = true},
      Key{.section = "contact",
          .name = "W",
          .range = positive,
          .meaning = "Hamrock-Dowson load number W = F/(E' R_x^2). Second language: W, U and G.",
          .example = "1.9e-7"},
      Key{.section = "contact",
          .name = "U",
          .range = positive,
          .meaning = "Hamrock-Dowson speed number U = eta0 u_m/(E' R_x), u_m = (u1 + u2)/2.",
          .example = "9.1e-12"},
      Key{.section = "contact",
          .name = "G",
          .range = {0.0, infinity, false, true},
          .meaning = "Hamrock-Dowson material number G = alpha E'; 0 for an isoviscous lubricant.",
          .example = "4500"},
      Key{.section = "contact",
          .name = "a_over_R",
          .range = {0.0, 1.0, true, false},
          .remedy = "a/R = pi p_h/E'",
          .meaning =
              "Hertz radius over R, which M and L leave open and shear stresses depend on. Only with M and L, and "
              "[shear] or [friction].",
          .example = "0.01"},
  };
}

std::vector<Key> si_keys() {
  return {
      Key{.section = "contact",
          .name = "load",
          .unit = "N",
          .range = positive,
          .remedy = "the load presses the bodies together",
          .meaning =
              "Normal load F. Third language: load, radius_x and the elastic data in SI, with [motion] and eta0.",
          .example = "15"},
      Key{.section = "contact",
          .name = "radius_x",
          .unit = "m",
          .range = positive,
          .meaning = "Reduced radius along the entrainment: 1/R_x = 1/R_x1 + 1/R_x2 (ball on flat: the ball's).",
          .example = "0.0125"},
      Key{.section = "contact",
          .name = "radius_y",
          .default_note = "radius_x (circular contact)",
          .unit = "m",
          .range = positive,
          .meaning = "Principal reduced radius across radius_x: 1/R_y = 1/R_y1 + 1/R_y2; or radius_ratio.",
          .example = "0.0125"},
      Key{.section = "contact",
          .name = "E1",
          .unit = "Pa",
          .range = positive,
          .meaning = "Young's modulus of body 1 (with nu1, E2 and nu2; or E_prime instead of the four).",
          .example = "206e9"},
      Key{.section = "contact",
          .name = "nu1",
          .range = {-1.0, 0.5, true, false},
          .meaning = "Poisson's ratio of body 1.",
          .example = "0.3"},
      Key{.section = "contact",
          .name = "E2",
          .unit = "Pa",
          .range = positive,
          .meaning = "Young's modulus of body 2.",
          .example = "81e9"},
      Key{.section = "contact",
          .name = "nu2",
          .range = {-1.0, 0.5, true, false},
          .meaning = "Poisson's ratio of body 2.",
          .example = "0.208"},
      Key{.section = "contact",
          .name = "E_prime",
          .unit = "Pa",
          .range = positive,
          .meaning = "Reduced modulus E' = 2/[(1 - nu1^2)/E1 + (1 - nu2^2)/E2], instead of E1, nu1, E2, nu2.",
          .example = "110e9"},
  };
}

std::vector<Key> shape_keys() {
  return {
      Key{.section = "contact",
          .name = "radius_ratio",
          .default_note = "1 (circular contact), or from radius_y",
          .range = {0.05, 20.0},
          .remedy = "beyond it the contact is nearly a line",
          .meaning =
              "R_x/R_y, the radius along the entrainment over the one across it: below 1 an ellipse that lies across "
              "it. With any language; groups, Hertz radii and scales are made with R_x.",
          .source = "Nijenbanning, Venner and Moes 1994 computed 0.05 to 1",
          .example = "0.2"},
  };
}

std::vector<Key> motion_keys() {
  constexpr deck::Range speed{-1e6, 1e6};
  return {
      Key{.section = "motion",
          .name = "angle",
          .default_note = "0, along radius_x",
          .unit = "degrees",
          .range = {-90.0, 90.0},
          .meaning =
              "From the direction of radius_x to that of the entrainment, of an elliptic contact; 90: along radius_y. "
              "Not 0 or 90: the whole domain is computed. x stays the direction of entrainment.",
          .example = "45"},
      Key{.section = "motion",
          .name = "u1",
          .unit = "m/s",
          .range = speed,
          .meaning = "Surface speed of body 1 (u1 and u2, or u_m and srr). The oil enters at the side of negative x.",
          .example = "0.09"},
      Key{.section = "motion",
          .name = "u2",
          .unit = "m/s",
          .range = speed,
          .meaning = "Surface speed of body 2.",
          .example = "0.09"},
      Key{.section = "motion",
          .name = "u_m",
          .unit = "m/s",
          .range = {0.0, 1e6, true, false},
          .remedy = "without entrainment there is no film",
          .meaning = "Entrainment speed (u1 + u2)/2, instead of u1 and u2.",
          .example = "0.09"},
      Key{.section = "motion",
          .name = "srr",
          .default_note = "0",
          .range = {-1e6, 1e6},
          .meaning =
              "Slide-roll ratio (u1 - u2)/u_m. A steady, smooth, isothermal Newtonian film does not depend on it; "
              "[shear] and [friction] do, with contacts in M and L or W, U and G too.",
          .example = "0.1"},
  };
}

}  // namespace

std::vector<Key> keys() {
  std::vector<Key> all = dimensionless_keys();
  for (const std::vector<Key>& more : {si_keys(), shape_keys(), motion_keys()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace ehl::contact
