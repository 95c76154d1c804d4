#pragma once
#include <optional>
#include <vector>

#include "contact/ellipse.hpp"
#include "core/constants.hpp"
#include "deck/deck.hpp"
#include "kernel/coating.hpp"

namespace ehl::contact {

/// Set of quantities by which a deck defines the contact.
enum class Language { none, moes, hamrock_dowson, si };

/// Elastic bodies pressed together.
struct Bodies {
  double load = core::unknown;              ///< [N]; for a line contact [N/m]
  double radius = core::unknown;            ///< R_x [m]
  double E_prime = core::unknown;           ///< of the scales [Pa]; of coated bodies by equivalent_modulus()
  double E_prime_uncoated = core::unknown;  ///< of the bodies without their coatings [Pa]
  std::vector<kernel::Coating> coatings{};  ///< thickness in m
};

/// [contact] and [motion]; NaN for quantities that the deck does not define.
struct Input {
  Language language = Language::none;  ///< none: an error has been reported
  double M = core::unknown, L = core::unknown;
  double W = core::unknown, U = core::unknown, G = core::unknown;
  double a_over_R = core::unknown;
  double Sq1 = core::unknown, Sq2 = core::unknown;  ///< roughness [m]
  Bodies bodies{};
  Ellipse shape{};
  double u1 = core::unknown, u2 = core::unknown;  ///< [m/s]
  double u_s = core::unknown;                     ///< u1 + u2
  double srr = 0.0;
};

/// Keys of [contact] and [motion].
std::vector<deck::Key> keys();
/// in: slides, true if the deck has a model that depends on sliding. Defaults (radius_y, angle) are recorded in the
/// deck.
Input read(deck::Deck& deck, bool slides);
/// True if [contact] kind = line.
bool is_line(deck::Deck& deck);
/// E', R_x and shape of a point contact in SI without coatings, which do not depend on its load. NaN for what is
/// missing or wrong, which read() reports.
struct ElasticShape {
  double radius = core::unknown;   ///< R_x [m]
  double E_prime = core::unknown;  ///< [Pa]
  Ellipse shape{};
};
ElasticShape elastic_shape(deck::Deck& deck);
/// Bodies of a contact without lubricant; nullopt if the deck defines no contact in SI.
std::optional<Bodies> read_bodies(deck::Deck& deck);

/// Keys of [motion]. out: speeds and srr of the input.
std::vector<deck::Key> motion_keys();
/// Reads [motion] into `input`. in: slides, as for read(). Errors are added to the deck.
void read_motion(const deck::Part& motion, bool slides, Input& input);

/// Keys of a roller's length. out: length in half widths, NaN after an error; the load in `input` becomes a load per
/// length.
std::vector<deck::Key> length_keys();
double read_length(const deck::Part& contact, Input& input);

}  // namespace ehl::contact
