#pragma once
// Local Fourier analysis of the line relaxations on the linear model problem of eq. (10), with the full discrete
// kernel: what the relaxations and two grids should do far from boundaries.
//
//   L(P) = e (P_W + P_E + P_S + P_N - 4 P) - wedge(K*P),   e = epsilon/h^2,   unit mesh size, K with 2/pi^2
//
// (the factors h of K and 1/h of the wedge cancel). Of cells that are s times as long along X as across, hx = s hy:
// e = epsilon/(hx hy), e/s along X and e s across, hx the unit. An error exp(i(theta_x i + theta_y j)) is multiplied by
// a number or, where two colours couple theta_y and theta_y + pi, by a matrix.
#include <array>
#include <complex>
#include <vector>

#include "reynolds/wedge.hpp"

namespace ehl::tests {

enum class Ordering {
  simultaneous,   ///< Jacobi: every line sees the old pressure
  lexicographic,  ///< line after line; each sees the new pressure of the one before in the Poiseuille terms
  two_colours     ///< odd lines, then even ones with the new pressures of the first in the Poiseuille terms
};

/// In all orderings the film is renewed once, after the sweep.
struct LineRelaxation {
  bool distributed = false;  ///< eq. (15): each change takes a quarter from the four neighbours
  Ordering ordering = Ordering::two_colours;
  double weight = 1.0;
  int reach = 1;         ///< terms of the truncated film equation on each side
  double stretch = 1.0;  ///< hx/hy
  /// A distributed change takes from its four neighbours in proportion to 1/h^2; else a quarter from each.
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
/// Acts on (theta, theta + (0, pi)): what one sweep does to the amplitudes of the two.
using SweepMatrix = std::array<std::array<Complex, 2>, 2>;

/// Symbol of the influence coefficients of square cells of size 1 (eq. 6, 2/pi^2 included). K is 1/r averaged over a
/// cell and sampled, so by Poisson's formula its symbol is
///   (2/pi^2) sum_mn (2 pi/|t|) sinc(t_x/2) sinc(t_y/2),   t = theta + 2 pi (m, n).
/// limits: theta not a multiple of 2 pi. accuracy: about 1e-6. Of stretched cells: |t| of (t_x, stretch t_y).
double kernel_symbol(Frequency theta, double stretch = 1.0);

/// A frequency and the symbol of the kernel there, which costs far more than the rest.
struct Mode {
  Frequency theta;
  double kernel = 0.0;
};
inline Mode mode(Frequency theta, double stretch = 1.0) { return {theta, kernel_symbol(theta, stretch)}; }
/// theta and theta + (0, pi).
std::array<Mode, 2> mode_pair(Frequency theta, double stretch = 1.0);

/// Symbol of L. in: theta per cell of a grid with mesh size `cell` times the one of e.
Complex equation_symbol(double e, reynolds::Wedge wedge, const Mode& at, double cell = 1.0, double stretch = 1.0);

SweepMatrix sweep_matrix(const LineRelaxation& relaxation, double e, reynolds::Wedge wedge,
                         const std::array<Mode, 2>& pair);

double spectral_radius(const SweepMatrix& matrix);

/// What one sweep leaves of the oscillating part of an error of the group theta, theta + (0, pi): the part that a grid
/// of twice the mesh size cannot represent. in: |theta_x| <= pi, |theta_y| <= pi/2.
double smoothing_factor(const SweepMatrix& matrix, Frequency theta);

struct Analysis {
  double smoothing = 0.0;  ///< mu: largest smoothing_factor
  Frequency slowest;       ///< and where it is
  double low = 0.0;        ///< largest factor on smooth errors
  double two_grid = 0.0;   ///< largest factor of a two-grid cycle: full weighting, bilinear, coarse grid solved exactly
};

/// A frequency, the three companions that a grid of twice the mesh size takes for the same, and what they are there.
struct Harmonics {
  std::array<std::array<Mode, 2>, 2> pairs;  ///< theta_x low and high; in each theta_y low and high
  Mode coarse;
};

/// The analysis on the frequencies (k + 1/2) pi/(2 per_quarter) in each direction.
class LocalFourierAnalysis {
 public:
  explicit LocalFourierAnalysis(int per_quarter = 32);
  Analysis analyse(const LineRelaxation& relaxation, double e, reynolds::Wedge wedge, int pre = 2, int post = 1) const;

 private:
  std::vector<Harmonics> all_;
};

/// The same of cycles whose coarse grid keeps all stations along X and every second line: smoothing is what a sweep
/// leaves where theta_y is high, whatever theta_x; the two grids are cells of `stretch` and of half of it.
class AnalysisAcross {
 public:
  explicit AnalysisAcross(double stretch, int per_quarter = 24);
  Analysis analyse(LineRelaxation relaxation, double e, reynolds::Wedge wedge, int pre = 2, int post = 1) const;

 private:
  struct Pair {
    std::array<Mode, 2> fine;  ///< theta_y low and high
    Mode coarse;
  };
  double stretch_;
  std::vector<Pair> all_;
};

}  // namespace ehl::tests
