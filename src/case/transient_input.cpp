#include "case/transient_input.hpp"

#include <fmt/format.h>

namespace ehl::program {

namespace {

transient::Scales scales_of(const Physics& physics) {
  if (!physics.si) return {.in_SI = physics.language == Language::si};
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

std::optional<transient::Input> transient_input(deck::Deck& deck, const Physics& physics, const SurfaceInput& surfaces,
                                                const core::Grid& grid) {
  if (!deck::called_for(deck, "transient")) return std::nullopt;
  if (deck::given(deck, "grid", "accuracy"))
    deck::complain(deck, "grid", "accuracy", "is available for steady contacts only: give cells for a contact in time");
  transient::Conditions carried;
  if (surfaces.on_1) carried.on_1 = surfaces.on_1->relief;
  if (surfaces.on_2) carried.on_2 = surfaces.on_2->relief;
  return transient::read(deck, scales_of(physics), carried, grid);
}

Way way_of(const CarriedSurface& surface, const transient::Input& input) {
  const double X = std::visit([](const auto& relief) { return relief.X; }, surface.relief);
  const transient::Schedule& speed = surface.section == "surface1" ? input.conditions.u1 : input.conditions.u2;
  return {X, X + transient::integral(speed, input.parameters.end)};
}

std::string name_of_probe(const char* quantity, const transient::Place& place) {
  return fmt::format("{} at ({:g}, {:g})", quantity, place.X, place.Y);
}

}  // namespace ehl::program
