#pragma once
// Decimation: odd-even reduction of the band. Points are collected in blocks as wide as the band, which makes the
// system block tridiagonal. Every second block is eliminated, repeatedly, until one is left; then the solution is
// substituted back.
#include <vector>

#include "line_solvers/line_system.hpp"

namespace ehl::line_solvers {

/// Solves the band by decimation for a batch of lines at once.
/// cost: about (14/3 m^3) / m multiplications per point with block width m = lower; parallel depth log2(points/m).
template <int reach>
class Decimation {
  using Row = BandRow<reach>;

 public:
  static constexpr int width = Row::lower;

  /// in: points of a line, numbered 1..points. Allocates; solve() does not.
  explicit Decimation(int points);

  /// Sets the row of point i = 1..points.
  void set(int i, const Row& row);

  /// Solves for all delta. Every row must be set again before the next solution. out: the first small pivot, if any,
  /// with its point. Since the order of elimination is not that of the points, it may be another pivot than that of
  /// Elimination.
  SmallPivot solve();

  /// The solution of point i; valid after solve().
  const Lanes& delta(int i) const {
    return levels_[0].x[static_cast<std::size_t>((i - 1) / width)][static_cast<std::size_t>((i - 1) % width)];
  }

 private:
  using Vector = std::array<Lanes, static_cast<std::size_t>(width)>;
  using Matrix = std::array<Vector, static_cast<std::size_t>(width)>;
  /// Block rows left x_{b-1} + middle x_b + right x_{b+1} = rhs.
  struct Level {
    std::vector<Matrix> left, middle, right;
    std::vector<Vector> rhs, x;
  };

  static void multiply_subtract(const Matrix& a, const Matrix& b, Matrix& c);
  static void multiply_subtract(const Matrix& a, const Vector& b, Vector& c);
  /// Replaces left, right and rhs of block b by middle^-1 times themselves.
  void divide_by_middle(Level& level, std::size_t b, int points_per_block, SmallPivot& small);
  void reduce(Level& fine, Level& coarse, int points_per_block, SmallPivot& small);
  static void expand(Level& fine, const Level& coarse);

  int points_;
  std::vector<Level> levels_;
};

}  // namespace ehl::line_solvers
