// The keys of [lubricant] that belong to single laws, and the fluids by name.
#include "rheology/fluids.hpp"
#include "rheology/keys.hpp"

namespace ehl::rheology {
namespace {

using deck::Key;
using deck::Type;

Key constant(const char* name, const char* unit, deck::Range range, const char* meaning, const char* example) {
  return {.section = "lubricant", .name = name, .unit = unit, .range = range, .meaning = meaning, .example = example};
}

Key of_law(Key key, const char* law) {
  key.needs = {.name = "viscosity", .words = {law}};
  return key;
}

Key fluid_key() {
  Key key{.section = "lubricant",
          .name = "fluid",
          .type = Type::word,
          .default_note = "none: the keys of [lubricant] say what the oil is",
          .meaning =
              "An oil by name: laws of viscosity and density with their constants. A key that it sets may be "
              "repeated with the same value; another value, or a constant of another law, is refused."};
  for (const Fluid& fluid : fluids) {
    key.words.emplace_back(fluid.name);
    if (!key.source.empty()) key.source += "; ";
    key.source.append(fluid.name).append(": ").append(fluid.about).append(" (").append(fluid.source).append(")");
  }
  key.example = "squalane";
  return key;
}

}  // namespace

std::vector<Key> liquid_keys() {
  const deck::Range positive{0.0, 1e12, true, false};
  std::vector<Key> all{
      fluid_key(),
      constant("K0", "Pa", {1e7, 1e12},
               "Bulk modulus at ambient pressure, at the temperature of the contact. Required by density = tait and "
               "murnaghan and by viscosity = doolittle.",
               "1.192e9"),
      constant("K0_prime", "", {1.0, 50.0}, "Its derivative with pressure. Required with K0.", "11.74"),
      of_law(constant("doolittle_B", "", {0.0, 1e3, true, false}, "Doolittle's factor.", "4.71"), "doolittle"),
      of_law(
          constant("doolittle_R0", "", {0.0, 1.0, true, true},
                   "Occupied volume over the volume at ambient pressure, at the temperature of the contact.", "0.6568"),
          "doolittle"),
      of_law(constant("temperature", "C", {-273.15, 1000.0, true, false},
                      "Temperature of the contact, above the glass transition Tg0. The other laws have none.", "40"),
             "yasutomi"),
      of_law(constant("Tg0", "C", {-273.15, 1000.0, true, false}, "Glass transition at ambient pressure.", "-83.2"),
             "yasutomi"),
      of_law(constant("A1", "K", positive, "Tg = Tg0 + A1 ln(1 + A2 p).", "188.95"), "yasutomi"),
      of_law(constant("A2", "1/Pa", {0.0, 1e-6, true, false}, "Tg = Tg0 + A1 ln(1 + A2 p).", "0.719e-9"), "yasutomi"),
      of_law(constant("b1", "1/Pa", {0.0, 1e-6}, "F = (1 + b1 p)^b2.", "8.2e-9"), "yasutomi"),
      of_law(constant("b2", "", {-10.0, 0.0}, "F = (1 + b1 p)^b2.", "-0.53"), "yasutomi"),
      of_law(constant("C1", "", {0.0, 100.0, true, false}, "First constant of Williams, Landel and Ferry.", "16.09"),
             "yasutomi"),
      of_law(constant("C2", "K", {0.0, 1e3, true, false}, "Second constant of Williams, Landel and Ferry.", "17.38"),
             "yasutomi"),
      of_law(constant("eta_g", "Pa s", {1e3, 1e15}, "Viscosity at the glass transition.", "1e12"), "yasutomi"),
      {.section = "lubricant",
       .name = "table",
       .type = Type::text,
       .meaning = "A CSV file with columns p [Pa], rising from 0, eta [Pa s], rho [kg/m^3]; for viscosity = table, "
                  "density = table or both. At least 4 rows, eta and rho > 0 and rising, up to more than p_h. Beside "
                  "the deck, or where the program runs.",
       .example = "oil.csv"},
  };
  return all;
}

}  // namespace ehl::rheology
