#include "transient/march.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "core/timer.hpp"
#include "multigrid/mass_balance.hpp"
#include "multigrid/start.hpp"
#include "steady/multigrid_solve.hpp"
#include "transient/contact_dae.hpp"
#include "transient/jump.hpp"
#include "transient/scene_in_time.hpp"
#include "transient/settle.hpp"
#include "transient/showing.hpp"

namespace ehl::transient {
namespace {

constexpr double rounding_of_time = 1e-14;  // relative; some fifty units in the last place

/// One time integration.
class March {
 public:
  March(multigrid::Hierarchy& hierarchy, const Conditions& conditions, const MarchParameters& parameters,
        const Observer& observer, const Coupling* coupling, const newton::Tuning& newton, double of_unit,
        double line_unit)
      : hierarchy_(hierarchy),
        line_unit_(line_unit),
        conditions_(conditions),
        tuning_(conditions.tuning),
        parameters_(parameters),
        observer_(observer),
        coupling_(coupling),
        course_(course_of(conditions)),
        dae_(hierarchy_, course_,
             {.rtol = parameters.rtol,
              .Q_scale = film_scale(),
              .tuning = conditions.tuning,
              .newton = newton,
              .coupling = coupling}),
        between_(dae_.size()),
        showing_(hierarchy, dae_, conditions, parameters, observer, of_unit) {
    if (course_.surface)
      course_.surface = [this, shape = std::move(course_.surface)](const core::Patch& grid, double T, core::Field& S) {
        const double began = core::now();
        shape(grid, T, S);
        report_.seconds_of_surfaces += core::now() - began;
      };
    problem_.size = dae_.size();
    problem_.solve = [this](const Stage& stage, std::span<double> correction) {
      return dae_.solve(stage, drive(stage.T), correction);
    };
    problem_.weights = [this](double, std::span<const double> y, std::span<double> w) { dae_.weights(y, w); };
    if (!std::isnan(parameters.stop_film))
      problem_.event = [this](double, std::span<const double> y) { return dae_.least_film(y) - parameters_.stop_film; };
    report_.longest_step =
        std::isnan(parameters.longest_step) ? longest_step(conditions, parameters.end) : parameters.longest_step;
  }

  std::size_t size() const { return dae_.size(); }

  // in: the scene, for the steady solution at T = 0; from, where an earlier run continues, or null.
  MarchReport run(const steady::Scene& scene, const Checkpoint* from) {
    const bool released = conditions_.body && conditions_.body->gap;
    const Drive near = from || released ? Drive{} : begin_with(hierarchy_, dae_, scene, conditions_);
    Checkpoint start = from ? *from : first_state(hierarchy_, dae_, conditions_, near, coupling_);
    if (from) dae_.set_weight(from->weight);
    // The relaxation multiplies its predicted change of the film by cj, so the prediction must be accurate.
    multigrid::take_line_zero(hierarchy_, line_unit_);
    report_.T = start.T;
    report_.restarts = start.restarts;
    showing_.frames = start.frames;
    dae_.set_state(start.T, drive(start.T), start.y, start.yp);
    const std::vector<double> stops = stops_of(conditions_, parameters_.end, parameters_.period);
    bool on = true;
    if (!from) {
      on = showing_.show({}) || stopped(MarchEnd::interrupted);
      // An event needs a change of sign, which a film that starts below the limit does not have.
      if (on && dae_.least_film(start.y) <= parameters_.stop_film) on = stopped(MarchEnd::film);
      showing_.show_frame(0.0);
      if (on && starts_moving()) on = set_off(*std::ranges::upper_bound(stops, 0.0), start);
    }
    const double shorter = from ? tuning_.after_checkpoint * from->step : tuning_.first_step;
    Ida ida(problem_,
            {.first = std::min(shorter, 0.1 * report_.longest_step),
             .longest = report_.longest_step,
             .shortest = parameters_.shortest_step},
            start.T, start.y, start.yp);
    for (std::size_t k = 0; on && k < stops.size(); ++k) {
      if (stops[k] < start.T) continue;
      on = reach(ida, stops[k]);
      if (on && jumps_at(conditions_, stops[k], parameters_.end)) on = cross(ida, stops[k + 1]);
    }
    const bool whole = report_.end != MarchEnd::failed && report_.end != MarchEnd::interrupted;
    if (whole && showing_.last_frame < report_.T * (1.0 - rounding_of_time)) showing_.show_frame(report_.T);
    return std::move(report_);
  }

 private:
  Drive drive(double T) const { return drive_at(conditions_, T); }

  // Scale of the error test. An approaching body will have a film of this order at impact.
  double film_scale() const {
    const double Hc = central_film(hierarchy_.finest());
    if (!conditions_.body) return Hc;
    // The reference contact of separated bodies may not have been found.
    return Hc > 0.0 ? std::min(Hc, 0.1) : 0.01;
  }

  bool reach(Ida& ida, double stop) {
    while (report_.T < stop) {
      if (report_.steps >= parameters_.most_steps)
        return fail("more than " + std::to_string(parameters_.most_steps) + " steps");
      const double before = report_.T;
      const StepReport step = ida.step(stop);
      if (step.end == StepReport::End::failed) return fail(step.reason);
      if (step.end == StepReport::End::at_event) dae_.set_state(step.T, drive(step.T), ida.y(), ida.yp());
      const bool on = accept(step, ida.y(), [&](double T) { ida.interpolate(T, between_); });
      const bool wanted = observer_.wants_checkpoint && observer_.wants_checkpoint();
      if ((wanted || !on) && observer_.checkpoint) hand_out_checkpoint(step.length, ida.y(), ida.yp());
      if (!on) return stopped(MarchEnd::interrupted);
      if (step.end == StepReport::End::at_event) return stopped(MarchEnd::film);
      if (showing_.at_rest()) return stopped(MarchEnd::steady);
      if (showing_.periodic()) return stopped(MarchEnd::periodic);
      if (!(step.T > before)) return fail("the time step is too small to change the time");
    }
    return true;
  }

  // After a jump of load or speed pressure and film must be made consistent before IDA continues. In one very short
  // step load and speed go from the old to the new values; a few more short steps follow; then IDA starts at order one.
  // All of them end before the next stop.
  bool cross(Ida& ida, double next_stop) {
    EulerStep step;
    if (coupling_) coupling_->restart();
    step.y.assign(ida.y().begin(), ida.y().end());
    if (!short_steps(step, drive(report_.T), tuning_.first_step, next_stop)) return false;
    ++report_.restarts;
    ida.restart(report_.T, step.y, step.yp, step.length);
    return true;
  }

  bool starts_moving() const {
    return conditions_.body && (conditions_.body->gap || conditions_.body->velocity != 0.0);
  }

  // Short steps for a body that starts with a velocity: the pressure at T = 0 is not consistent. out: IDA's start.
  bool set_off(double next_stop, Checkpoint& start) {
    EulerStep step;
    step.y = start.y;
    if (!short_steps(step, drive(0.0), std::min(tuning_.first_step, 0.1 * report_.longest_step), next_stop))
      return false;
    start.T = report_.T;
    start.y = step.y;
    start.yp = step.yp;
    return true;
  }

  // Within the first of these steps the pressure adapts and the film hardly moves; the others let fast disturbances
  // decay, which IDA would follow with steps too short for the cycles. in: step.y, the state at report_.T, and the
  // drive before. out: step, the last one.
  bool short_steps(EulerStep& step, Drive before, double length, double next_stop) {
    const double room = 0.5 * (next_stop - report_.T);
    const int count = std::clamp(static_cast<int>(room / length), 2, std::max(2, tuning_.micro_steps));
    step.length = std::min(length, room / count);
    for (int k = 0; k < count; ++k) {
      step.old = step.y;
      step.T = report_.T + step.length;
      step.cycles = step.newton_steps = 0;
      const Drive next = drive(step.T);
      if (conditions_.body) before.load = next.load;  // the inertia of the body takes the jump of the load
      const bool solved = k > 0 ? solve_euler_step(dae_, next, step) : solve_step_across(dae_, before, next, step);
      if (!solved) return fail("the cycles did not converge in the short steps after a jump or a start");
      const auto interpolate = [&](double at) {
        const double ahead = (step.T - at) / step.length;
        for (std::size_t n = 0; n < step.y.size(); ++n) between_[n] = step.y[n] - ahead * (step.y[n] - step.old[n]);
      };
      if (!accept(report_of(step), step.y, interpolate)) {
        if (observer_.checkpoint) hand_out_checkpoint(step.length, step.y, step.yp);
        return stopped(MarchEnd::interrupted);
      }
    }
    return true;
  }

  void hand_out_checkpoint(double length, std::span<const double> y, std::span<const double> yp) {
    Checkpoint at{report_.T, length, showing_.frames, report_.restarts, dae_.weight()};
    at.y.assign(y.begin(), y.end());
    at.yp.assign(yp.begin(), yp.end());
    observer_.checkpoint(std::move(at));
  }

  // Counts and reports a step whose state the level holds.
  template <class Interpolate>
  bool accept(const StepReport& step, std::span<const double> y, Interpolate interpolate) {
    const double before = std::exchange(report_.T, step.T);
    if (coupling_) coupling_->accept();
    ++report_.steps;
    report_.cycles += step.cycles;
    report_.newton_steps += step.newton_steps;
    report_.rejected += step.rejected;
    report_.not_solved += step.not_solved;
    const bool on = showing_.show(step);
    frames_between(before, y, interpolate);
    return on;
  }

  // Frames up to report_.T, whose state is `now`; `interpolate` writes an earlier state to between_.
  template <class Interpolate>
  void frames_between(double before, std::span<const double> now, Interpolate interpolate) {
    if (std::isnan(parameters_.output_interval) || !observer_.frame) return;
    bool moved = false;
    for (double T = next_frame(); T <= report_.T * (1.0 + rounding_of_time) && T <= parameters_.end; T = next_frame()) {
      interpolate(std::clamp(T, before, report_.T));
      dae_.set_state(T, drive(T), between_);
      showing_.show_frame(T);
      moved = true;
    }
    if (moved) dae_.set_state(report_.T, drive(report_.T), now);
  }
  double next_frame() const { return showing_.frames * parameters_.output_interval; }

  bool fail(const std::string& reason) {
    report_.reason = reason;
    return stopped(MarchEnd::failed);
  }
  bool stopped(MarchEnd end) {
    report_.end = end;
    return false;
  }

  multigrid::Hierarchy& hierarchy_;
  double line_unit_;  ///< of a line contact, in the logarithm
  const Conditions& conditions_;
  const Tuning& tuning_;
  const MarchParameters& parameters_;
  const Observer& observer_;
  const Coupling* coupling_;
  Course course_;
  ContactDae dae_;
  DaeProblem problem_{};
  std::vector<double> between_;  ///< a state between two steps
  Showing showing_;
  MarchReport& report_ = showing_.report;
};

}  // namespace

MarchReport march(const steady::Scene& scene, const steady::Solution& start, const Conditions& conditions,
                  const MarchParameters& parameters, const Observer& observer, const Checkpoint* from,
                  const Coupling* coupling) {
  const double began = core::now();
  steady::Scene own = scene_in_time(scene, conditions);
  own.has_factors = coupling != nullptr;
  if (coupling) own.limit = coupling->limit;
  const double of_unit = shift_of_unit(own);
  multigrid::Run run = steady::begin_multigrid(own, steady::Start{.coarsest = 32}, {});
  multigrid::Hierarchy& hierarchy = run.hierarchy;
  const core::Field P = core::on_patch(hierarchy.finest().grid, start.P);
  multigrid::start_from_state(hierarchy, run.finest(), {P, start.H00 - of_unit});
  prepare(hierarchy);
  March under_way(hierarchy, conditions, parameters, observer, coupling, own.newton, of_unit,
                  own.deformation.line_unit);
  if (from && (from->y.size() != under_way.size() || from->yp.size() != under_way.size()))
    throw core::FileError("the checkpoint belongs to another grid than that of the deck");
  MarchReport report = under_way.run(scene, from);
  report.times = hierarchy.times;
  report.seconds = core::now() - began;
  return report;
}

}  // namespace ehl::transient
