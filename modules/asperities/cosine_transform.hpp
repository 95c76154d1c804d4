#pragma once
// The cosine transform of a cell that is mirrored at its edges.
#include <cstddef>
#include <vector>

#include "mlmi/buffer.hpp"
#include "mlmi/fourier_transform.hpp"

namespace ehl::asperities {

/// A rectangular cell of nx by ny points, x fastest, at the centres of dx by dy [m]. Mirrored at its edges it is one
/// period of an even, periodic surface, so its waves are cos(pi k x/Lx) cos(pi l y/Ly).
struct Cell {
  int nx = 0, ny = 0;  ///< even
  double dx = 0.0, dy = 0.0;

  std::size_t points() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
  double length_x() const { return nx * dx; }
  double length_y() const { return ny * dy; }
  double wave_number_x(int k) const;
  double wave_number_y(int l) const;
};

/// s_kl = sum_ij f_ij cos(pi k (2i+1)/(2 nx)) cos(pi l (2j+1)/(2 ny)), and back. The spectrum is stored with l fastest.
/// cost: four real transforms per row and column, a quarter of those of the mirrored cell.
/// source: Makhoul (1980), IEEE Trans. ASSP 28, 27: a cosine transform from one real transform of the same length.
class CosineTransform {
 public:
  CosineTransform(const Cell& cell, int threads);

  void forward(const std::vector<double>& values, std::vector<double>& spectrum);
  /// forward and then inverse returns the values. The spectrum is destroyed.
  void inverse(std::vector<double>& spectrum, std::vector<double>& values);

 private:
  // The transforms of one thread along x and y, and their work space.
  struct Worker {
    mlmi::RealTransform along_x, along_y;
    mlmi::Buffer row, waves;
  };
  enum class Way { forward, inverse };
  void rows(Way way, double* data, int length, int count, bool along_x);
  void transpose(const double* from, double* to, int rows, int columns) const;

  Cell cell_;
  std::vector<double> other_;                          // the array in the other order
  std::vector<double> cos_x_, sin_x_, cos_y_, sin_y_;  // of pi k/(2 n)
  std::vector<Worker> workers_;
};

/// Deformation of the cell by a pressure: u = sum over waves of 4/(E' q) times the wave of p, without a mean.
///
/// The wave p cos(q x) on a half-space gives u = 2 p/(E* q) cos(q x), and E* = E'/2. (Johnson, Contact Mechanics 1985,
/// section 13.2)
class CellDeformation {
 public:
  CellDeformation(const Cell& cell, double E_prime, int threads);
  void evaluate(const std::vector<double>& p, std::vector<double>& u);
  /// The pressure of a deformation, without a mean.
  void invert(const std::vector<double>& u, std::vector<double>& p);

 private:
  CosineTransform transform_;
  std::vector<double> response_, spectrum_;
};

}  // namespace ehl::asperities
