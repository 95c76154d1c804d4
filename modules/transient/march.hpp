#pragma once
// A contact in time: from its steady state through varying load and speed, with features on its surfaces.
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "transient/conditions.hpp"
#include "transient/probe.hpp"

namespace ehl::transient {

struct MarchParameters {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double end = 0.0;
  double rtol = 1e-4;          ///< of IDA's error test
  double longest_step = none;  ///< none: from what varies (longest_step())
  double shortest_step = 1e-9;
  int most_steps = 100000;
  double output_interval = none;  ///< between two frames; none: first and last only
  double stop_film = none;        ///< end where Hm falls to this
  double stop_steady = none;      ///< end where Hc, Hm and P_max change by less than this, relative, in a time of 1
  std::vector<Place> probes{};    ///< where P and H are wanted at every step
};

/// One accepted step.
struct StepRow {
  double T = 0.0;
  double Hc = 0.0, Hm = 0.0, Hm_X = 0.0, Hm_Y = 0.0, P_max = 0.0, H00 = 0.0;
  double load = 1.0;        ///< wanted, over the scene's
  double speed = 1.0;       ///< (u1 + u2)/2 over u_m
  double load_error = 0.0;  ///< relative
  double velocity = 0.0;    ///< V = H00' of a moving body
  double carried = 1.0;     ///< by the film, over the scene's load
  double length = 0.0;      ///< of the step; 0 in the first row
  int order = 0;
  int cycles = 0;
  int newton_steps = 0;  ///< of a line contact, where cycles do not converge
  int rejected = 0;      ///< attempts that failed the error test
  int not_solved = 0;    ///< attempts that neither solved

  OilInTime oil{};
  std::vector<Probed> probed{};  ///< of every probe
};

/// The contact at one time, on the whole domain.
struct Frame {
  double T = 0.0;
  core::Field P{}, H{};
  core::Field theta{};  ///< Q/(rho H), where mass is conserved; else empty
};

/// All that a march needs to go on from here.
struct Checkpoint {
  double T = 0.0;
  double step = 0.0;  ///< length of the last one
  int frames = 0;     ///< given out so far
  int restarts = 0;
  double weight = 1.0;            ///< of the cycles, contact_dae.hpp
  std::vector<double> y{}, yp{};  ///< contact_dae.hpp, on the grid that is computed on
};

/// What comes out while it goes on; each may be empty. `row` answers whether to go on.
struct Observer {
  std::function<bool(const StepRow& row)> row{};
  std::function<void(Frame&& frame)> frame{};
  std::function<bool()> wants_checkpoint{};                   ///< asked after every step
  std::function<void(Checkpoint&& checkpoint)> checkpoint{};  ///< when wanted, and where an answer to a row was to stop
};

enum class MarchEnd { end_time, film, steady, failed, interrupted };

struct MarchReport {
  MarchEnd end = MarchEnd::end_time;
  double T = 0.0;
  std::string reason{};  ///< of a failure
  int steps = 0, cycles = 0, newton_steps = 0, rejected = 0, not_solved = 0, restarts = 0;
  double worst_load_error = 0.0;
  double worst_oil_error = 0.0;  ///< of the rows
  double longest_step = 0.0;     ///< that was allowed
  double seconds = 0.0;
  double seconds_of_surfaces = 0.0;  ///< of them: the shape of the surfaces
  core::PartTimes times{};
};

/// Integrates Q_T + U Q_X = div(eps grad P), P >= 0, Q = rho_bar H or, where mass is conserved, Q <= rho_bar H with Q
/// an unknown where P = 0 (reynolds/content.hpp), with the load balance, from the steady
/// solution of the scene under the conditions of T = 0, by IDA's BDF of variable order and step; every implicit step is
/// solved by multigrid cycles. At a jump of load or speed the integration starts anew behind a very short step.
/// in: scene, and its solution; conditions with load > 0 and u1 + u2 >= 0 at all times, > 0 at T = 0; from, where
/// given: a checkpoint of the same march, from which it goes on at order one with a shorter step, the report counting
/// anew. errors: core::SolverError where the state at T = 0 cannot be solved; core::FileError where the checkpoint is
/// of another grid.
MarchReport march(const steady::Scene& scene, const steady::Solution& start, const Conditions& conditions,
                  const MarchParameters& parameters, const Observer& observer, const Checkpoint* from = nullptr);

}  // namespace ehl::transient
