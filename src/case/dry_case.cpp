#include "case/dry_case.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "dry/keys.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;

// A dry contact is a circle of radius 1; roughness makes it slightly larger.
constexpr double chosen_edge = 1.5;
constexpr int chosen_cells = 256;

struct Meaningless {
  std::string section;
  std::vector<std::string> keys;  // empty: all keys of the section
};

const std::vector<Meaningless> of_a_film = {
    {"contact", {"kind", "load_per_length", "M", "L", "W", "U", "G", "radius_y", "radius_ratio", "Sq1", "Sq2"}},
    {"motion", {}},
    {"lubricant", {}},
    {"discretization", {}},
    {"multigrid", {}},
    {"continuation", {}},
    {"tuning", {}},
    {"transient", {}},
    {"body", {}},
    {"shear", {}},
    {"friction", {}},
    {"thermal", {}},
    {"surface1", {"at_rest"}},
    {"surface2", {"at_rest"}},
    {"domain", {"far_field"}},
    {"grid", {"accuracy"}},
    {"output", {"fields", "checkpoint"}}};

bool speaks_of_film(const deck::Key& key) {
  return std::ranges::any_of(of_a_film, [&](const Meaningless& entry) {
    return entry.section == key.section &&
           (entry.keys.empty() || std::ranges::find(entry.keys, key.name) != entry.keys.end());
  });
}

void refuse_film(deck::Deck& deck) {
  for (std::size_t k = 0; k < deck.catalogue.keys.size(); ++k) {
    const deck::Key key = deck.catalogue.keys[k];
    if (!speaks_of_film(key)) continue;
    if (given(deck, key.section, key.name)) {
      const bool radii = key.name.starts_with("radius") || key.name == "kind";
      const bool scales = key.section == "contact" && !key.name.starts_with("Sq");
      complain(deck, key.section, key.name,
               radii ? "must be left out: a dry contact is always circular"
               : key.name == "load_per_length"
                   ? "belongs to a line contact, and a dry contact is always circular: give load [N], radius_x and the "
                     "elastic data in SI, or nothing (units of Hertz)"
               : scales ? "contains a lubricant, but [case] kind = dry: give load, radius_x and the elastic data in "
                          "SI, or nothing (units of Hertz)"
                        : "has no influence with [case] kind = dry: remove it",
               radii || scales ? deck::Cause::between : deck::Cause::idle);
    } else {
      deck.values[k] = {.origin = deck::Origin::absent, .number = core::unknown};
    }
  }
}

void choose_domain(deck::Deck& deck) {
  const std::string why = "a dry contact has radius 1";
  if (!given(deck, "domain", "x_inlet")) deck::choose(deck, "domain", "x_inlet", -chosen_edge, why);
  if (!given(deck, "domain", "x_outlet")) deck::choose(deck, "domain", "x_outlet", chosen_edge, why);
  if (!given(deck, "domain", "y_half")) deck::choose(deck, "domain", "y_half", chosen_edge, why);
  if (given(deck, "grid", "cells")) return;
  int cells = std::max(1, deck::integer(deck, "grid", "coarsest", chosen_cells));
  while (cells < chosen_cells) cells *= 2;
  deck::choose(deck, "grid", "cells", cells, "resolves the Hertz pressure at the centre to about 1e-5");
}

}  // namespace

Physics dry_physics(const DryInput& input) {
  Physics physics;
  if (!input.contact) return physics;
  const ElasticContact& contact = *input.contact;
  physics.language = Language::si;
  SiInput si;
  si.contact.load = contact.bodies.load;
  si.contact.radius = contact.bodies.radius;
  si.contact.E_prime = contact.bodies.E_prime;
  si.E_prime_uncoated = contact.bodies.E_prime_uncoated;
  si.coatings = contact.bodies.coatings;
  si.hertz = contact.hertz;
  physics.si = si;
  physics.p_h = contact.hertz.p_h;
  return physics;
}

std::optional<DryInput> dry_input(deck::Deck& deck) {
  const std::optional<dry::Parameters> parameters = dry::read(deck);
  if (!parameters) return std::nullopt;
  refuse_film(deck);
  DryInput input{.parameters = *parameters};
  input.contact = elastic_contact(deck);
  choose_domain(deck);
  return input;
}

}  // namespace ehl::program
