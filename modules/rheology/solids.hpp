#pragma once
// Materials of the bodies by name: elasticity and heat.
#include <array>
#include <string_view>

namespace ehl::rheology {

/// Material of a body, at room temperature.
struct Solid {
  std::string_view name;
  double E;    ///< Young's modulus [Pa]
  double nu;   ///< Poisson's ratio
  double k;    ///< conductivity [W/(m K)]
  double c;    ///< heat capacity [J/(kg K)]
  double rho;  ///< density [kg/m^3]
  std::string_view source;
};

/// Materials that are part of the program, at room temperature. A thin coating is not a half-space of its own material:
/// a body with DLC is its substrate, with another friction.
inline constexpr std::array<Solid, 8> solids{{
    {"steel", 206e9, 0.30, 46.0, 470.0, 7850.0,
     "bearing steel 100Cr6: the values of most published thermal contacts, 46 W/(m K), 470 J/(kg K), 7850 kg/m^3"},
    {"bk7", 82e9, 0.206, 1.114, 858.0, 2510.0, "SCHOTT N-BK7, data sheet"},
    {"glass", 81e9, 0.208, 1.114, 858.0, 2510.0,
     "crown glass discs of optical rigs: elasticity as usually published, heat of SCHOTT N-BK7"},
    {"sapphire", 345e9, 0.25, 35.0, 763.0, 3980.0,
     "crystal suppliers' tables (rostox-n.ru, quick-ohm.de); k = 33 to 46 by direction, half of it at 100 C"},
    {"si3n4", 310e9, 0.27, 30.0, 700.0, 3290.0,
     "hot pressed, as for bearings: lily-bearing.com, ceramic materials; c typical, no single source, +-10 %"},
    {"al2o3", 375e9, 0.22, 35.0, 880.0, 3890.0, "99.5 %: lily-bearing.com, ceramic materials"},
    {"zro2", 200e9, 0.30, 2.0, 450.0, 6040.0,
     "with Y2O3: lily-bearing.com, ceramic materials; nu, c typical, no single source, +-10 %"},
    {"wc", 630e9, 0.22, 80.0, 200.0, 14900.0,
     "cemented with 6 % cobalt: typical, no single source; k = 70 to 100 by grade"},
}};

/// Solid of that name, or nullptr.
constexpr const Solid* find_solid(std::string_view name) {
  for (const Solid& solid : solids)
    if (solid.name == name) return &solid;
  return nullptr;
}

/// Solid of that name. errors: InputError with the list of names.
const Solid& solid_by_name(std::string_view name);

}  // namespace ehl::rheology
