#include "transient/march.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "core/timer.hpp"
#include "fmg/cycle.hpp"
#include "fmg/full_multigrid.hpp"
#include "steady/climb.hpp"
#include "steady/state_of_level.hpp"
#include "transient/contact_dae.hpp"

namespace ehl::transient {
namespace {

constexpr double first_step = 1e-3;
/// The step across a jump of load or speed: the pressure follows at once, the film hardly moves.
constexpr double micro_step = 1e-3;
constexpr double largest_bit_of_load = 0.02;
constexpr double largest_bit_of_speed = 0.1;
/// Of a stage, in IDA's norm: what IDA asks for.
constexpr double tolerance = 1.0 / 3.0;
constexpr double settled_residual = 1e-9;
constexpr double hopeless_residual = 1e-5;
constexpr int most_settling_cycles = 60;
constexpr int cycles_per_bit = 3;

core::Field on_whole(const core::Grid& grid, const core::Field& field) {
  if (!grid.mirrored) return field;
  core::Field both(core::whole(grid));
  core::copy_whole(grid, field, both);
  return both;
}

/// The integration under way.
class March {
 public:
  March(steady::Climb& climb, const Conditions& conditions, const MarchParameters& parameters, const Observer& observer)
      : hierarchy_(climb.hierarchy),
        conditions_(conditions),
        parameters_(parameters),
        observer_(observer),
        course_(course_of(conditions, crossing_)),
        dae_(hierarchy_, course_, {.rtol = parameters.rtol, .Q_scale = central_film()}),
        y_(dae_.size()),
        yp_(dae_.size(), 0.0) {
    problem_.size = dae_.size();
    problem_.solve = [this](const Stage& stage, std::span<double> correction) { return dae_.solve(stage, correction); };
    problem_.weights = [this](double, std::span<const double> y, std::span<double> w) { dae_.weights(y, w); };
    if (!std::isnan(parameters.stop_film))
      problem_.event = [this](double, std::span<const double> y) { return dae_.least_film(y) - parameters_.stop_film; };
    report_.longest_step =
        std::isnan(parameters.longest_step) ? longest_step(conditions, parameters.end) : parameters.longest_step;
  }

  MarchReport run() {
    settle();
    dae_.state(y_);
    Ida ida(problem_,
            {.first = std::min(first_step, 0.1 * report_.longest_step),
             .longest = report_.longest_step,
             .shortest = parameters_.shortest_step},
            0.0, y_, yp_);
    show({});
    show_frame(0.0);
    for (const double stop : stops_of(conditions_, parameters_.end)) {
      if (!reach(ida, stop)) break;
      if (stop < parameters_.end && jumps_at(conditions_, stop, parameters_.end) && !cross(ida, stop)) break;
    }
    if (last_frame_ < report_.T && report_.end != MarchEnd::failed) show_frame(report_.T);
    return std::move(report_);
  }

 private:
  double central_film() const {
    const fmg::Level& level = hierarchy_.levels.back();
    return steady::value_at(level.grid, level.H, 0.0, 0.0);
  }

  // Load and speed on the way from one state to another, in bits that the cycles can follow.
  int bits_between(const Drive& from, const Drive& to) const {
    const double bits = std::max(std::abs(to.load / from.load - 1.0) / largest_bit_of_load,
                                 std::abs(to.speed - from.speed) / largest_bit_of_speed);
    return std::max(1, static_cast<int>(std::ceil(bits)));
  }
  void put_between(const Drive& from, const Drive& to, double share) {
    crossing_ = Drive{from.load + share * (to.load - from.load), from.speed + share * (to.speed - from.speed)};
  }

  // The steady state of T = 0, with its load, speed and surfaces, as exactly as rounding allows.
  void settle() {
    const Drive start = course_.drive(0.0);
    const int bits = bits_between(Drive{}, start);
    double residual = 0.0;
    for (int k = 1; k <= bits; ++k) {
      put_between(Drive{}, start, static_cast<double>(k) / bits);
      residual = cycles_at_rest(k == bits ? most_settling_cycles : cycles_per_bit);
    }
    crossing_.reset();
    if (!(residual < hopeless_residual) || !(core::minimum(hierarchy_.finest().H).value > 0.0))
      throw core::SolverError(
          "the steady state at the start of the transient was not found: its relative residual is " +
          std::to_string(residual));
    dae_.balance_load();
  }
  // Residual after cycles at T = 0 without squeeze: `most` of them, or fewer where it is as small as rounding allows.
  double cycles_at_rest(int most) {
    dae_.pose(0.0, 0.0);
    fmg::update_film(hierarchy_, hierarchy_.finest());
    const std::size_t l = hierarchy_.levels.size() - 1;
    double residual = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most; ++k) {
      fmg::fas_cycle(hierarchy_, l);
      const double now = steady::state_of_level(hierarchy_, l).residual;
      if (!std::isfinite(now)) return now;
      const bool rounding = now < hopeless_residual && now > 0.9 * residual;
      residual = now;
      if (now < settled_residual || rounding) break;
    }
    return residual;
  }

  bool reach(Ida& ida, double stop) {
    while (report_.T < stop) {
      if (report_.steps >= parameters_.most_steps)
        return fail("more than " + std::to_string(parameters_.most_steps) + " steps");
      const double before = report_.T;
      const StepReport step = ida.step(stop);
      if (step.end == StepReport::End::failed) return fail(step.reason);
      if (step.end == StepReport::End::at_event) dae_.set_state(step.T, ida.y());
      ++report_.steps;
      report_.cycles += step.cycles;
      report_.rejected += step.rejected;
      report_.not_solved += step.not_solved;
      report_.T = step.T;
      const bool on = show(step);
      frames_between(ida, before);
      if (!on) return stopped(MarchEnd::interrupted);
      if (step.end == StepReport::End::at_event) return stopped(MarchEnd::film);
      if (is_steady()) return stopped(MarchEnd::steady);
      if (!(step.T > before)) return fail("the step does not move the time");
    }
    return true;
  }

  // Behind a jump of load or speed pressure and film must be consistent again before IDA goes on: one very short step
  // by the same equations, in which load and speed go from the old to the new values bit by bit; and from there at
  // order one.
  bool cross(Ida& ida, double T) {
    const Drive before = course_.drive(T);
    const Drive after = course_.drive(T + micro_step);
    const int count = bits_between(before, after);
    std::ranges::copy(ida.y(), y_.begin());
    const std::vector<double> old(y_);
    std::vector<double> weights(dae_.size());
    std::vector<double> correction(dae_.size());
    std::ranges::fill(yp_, 0.0);
    int cycles = 0;
    for (int k = 1; k <= count; ++k) {
      put_between(before, after, static_cast<double>(k) / count);
      dae_.weights(y_, weights);
      const StageResult result =
          dae_.solve({T + micro_step, 1.0 / micro_step, y_, yp_, weights, tolerance}, correction);
      cycles += result.cycles;
      if (!result.solved) return fail("the cycles did not converge across the jump at T = " + std::to_string(T));
      for (std::size_t n = 0; n < y_.size(); ++n) y_[n] += correction[n];
      // The film has moved from its old state since, within this one step.
      for (std::size_t n = dae_.nodes(); n < 2 * dae_.nodes(); ++n) yp_[n] = (y_[n] - old[n]) / micro_step;
    }
    crossing_.reset();
    ida.restart(T + micro_step, y_, yp_, micro_step);
    report_.T = T + micro_step;
    report_.cycles += cycles;
    ++report_.restarts;
    ++report_.steps;
    return show({.T = report_.T, .length = micro_step, .order = 1, .cycles = cycles}) || stopped(MarchEnd::interrupted);
  }

  bool show(const StepReport& step) {
    const fmg::Level& level = hierarchy_.finest();
    const core::Location Hm = core::minimum(level.H);
    const double load = fmg::carried_load(level);
    const StepRow row{.T = step.T,
                      .Hc = central_film(),
                      .Hm = Hm.value,
                      .Hm_X = level.grid.X(Hm.i),
                      .Hm_Y = level.grid.Y(Hm.j),
                      .P_max = core::maximum(level.P).value,
                      .H00 = hierarchy_.H00,
                      .load = value(conditions_.load, step.T),
                      .speed = drive_at(conditions_, step.T).speed,
                      .load_error = std::abs(load / level.load - 1.0),
                      .length = step.length,
                      .order = step.order,
                      .cycles = step.cycles,
                      .rejected = step.rejected,
                      .not_solved = step.not_solved};
    report_.worst_load_error = std::max(report_.worst_load_error, row.load_error);
    recent_.push_back(row);
    return !observer_.row || observer_.row(row);
  }

  void frames_between(const Ida& ida, double before) {
    if (std::isnan(parameters_.output_interval) || !observer_.frame) return;
    for (double T = next_frame(); T <= report_.T * (1.0 + 1e-14) && T <= parameters_.end; T = next_frame()) {
      ida.interpolate(std::clamp(T, before, report_.T), y_);
      dae_.set_state(T, y_);
      show_frame(T);
    }
  }
  double next_frame() const { return (frames_)*parameters_.output_interval; }

  void show_frame(double T) {
    ++frames_;
    last_frame_ = T;
    if (!observer_.frame) return;
    const fmg::Level& level = hierarchy_.finest();
    observer_.frame({T, on_whole(level.grid, level.P), on_whole(level.grid, level.H)});
  }

  bool is_steady() {
    constexpr double window = 1.0;
    if (std::isnan(parameters_.stop_steady)) return false;
    const StepRow& now = recent_.back();
    while (recent_.size() > 1 && recent_[1].T <= now.T - window) recent_.erase(recent_.begin());
    const StepRow& then = recent_.front();
    if (now.T - then.T < window) return false;
    const auto rests = [&](double was, double is) { return std::abs(is / was - 1.0) < parameters_.stop_steady; };
    return rests(then.Hc, now.Hc) && rests(then.Hm, now.Hm) && rests(then.P_max, now.P_max);
  }

  bool fail(const std::string& reason) {
    report_.reason = reason;
    return stopped(MarchEnd::failed);
  }
  bool stopped(MarchEnd end) {
    report_.end = end;
    return false;
  }

  fmg::Hierarchy& hierarchy_;
  const Conditions& conditions_;
  const MarchParameters& parameters_;
  const Observer& observer_;
  std::optional<Drive> crossing_{};  ///< on the way across a jump
  Course course_;
  ContactDae dae_;
  DaeProblem problem_{};
  std::vector<double> y_, yp_;
  MarchReport report_{};
  std::vector<StepRow> recent_{};  ///< of the last time of 1
  int frames_ = 0;
  double last_frame_ = -1.0;
};

}  // namespace

MarchReport march(const steady::Scene& scene, const steady::Solution& start, const Conditions& conditions,
                  const MarchParameters& parameters, const Observer& observer) {
  const double began = core::now();
  steady::Scene own = scene;
  own.use_symmetry = own.use_symmetry && symmetric(conditions);
  own.multigrid.tolerance = settled_residual;  // cycles with a relaxation after the correction
  const steady::ProgressCallback silent;
  steady::Climb climb = steady::begin_climb(own, steady::Start{.coarsest = 32}, silent);
  fmg::Hierarchy& hierarchy = climb.hierarchy;
  // A V-cycle from the predicted state is enough for a step.
  if (!scene.multigrid.cycle) hierarchy.parameters.cycle = fmg::Cycle::V;
  fmg::start_from_state(hierarchy, climb.finest(), steady::part_on(hierarchy.finest().grid, start.P), start.H00);
  prepare(hierarchy);
  MarchReport report = March(climb, conditions, parameters, observer).run();
  report.times = hierarchy.times;
  report.seconds = core::now() - began;
  return report;
}

}  // namespace ehl::transient
