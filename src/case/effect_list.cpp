// The list of effects. A test program that links a list of its own has other effects.
#include "case/effects.hpp"

namespace ehl::program {

Effect elliptic_effect();
Effect coating_effect();
Effect transient_effect();
Effect body_effect();
Effect surfaces_effect();
Effect shear_effect();
Effect starvation_effect();
Effect subsurface_effect();
Effect friction_effect();
Effect thermal_effect();
Effect roller_effect();
Effect mixed_effect();

std::vector<Effect> listed_effects() {
  std::vector<Effect> all;
  all.push_back(elliptic_effect());
  all.push_back(coating_effect());
  all.push_back(transient_effect());
  all.push_back(body_effect());
  all.push_back(surfaces_effect());
  all.push_back(shear_effect());
  all.push_back(starvation_effect());
  all.push_back(subsurface_effect());
  all.push_back(friction_effect());
  all.push_back(thermal_effect());
  all.push_back(roller_effect());
  all.push_back(mixed_effect());
  return all;
}

}  // namespace ehl::program
