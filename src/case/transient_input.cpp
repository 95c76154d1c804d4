#include "case/transient_input.hpp"

#include <fmt/format.h>

#include "core/constants.hpp"

namespace ehl::program {

namespace {

transient::Scales scales_of(const Physics& physics) {
  if (!physics.si)
    return {.in_SI = physics.language == Language::si, .u1 = 1.0 + 0.5 * physics.srr, .u2 = 1.0 - 0.5 * physics.srr};
  const contact::SiContact& contact = physics.si->contact;
  const double u_m = 0.5 * contact.u_s;
  return {.in_SI = true,
          .a = physics.si->hertz.a,
          .height = physics.si->hertz.h_scale,
          .time = physics.si->hertz.a / u_m,
          .load = contact.load,
          .radius = contact.radius,
          .u1 = physics.si->u1 / u_m,
          .u2 = physics.si->u2 / u_m};
}

}  // namespace

double steepest_load(const deck::Deck& deck, const Physics& physics) {
  return deck::called_for(deck, "transient") ? transient::steepest_load(deck, scales_of(physics)) : 0.0;
}

std::optional<transient::Input> transient_input(deck::Deck& deck, const transient::Tuning& tuning,
                                                const Physics& physics, const SurfaceInput& surfaces,
                                                const core::Grid& grid) {
  if (!deck::called_for(deck, "transient")) return std::nullopt;
  if (deck::given(deck, "grid", "accuracy"))
    deck::complain(deck, "grid", "accuracy", "is available for steady contacts only: give cells for a contact in time");
  transient::Conditions carried{.tuning = tuning};
  if (surfaces.on_1) carried.on_1 = surfaces.on_1->relief;
  if (surfaces.on_2) carried.on_2 = surfaces.on_2->relief;
  return transient::read(deck, scales_of(physics), carried, grid);
}

namespace {

const transient::Schedule& speed_of(const CarriedSurface& surface, const transient::Input& input) {
  return surface.section == "surface1" ? input.conditions.u1 : input.conditions.u2;
}

}  // namespace

Travel travel_of(const CarriedSurface& surface, const transient::Input& input) {
  const double X = std::visit([](const auto& relief) { return relief.X; }, surface.relief);
  return {X, X + transient::integral(speed_of(surface, input), input.parameters.end)};
}

double time_to_move(const CarriedSurface& surface, const transient::Input& input, double distance) {
  const transient::Schedule& speed = speed_of(surface, input);
  constexpr int most_doublings = 30, halvings = 60;
  double before = 0.0, after = input.parameters.end;
  for (int n = 0; transient::integral(speed, after) < distance; ++n) {
    if (n == most_doublings) return core::unknown;
    before = after;
    after *= 2.0;
  }
  for (int n = 0; n < halvings; ++n) {
    const double middle = 0.5 * (before + after);
    (transient::integral(speed, middle) < distance ? before : after) = middle;
  }
  return after;
}

std::string name_of_probe(const char* quantity, const transient::Place& place) {
  return fmt::format("{} at ({:g}, {:g})", quantity, place.X, place.Y);
}

}  // namespace ehl::program
