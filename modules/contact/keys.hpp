#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "contact/ellipse.hpp"
#include "deck/deck.hpp"

namespace ehl::contact {

/// What a deck gives the contact in.
enum class Language { none, moes, hamrock_dowson, si };

inline constexpr double silent = std::numeric_limits<double>::quiet_NaN();

/// Elastic bodies that are pressed together.
struct Bodies {
  double load = silent;     ///< [N]; of a line contact [N/m]
  double radius = silent;   ///< R_x [m]
  double E_prime = silent;  ///< [Pa]
};

/// [contact] and [motion]. What the language does not give is NaN.
struct Input {
  Language language = Language::none;  ///< none: complained about
  double M = silent, L = silent;
  double W = silent, U = silent, G = silent;
  double a_over_R = silent;
  double Sq1 = silent, Sq2 = silent;  ///< roughness [m]
  Bodies bodies{};
  Ellipse shape{};
  double u1 = silent, u2 = silent;  ///< [m/s]
  double u_s = silent;              ///< u1 + u2
  double srr = 0.0;
};

/// The deck's keys of [contact] and [motion].
std::vector<deck::Key> keys();
/// in: the deck has what depends on sliding. Choices (radius_y, angle) are recorded in the deck.
Input read(deck::Deck& deck, bool slides);
/// [contact] kind = line.
bool is_line(deck::Deck& deck);
/// Of bodies without lubricant; nothing where the deck gives no contact in SI.
std::optional<Bodies> read_bodies(deck::Deck& deck);

/// Those of [motion] among them. out: speeds and srr of the input.
std::vector<deck::Key> motion_keys();
void read_motion(const deck::Part& motion, bool slides, Input& input);

/// Those of a roller's length. out: the length in half widths, NaN where a complaint is on its way; the load of the
/// input's bodies becomes that per length.
std::vector<deck::Key> length_keys();
double read_length(const deck::Part& contact, Input& input);

}  // namespace ehl::contact
