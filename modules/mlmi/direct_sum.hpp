#pragma once
// The sum w = K*u over all pairs of points, term by term: the reference of the tests.
#include <cstddef>

#include "kernel/influence.hpp"

namespace ehl::mlmi {

/// w_ij = factor sum_kl K(i-k, j-l) u_kl, terms added in storage order. Shapes as in FourierConvolution.
/// cost: O(N^2), N = rows x columns; points with u = 0 cost nothing.
class DirectSum {
 public:
  DirectSum(int rows, int columns, const kernel::InfluenceTable& kernel, double factor, int threads);
  void apply(const double* u, std::ptrdiff_t stride_u, double* w, std::ptrdiff_t stride_w) const;
  std::size_t bytes() const { return kernel_.size() * sizeof(double); }

 private:
  int rows_, columns_, threads_;
  std::vector<double> kernel_;  // factor K(d, e): rows d = 0..rows-1, e = -(columns-1)..columns-1
};

}  // namespace ehl::mlmi
