#include "effects/roller/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "contact/ellipse.hpp"
#include "effects/roller/slices.hpp"

namespace ehl::roller {
namespace {

using Shape = Profile::Shape;

// Least share of the length that carries load: with less, the mean load per length is no useful scale.
constexpr double least_share = 0.1;
// Cells along an end within which the profile falls by the approach. [bench: roller_fewest_cells]
constexpr double fewest_cells = 8.0;

// Key as given in the deck: dimensionless or in SI.
std::string given_key(const deck::Part& roller, const std::string& name, const std::string& suffix) {
  return roller.given(name) || !roller.given(name + suffix) ? name : name + suffix;
}

// Key that determines the profile.
std::string profile_key(const deck::Part& roller, const Profile& profile) {
  switch (profile.shape) {
    case Shape::straight: return given_key(roller, "end_radius", "_m");
    case Shape::crowned: return given_key(roller, "crown_radius", "_m");
    case Shape::table: return "file";
    case Shape::logarithmic: break;
  }
  return "profile";
}

// Compares numbers in the same unit; a/R converts the lengths. If a/R is NaN, nothing is reported.
void check_circles(const deck::Part& roller, const Scales& scales, const Profile& profile) {
  const double half = 0.5 * profile.length * scales.a_over_R, end = profile.end_length * scales.a_over_R;
  const char* units = "radii are relative to R_x, or in metres with _m";
  if (profile.shape == Shape::crowned && profile.crown_radius < half)
    roller.complain(profile_key(roller, profile),
                    fmt::format("is {:.4g} R_x, and half of the roller's length is {:.4g}: a circle of this radius "
                                "does not reach the ends; {}",
                                profile.crown_radius, half, units));
  if (profile.shape == Shape::straight && profile.end_radius < end)
    roller.complain(
        profile_key(roller, profile),
        fmt::format("is {:.4g} R_x, and the ends are {:.4g} long: a circle of this radius does not reach the end; {}",
                    profile.end_radius, end, units));
}

void check_drop(const deck::Part& roller, const Scales& scales, const Profile& profile) {
  const double half = 0.5 * profile.length;
  const double most = std::max(std::abs(drop(profile, half)), std::abs(drop(profile, -half)));
  if (const double over_R = most * scales.a_over_R * scales.a_over_R; over_R > 1.0)
    roller.complain(profile_key(roller, profile),
                    fmt::format("an end lies {:.4g} R_x from the level of the middle, and a body of "
                                "that radius can lose at most 1: check the units, {}",
                                over_R, scales.in_SI ? "metres" : "a and a^2/R"));
}

// True if the roller without its tilt passes the check `is_right`.
template <class Right>
bool tilt_is_at_fault(const Profile& profile, Right is_right) {
  Profile upright = profile;
  upright.tilt = 0.0;
  return profile.tilt != 0.0 && is_right(bearing(upright));
}

std::string key_at_fault(const deck::Part& roller, const Profile& profile, bool tilt) {
  return tilt ? given_key(roller, "tilt", "_mrad") : profile_key(roller, profile);
}

void check_length_that_bears(const deck::Part& roller, const Profile& profile) {
  const auto bears_enough = [&](const Bearing& found) { return found.length >= least_share * profile.length; };
  const Bearing found = bearing(profile);
  if (bears_enough(found)) return;
  const bool tilt = tilt_is_at_fault(profile, bears_enough);
  roller.complain(key_at_fault(roller, profile, tilt),
                  fmt::format("by a slice model {:.3g} of the roller's {:.4g} half widths carry load, and at least a "
                              "tenth of the length must: {}",
                              found.length, profile.length,
                              tilt ? "use less tilt, or a crown that carries it"
                                   : "check the units, or give [contact] kind = point and radius_y"));
}

void check_width(const deck::Part& roller, const core::Grid& grid, const Profile& profile) {
  const double reach = std::min(-grid.X_a, grid.X_b);
  const auto fits = [&](const Bearing& found) { return !(found.widest >= reach); };
  const Bearing found = bearing(profile);
  if (fits(found)) return;
  const bool tilt = tilt_is_at_fault(profile, fits);
  roller.complain(
      key_at_fault(roller, profile, tilt),
      fmt::format(
          "by a slice model one slice carries {:.3g} times the mean load per length and is about {:.3g} half widths "
          "wide to either side, beyond the domain's {:.3g}: move [domain] x_inlet and x_outlet, or use {}",
          found.heaviest, found.widest, reach, tilt ? "less tilt" : "a profile that spreads the load"));
}

// Where the rounded end has fallen by the approach of the bodies, the contact ends.
void check_ends(const deck::Part& roller, const core::Grid& grid, const Profile& profile) {
  if (profile.shape != Shape::straight || !roller.deck.errors.empty()) return;
  const double fall = std::sqrt(2.0 * profile.end_radius * contact::roller_contact(profile.length).approach);
  if (fall < profile.end_length && fall < fewest_cells * grid.hy())
    roller.complain(
        profile_key(roller, profile),
        fmt::format(
            "makes the ends leave the contact within {:.3g} half widths, fewer than {:g} cells of {:.3g}: such an edge "
            "is not resolved by the grid, and half-spaces have no edges; use a larger radius, or more cells",
            fall, fewest_cells, grid.hy()));
}

}  // namespace

void check_profile(deck::Deck& deck, const Scales& scales, const Profile& profile) {
  const deck::Part roller{deck, "roller"};
  check_circles(roller, scales, profile);
  if (!deck.errors.empty()) return;
  check_drop(roller, scales, profile);
  if (deck.errors.empty()) check_length_that_bears(roller, profile);
}

void check_on_grid(deck::Deck& deck, const core::Grid& grid, const Profile& profile) {
  const deck::Part roller{deck, "roller"};
  check_width(roller, grid, profile);
  if (!deck::given(deck, "grid", "accuracy")) check_ends(roller, grid, profile);
}

}  // namespace ehl::roller
