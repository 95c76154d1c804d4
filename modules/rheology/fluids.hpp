#pragma once
// Oils by name: what [lubricant] fluid = NAME stands for.
#include <array>
#include <string>
#include <string_view>

namespace ehl::rheology {

/// A key of [lubricant] and its value; both empty where a fluid has fewer of them.
struct FluidKey {
  std::string_view name{};
  std::string_view value{};
};

struct Fluid {
  std::string_view name{};
  std::string_view about{};   ///< what it is, and at which temperature
  std::string_view source{};  ///< where its numbers are from
  std::array<FluidKey, 8> keys{};
};

/// A Roelands oil whose exponent follows from its viscosity, with Dowson and Higginson's density.
constexpr std::array<FluidKey, 8> roelands_oil(std::string_view eta0, std::string_view alpha) {
  return {
      {{"viscosity", "roelands"}, {"eta0", eta0}, {"alpha", alpha}, {"p0", "1.96e8"}, {"density", "dowson-higginson"}}};
}

/// The fluids that come with the program.
inline constexpr std::array<Fluid, 6> fluids{{
    {"mourier", "oil of Mourier's experiment",
     "Mourier, Mazuyer, Lubrecht and Donnet, Tribology International 39, 2006", roelands_oil("0.25", "22e-9")},
    {"mineral-vg32", "mineral oil like ISO VG 32 (about 31 mm^2/s at 40 C), at 30 C",
     "Stachowiak and Batchelor, Engineering Tribology, Table 2.3, light machine oil of medium viscosity index",
     roelands_oil("0.045", "28e-9")},
    {"mineral-vg68", "mineral oil like ISO VG 68 (about 69 mm^2/s at 40 C), at 30 C",
     "Stachowiak and Batchelor, Engineering Tribology, Table 2.3, medicinal white oil",
     roelands_oil("0.107", "29.6e-9")},
    {"pao4", "polyalphaolefin PAO 4, at 40 C",
     "data of the open program Thermoelastohydrodynamics_time_transient (DausdasKreuz, GitHub), which names no "
     "temperature: the viscosity is that of the grade at 40 C",
     roelands_oil("0.01362", "14.8e-9")},
    {"pao10", "polyalphaolefin PAO 10, at 40 C", "as pao4", roelands_oil("0.05252", "17.1e-9")},
    {"squalane",
     "squalane, at 40 C",
     "constants of Bair, Tribology Letters 22, 2006, quoted from memory, K0 = 8.658 GPa exp(-6.332e-3 T/K); they give "
     "alpha* = 17.8 1/GPa, known is 18",
     {{{"viscosity", "doolittle"},
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

}  // namespace ehl::rheology
