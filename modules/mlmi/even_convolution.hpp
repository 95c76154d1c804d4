#pragma once
// The sum w = K*u over the points of one line by a forward and a backward complex transform of half the length.
#include <cstddef>
#include <span>
#include <vector>

#include "mlmi/buffer.hpp"
#include "mlmi/fourier_transform.hpp"

namespace ehl::mlmi {

/// w_i = sum_k K(|i - k|) u_k, i, k = 0 .. n - 1, exact to rounding. Owns plan, spectrum and work space. Points 2k and
/// 2k + 1 of the zero-padded line are the real and the imaginary part of one number: a complex transform of half the
/// length takes as long as a real one, with the additional sums, and is planned faster. [bench: complex_line_transform]
/// cost: O(n ln n). An object serves one thread at a time.
class EvenConvolution {
 public:
  /// in: K(0) .. K(n - 1).
  explicit EvenConvolution(std::span<const double> kernel);

  /// w = K*u. limits: both have n values.
  void apply(std::span<const double> u, std::span<double> w);

  std::size_t bytes() const;

 private:
  /// For the k-th and the (half - k)-th number of a spectrum, times 1/half: mean and half difference of the kernel's
  /// real spectrum at k and at half - k, and cosine and sine of -2 pi k/length.
  struct Factor {
    double mean, difference, cosine, sine;
  };
  void multiply();

  std::size_t points_;
  int half_;  // half of the padded length
  ComplexTransform transform_;
  std::vector<Factor> factors_;  // k = 0 .. half/2
  Buffer line_, spectrum_;
};

}  // namespace ehl::mlmi
