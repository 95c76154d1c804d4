#pragma once
// Everything a steady computation needs to know, dimensionless.
#include "core/grid.hpp"
#include "fmg/parameters.hpp"
#include "mlmi/deformation.hpp"
#include "reynolds/wedge.hpp"
#include "rheology/laws.hpp"

namespace ehl::steady {

struct Scene {
  double M = 0.0;       ///< Moes' load parameter: for the first guess only
  double L = 0.0;       ///< Moes' material parameter: likewise
  double lambda = 0.0;  ///< 6 eta0 u_s R_x^2 / (a^3 p_h)
  rheology::ViscosityLaw viscosity;
  rheology::DensityLaw density;
  core::Grid grid;  ///< the finest grid
  reynolds::Wedge wedge = reynolds::Wedge::upstream2;
  mlmi::Parameters deformation;
  fmg::Parameters multigrid;
  int threads = 1;
};

}  // namespace ehl::steady
