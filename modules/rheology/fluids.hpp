#pragma once
// Oils by name, for [lubricant] fluid = NAME.
#include <array>
#include <string_view>

namespace ehl::rheology {

/// A key of [lubricant] and its value; both empty in unused entries.
struct FluidKey {
  std::string_view name{};
  std::string_view value{};
};

/// An oil by name: the keys of [lubricant] that it sets, and the source of their values.
struct Fluid {
  std::string_view name{};
  std::string_view about{};   ///< what it is, and at which temperature; empty: covered by the previous entry
  std::string_view source{};  ///< source of its constants; empty: covered by the previous entry
  std::array<FluidKey, 8> keys{};
};

/// A Roelands oil known at one temperature, with Dowson and Higginson's density; its exponent follows from its
/// viscosity.
constexpr std::array<FluidKey, 8> roelands_oil(std::string_view eta0, std::string_view alpha) {
  return {
      {{"viscosity", "roelands"}, {"eta0", eta0}, {"alpha", alpha}, {"p0", "1.96e8"}, {"density", "dowson-higginson"}}};
}

/// A Roelands oil at any temperature, from kinematic viscosities at 40 and 100 C [mm^2/s], density at 15 C [kg/m^3] and
/// alpha* at 40 C [1/Pa].
constexpr std::array<FluidKey, 8> data_sheet_oil(std::string_view kv40, std::string_view kv100,
                                                 std::string_view density15, std::string_view alpha_star) {
  return {{{"viscosity", "roelands"},
           {"kv40", kv40},
           {"kv100", kv100},
           {"density15", density15},
           {"alpha_star", alpha_star},
           {"alpha_temperature", "40"},
           {"p0", "1.96e8"},
           {"density", "dowson-higginson"}}};
}

/// Temperature used if the deck gives none for an oil defined at several.
inline constexpr std::string_view temperature_of_grades = "40";

// Gold's coefficients are secants of ln eta up to 0.2 GPa at 40 C [1/Pa]: 9.904e-9 kv40^0.139 for paraffinic mineral
// oils, 7.382e-9 kv40^0.1335 for polyalphaolefins. alpha* is that of Roelands' law through these secants, with z = 0.60
// and 0.46 to 0.48.
constexpr Fluid grade(std::string_view name, std::string_view kv40, std::string_view kv100, std::string_view density15,
                      std::string_view alpha_star, std::string_view about = {}, std::string_view source = {}) {
  return {name, about, source, data_sheet_oil(kv40, kv100, density15, alpha_star)};
}

/// Fluids that are part of the program.
inline constexpr std::array<Fluid, 15> fluids{{
    {"mourier", "oil of Mourier's experiment, at its temperature only",
     "Mourier, Mazuyer, Lubrecht and Donnet, Tribology International 39, 2006", roelands_oil("0.25", "22e-9")},
    grade("mineral-vg32", "32", "5.290", "870", "16.93e-9",
          "and the grades up to mineral-vg460, paraffinic mineral oils in the middle of the ISO VG, at any temperature",
          "kv40: ISO 3448; kv100: viscosity index 95 by ASTM D2270; density15: typical data sheet values, no single "
          "source, +-2 %; alpha*: from Gold et al., Journal of Synthetic Lubrication 18, 2001, at 40 C and 0.2 GPa, "
          "9.904e-9 kv40^0.139; an estimate: oils differ by 20 %, and the film by 10 %"),
    grade("mineral-vg46", "46", "6.644", "876", "17.89e-9"),
    grade("mineral-vg68", "68", "8.530", "881", "18.99e-9"),
    grade("mineral-vg100", "100", "11.07", "885", "20.13e-9"),
    grade("mineral-vg150", "150", "14.54", "889", "21.38e-9"),
    grade("mineral-vg220", "220", "18.75", "893", "22.64e-9"),
    grade("mineral-vg320", "320", "23.95", "897", "23.92e-9"),
    grade("mineral-vg460", "460", "30.34", "902", "25.22e-9"),
    grade("pao4", "18.4", "4.1", "820", "11.05e-9", "and the grades up to pao40, polyalphaolefins, at any temperature",
          "kv40, kv100, density15: typical data sheet values of the grade, no single source, +-5 %; alpha*: from "
          "Gold et al., as above, 7.382e-9 kv40^0.1335; an estimate: 20 %, and the film 10 %"),
    grade("pao6", "31", "5.8", "827", "11.98e-9"),
    grade("pao8", "48", "8.0", "833", "12.83e-9"),
    grade("pao10", "66", "10.0", "835", "13.48e-9"),
    grade("pao40", "396", "39.0", "850", "17.69e-9"),
    {"squalane",
     "squalane, at 40 C only",
     "constants of Bair, Tribology Letters 22, 2006, quoted from memory, K0 = 8.658 GPa exp(-6.332e-3 T/K); they give "
     "alpha* = 17.8 1/GPa, known is 18",
     {{{"temperature", "40"},
       {"viscosity", "doolittle"},
       {"eta0", "0.0156"},
       {"doolittle_B", "4.71"},
       {"doolittle_R0", "0.6568"},
       {"density", "tait"},
       {"K0", "1.192e9"},
       {"K0_prime", "11.74"}}}},
}};

/// The fluid of that name, or nullptr.
constexpr const Fluid* find_fluid(std::string_view name) {
  for (const Fluid& fluid : fluids)
    if (fluid.name == name) return &fluid;
  return nullptr;
}

/// Value that a fluid gives to a key; empty if it gives none.
constexpr std::string_view value_of(const Fluid& fluid, std::string_view key) {
  for (const FluidKey& own : fluid.keys)
    if (own.name == key) return own.value;
  return {};
}

}  // namespace ehl::rheology
