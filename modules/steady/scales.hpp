#pragma once
// The films and sizes that are expected of a contact, from load, speed and shape alone.

#include "contact/ellipse.hpp"
#include "core/constants.hpp"

namespace ehl::steady {

/// Made once for a contact, by scales_of(). M and L are those of contact/groups.hpp, made with R_x; films are in
/// a^2/R_x, lengths in Hertz radii a.
struct ContactScales {
  double M = core::unknown;
  double L = core::unknown;
  contact::Ellipse shape;
  /// Central film by the formula of Nijenbanning, Venner and Moes, good to 15 %; of an oblique contact up to 25 % too
  /// thick.
  double film = core::unknown;
  double least_film = core::unknown;  ///< minimum film, within a factor of 1.5
  /// M of the circular contact with the same oil and speed and the same ratio of film thickness to mutual approach. It
  /// measures how heavily a contact of any shape is loaded. M itself for a circle.
  double circular_load = core::unknown;
  /// Half the length along X of the region of pressure: that of the dry contact, or sqrt(2 film) if the film is so
  /// thick that the bodies are nearly rigid.
  double size = core::unknown;
  double shorter_size = core::unknown;  ///< the same along the shorter axis
  /// size over shorter_size: the factor by which the contact needs more cells along X than a circle does; 1 for a
  /// circle.
  double slenderness = core::unknown;
  /// Steepness of the gap outside the edge of the dry contact, relative to a circle, where the edge is steepest: at the
  /// ends of the shorter axis. The gap grows as the power 3/2 of the distance.
  double edge_steepness = core::unknown;
  /// Width of the zones at inlet and outlet in which the film forms: (least_film/edge_steepness)^(2/3), because the gap
  /// grows as the power 3/2 of the distance from the edge.
  double film_zone = core::unknown;
};

/// out: NaN but for M, L and shape unless M > 0 and L >= 0.
ContactScales scales_of(double M, double L, const contact::Ellipse& shape = {});

}  // namespace ehl::steady
