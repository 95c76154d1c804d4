#include "case/catalogue.hpp"

#include <algorithm>
#include <iterator>

#include "case/effects.hpp"
#include "case/tuning_input.hpp"
#include "case/unavailable.hpp"
#include "contact/keys.hpp"
#include "dry/keys.hpp"
#include "machines/keys.hpp"
#include "mlmi/keys.hpp"
#include "multigrid/keys.hpp"
#include "reynolds/keys.hpp"
#include "rheology/keys.hpp"
#include "steady/keys.hpp"

namespace ehl::program {

namespace {

deck::Catalogue collected() {
  deck::Catalogue all;
  all.sections = {
      {"case", "Title and kind of the case."},
      {"bearing", "A ball or a roller on its race. Used only with [case] kind = ball_race or roller_race."},
      {"gear", "Two spur gears. Used only with [case] kind = gear_mesh."},
      {"cam", "A cam and a flat tappet. Used only with [case] kind = cam."},
      {"stroke", "A body that moves to and fro. Used only with [case] kind = reciprocating."},
      {"impact", "A body that falls on a film. Used only with [case] kind = impact."},
      {"contact",
       "The contact, given in one of three ways: M and L (Moes); W, U and G (Hamrock and Dowson); or SI: load, "
       "radius_x and the elastic data."},
      {"motion",
       "Speeds of the surfaces: u1 and u2, or u_m and srr. For a contact in M and L or in W, U and G only srr is "
       "given, and only with [shear] or [friction]. Also the rolling direction of an ellipse."},
      {"lubricant", "The lubricant: viscosity and density against pressure."},
      {"domain", "Domain of the computation: a rectangle, in Hertz radii."},
      {"grid", "Finest and coarsest grid, and the required accuracy."},
      {"discretization", "Discretization of the Reynolds equation."},
      {"deformation", "Evaluation of the elastic deformation."},
      {"multigrid", "Parameters of the full multigrid solution. The defaults need no tuning."},
      {"continuation", "Load continuation: a high load is reached from lower ones if needed."},
      {"dry", "Solution of a contact without lubricant. Used only with [case] kind = dry."},
      tuning_section(),
      {"output", "The result file and what it contains."},
  };
  all.keys =
      deck::together({case_keys(), steady::grid_keys(), steady::path_keys(), contact::keys(), rheology::keys(),
                      reynolds::keys(), mlmi::keys(), multigrid::keys(), dry::keys(), machines::keys(), tuning_keys()});
  for (const Effect& effect : effects()) {
    all.sections.insert(all.sections.end() - 1, effect.sections.begin(), effect.sections.end());  // before [output]
    if (!effect.keys) continue;
    std::ranges::move(effect.keys(), std::back_inserter(all.keys));
  }
  all.unavailable = unavailable();
  return all;
}

}  // namespace

const deck::Catalogue& catalogue() {
  static const deck::Catalogue all = collected();
  return all;
}

}  // namespace ehl::program
