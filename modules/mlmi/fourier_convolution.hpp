#pragma once
// The sum w = K*u over all pairs of points by zero-padded Fourier transforms, exact to rounding.
#include <cstddef>
#include <vector>

#include "kernel/influence.hpp"
#include "mlmi/buffer.hpp"
#include "mlmi/fourier_transform.hpp"

namespace ehl::mlmi {

/// The smallest even 2^a 3^b 5^c that is at least n.
int padded_length(int n);

/// w_ij = factor sum_kl K(i-k, j-l) u_kl for arrays of rows x columns points, the columns contiguous. Owns the real
/// spectrum of the symmetric kernel, the plans and the work space. cost: O(N ln N); rows of u that are zero at both
/// ends of the array are not transformed.
///
/// Even: the last column is an axis of symmetry, and the sum includes the images of the others. Rows that are even
/// about it have real spectra, and two of these make one complex column for the second transform: half of the work.
class FourierConvolution {
 public:
  struct Shape {
    int rows = 0;
    int columns = 0;    ///< stored columns
    bool even = false;  ///< symmetric about the last column
    /// Columns of the whole array.
    int all_columns() const { return even ? 2 * columns - 1 : columns; }
  };
  /// in: kernel table with n_x >= rows-1 (first offset), n_y >= all_columns-1.
  FourierConvolution(const Shape& shape, const kernel::InfluenceTable& kernel, double factor, int threads);

  /// in: u, row i at u + i stride_u. out: w, row i at w + i stride_w. limits: u and w do not overlap.
  void apply(const double* u, std::ptrdiff_t stride_u, double* w, std::ptrdiff_t stride_w);

  std::size_t bytes() const;

 private:
  // Plans and work space of one thread.
  struct Worker {
    RealTransform row;
    ColumnTransform column;
    Buffer real, complex, block, transformed;
  };
  void prepare_spectrum(const kernel::InfluenceTable& kernel, double factor);
  void row_forward(const double* u, Worker& worker, double* spectrum) const;
  void row_inverse(double* spectrum, Worker& worker, double* w) const;
  void multiply(const double* kernel, double* transformed) const;
  void convolve_block(int block, int first, int last, Worker& worker);

  Shape shape_;
  int length_rows_, length_columns_;  // padded numbers of rows and columns
  int numbers_;                       // doubles in the spectrum of a row, complex or real
  int blocks_;                        // blocks of ColumnTransform::columns complex columns
  std::ptrdiff_t stride_;             // doubles per row of the half transformed array
  Buffer half_;                       // rows x numbers, with the rows transformed
  Buffer spectrum_;                   // of the kernel, block by block; rows 0 .. length/2
  std::vector<Worker> workers_;
};

}  // namespace ehl::mlmi
