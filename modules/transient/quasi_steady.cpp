#include "transient/quasi_steady.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/film_formulas.hpp"
#include "contact/groups.hpp"
#include "core/errors.hpp"
#include "core/norms.hpp"
#include "core/timer.hpp"
#include "rheology/laws.hpp"
#include "steady/solve.hpp"
#include "transient/nodes.hpp"

namespace ehl::transient {
namespace {

using core::unknown;

// M at a time: W (2U)^(-3/4), in a line contact W (2U)^(-1/2).
double moes_load(const steady::Scene& scene, const Drive& drive) {
  const double speed = std::abs(drive.speed);
  const double M = scene.contact.M * drive.load, radius = drive.radius;
  return contact::line(scene.contact.shape) ? M / std::sqrt(speed * radius)
                                            : M * std::pow(speed, -0.75) * std::pow(radius, -1.25);
}

// Film between rigid bodies without piezoviscosity, in a^2/R of the scene: h/R (2U)^(-1/2) depends on M alone.
double rigid_film(const steady::Scene& scene, const Drive& drive) {
  constexpr double exact_of_line = 2.45;
  const contact::Ellipse& shape = scene.contact.shape;
  const double M = moes_load(scene, drive), radius = drive.radius;
  const double H_moes = contact::line(shape)
                            ? exact_of_line / M
                            : contact::asymptotes(M, 0.0, radius * shape.radius_ratio).rigid_isoviscous;
  return contact::H_from_moes_units(H_moes, scene.contact.M, shape) * std::sqrt(std::abs(drive.speed) * radius);
}

StepRow row_without_state(const Drive& drive, double T, std::size_t probes) {
  return {.T = T,
          .Hc = unknown,
          .Hm = unknown,
          .Hm_X = unknown,
          .Hm_Y = unknown,
          .P_max = unknown,
          .H00 = unknown,
          .load = drive.load,
          .speed = drive.speed,
          .radius = drive.radius,
          .carried = unknown,
          .probed = std::vector<Probed>(probes, {unknown, unknown})};
}

// The fields of a state in the units and coordinates of the given scene.
Frame frame_of(const StateScene& state, const steady::Solution& found, const Drive& drive, double T) {
  Frame frame{.T = T, .P = found.P, .H = found.H, .theta = found.theta};
  for (int i = 0; i < frame.P.nodes_x(); ++i)
    for (int j = 0; j < frame.P.nodes_y(); ++j) {
      frame.P(i, j) *= state.pressure;
      frame.H(i, j) *= state.film;
    }
  if (drive.speed < 0.0)
    for (core::Field* field : {&frame.P, &frame.H, &frame.theta})
      if (field->nodes_x() > 0) mirror_in_X(state.scene.grid, *field);
  return frame;
}

}  // namespace

DryContact dry_contact(const contact::Ellipse& before, double load, double radius) {
  if (contact::line(before)) return {before, std::sqrt(load * radius), std::sqrt(load / radius)};
  const contact::Ellipse shape = radius == 1.0 ? before : contact::ellipse(radius * before.radius_ratio);
  return {shape, std::cbrt(load * radius) * shape.a / before.a,
          std::cbrt(load / (radius * radius)) * shape.p_h / before.p_h};
}

StateScene scene_at(const steady::Scene& scene, const Conditions& conditions, double T) {
  const Drive drive = drive_at(conditions, T);
  const double radius = drive.radius;
  const DryContact dry = dry_contact(scene.contact.shape, drive.load, radius);
  const contact::Ellipse& shape = dry.shape;
  StateScene state{
      .scene = scene, .length = dry.length, .film = dry.length * dry.length / radius, .pressure = dry.pressure};
  steady::Scene& own = state.scene;
  const double M = moes_load(scene, drive);
  const double L = scene.contact.L * std::pow(std::abs(drive.speed) / radius, 0.25);
  own.contact = steady::scales_of(M, L, shape);
  own.lambda = contact::from_moes(M, L, shape).lambda;
  own.viscosity = rheology::rescaled(scene.viscosity, state.pressure);
  own.density = rheology::rescaled(scene.density, state.pressure);
  if (scene.thinning) {
    own.thinning = rheology::rescaled(*scene.thinning, state.pressure);
    own.thinning->k = conditions.thinning_k * drive.sliding / state.film;
  }
  for (double* bound : {&own.grid.X_a, &own.grid.X_b}) *bound /= state.length;
  if (!own.grid.line)
    for (double* bound : {&own.grid.Y_a, &own.grid.Y_b}) *bound /= state.length;
  if (scene.supply)
    own.supply = [supply = scene.supply, s = state.length, film = state.film, share = drive.supply](double Y) {
      return share * supply(s * Y) / film;
    };
  own.observer = {};
  own.adjoint_errors = own.error_maps = false;
  return state;
}

std::optional<Frame> steady_frame(const steady::Scene& scene, const Conditions& conditions, double T) try {
  if (scene.surface || conditions.on_1 || conditions.on_2 || !scene.coatings.parts.empty()) return std::nullopt;
  const StateScene state = scene_at(scene, conditions, T);
  const steady::Solution found = steady::solve(state.scene);
  if (!found.converged) return std::nullopt;
  return frame_of(state, found, drive_at(conditions, T), T);
} catch (const core::SolverError&) {
  return std::nullopt;
}

namespace {

// Solves the state at T and writes it to the row. returns why it was not found; empty if it was.
std::string solve_state(const steady::Scene& scene, const Conditions& conditions, const MarchParameters& parameters,
                        const Observer& observer, const std::function<bool()>& going_on, StepRow& row) {
  const Drive drive = drive_at(conditions, row.T);
  const StateScene state = scene_at(scene, conditions, row.T);
  steady::Solution found;
  try {
    found = steady::solve(state.scene, [&](const steady::Progress&) { return !going_on || going_on(); });
  } catch (const core::SolverError& error) {
    return error.what();
  }
  if (!found.converged) return found.failed_check;
  Frame frame = frame_of(state, found, drive, row.T);
  const core::Location Hm = core::minimum(frame.H);
  row.Hc = found.levels.back().Hc * state.film;
  row.Hm = Hm.value;
  row.Hm_X = scene.grid.X(Hm.i);
  row.Hm_Y = scene.grid.Y(Hm.j);
  row.P_max = core::maximum(frame.P).value;
  row.carried = drive.load;
  row.probed = probed_at(scene.grid, frame.P, frame.H, parameters.probes);
  if (observer.frame) observer.frame(std::move(frame));
  return "";
}

}  // namespace

MarchReport quasi_steady(const steady::Scene& scene, const Conditions& conditions, const MarchParameters& parameters,
                         const std::vector<double>& times, const Observer& observer,
                         const std::function<bool()>& going_on) {
  constexpr double rigid = 0.1;  // M of a contact whose bodies are practically rigid
  const double began = core::now();
  MarchReport report;
  bool on = true;
  for (const double T : times) {
    report.T = T;
    ++report.steps;
    const Drive drive = drive_at(conditions, T);
    StepRow row = row_without_state(drive, T, parameters.probes.size());
    if (drive.speed == 0.0) {
      ++report.at_rest;
    } else if (moes_load(scene, drive) < rigid) {
      row.Hc = row.Hm = rigid_film(scene, drive);
    } else {
      std::string reason;
      try {
        reason = solve_state(scene, conditions, parameters, observer, going_on, row);
      } catch (const core::Interrupted&) {
        on = false;
      }
      if (!reason.empty()) ++report.not_found;
      if (report.reason.empty()) report.reason = reason;
    }
    on = (!observer.row || observer.row(row)) && on;
    if (!on) break;
  }
  if (!on) report.end = MarchEnd::interrupted;
  report.seconds = core::now() - began;
  return report;
}

}  // namespace ehl::transient
