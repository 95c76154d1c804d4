#include "case/catalogue.hpp"

#include "case/effects.hpp"
#include "case/unavailable.hpp"
#include "contact/keys.hpp"
#include "dry/keys.hpp"
#include "fmg/keys.hpp"
#include "machines/keys.hpp"
#include "mlmi/keys.hpp"
#include "reynolds/keys.hpp"
#include "rheology/keys.hpp"
#include "steady/keys.hpp"

namespace ehl::program {

namespace {

deck::Catalogue collected() {
  deck::Catalogue all;
  all.sections = {
      {"case", "What this case is called, and of what kind it is."},
      {"bearing", "A ball or a roller on its race. Only with [case] kind = ball_race or roller_race."},
      {"gear", "Two spur gears. Only with [case] kind = gear_mesh."},
      {"contact",
       "The contact, in ONE of three languages: M and L (Moes); W, U and G (Hamrock and Dowson); or SI: load, "
       "radius_x and the elastic data."},
      {"motion",
       "The speeds of the surfaces: u1 and u2, or u_m and srr. With a contact in M and L or W, U and G srr alone, and "
       "only with [shear] or [friction]. And the angle of an ellipse."},
      {"lubricant", "The oil."},
      {"domain", "The computed rectangle, in radii of the Hertz contact."},
      {"grid", "The finest and the coarsest grid."},
      {"discretization", "How derivatives become differences."},
      {"deformation", "How the elastic deformation is evaluated."},
      {"multigrid", "How the full multigrid works; the defaults need no tuning."},
      {"continuation", "How a high load is reached from lower ones, where that is needed."},
      {"dry", "How a contact without lubricant is solved. Only with [case] kind = dry."},
      {"output", "What is kept."},
  };
  all.keys = deck::together({case_keys(), steady::grid_keys(), steady::path_keys(), contact::keys(), rheology::keys(),
                             reynolds::keys(), mlmi::keys(), fmg::keys(), dry::keys(), machines::keys()});
  for (const Effect& effect : effects()) {
    all.sections.insert(all.sections.end() - 1, effect.sections.begin(), effect.sections.end());  // before [output]
    if (!effect.keys) continue;
    all.keys = deck::together({all.keys, effect.keys()});
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
