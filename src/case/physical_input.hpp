#pragma once
// Converts the contact, motion and lubricant of the deck to dimensionless groups, fluid laws and scales.
#include <optional>

#include "base/si_units.hpp"
#include "contact/groups.hpp"
#include "contact/hertz.hpp"
#include "contact/keys.hpp"
#include "core/constants.hpp"
#include "deck/deck.hpp"
#include "rheology/keys.hpp"
#include "rheology/laws.hpp"

namespace ehl::program {

using contact::Language;

/// A contact given in SI units.
struct SiInput {
  contact::SiContact contact{};
  contact::Hertz hertz{};
  double u1 = 0.0;  ///< [m/s]
  double u2 = 0.0;
  double Sq1 = core::unknown;  ///< roughness that the deck states [m]; NaN: none
  double Sq2 = core::unknown;
  double E_prime_uncoated = 0.0;            ///< of the bodies without their coatings [Pa]
  std::vector<kernel::Coating> coatings{};  ///< thickness in m
};

/// The total load of a contact [N]; for a line contact the load per length [N/m].
inline double whole_load(const SiInput& si) {
  const contact::Ellipse& shape = si.contact.shape;
  return si.contact.load * (contact::roller(shape) ? shape.length * si.hertz.a : 1.0);
}

struct Physics {
  Language language = Language::none;
  contact::Groups groups{};
  std::optional<SiInput> si{};
  double p_h = core::unknown;       ///< Hertz pressure [Pa]; NaN if only M and L are known
  double srr = 0.0;                 ///< (u1 - u2)/u_m
  double a_over_R = core::unknown;  ///< NaN if only M and L are known
  rheology::ViscosityLaw viscosity{};
  rheology::DensityLaw density{};
  std::optional<rheology::AmbientOil> ambient{};  ///< set for an oil given by its viscosities at two temperatures
};

/// The scales that convert the dimensionless numbers of the case to SI; nothing if the contact is not in SI.
std::optional<SiScales> si_scales(const Physics& physics);

/// Checks the rules between the keys of [contact], [motion] and [lubricant]. Errors are added to deck.errors; then only
/// `language` of the result is valid. Chosen values (Roelands' z, radius_y) are recorded in the deck.
Physics physical_input(deck::Deck& deck);

/// The elastic contact alone, for bodies without lubricant.
struct ElasticContact {
  contact::Bodies bodies{};
  contact::Hertz hertz{};
};

/// Reads load, radius_x and the elastic data of [contact]; nothing if the deck gives none of them.
/// Errors are added to the deck.
std::optional<ElasticContact> elastic_contact(deck::Deck& deck);

}  // namespace ehl::program
