#pragma once
// Time integration of a contact from its steady state, with varying load and speed and with moving surface features.
#include <functional>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "core/field.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "transient/conditions.hpp"
#include "transient/probe.hpp"

namespace ehl::transient {

/// Parameters of a time integration; times in T.
struct MarchParameters {
  double end = 0.0;
  double rtol = 1e-4;                   ///< of IDA's error test
  double longest_step = core::unknown;  ///< NaN: from the conditions (longest_step())
  double shortest_step = 1e-9;
  int most_steps = 100000;
  double output_interval = core::unknown;  ///< time between two frames; NaN: only the first and the last
  double stop_film = core::unknown;        ///< end when Hm falls to this value
  double stop_steady = core::unknown;  ///< end when Hc, Hm and P_max change by less than this, relative, in a time of 1
  double period = core::unknown;       ///< of the conditions; NaN: they do not repeat
  double stop_periodic =
      core::unknown;  ///< end when Hc and Hm change by less than this, relative, from period to period
  double start_of_means = core::unknown;  ///< extremes and means are taken from here on; NaN: see the key of this name
  std::vector<Place> probes{};            ///< where P and H are recorded at every step
};

/// One accepted step.
struct StepRow {
  double T = 0.0;
  double Hc = 0.0, Hm = 0.0, Hm_X = 0.0, Hm_Y = 0.0, P_max = 0.0, H00 = 0.0;
  double load = 1.0;        ///< required load, over that of the scene
  double speed = 1.0;       ///< (u1 + u2)/2 over u_m
  double radius = 1.0;      ///< R_x over that of the scene
  double load_error = 0.0;  ///< relative
  double velocity = 0.0;    ///< V = H00' of a moving body
  double carried = 1.0;     ///< load carried by the film, over that of the scene
  double length = 0.0;      ///< of the time step; 0 in the first row
  int order = 0;
  int cycles = 0;
  int newton_steps = 0;  ///< of a line contact, if the cycles do not converge
  int rejected = 0;      ///< attempts that failed the error test
  int not_solved = 0;    ///< attempts whose equations were not solved

  double Hc_quasi = core::unknown;  ///< of the quasi-steady state at T, if it is known
  double Hm_quasi = core::unknown;
  double P_max_quasi = core::unknown;

  /// Relative error bars, if they are asked for; NaN where none is known.
  double error_Hc = core::unknown, error_Hm = core::unknown, error_P_max = core::unknown;
  double error_mu = core::unknown;

  OilInTime oil{};
  std::vector<Probed> probed{};    ///< one entry per probe
  std::vector<double> measured{};  ///< by Observer::measure
};

/// The contact at one time, on the whole domain.
struct Frame {
  double T = 0.0;
  core::Field P{}, H{};
  core::Field theta{};                  ///< Q/(rho_bar H) where mass is conserved; else empty
  std::vector<core::Field> measured{};  ///< by Observer::measure_fields
};

/// The solved contact at one time, on the computed patch. It refers to the running integration.
struct Snapshot {
  double T = 0.0;
  const core::Patch& grid;
  const core::Field& P;
  const core::Field& H;
  double carried = 1.0;                           ///< load that the film carries, over that of the scene
  double u1 = 1.0, u2 = 1.0;                      ///< speeds of the surfaces over u_m
  const reynolds::FarField* far_field = nullptr;  ///< null: no oil outside the domain is known
  reynolds::FarState far{};
  const film::FactorFields* factors = nullptr;  ///< of an effect on the coefficients; null: none
  const core::Field* stress = nullptr;          ///< its factor on the shear stress of sliding; null: 1
};

/// Everything that is needed to continue from here.
struct Checkpoint {
  double T = 0.0;
  double step = 0.0;  ///< length of the last step
  int frames = 0;     ///< number of frames so far
  int restarts = 0;
  double weight = 1.0;            ///< ContactDae::weight()
  std::vector<double> y{}, yp{};  ///< as in ContactDae, on the computed grid
};

/// Functions called during the integration; each may be empty. `row` returns whether to continue.
struct Observer {
  std::function<bool(const StepRow& row)> row{};
  std::function<void(Frame&& frame)> frame{};
  std::function<std::vector<double>(const Snapshot& at)> measure{};              ///< numbers for every row
  std::function<std::vector<core::Field>(const Snapshot& at)> measure_fields{};  ///< fields for every frame
  std::function<bool()> wants_checkpoint{};                                      ///< called after every step
  std::function<void(Checkpoint&& checkpoint)> checkpoint{};  ///< called when wanted, and when `row` returned false
};

enum class MarchEnd { end_time, film, steady, periodic, failed, interrupted };

/// Result of a time integration: why it ended, its counters and times.
struct MarchReport {
  MarchEnd end = MarchEnd::end_time;
  double T = 0.0;
  std::string reason{};  ///< why it failed; of quasi-steady states, why the first was not found
  int steps = 0, cycles = 0, newton_steps = 0, rejected = 0, not_solved = 0, restarts = 0;
  double worst_load_error = 0.0;
  double worst_oil_error = 0.0;             ///< largest of all rows
  double longest_step = 0.0;                ///< longest step allowed
  int periods = 0;                          ///< whole periods
  double change_of_period = core::unknown;  ///< Periodic::change() at the end
  int at_rest = 0, not_found = 0;           ///< quasi-steady states without entrainment, and those that were not found
  double seconds = 0.0;
  double seconds_of_surfaces = 0.0;  ///< of `seconds`, spent on the shape of the surfaces
  core::PartTimes times{};
};

/// Integrates Q_T + U Q_X = div(eps grad P), P >= 0, with the load balance, from the steady solution of the scene under
/// the conditions at T = 0. Q = rho_bar H; where mass is conserved, Q <= rho_bar H is an unknown where P = 0
/// (reynolds/content.hpp). IDA's BDF of variable order and step; multigrid cycles solve every implicit step. After a
/// jump of load or speed the integration starts again behind a few very short steps.
/// in: coupling, an effect on the coefficients; scene and its solution; conditions with load > 0 at all times and u1 +
/// u2 > 0 at T = 0; if u1 + u2 may become negative, a grid with X_a = -X_b and a gap without a term X Y; from: a
/// checkpoint of the same integration, which continues at order one with a shorter step and counts its report from
/// zero. errors: core::SolverError if the state at T = 0 cannot be solved; core::FileError if the checkpoint belongs to
/// another grid.
MarchReport march(const steady::Scene& scene, const steady::Solution& start, const Conditions& conditions,
                  const MarchParameters& parameters, const Observer& observer, const Checkpoint* from = nullptr,
                  const Coupling* coupling = nullptr);

}  // namespace ehl::transient
