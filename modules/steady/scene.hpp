#pragma once
// Everything a steady computation needs to know, dimensionless.
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contact/ellipse.hpp"
#include "core/field.hpp"
#include "core/grid.hpp"
#include "film/model.hpp"
#include "fmg/parameters.hpp"
#include "mlmi/deformation.hpp"
#include "reynolds/wedge.hpp"
#include "rheology/laws.hpp"
#include "rheology/shear.hpp"

namespace ehl::steady {

/// Load continuation: solutions for one load after another, each from the one before.
struct ContinuationParameters {
  enum class Path {
    automatic,  ///< where the full multigrid alone does not lead to a solution
    load,       ///< always
    off,        ///< never
  };
  Path path = Path::automatic;
  double load_ratio = std::numeric_limits<double>::quiet_NaN();  ///< first load over the scene's; NaN: chosen
  double step = 2.0;                                             ///< factor between the first two loads; > 1
  int max_steps = 60;                                            ///< rejected ones included
};

/// Newton's method on the finest grid.
enum class Polish {
  rescue,  ///< where nothing else leads to a solution
  always,  ///< and after the cycles, down to rounding errors
  off,     ///< never
};

/// An accuracy to reach instead of a grid to compute on (accuracy.hpp).
struct AccuracyTarget {
  double error = std::numeric_limits<double>::quiet_NaN();  ///< relative, of Hc and Hm; NaN: the grid is what is given
  bool domain_is_free = false;                              ///< the domain may grow
  int most_cells = 8192;                                    ///< along x
  double most_nodes = std::numeric_limits<double>::infinity();       ///< that the memory holds
  double bytes_per_node = std::numeric_limits<double>::quiet_NaN();  ///< of a run, about; NaN: unknown, not reported
};

/// Contacts one after another on the same track (passes.hpp): what a surface brings to the next one.
struct Passes {
  int number = 1;
  double returning = 1.0;  ///< share of what leaves that comes back
  double renewed = 0.0;    ///< share of the scene's supply that is brought anew every time
  double levelled = 0.0;   ///< share of the differences across the track that has levelled out
};

struct Scene {
  double M = 0.0;       ///< Moes' load parameter: for guesses, and for the loads of a continuation
  double L = 0.0;       ///< Moes' material parameter: likewise
  double lambda = 0.0;  ///< 6 eta0 u_s R_x^2 / (a^3 p_h)
  contact::Ellipse shape;
  rheology::ViscosityLaw viscosity;
  rheology::DensityLaw density;
  /// Writes S(X, Y), what surfaces at rest add to the gap, in a^2/R: the mean over each node's cell. Empty: smooth. One
  /// that is not symmetric in Y forbids use_symmetry.
  std::function<void(const core::Patch& grid, core::Field& S)> surface{};
  /// Writes the pressure of the dry contact and gives its H00, to begin with where Hertz' is far from it. Empty: Hertz.
  std::function<double(const core::Patch& grid, core::Field& P)> dry{};
  /// Why no other strategy follows a first start that fails; the failure then says this. Empty: all are tried.
  std::string one_start_only{};
  std::optional<rheology::ShearThinning> thinning{};  ///< sliding that thins the oil; absent: Newtonian
  std::vector<film::CoefficientEffect> effects{};     ///< effects at the stage of the coefficients
  /// What the surfaces bring of oil, in units of H (or mass over rho0): a mass conserving inlet and cavity. Empty: the
  /// inlet is full.
  std::function<double(double Y)> supply{};
  /// What coarse grids get of it, by their cells along X; empty: all.
  std::function<double(int nx)> supply_share{};
  Passes passes{};  ///< where there is a supply
  core::Grid grid;  ///< the finest grid; where an accuracy is asked for, the first to be tried
  /// Pressure on the boundary and load outside of the domain in closed form; else none of them.
  bool far_field = false;
  reynolds::Wedge wedge = reynolds::Wedge::upstream2;
  reynolds::Face face = reynolds::Face::mean;
  mlmi::Parameters deformation;
  fmg::Parameters multigrid;
  ContinuationParameters continuation;
  Polish polish = Polish::rescue;
  /// The errors of Hc and Hm by the weights of what is left of the equations, with the third-order wedge; else from the
  /// levels alone.
  bool adjoint_errors = true;
  bool error_maps = false;  ///< and where they are made
  AccuracyTarget accuracy;
  bool use_symmetry = true;  ///< compute on one half of a grid that is symmetric in Y: the same but for rounding
  int threads = 1;
};

}  // namespace ehl::steady
