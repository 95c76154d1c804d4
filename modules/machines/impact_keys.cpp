// Keys of [impact], and the numbers that follow from them.
#include <algorithm>
#include <cmath>

#include "contact/hertz.hpp"
#include "contact/keys.hpp"
#include "core/constants.hpp"
#include "deck/record.hpp"
#include "machines/impact.hpp"
#include "machines/keys.hpp"

namespace ehl::machines {

namespace {

struct Impact {
  double mass = 0.0;
  double velocity = 0.0;
  double gap = 0.0;
};

deck::Records<Impact> records() {
  using namespace deck::record;
  const char* const computed_from_it = "the contact is computed from it";
  return deck::only_with<Impact>(
      {.name = "kind", .words = {impact}, .section = "case"},
      {key("mass", &Impact::mass, required(computed_from_it), unit("kg"), positive, example("0.0329"),
           "Mass of the body that meets a body at rest; of two free bodies m1 m2/(m1 + m2)."),
       key("velocity", &Impact::velocity, required(computed_from_it), unit("m/s"), up_to(1e3), example("0.1"),
           "Velocity with which the bodies approach at time 0."),
       key("gap", &Impact::gap, required("the oil begins to resist there"), unit("m"), positive, example("20e-6"),
           "Distance of the bodies at time 0, filled with oil.")});
}

}  // namespace

std::vector<deck::Key> impact_keys() { return deck::keys_of("impact", records()); }

Contact read_impact(const deck::Part& part) {
  const Impact given = deck::read(part, records());
  Contact contact{.section = "impact", .what = "a body that meets a film", .only_moves = true};
  if (deck::word(part.deck, "contact", "kind") != "point")
    deck::complain(
        part.deck, "contact", "kind",
        "must be point with [case] kind = impact: the approach of a line contact depends on the whole bodies",
        deck::Cause::by_itself);
  for (const char* coating : {"coating1_E", "coating2_E"})
    if (deck::given(part.deck, "contact", coating))
      deck::complain(part.deck, "contact", coating,
                     "is not available with [case] kind = impact: the approach of coated bodies depends on the load in "
                     "another way");
  const contact::ElasticShape shape = contact::elastic_shape(part.deck);
  if (!part.deck.errors.empty() || std::isnan(shape.radius + shape.E_prime)) return contact;
  const contact::Hertz of_newton = contact::hertz(1.0, shape.radius, shape.E_prime, shape.shape);
  const DryImpact dry = dry_impact(given.mass, given.velocity, of_newton.approach);
  const contact::Hertz largest = contact::hertz(dry.load, shape.radius, shape.E_prime, shape.shape);
  const double widest = std::max(shape.radius, shape.radius / shape.shape.radius_ratio);
  contact.numbers = {
      {"energy", 0.5 * given.mass * given.velocity * given.velocity, "J", "mass velocity^2/2"},
      {"load", dry.load, "N", "largest load of the dry impact: mass velocity^2/2 = (2/5) load approach (Hertz)"},
      {"approach", dry.approach, "m", "largest approach of the dry impact"},
      {"dry_duration", dry.duration, "s", "time of contact of the dry impact, 2.943 approach/velocity (Hertz)"},
      {"reference_speed", largest.a * given.velocity / dry.approach, "m/s",
       "a velocity/approach: the scale of time is approach/velocity"},
      {"reach", std::max(4.0, 3.0 * std::sqrt(2.0 * widest * given.gap) / largest.a), "a",
       "half side of the domain: 3 sqrt(2 R gap), within which the oil carries 81 % of the first squeeze force between "
       "rigid bodies; at least 4"},
      {"end_time", given.gap / given.velocity + 1.5 * dry.duration, "s", "gap/velocity + 1.5 dry_duration"}};
  return contact;
}

}  // namespace ehl::machines
