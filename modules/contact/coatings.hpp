#pragma once
// Elastic coatings bonded to the bodies: their keys, and the modulus of the scales.
#include <vector>

#include "contact/keys.hpp"

namespace ehl::contact {

/// Keys coating1_E, coating1_nu, coating1_thickness of [contact], and those of body 2.
std::vector<deck::Key> coating_keys();

/// The coatings of the deck, with thickness in m; a coating of the material of its body is none. Keys of a coating that
/// are missing or have no influence are errors.
std::vector<kernel::Coating> read_coatings(const deck::Part& contact);

/// E' on which the scales of a coated contact are based: that of uncoated bodies which yield as much to a wave of
/// pressure cos(k x), k = 2/a, a the shorter Hertz semi-axis for this E'. With it a and p_h are about those of the
/// coated contact, whatever the coating. Without coatings: that of the bodies. limits: if several values fit, one of
/// them.
double equivalent_modulus(const Bodies& bodies, const Ellipse& shape);

}  // namespace ehl::contact
