#include "case/supply_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "deck/text_table.hpp"
#include "effects/starvation/keys.hpp"

namespace ehl::program {
namespace {

struct Profile {
  std::vector<double> Y, H;
};

// Linear interpolation between the points of a profile.
double at(const Profile& profile, double Y) {
  const auto behind = std::ranges::upper_bound(profile.Y, Y);
  if (behind == profile.Y.begin()) return profile.H.front();
  if (behind == profile.Y.end()) return profile.H.back();
  const auto k = static_cast<std::size_t>(behind - profile.Y.begin());
  const double share = (Y - profile.Y[k - 1]) / (profile.Y[k] - profile.Y[k - 1]);
  return profile.H[k - 1] + share * (profile.H[k] - profile.H[k - 1]);
}

constexpr double rounding = 1e-9;

bool even(const Profile& profile, double half_width) {
  return std::ranges::all_of(profile.Y, [&](double Y) {
    return std::abs(Y) > half_width ||
           std::abs(at(profile, Y) - at(profile, -Y)) <= rounding * std::abs(at(profile, Y));
  });
}

// Reads the profile. out: an error message, else empty.
std::string read_profile(const std::string& path, const starvation::Scales& scales, const core::Grid& grid,
                         Profile& profile) {
  const double unit_Y = scales.in_SI ? scales.a : 1.0, unit_H = scales.in_SI ? scales.height : 1.0;
  const deck::ReadColumns read = deck::read_columns(
      path, {{{"y"}, scales.in_SI ? "m" : "a"}, {{"h", "H", "layer", "thickness"}, scales.in_SI ? "m" : "a^2/R"}});
  if (const auto* wrong = std::get_if<std::string>(&read)) return *wrong;
  for (const deck::ColumnRow& row : std::get<deck::ColumnTable>(read).rows) {
    const std::vector<double>& value = row.values;
    if (value[1] < 0.0) return fmt::format("{}: h = {:g} must be >= 0", row.place, value[1]);
    if (!profile.Y.empty() && value[0] / unit_Y <= profile.Y.back()) return row.place + ": y must rise from row to row";
    profile.Y.push_back(value[0] / unit_Y);
    profile.H.push_back(value[1] / unit_H);
  }
  if (profile.Y.size() < 2) return path + ": a table needs at least two rows";
  if (std::ranges::max(profile.H) <= 0.0) return path + ": there is no oil: at least one h must be > 0";
  const double slip = rounding * (grid.Y_b - grid.Y_a);
  if (profile.Y.front() > grid.Y_a + slip || profile.Y.back() < grid.Y_b - slip)
    return fmt::format(
        "{}: y goes from {:.4g} to {:.4g} a, which is narrower than the domain, {:.4g} to {:.4g} a: give more of the "
        "track, or a smaller y_half",
        path, profile.Y.front(), profile.Y.back(), grid.Y_a, grid.Y_b);
  return {};
}

starvation::Scales scales_of(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  starvation::Scales scales;
  scales.width = grid.Y_b - grid.Y_a;
  scales.line = grid.line;
  scales.point = grid.ny > 0 && !grid.line;
  scales.in_SI = input.physics.language == Language::si;
  if (!input.physics.si) return scales;
  scales.a = input.physics.si->hertz.a;
  scales.height = input.physics.si->hertz.h_scale;
  scales.u1 = input.physics.si->u1;
  scales.u2 = input.physics.si->u2;
  return scales;
}

}  // namespace

void settle_boundary_of_supply(deck::Deck& deck) {
  const deck::Part transient{deck, "transient"};
  if (deck::called_for(deck, "transient"))
    transient.follow("cavitation", std::string(starvation::called_for(deck) ? "content" : "pressure"),
                     starvation::called_for(deck) ? "the inlet is starved" : "the inlet is flooded");
  if (starvation::called_for(deck))
    deck::Part{deck, "grid"}.follow("errors", std::string("levels"), "adjoint error estimates need a flooded inlet");
  const bool content = transient.word("cavitation") == "content";
  if (!starvation::called_for(deck) && !content) return;
  const deck::Part domain{deck, "domain"};
  if (domain.given("far_field") && domain.word("far_field") == "closed")
    domain.complain(
        "far_field",
        "closed is the pressure around a flooded contact, and there is none without oil: set zero, or remove it");
  domain.follow("far_field", std::string("zero"), "there is no pressure without oil");
}

void supply_input(Case& input) {
  deck::Deck& deck = input.deck;
  if (!starvation::called_for(deck)) {
    const deck::Part transient{deck, "transient"};
    transient.refuse({"supply", "supply_wave"},
                     "varies the oil of [supply], and [supply] is missing: give it, or remove this key");
    return;
  }
  const deck::Part supply{deck, "supply"};
  const std::string first = supply.given_of(starvation::supply_keys())[0];
  if (input.dry)
    return supply.complain(first, "is not available for a dry contact: remove [supply], or [case] kind = dry");
  if (input.transient && supply.integer("passes", 1) > 1)
    return supply.complain("passes",
                           "is available for steady contacts only: remove it, or remove [transient] end_time");
  if (deck::word(deck, "transient", "cavitation") == "pressure")
    return supply.complain(first, "needs [transient] cavitation = content: the gap behind a meniscus is not full");
  if (std::isfinite(input.scene.accuracy.error))
    return supply.complain(first, "is not available together with [grid] accuracy: give [grid] cells");
  if (input.flow_thinning)
    return supply.complain(first, "is not available together with [shear] flow = on: remove one of them");
  if (deck::given(deck, "grid", "errors") && deck::word(deck, "grid", "errors") == "adjoint")
    deck::complain(deck, "grid", "errors", "adjoint is not available with [supply]: set levels");
  const starvation::Scales scales = scales_of(input);
  const starvation::Input given = starvation::read(deck, scales);
  if (!deck.errors.empty()) return;
  if (input.transient) {
    transient::Supply& in_time = input.transient->conditions.supply;
    in_time.layer1 = given.layer1;
    in_time.layer2 = given.layer2;
    in_time.is_flow = given.is_flow;
    input.transient->conditions.conserves_mass = true;
  }
  input.scene.passes = {given.passes, given.returning, given.renewed, given.levelled};
  if (given.profile.empty()) {
    input.scene.supply = [H_oil = given.H_oil](double) { return H_oil; };
    return;
  }
  auto profile = std::make_shared<Profile>();
  const std::string wrong =
      read_profile(deck::found_beside(deck, "supply", "profile"), scales, input.scene.grid, *profile);
  if (!wrong.empty()) return supply.complain("profile", wrong);
  input.scene.use_symmetry = input.scene.use_symmetry && even(*profile, input.scene.grid.Y_b);
  input.scene.supply = [profile = std::shared_ptr<const Profile>(std::move(profile))](double Y) {
    return at(*profile, Y);
  };
}

}  // namespace ehl::program
