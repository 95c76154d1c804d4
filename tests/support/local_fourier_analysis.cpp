#include "support/local_fourier_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "kernel/influence.hpp"

namespace ehl::tests {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double two_over_pi_squared = 2.0 / (pi * pi);

double away(double theta) { return theta > 0.0 ? theta - pi : theta + pi; }

double sinc(double t) { return t == 0.0 ? 1.0 : std::sin(t) / t; }

// The terms of Poisson's sum alternate in sign and decay slowly. A weight that fades over the outer half makes the
// truncation error negligible.
constexpr int terms = 24;
double fading(int m, int last) {
  const int outer = std::abs(m) - last / 2;
  if (outer <= 0) return 1.0;
  const double c = std::cos(0.5 * pi * outer / (last / 2 + 1));
  return c * c;
}

Complex wedge_symbol(reynolds::Wedge wedge, double theta_x) {
  const Complex one_back = std::polar(1.0, -theta_x);
  if (wedge == reynolds::Wedge::upstream2) return 1.5 - 2.0 * one_back + 0.5 * one_back * one_back;
  return 1.0 - one_back;
}

Complex film_symbol(reynolds::Wedge wedge, const Mode& at) { return -wedge_symbol(wedge, at.theta.x) * at.kernel; }

Complex poiseuille_symbol(double e, Frequency theta, double stretch) {
  return -e / stretch * (2.0 - 2.0 * std::cos(theta.x)) - e * stretch * (2.0 - 2.0 * std::cos(theta.y));
}

struct Shares {
  double along = 0.0, across = 0.0;
};
Shares shares_of(const LineRelaxation& relaxation) {
  if (!relaxation.distributed) return {};
  const double across2 = relaxation.by_mesh_size ? relaxation.stretch * relaxation.stretch : 1.0;
  return {0.5 / (1.0 + across2), 0.5 * across2 / (1.0 + across2)};
}

// The pressure change caused by a unit delta: 1 minus the shares of the four neighbours.
double distribution_symbol(const LineRelaxation& relaxation, Frequency theta) {
  const Shares share = shares_of(relaxation);
  return 1.0 - 2.0 * (share.along * std::cos(theta.x) + share.across * std::cos(theta.y));
}

// The coefficient K, or its distributed form Delta K, at distance d along the line.
double influence_on_line(const LineRelaxation& relaxation, int d) {
  const double hy = 1.0 / relaxation.stretch;
  const auto K = [hy](int a, int b) { return kernel::influence(a, b, 1.0, hy); };
  const Shares share = shares_of(relaxation);
  return K(d, 0) - share.along * (K(d - 1, 0) + K(d + 1, 0)) - 2.0 * share.across * K(d, 1);
}

// The symbol of the system of one line, eqs. (12)-(13) or (16)-(17): the effect of the line's
// deltas on its own equations.
Complex line_symbol(const LineRelaxation& relaxation, double e, reynolds::Wedge wedge, double theta_x) {
  const double cosine = std::cos(theta_x);
  // The change of the line itself, and the part that its neighbour lines take from it.
  const Shares share = shares_of(relaxation);
  const double on_line = 1.0 - 2.0 * share.along * cosine;
  const double beside = -share.across;
  double film = 0.0;
  for (int d = 0; d <= relaxation.reach; ++d)
    film += (d == 0 ? 1.0 : 2.0 * std::cos(d * theta_x)) * two_over_pi_squared * influence_on_line(relaxation, d);
  const double e_x = e / relaxation.stretch;
  const double e_y = e * relaxation.stretch;
  return (2.0 * e_x * (cosine - 1.0) - 2.0 * e_y) * on_line + 2.0 * e_y * beside - wedge_symbol(wedge, theta_x) * film;
}

using Matrix4 = std::array<std::array<Complex, 4>, 4>;

Matrix4 product(const Matrix4& a, const Matrix4& b) {
  Matrix4 result{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t j = 0; j < 4; ++j) result[i][j] += a[i][k] * b[k][j];
  return result;
}

// The limit of |T^n|^(1/n), evaluated for n = 2^20 by repeated squaring. The norm is the largest entry.
double spectral_radius(Matrix4 matrix) {
  constexpr int squarings = 20;
  double logarithm = 0.0;
  for (int k = 0; k <= squarings; ++k) {
    double norm = 0.0;
    for (const auto& row : matrix)
      for (const Complex& entry : row) norm = std::max(norm, std::abs(entry));
    if (norm == 0.0) return 0.0;
    logarithm += std::log(norm) / std::exp2(k);
    for (auto& row : matrix)
      for (Complex& entry : row) entry /= norm;
    matrix = product(matrix, matrix);
  }
  return std::exp(logarithm);
}

Matrix4 sweep_of_harmonics(const LineRelaxation& relaxation, double e, reynolds::Wedge wedge,
                           const Harmonics& harmonics) {
  Matrix4 all{};
  for (std::size_t pair = 0; pair < 2; ++pair) {
    const SweepMatrix matrix = sweep_matrix(relaxation, e, wedge, harmonics.pairs[pair]);
    for (std::size_t row = 0; row < 2; ++row)
      for (std::size_t column = 0; column < 2; ++column) all[2 * pair + row][2 * pair + column] = matrix[row][column];
  }
  return all;
}

// The coarse-grid correction I - P L_coarse^-1 R L.
Matrix4 coarse_grid_correction(double e, reynolds::Wedge wedge, const Harmonics& harmonics) {
  const Complex coarse = equation_symbol(e, wedge, harmonics.coarse, 2.0);
  std::array<double, 4> transfer{};
  std::array<Complex, 4> residual{};
  for (std::size_t k = 0; k < 4; ++k) {
    const Mode& at = harmonics.pairs[k / 2][k % 2];
    transfer[k] = 0.25 * (1.0 + std::cos(at.theta.x)) * (1.0 + std::cos(at.theta.y));
    residual[k] = equation_symbol(e, wedge, at);
  }
  Matrix4 correction{};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t from = 0; from < 4; ++from)
      correction[k][from] = (k == from ? 1.0 : 0.0) - transfer[k] * transfer[from] * residual[from] / coarse;
  return correction;
}

}  // namespace

double kernel_symbol(Frequency theta, double stretch) {
  double sum = 0.0;
  const int along = static_cast<int>(terms * stretch);  // both directions reach equally far
  for (int m = -along; m <= along; ++m) {
    const double t_x = theta.x + 2.0 * pi * m;
    const double along_x = fading(m, along) * sinc(0.5 * t_x);
    for (int n = -terms; n <= terms; ++n) {
      const double t_y = theta.y + 2.0 * pi * n;
      sum += along_x * fading(n, terms) * sinc(0.5 * t_y) * 2.0 * pi / std::hypot(t_x, stretch * t_y);
    }
  }
  return two_over_pi_squared * sum;
}

std::array<Mode, 2> mode_pair(Frequency theta, double stretch) {
  return {mode(theta, stretch), mode({theta.x, away(theta.y)}, stretch)};
}

Complex equation_symbol(double e, reynolds::Wedge wedge, const Mode& at, double cell, double stretch) {
  return poiseuille_symbol(e / (cell * cell), at.theta, stretch) + film_symbol(wedge, at);
}

SweepMatrix sweep_matrix(const LineRelaxation& relaxation, double e, reynolds::Wedge wedge,
                         const std::array<Mode, 2>& pair) {
  const Complex line = line_symbol(relaxation, e, wedge, pair[0].theta.x);
  // For each frequency: the pressure change per delta, including the weight, and the change of L that the deltas cause.
  std::array<double, 2> change{};
  std::array<Complex, 2> poiseuille{};
  std::array<Complex, 2> film{};
  for (std::size_t k = 0; k < 2; ++k) {
    change[k] = relaxation.weight * distribution_symbol(relaxation, pair[k].theta);
    poiseuille[k] = poiseuille_symbol(e, pair[k].theta, relaxation.stretch) / line;
    film[k] = film_symbol(wedge, pair[k]) / line;
  }
  SweepMatrix sweep{};
  if (relaxation.ordering != Ordering::two_colours) {
    for (std::size_t k = 0; k < 2; ++k) {
      // The preceding line has already changed, which adds e exp(-i theta_y) delta to the left-hand side.
      const bool after = relaxation.ordering == Ordering::lexicographic;
      const Complex before = after ? 1.0 + e * relaxation.stretch * std::polar(1.0, -pair[k].theta.y) / line : 1.0;
      sweep[k][k] = 1.0 - change[k] * (poiseuille[k] + film[k]) / before;
    }
    return sweep;
  }
  // The restriction to the odd lines, (1 - (-1)^j)/2, couples the two frequencies with +-1/2; that to the
  // even lines is (1 + (-1)^j)/2.
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t from = 0; from < 2; ++from) {
      const double odd = k == from ? 0.5 : -0.5;
      sweep[k][from] = (k == from ? 1.0 : 0.0) - change[k] * odd * (poiseuille[from] + film[from]);
    }
  const SweepMatrix first = sweep;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t from = 0; from < 2; ++from) {
      Complex deltas = 0.5 * film[from];
      for (std::size_t via = 0; via < 2; ++via) deltas += 0.5 * poiseuille[via] * first[via][from];
      sweep[k][from] -= change[k] * deltas;
    }
  return sweep;
}

double spectral_radius(const SweepMatrix& matrix) {
  const Complex half_trace = 0.5 * (matrix[0][0] + matrix[1][1]);
  const Complex determinant = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
  const Complex root = std::sqrt(half_trace * half_trace - determinant);
  return std::max(std::abs(half_trace + root), std::abs(half_trace - root));
}

double smoothing_factor(const SweepMatrix& matrix, Frequency theta) {
  return std::abs(theta.x) < 0.5 * pi ? std::abs(matrix[1][1]) : spectral_radius(matrix);
}

LocalFourierAnalysis::LocalFourierAnalysis(int per_quarter) {
  // theta_y -> -theta_y and complex conjugation change nothing, so theta_x, theta_y > 0 suffice.
  const double step = 0.5 * pi / per_quarter;
  for (int a = 0; a < per_quarter; ++a)
    for (int b = 0; b < per_quarter; ++b) {
      const Frequency theta{(a + 0.5) * step, (b + 0.5) * step};
      all_.push_back({{mode_pair(theta), mode_pair({away(theta.x), theta.y})}, mode({2.0 * theta.x, 2.0 * theta.y})});
    }
}

Analysis LocalFourierAnalysis::analyse(const LineRelaxation& relaxation, double e, reynolds::Wedge wedge, int pre,
                                       int post) const {
  Analysis result;
  for (const Harmonics& harmonics : all_) {
    for (const std::array<Mode, 2>& pair : harmonics.pairs) {
      const double factor = smoothing_factor(sweep_matrix(relaxation, e, wedge, pair), pair[0].theta);
      if (factor > result.smoothing) {
        result.smoothing = factor;
        result.slowest = pair[0].theta;
      }
    }
    const Matrix4 sweep = sweep_of_harmonics(relaxation, e, wedge, harmonics);
    result.low = std::max(result.low, std::abs(sweep[0][0]));
    Matrix4 cycle = coarse_grid_correction(e, wedge, harmonics);
    for (int k = 0; k < pre; ++k) cycle = product(cycle, sweep);
    for (int k = 0; k < post; ++k) cycle = product(sweep, cycle);
    result.two_grid = std::max(result.two_grid, spectral_radius(cycle));
  }
  return result;
}

AnalysisAcross::AnalysisAcross(double stretch, int per_quarter) : stretch_(stretch) {
  const double step = 0.5 * pi / per_quarter;
  for (int a = 0; a < 2 * per_quarter; ++a)
    for (int b = 0; b < per_quarter; ++b) {
      const Frequency theta{(a + 0.5) * step, (b + 0.5) * step};
      all_.push_back({mode_pair(theta, stretch), mode({theta.x, 2.0 * theta.y}, 0.5 * stretch)});
    }
}

Analysis AnalysisAcross::analyse(LineRelaxation relaxation, double e, reynolds::Wedge wedge, int pre, int post) const {
  relaxation.stretch = stretch_;
  Analysis result;
  const auto product = [](const SweepMatrix& a, const SweepMatrix& b) {
    SweepMatrix c{};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t j = 0; j < 2; ++j) c[i][j] += a[i][k] * b[k][j];
    return c;
  };
  for (const auto& [fine, coarse] : all_) {
    const SweepMatrix sweep = sweep_matrix(relaxation, e, wedge, fine);
    if (const double factor = std::abs(sweep[1][1]); factor > result.smoothing) {
      result.smoothing = factor;
      result.slowest = fine[0].theta;
    }
    if (fine[0].theta.x < 0.5 * pi) result.low = std::max(result.low, std::abs(sweep[0][0]));
    const Complex below = equation_symbol(0.5 * e, wedge, coarse, 1.0, 0.5 * stretch_);
    SweepMatrix cycle{};  // I - P L_coarse^-1 R L
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t from = 0; from < 2; ++from) {
        const auto transfer = [&](std::size_t of) { return 0.5 * (1.0 + std::cos(fine[of].theta.y)); };
        cycle[k][from] = (k == from ? 1.0 : 0.0) -
                         transfer(k) * transfer(from) * equation_symbol(e, wedge, fine[from], 1.0, stretch_) / below;
      }
    for (int k = 0; k < pre; ++k) cycle = product(cycle, sweep);
    for (int k = 0; k < post; ++k) cycle = product(sweep, cycle);
    result.two_grid = std::max(result.two_grid, spectral_radius(cycle));
  }
  return result;
}

}  // namespace ehl::tests
