#include "case/unavailable.hpp"

#include <string>

namespace ehl::program {

std::vector<deck::Unavailable> unavailable() {
  const std::string asperities =
      "there is no such section: [mixed] lets surfaces touch at a boundary film; Sq1 and Sq2 of [contact] give the "
      "lambda "
      "ratio, and [surface1] or [surface2] a wave, a dent or a measured map";
  const std::string roughness =
      "there is no such section: the roughness heights are Sq1 and Sq2 of [contact], and the shape of a roughness is "
      "given in [surface1] or [surface2]";
  const std::string coating =
      "there is no such section: give coating1_E, coating1_nu and coating1_thickness in [contact], and E1, nu1, E2, "
      "nu2 "
      "of the bodies";
  const std::string grease =
      "greases are not available: give the base oil in [lubricant], and [supply] if the inlet lacks oil";
  const std::string wear =
      "wear is not computed: [friction] gives the friction, and [subsurface] the stresses for a wear or fatigue "
      "calculation";
  const std::string plastic =
      "plastic deformation is not available, and the report warns if steel would yield: give an existing dent as a "
      "measured map in [surface1] or [surface2]";
  const std::string spur =
      "gear_mesh holds for spur gears: give the contact of other gears by [contact] kind = line with radius_x, "
      "load_per_length and the moduli, and [motion] u1, u2, or the equivalent spur gear of the normal section";
  const std::string radial =
      "only radial loads are available: for an axial load F_a give load on the ball, F_a/(elements sin(contact_angle))";
  const std::string spin = "spin is not available: [motion] has the speeds u1 and u2 along x and the angle";
  const std::string clearance =
      "the load distribution holds for a bearing without clearance or preload: give load on the ball or roller instead "
      "of radial_load";
  const std::string p_h =
      "the Hertz pressure is a result: give the load, for a circular contact 2 pi^3 R^2 p_h^3/(3 E'^2), or "
      "load_per_length of a line contact, 2 pi R p_h^2/E', with 2/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2";
  const std::string Ra = "is not used: give Sq1 and Sq2; for a Gaussian roughness Sq = 1.25 Ra";
  const std::string shear_law =
      "this law of shear-thinning is not available: use [shear] law = eyring or carreau, and [friction] limit for a "
      "stress that the oil does not exceed";
  return {{"surface", "", "is not a section: write [surface1] or [surface2]"},
          {"asperities", "", asperities},
          {"roughness", "", roughness},
          {"coating", "", coating},
          {"coating1", "", coating},
          {"coating2", "", coating},
          {"grease", "", grease},
          {"wear", "", wear},
          {"fatigue", "", wear},
          {"life", "", wear},
          {"plasticity", "", plastic},
          {"plastic", "", plastic},
          {"helix", "", spur},
          {"spin", "", spin},
          {"contact", "p_h", p_h},
          {"contact", "Ra1", Ra},
          {"contact", "Ra2", Ra},
          {"motion", "spin", spin},
          {"motion", "u_side", spin},
          {"gear", "helix_angle", spur},
          {"bearing", "axial_load", radial},
          {"bearing", "clearance", clearance},
          {"bearing", "preload", clearance},
          {"case", "kind", spur, {"bevel", "helical", "worm", "planetary", "hypoid", "internal_gear"}},
          {"lubricant", "fluid", grease, {"grease"}},
          {"lubricant", "viscosity", shear_law, {"herschel-bulkley", "bingham", "eyring", "carreau"}}};
}

}  // namespace ehl::program
