#pragma once
// All input of a steady computation, dimensionless.
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "core/field.hpp"
#include "core/grid.hpp"
#include "film/model.hpp"
#include "kernel/kernel.hpp"
#include "mlmi/deformation.hpp"
#include "multigrid/boundary_film.hpp"
#include "multigrid/parameters.hpp"
#include "newton/tuning.hpp"
#include "reynolds/wedge.hpp"
#include "rheology/laws.hpp"
#include "rheology/shear.hpp"
#include "steady/scales.hpp"
#include "steady/tuning.hpp"

namespace ehl::steady {

/// Load continuation: solutions for one load after another, each started from the one before.
struct ContinuationParameters {
  enum class Path {
    automatic,  ///< if the full multigrid alone does not lead to a solution
    load,       ///< always
    off,        ///< never
  };
  Path path = Path::automatic;
  double load_ratio = core::unknown;  ///< first load over the scene's; NaN: chosen
  double step = 2.0;                  ///< factor between the first two loads; > 1
  int max_steps = 60;                 ///< rejected ones included
};

/// When Newton's method is used on the finest grid.
enum class Polish {
  fallback,  ///< if nothing else leads to a solution (Newton fallback)
  always,    ///< also after the cycles, down to rounding errors (Newton refinement)
  off,       ///< never
};

/// A required accuracy instead of a grid (accuracy.hpp).
struct AccuracyTarget {
  double error = core::unknown;                                 ///< relative, of Hc and Hm; NaN: the grid is given
  bool domain_is_free = false;                                  ///< the domain may grow
  int most_cells = 8192;                                        ///< along x
  double most_nodes = std::numeric_limits<double>::infinity();  ///< limit by the memory
  double bytes_per_node = core::unknown;                        ///< of a run, estimated; NaN: unknown
};

/// Several contacts one after another on the same track (passes.hpp): what a surface brings to the next one.
struct Passes {
  int number = 1;
  double returning = 1.0;  ///< share of the oil left behind that returns
  double renewed = 0.0;    ///< share of the scene's supply that is added before every pass
  double levelled = 0.0;   ///< share of the differences across the track that has levelled out
};

/// A solution on one grid, on the whole domain.
struct SolvedFilm {
  const core::Grid& grid;
  const core::Field& P;  ///< of the fluid
  const core::Field& H;
  double H00 = 0.0;
  const core::Field* I0 = nullptr;        ///< mean fluidity of a warm film over that of the oil; none: 1
  const core::Field* less_tau = nullptr;  ///< of the sliding stress, where the pressure's own flow thins; none: 1
  const core::Field* P_c = nullptr;       ///< pressure of touching surfaces; none: 0
};

/// Coatings on the bodies. E' of the scales (M, L, a, p_h) is that of uncoated bodies as compliant as these.
struct Coatings {
  double stiffness = 1.0;                   ///< E' of the scales over that of the bodies without their coatings
  std::vector<kernel::SmoothPart> parts{};  ///< of the kernel; none: no coatings
};

struct Scene {
  /// Load, oil and shape of the contact, and the film and sizes that follow; made by scales_of().
  ContactScales contact;
  double lambda = 0.0;  ///< 6 eta0 u_s R_x^2 / (a^3 p_h)
  Coatings coatings{};
  rheology::ViscosityLaw viscosity;
  rheology::DensityLaw density;
  /// Writes S(X, Y), the contribution of surfaces at rest to the gap, in a^2/R, as the mean over each node's cell.
  /// Empty: smooth. A relief that is not symmetric in Y forbids use_symmetry.
  std::function<void(const core::Patch& grid, core::Field& S)> surface{};
  /// Writes the pressure of the dry contact and returns its H00: the start if that is far from Hertz. Empty: Hertz.
  std::function<double(const core::Patch& grid, core::Field& P)> dry{};
  /// Why no other strategy follows a failed first start; it becomes the message of the failure. Empty: all are tried.
  std::string one_start_only{};
  std::optional<rheology::ShearThinning> thinning{};  ///< shear thinning; absent: Newtonian
  bool has_factors = false;  ///< an effect sets factors on the coefficients between cycles (film::FactorFields)
  std::optional<film::StressLimit> limit{};  ///< limiting stress in the film; only with thinning and factors
  /// Oil layer that the surfaces bring, in units of H (or mass over rho0): mass conserving inlet and cavity. Empty: the
  /// inlet is full.
  std::function<double(double Y)> supply{};
  /// Share of the supply on coarse grids, by their cells along X; empty: all of it.
  std::function<double(int nx)> supply_share{};
  /// The surfaces touch at a boundary film (mixed.hpp); absent: they do not touch.
  std::optional<multigrid::BoundaryFilm> boundary_film{};
  Passes passes{};  ///< if there is a supply
  core::Grid grid;  ///< the finest grid; with a required accuracy, the first one to be tried
  /// Pressure on the boundary and load outside the domain in closed form; else both are zero.
  bool far_field = false;
  reynolds::Wedge wedge = reynolds::Wedge::upstream2;
  reynolds::Face face = reynolds::Face::mean;
  mlmi::Parameters deformation;
  multigrid::Parameters solver;
  newton::Tuning newton;
  Tuning tuning;
  ContinuationParameters continuation;
  Polish polish = Polish::fallback;
  /// Adjoint error estimates of Hc and Hm, with the third-order wedge; else from the grid sequence alone.
  bool adjoint_errors = true;
  bool error_maps = false;  ///< also maps of where the errors arise
  /// Computes numbers from a solution of this scene. The solutions on all levels give each number an error bar
  /// (ErrorBars::observed). May be empty.
  std::function<std::vector<double>(const Scene& scene, const SolvedFilm& film)> observer{};
  AccuracyTarget accuracy;
  bool use_symmetry = true;  ///< compute one half of a grid that is symmetric in Y; differs by rounding only
  int threads = 1;
};

}  // namespace ehl::steady
