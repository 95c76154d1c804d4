#pragma once
// Local Fourier analysis of the line relaxations for the linear model problem of eq. (10), with the full discrete
// kernel. It predicts the convergence of relaxation and of two-grid cycles far from boundaries.
//
//   L(P) = e (P_W + P_E + P_S + P_N - 4 P) - wedge(K*P),   e = epsilon/h^2,   unit mesh size, K with 2/pi^2
//
// The factors h of K and 1/h of the wedge cancel. On stretched cells, hx = s hy and e = epsilon/(hx hy); the
// coefficients are e/s along X and e s along Y, and hx is the unit of length. A sweep multiplies an error exp(i(theta_x
// i + theta_y j)) by a number or, if two colours couple theta_y and theta_y + pi, by a matrix.
#include <array>
#include <complex>
#include <vector>

#include "reynolds/wedge.hpp"

namespace ehl::tests {

enum class Ordering {
  simultaneous,   ///< Jacobi: all lines use the old pressure
  lexicographic,  ///< Gauss-Seidel: the Poiseuille terms of a line use the new pressure of the preceding line
  two_colours     ///< odd lines first; the Poiseuille terms of the even lines then use the new
                  ///< pressures of the odd ones
};

/// In all orderings the film thickness is updated once, after the sweep.
struct LineRelaxation {
  bool distributed = false;  ///< eq. (15): distributive relaxation, each change subtracts a
                             ///< quarter from the four neighbours
  Ordering ordering = Ordering::two_colours;
  double weight = 1.0;
  int reach = 1;         ///< terms of the truncated film equation on each side
  double stretch = 1.0;  ///< hx/hy
  /// A distributed change subtracts from its neighbours in proportion to 1/h^2; if false, a quarter from each.
  bool by_mesh_size = true;
};

/// The relaxations of Venner and ten Napel (1992), section 3.3.1.
inline constexpr LineRelaxation papers_distributive{true, Ordering::simultaneous, 0.6};
inline constexpr LineRelaxation papers_gauss_seidel{false, Ordering::lexicographic, 1.0};

struct Frequency {
  double x = 0.0;
  double y = 0.0;
};

using Complex = std::complex<double>;
/// The effect of one sweep on the amplitudes of the frequencies theta and theta + (0, pi).
using SweepMatrix = std::array<std::array<Complex, 2>, 2>;

/// Symbol of the influence coefficients for square cells of size 1 (eq. 6, with 2/pi^2). K is 1/r averaged over a cell
/// and sampled, so Poisson's summation formula gives
///   (2/pi^2) sum_mn (2 pi/|t|) sinc(t_x/2) sinc(t_y/2),   t = theta + 2 pi (m, n).
/// limits: theta not a multiple of 2 pi. accuracy: about 1e-6. For stretched cells |t| is that of (t_x, stretch t_y).
double kernel_symbol(Frequency theta, double stretch = 1.0);

/// A frequency with the symbol of the kernel, which is expensive to compute.
struct Mode {
  Frequency theta;
  double kernel = 0.0;
};
inline Mode mode(Frequency theta, double stretch = 1.0) { return {theta, kernel_symbol(theta, stretch)}; }
/// The modes of theta and theta + (0, pi).
std::array<Mode, 2> mode_pair(Frequency theta, double stretch = 1.0);

/// Symbol of L. in: theta, per cell of a grid whose mesh size is `cell` times that of e.
Complex equation_symbol(double e, reynolds::Wedge wedge, const Mode& at, double cell = 1.0, double stretch = 1.0);

SweepMatrix sweep_matrix(const LineRelaxation& relaxation, double e, reynolds::Wedge wedge,
                         const std::array<Mode, 2>& pair);

double spectral_radius(const SweepMatrix& matrix);

/// The smoothing factor of one sweep for the frequencies theta and theta + (0, pi): the reduction of the part of the
/// error that a grid with twice the mesh size cannot represent. in: |theta_x| <= pi, |theta_y| <= pi/2.
double smoothing_factor(const SweepMatrix& matrix, Frequency theta);

struct Analysis {
  double smoothing = 0.0;  ///< mu: the largest smoothing factor
  Frequency slowest;       ///< the frequency of the largest factor
  double low = 0.0;        ///< largest amplification of smooth errors
  double two_grid = 0.0;   ///< convergence factor of a two-grid cycle: full weighting, bilinear interpolation, exact
                           ///< solution on the coarse grid
};

/// A frequency and the three frequencies that alias with it on a grid with twice the mesh size,
/// and their mode on that grid.
struct Harmonics {
  std::array<std::array<Mode, 2>, 2> pairs;  ///< first index: theta_x low, high; second: theta_y low, high
  Mode coarse;
};

/// The analysis over the frequencies (k + 1/2) pi/(2 per_quarter) in each direction.
class LocalFourierAnalysis {
 public:
  explicit LocalFourierAnalysis(int per_quarter = 32);
  Analysis analyse(const LineRelaxation& relaxation, double e, reynolds::Wedge wedge, int pre = 2, int post = 1) const;

 private:
  std::vector<Harmonics> all_;
};

/// The analysis of cycles that coarsen in Y only (semi-coarsening). The smoothing factor is then that of all
/// frequencies with high theta_y. The fine cells have the ratio `stretch`, the coarse cells half of it.
class AnalysisAcross {
 public:
  explicit AnalysisAcross(double stretch, int per_quarter = 24);
  Analysis analyse(LineRelaxation relaxation, double e, reynolds::Wedge wedge, int pre = 2, int post = 1) const;

 private:
  struct Pair {
    std::array<Mode, 2> fine;  ///< theta_y low, high
    Mode coarse;
  };
  double stretch_;
  std::vector<Pair> all_;
};

}  // namespace ehl::tests
