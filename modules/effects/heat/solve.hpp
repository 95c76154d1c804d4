#pragma once
// Steady contact with heat, starting from the isothermal solution of the same scene.
#include <cmath>
#include <string>
#include <vector>

#include "effects/heat/passes.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"
#include "thermal/film_temperature.hpp"

namespace ehl::heat {

/// A temperature and its place, in Hertz radii.
struct Hottest {
  double theta = 0.0, X = 0.0, Y = 0.0;
  double error = std::numeric_limits<double>::quiet_NaN();  ///< relative discretization error
};

/// One grid of the sequence.
struct Row {
  int nx = 0, ny = 0, passes = 0;
  double Hc = 0.0, Hm = 0.0, mu = 0.0, film = 0.0, surface_1 = 0.0, surface_2 = 0.0;  ///< theta
  double defect = 0.0, seconds = 0.0;
  /// These three temperatures again, but only downstream where the dry contact pressure is below 0.8 of its maximum:
  /// the place of a pressure spike, which heats the oil by compression.
  double film_behind = NAN, surface_1_behind = NAN, surface_2_behind = NAN;
};

/// On the whole domain; temperatures in kelvin above T0.
struct Fields {
  core::Field I0;        ///< mean fluidity over that at T0: the film shears like one of viscosity 1/I0
  core::Field less_tau;  ///< factor on tau_m from shear thinning by the pressure flow
  core::Field mid, largest, surface_1, surface_2;
  core::Field section_T, section_u;  ///< columns x nodes across the film, at Y = 0; u in u_m
};

/// A thermal solution: film, heat balance, temperatures with errors, and the sequence of grids.
struct Solution {
  steady::Solution film{};  ///< with heat; the isothermal solution if none was attempted
  thermal::Balance balance{};
  Hottest in_film{}, on_1{}, on_2{};
  double mean = 0.0;              ///< mean theta of the pressurised film, weighted with P
  double C = 1.0;                 ///< at (0, 0); the surfaces carry rho_bar H C
  double inlet = 0.0;             ///< mid-film theta at X = -1, Y = 0
  double nahme = 0.0;             ///< largest beta tau_m |u1 - u2| h/k
  bool spike_unresolved = false;  ///< as in error_bars.hpp; in_film then has no error
  bool undone = false;            ///< true if no cycle converged with the temperature of the last iteration
  Fields fields{};
  std::vector<Row> rows{};  ///< coarse to fine
  double seconds = 0.0;     ///< without the isothermal solution
  std::size_t bytes = 0;
};

/// Thermal solutions on up to three grids: the coarsest starts from the isothermal pressure, each finer one from
/// pressure and temperatures of the coarser ones. If the coarser grids fail, the finest starts from the isothermal
/// pressure. Converged if the passes on the finest grid are (passes.hpp). in: setup, whose patch is set here; a
/// converged isothermal solution on the scene's grid. errors: core::Interrupted.
Solution solve(const steady::Scene& scene, const thermal::Setup& setup, const Tuning& tuning,
               const steady::Solution& isothermal, const steady::ProgressCallback& progress);

}  // namespace ehl::heat
