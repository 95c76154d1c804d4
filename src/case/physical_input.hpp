#pragma once
// From the deck's words about contact, motion and lubricant to groups, laws and scales.
#include <limits>
#include <optional>

#include "base/si_units.hpp"
#include "contact/groups.hpp"
#include "contact/hertz.hpp"
#include "contact/keys.hpp"
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
  double Sq1 = std::numeric_limits<double>::quiet_NaN();  ///< roughness that the deck states [m]; NaN: none
  double Sq2 = std::numeric_limits<double>::quiet_NaN();
};

/// The load of all of a contact [N]; of a line contact per length [N/m].
inline double whole_load(const SiInput& si) {
  const contact::Ellipse& shape = si.contact.shape;
  return si.contact.load * (contact::roller(shape) ? shape.length * si.hertz.a : 1.0);
}

struct Physics {
  Language language = Language::none;
  contact::Groups groups{};
  std::optional<SiInput> si{};
  double p_h = std::numeric_limits<double>::quiet_NaN();  ///< Hertz pressure [Pa]; NaN where only M and L are known
  double srr = 0.0;                                       ///< (u1 - u2)/u_m
  double a_over_R = std::numeric_limits<double>::quiet_NaN();  ///< NaN where only M and L are known
  rheology::ViscosityLaw viscosity{};
  rheology::DensityLaw density{};
  std::optional<rheology::AmbientOil> ambient{};  ///< an oil by its viscosities at two temperatures
};

/// What to read the dimensionless numbers of the case with; nothing where the contact is not in SI.
std::optional<SiScales> si_scales(const Physics& physics);

/// Rules between the keys of [contact], [motion] and [lubricant]; what breaks them is added to deck.errors, and then
/// nothing else in the result but the language has a meaning. Choices (Roelands' z, radius_y) are recorded in the deck.
Physics physical_input(deck::Deck& deck);

/// The elastic contact alone, for bodies without lubricant.
struct ElasticContact {
  double load = 0.0;     ///< [N]
  double radius = 0.0;   ///< [m]
  double E_prime = 0.0;  ///< [Pa]
  contact::Hertz hertz{};
};

/// load, radius_x and the elastic data of [contact]; nothing where the deck gives none of them. Complains as above.
std::optional<ElasticContact> elastic_contact(deck::Deck& deck);

}  // namespace ehl::program
