#pragma once
// Scenes and tolerances for the reference values.
#include "contact/groups.hpp"
#include "core/constants.hpp"
#include "reference/circular_contact.hpp"
#include "steady/scene.hpp"

namespace ehl::test {

inline steady::Scene scene_of(const reference::CircularContact& contact) {
  steady::Scene scene;
  const contact::Groups groups = contact::from_moes(contact.M, contact.L);
  scene.contact = steady::scales_of(contact.M, contact.L);
  scene.lambda = groups.lambda;
  const double alpha = contact.fluid == reference::Fluid::roelands_z060 ? 1.7e-8 : 2.2e-8;
  const double p_h = groups.alpha_bar / alpha;
  if (contact.fluid == reference::Fluid::barus) {
    scene.viscosity = rheology::make_barus(alpha, p_h);
    scene.density = rheology::Incompressible{};
  } else {
    const double z = contact.fluid == reference::Fluid::roelands_z060 ? 0.6 : 0.68;
    scene.viscosity = rheology::make_roelands(alpha, rheology::roelands_p0, z, p_h);
    scene.density = rheology::make_dowson_higginson(p_h);
  }
  scene.grid = contact.M < 200 ? core::Grid{contact.n, contact.n, -4.5, 1.5, -3.0, 3.0}
                               : core::Grid{contact.n, contact.n, -2.5, 1.5, -2.0, 2.0};
  scene.wedge = contact.wedge;
  return scene;
}

inline const reference::CircularLimit& limit_of(const reference::CircularContact& contact) {
  for (const reference::CircularLimit& limit : reference::circular_limits)
    if (limit.M == contact.M && limit.L == contact.L && limit.fluid == contact.fluid) return limit;
  throw std::logic_error("no limit for this contact");
}

inline std::string name_of(const reference::CircularContact& contact) {
  const char* fluid = contact.fluid == reference::Fluid::barus ? "Barus" : "Roelands";
  std::string name = "(";  // not "(" + ...: g++ 12 warns falsely of an overlap there
  name +=
      std::to_string(static_cast<int>(contact.M)) + "," + std::to_string(static_cast<int>(contact.L)) + ") " + fluid;
  name += contact.wedge == reference::Wedge::upstream1 ? " upstream1 " : " upstream2 ";
  return name + std::to_string(contact.n);
}

}  // namespace ehl::test
