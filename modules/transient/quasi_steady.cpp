#include "transient/quasi_steady.hpp"

#include <algorithm>
#include <cmath>

#include "contact/film_formulas.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "multigrid/boundary.hpp"
#include "multigrid/start.hpp"
#include "steady/multigrid_solve.hpp"
#include "transient/contact_dae.hpp"
#include "transient/jump.hpp"
#include "transient/scene_in_time.hpp"
#include "transient/settle.hpp"
#include "transient/showing.hpp"

namespace ehl::transient {
namespace {

/// M of the contact at a time: load, speed and radius enter W (2U)^(-3/4), in a line contact W (2U)^(-1/2).
double moes_load(const steady::Scene& scene, const Drive& drive, double radius) {
  const double speed = std::abs(drive.speed);
  const double M = scene.contact.M * drive.load;
  return contact::line(scene.contact.shape) ? M / std::sqrt(speed * radius)
                                            : M * std::pow(speed, -0.75) * std::pow(radius, -1.25);
}

/// Film between rigid bodies without piezoviscosity, in a^2/R of the scene. h/R (2U)^(-1/2) depends on M alone.
double rigid_film(const steady::Scene& scene, const Drive& drive, double radius) {
  constexpr double exact_of_line = 2.45;
  const double M = moes_load(scene, drive, radius);
  const double ratio = contact::line(scene.contact.shape) ? 0.0 : radius * scene.contact.shape.radius_ratio;
  const double H_moes = ratio == 0.0 ? exact_of_line / M : contact::asymptotes(M, 0.0, ratio).rigid_isoviscous;
  return contact::H_from_moes_units(H_moes, scene.contact.M, scene.contact.shape) *
         std::sqrt(std::abs(drive.speed) * radius);
}

/// The states, one after another.
class States {
 public:
  States(multigrid::Hierarchy& hierarchy, const steady::Scene& scene, const Conditions& conditions,
         const MarchParameters& parameters, const Observer& observer, double of_unit)
      : hierarchy_(hierarchy),
        scene_(scene),
        conditions_(conditions),
        parameters_(parameters),
        course_(course_of(conditions, hierarchy.problem.geometry.gap.XX)),
        dae_(hierarchy, course_, {.tuning = conditions.tuning, .newton = scene.newton}),
        showing_(hierarchy, dae_, conditions, parameters, observer, of_unit) {}

  MarchReport run(const std::vector<double>& times) {
    Drive at_first = drive_at(conditions_, times.front());
    settle(hierarchy_, dae_, at_first);
    found_ = at_first;
    good_ = multigrid::state_of(hierarchy_, last_level());
    for (const double T : times)
      if (!state_at(T)) {
        showing_.report.end = MarchEnd::interrupted;
        break;
      }
    return std::move(showing_.report);
  }

 private:
  std::size_t last_level() const { return hierarchy_.levels.size() - 1; }

  // Finds and shows one state. returns false if the observer wants to stop.
  bool state_at(double T) {
    constexpr double rigid = 0.1;  // in a lighter contact the bodies are rigid
    MarchReport& report = showing_.report;
    report.T = T;
    ++report.steps;
    const Drive drive = drive_at(conditions_, T);
    const double radius = value(conditions_.radius, T);
    StepRow row{.T = T,
                .Hc = unknown,
                .Hm = unknown,
                .Hm_X = unknown,
                .Hm_Y = unknown,
                .P_max = unknown,
                .H00 = unknown,
                .load = drive.load,
                .speed = drive.speed,
                .radius = radius,
                .carried = unknown,
                .probed = std::vector<Probed>(parameters_.probes.size(), {unknown, unknown})};
    if (drive.speed == 0.0) {
      ++report.at_rest;
      return showing_.show_row(row);
    }
    if (moes_load(scene_, drive, radius) < rigid) {
      row.Hc = row.Hm = rigid_film(scene_, drive, radius);
      return showing_.show_row(row);
    }
    if (!found(T, drive)) {
      ++report.not_found;
      return showing_.show_row(row);
    }
    showing_.show_frame(T);
    return showing_.show({.T = T});
  }

  // Moves the last state that was found to the one at T; leaves it if that fails.
  bool found(double T, Drive drive) {
    const double sign = drive.speed < 0.0 ? -1.0 : 1.0;
    Drive from = found_;
    from.speed = sign * std::abs(from.speed);  // mirrored
    if (settle_between(hierarchy_, dae_, T, from, drive).empty()) {
      dae_.balance_load();
      found_ = drive;
      good_ = multigrid::state_of(hierarchy_, last_level());
      return true;
    }
    multigrid::start_from_state(hierarchy_, last_level(), good_);
    prepare(hierarchy_);
    hierarchy_.coarsest_weight = 1.0;
    return false;
  }

  static constexpr double unknown = MarchParameters::none;
  multigrid::Hierarchy& hierarchy_;
  const steady::Scene& scene_;
  const Conditions& conditions_;
  const MarchParameters& parameters_;
  Course course_;
  ContactDae dae_;
  Showing showing_;
  Drive found_{};
  multigrid::State good_{};
};

}  // namespace

MarchReport quasi_steady(const steady::Scene& scene, const steady::Solution& start, const Conditions& conditions,
                         const MarchParameters& parameters, const std::vector<double>& times,
                         const Observer& observer) {
  const double began = core::now();
  const steady::Scene own = scene_in_time(scene, conditions);
  const double of_unit = shift_of_unit(own);
  multigrid::Run run = steady::begin_multigrid(own, steady::Start{.coarsest = 32}, {});
  multigrid::Hierarchy& hierarchy = run.hierarchy;
  multigrid::start_from_state(hierarchy, run.finest(),
                              {core::on_patch(hierarchy.finest().grid, start.P), start.H00 - of_unit});
  prepare(hierarchy);
  States states(hierarchy, own, conditions, parameters, observer, of_unit);
  MarchReport report = states.run(times);
  report.times = hierarchy.times;
  report.seconds = core::now() - began;
  return report;
}

}  // namespace ehl::transient
