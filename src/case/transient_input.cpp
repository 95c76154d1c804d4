#include "case/transient_input.hpp"

#include <fmt/format.h>

#include <cmath>

#include "contact/ellipse.hpp"
#include "core/constants.hpp"
#include "transient/quasi_steady.hpp"

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

const deck::ColumnTable* course_of(const std::optional<machines::Contact>& machine) {
  return machine && machine->course ? &*machine->course : nullptr;
}

}  // namespace

transient::FarDemands far_demands(const deck::Deck& deck, const Physics& physics,
                                  const std::optional<machines::Contact>& machine) {
  if (!deck::called_for(deck, "transient")) return {};
  transient::FarDemands demands = transient::far_demands(deck, scales_of(physics), course_of(machine));
  // The load outside the domain lags behind a moving body. [bench: far_field_of_moving_bodies]
  if (demands.why_zero.empty() && deck::called_for(deck, "body")) demands.why_zero = "a body moves";
  return demands;
}

namespace {

// Refuses what is not available if the radius varies or the direction of the entrainment reverses.
void check_geometry(deck::Deck& deck, const Physics& physics, const transient::Input& input) {
  const bool bends = !input.conditions.radius.points.empty();
  const bool reverses = transient::reversal(input.conditions, input.parameters.end) <= input.parameters.end;
  if (!bends && !reverses) return;
  const deck::Part transient{deck, "transient"}, domain{deck, "domain"};
  const std::string what = bends ? "a radius_x that varies" : "a reversal of the motion";
  if (contact::gap(physics.groups.shape).oblique())
    transient.complain(transient.given("cycle") ? "cycle" : "u1",
                       what + " is not available for an ellipse at an angle to the motion: set [motion] angle = 0");
  if (deck::called_for(deck, "thermal"))
    transient.complain(transient.given("cycle") ? "cycle" : "u1",
                       what + " is not available with [thermal]: remove one of them");
  if (domain.given("far_field") && domain.word("far_field") == "closed")
    domain.complain("far_field", "closed is not available with " + what + ": set zero, or remove it");
}

// Refuses a contact that grows out of its domain during the run: its half width follows (F R_x)^(1/3), that of a line
// contact (F R_x)^(1/2).
void check_reach(deck::Deck& deck, const contact::Ellipse& shape, const transient::Input& input,
                 const core::Grid& grid) {
  double largest = 0.0, at = 0.0;
  const auto look = [&](double T) {
    const double size = transient::value(input.conditions.load, T) * transient::value(input.conditions.radius, T);
    if (size <= largest) return;
    largest = size;
    at = T;
  };
  constexpr int samples = 1000;
  for (int k = 0; k <= samples; ++k) look(input.parameters.end * k / samples);
  for (const transient::Schedule* one : {&input.conditions.load, &input.conditions.radius})
    for (const transient::Schedule::Point& point : one->points)
      if (point.T >= 0.0 && point.T <= input.parameters.end) look(point.T);
  const transient::DryContact then = transient::dry_contact(shape, transient::value(input.conditions.load, at),
                                                            transient::value(input.conditions.radius, at));
  const contact::Extent reach = contact::extent(then.shape);
  const double length = then.length, X = reach.X * length, Y = reach.Y * length;
  const bool wide_enough = contact::line(shape) || grid.Y_b > Y;
  if (-grid.X_a > X && grid.X_b > X && wide_enough) return;
  const deck::Part transient{deck, "transient"};
  transient.complain(
      transient.given("cycle") ? "cycle" : "load",
      fmt::format("the contact grows to {:.3g} Hertz radii at time {:.4g}, beyond its domain: let [domain] reach from "
                  "x_inlet = {:.3g} to x_outlet = {:.3g}",
                  X, at / (input.in_seconds ? input.second : 1.0), grid.X_a * length, grid.X_b * length) +
          (wide_enough ? "" : fmt::format(", and to y_half = {:.3g}", grid.Y_b * length)));
}

// Refuses error bars where half the cells make no grid for the contact.
void check_half_grid(deck::Deck& deck, const contact::Ellipse& shape, const core::Grid& grid) {
  constexpr int least_cells = 64;            // of a coarsest grid of 32 cells, and a finer one
  constexpr double widest_over_size = 0.25;  // on half the cells half of the contact's size
  const deck::Part part{deck, "grid"};
  const double widest = widest_over_size * std::min(1.0, shape.kappa);
  const int coarsest = part.integer("coarsest", 0);
  if (grid.nx % 2 == 0 && grid.nx >= std::max(least_cells, 2 * coarsest) && grid.hx() <= widest) return;
  const double fewest = std::max({1.0 * least_cells, 2.0 * coarsest, (grid.X_b - grid.X_a) / widest});
  deck::complain(deck, "transient", "error",
                 fmt::format("computes the contact on half the cells too, and {} are too few for that: use cells = "
                             "{:g} or more, or set off",
                             grid.nx, std::exp2(std::ceil(std::log2(fewest)))));
}

}  // namespace

std::optional<transient::Input> transient_input(deck::Deck& deck, const transient::Tuning& tuning,
                                                const Physics& physics, const SurfaceInput& surfaces,
                                                const std::optional<machines::Contact>& machine,
                                                const core::Grid& grid) {
  if (!deck::called_for(deck, "transient")) return std::nullopt;
  if (deck::given(deck, "grid", "accuracy"))
    deck::complain(deck, "grid", "accuracy", "is available for steady contacts only: give cells for a contact in time");
  transient::Conditions carried{.tuning = tuning};
  if (surfaces.on_1) carried.on_1 = surfaces.on_1->relief;
  if (surfaces.on_2) carried.on_2 = surfaces.on_2->relief;
  transient::Input input = transient::read(deck, scales_of(physics), carried, grid, course_of(machine));
  if (std::isfinite(input.parameters.end)) {
    check_geometry(deck, physics, input);
    if (!input.conditions.body && grid.nx > 0 && deck.errors.empty())
      check_reach(deck, physics.groups.shape, input, grid);
  }
  if (input.error_bars && grid.nx > 0) check_half_grid(deck, physics.groups.shape, grid);
  if (input.mode != transient::Mode::in_time && deck::called_for(deck, "thermal"))
    deck::complain(deck, "transient", "mode", "the quasi-steady states have no heat: set in_time, or remove [thermal]");
  if (input.mode == transient::Mode::quasi_steady)
    for (const char* section : {"friction", "subsurface"})
      if (deck::called_for(deck, section))
        deck::complain(deck, "transient", "mode",
                       std::string("quasi_steady computes films only: set both, or remove [") + section + "]");
  return input;
}

namespace {

const transient::Schedule& speed_of(const CarriedSurface& surface, const transient::Input& input) {
  return surface.section == "surface1" ? input.conditions.u1 : input.conditions.u2;
}

}  // namespace

Travel travel_of(const CarriedSurface& surface, const transient::Input& input) {
  const double X = std::visit([](const auto& relief) { return relief.X; }, surface.relief);
  const auto place = [&](double T) { return X + transient::integral(speed_of(surface, input), T); };
  const double end = input.parameters.end;
  Travel travel{X, place(end), X};
  constexpr int samples = 1000;  // a motion that reverses may go farther than it ends
  for (int k = 1; k <= samples; ++k) travel.farthest = std::max(travel.farthest, place(end * k / samples));
  return travel;
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
