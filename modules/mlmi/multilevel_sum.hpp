#pragma once
// Multilevel multi-integration with alternating semi-coarsening: w = K*u in O(n) work on the fine grids plus one sum
// over all pairs of points on the coarsest.
#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/kernel.hpp"
#include "mlmi/buffer.hpp"
#include "mlmi/direct_sum.hpp"
#include "mlmi/fourier_convolution.hpp"
#include "mlmi/semi_coarsening.hpp"

namespace ehl::mlmi {

struct MultilevelChoice {
  int order = 6;                 ///< 2p
  int patch_along = 7;           ///< m1 [points]
  int patch_across = 2;          ///< m2 [point distances of the direction being coarsened]
  int coarsenings = 2;           ///< x, y, x, ...
  bool coarsest_direct = false;  ///< else by Fourier transform
};

/// True if MultilevelSum can use an axis of symmetry at the end of y.
bool holds_mirror(const Axis& y, const MultilevelChoice& choice);

/// w_ij = factor sum_kl K(i-k, j-l) u_kl on x points x y points, y contiguous. Owns every level. limits: where y ends
/// at an axis of symmetry, an even number of coarsenings, the coarsest sum by Fourier transform, and a last point that
/// every coarsening of y keeps (holds_mirror). source: Brandt and Lubrecht, J. Comput. Phys. 90 (1990) 348;
/// semi-coarsening: Venner and Lubrecht, Multilevel Methods in Lubrication (2000).
class MultilevelSum {
 public:
  MultilevelSum(const Axis& x, const Axis& y, const MultilevelChoice& choice, const kernel::Kernel& kernel,
                int threads);

  /// w = factor K*u. in: u, row i at u + i stride_u, rows allocated to a multiple of 8. out: w in the same layout; its
  /// columns are written up to a multiple of 8.
  void apply(const double* u, std::ptrdiff_t stride_u, double* w, std::ptrdiff_t stride_w);

  int coarsest_rows() const { return coarsest_rows_; }
  /// Columns of the coarsest grid in the whole domain.
  int coarsest_columns() const { return coarsest_columns_; }
  std::size_t bytes() const;

 private:
  // The arrays of one coarse grid.
  struct Coarse {
    std::ptrdiff_t stride;
    Buffer u, w;
  };
  std::vector<SemiCoarsening> steps_;  // the finest first
  std::vector<Coarse> grids_;          // grids_[l] belongs below steps_[l]
  int coarsest_rows_ = 0;
  int coarsest_columns_ = 0;
  std::optional<FourierConvolution> fourier_;
  std::optional<DirectSum> direct_;
};

}  // namespace ehl::mlmi
