#pragma once
// The steady contact with heat, from the isothermal solution of the same scene.
#include <cmath>
#include <string>
#include <vector>

#include "effects/heat/passes.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"
#include "thermal/film_temperature.hpp"

namespace ehl::heat {

/// A temperature and where it is, in Hertz radii.
struct Hottest {
  double theta = 0.0, X = 0.0, Y = 0.0;
  double error = std::numeric_limits<double>::quiet_NaN();  ///< relative, of the mesh
};

/// One grid of the sequence.
struct Row {
  int nx = 0, ny = 0, passes = 0;
  double Hc = 0.0, Hm = 0.0, mu = 0.0, film = 0.0, surface_1 = 0.0, surface_2 = 0.0;  ///< theta
  double defect = 0.0, seconds = 0.0;
  /// These are the same three temperatures downstream where the dry contact has less than 0.8 of its largest pressure:
  /// under a spike oil is hot by compression.
  double film_behind = NAN, surface_1_behind = NAN, surface_2_behind = NAN;
};

/// On the whole domain; temperatures in kelvin above T0.
struct Fields {
  core::Field I0;        ///< over the fluidity at T0: the film's friction is that of 1/I0
  core::Field less_tau;  ///< of it, where the pressure's own flow thins
  core::Field mid, largest, surface_1, surface_2;
  core::Field section_T, section_u;  ///< stations x nodes across, at Y = 0; u in u_m
};

struct Solution {
  steady::Solution film{};  ///< with heat; the isothermal one where heat was not tried
  thermal::Balance balance{};
  Hottest in_film{}, on_1{}, on_2{};
  double mean = 0.0;                                           ///< theta of the pressurised film, weighted with P
  double C = 1.0;                                              ///< at (0, 0): rho_bar H C is carried there
  double inlet = 0.0;                                          ///< theta of the middle of the film at X = -1, Y = 0
  double nahme = 0.0;                                          ///< largest beta tau_m |u1 - u2| h/k
  bool spike_unresolved = false;                               ///< error_bars.hpp: then in_film has no error
  double error_mu = std::numeric_limits<double>::quiet_NaN();  ///< relative, of the mesh
  Fields fields{};
  std::vector<Row> rows{};  ///< coarse to fine
  double seconds = 0.0;     ///< beyond the isothermal solution
  std::size_t bytes = 0;
};

/// Thermal solutions on up to three grids, the coarsest from the isothermal pressure, every finer one from the pressure
/// and the temperatures below; where that fails the finest from the isothermal pressure itself. Converged where the
/// passes on the finest grid are (passes.hpp). in: setup, of which patch is set here; a converged isothermal solution
/// on the scene's grid. errors: core::Interrupted.
Solution solve(const steady::Scene& scene, const thermal::Setup& setup, const steady::Solution& isothermal,
               const steady::ProgressCallback& progress);

}  // namespace ehl::heat
