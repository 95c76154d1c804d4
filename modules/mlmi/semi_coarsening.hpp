#pragma once
// One semi-coarsening of multilevel multi-integration (Brandt and Lubrecht 1990): the sum on a grid from the sum on the
// grid that keeps every second point in one direction, by transfers in that direction only.
//
// Notation in one direction, P the interpolation of order 2p from even points J to all points:
//   anterpolation   u^H = P^T u                                            (K is smooth in its source point)
//   even points     w_2I   = w^H_I               + sum_j C(2I - j) u_j     (j odd, |2I - j| <= m1)
//   odd points      w_2I+1 = [P w^H corrected]   + sum_j C(2I+1 - j) u_j   (|2I+1 - j| <= m1)
// with the same correction C = K - P K, the interpolation error of the kernel at distance d. It decays like the 2p-th
// derivative of 1/r and is dropped outside a patch of |d| <= m1 points along and |e| <= m2 points across the direction.
#include <array>
#include <cstddef>
#include <vector>

#include "core/grid.hpp"
#include "kernel/kernel.hpp"
#include "mlmi/buffer.hpp"

namespace ehl::mlmi {

/// Distance outside the patch up to which the dropped part of the correction is summed [points]; it falls as d^-2p.
inline constexpr int margin = 12;

/// The points of one direction of one level: indices `first` to `last` in units of `every` fine cells of size h. Coarse
/// levels extend beyond the domain, since interpolation of order 2p near its edge needs points outside.
struct Axis {
  int first = 0;
  int last = 0;
  int every = 1;
  double h = 0.0;
  core::Edge end = core::Edge::zero;  ///< mirror: the images of the points follow the last one
  int points() const { return last - first + 1; }
};

/// Axis with every second point, extended as far as interpolation of order 2p to all points of the fine axis needs.
/// limits: the last point of an axis that ends in a mirror is even.
Axis coarsened(const Axis& fine, int order);

/// Weights of the central interpolation of order 2p = 4, 6, 8 halfway between points, from the middle outwards.
std::array<double, 4> midpoint_weights(int order);

/// The correction C(d, e), even in both offsets, on its patch. Entries inside the patch that are smaller than the
/// largest one just outside are dropped as well, so that every e has its own reach along d. The sum of all dropped
/// entries is kept, so that the correction of a constant is exact.
struct Correction {
  int along = 0;           ///< m1
  int across = 0;          ///< m2
  std::vector<int> reach;  ///< largest |d| kept for e = 0..m2
  std::vector<double> C;   ///< (m2+1) x (2 m1+1), d fastest
  double operator()(int d, int e) const { return row(e)[d]; }
  const double* row(int e) const { return C.data() + e * (2 * along + 1) + along; }
};

/// The correction of one coarsening. in: axes of the fine level; order 2p, m1 and m2. cost: some
/// thousand kernel values.
Correction correction(const Axis& along, const Axis& across, int order, int m1, int m2, const kernel::Kernel& kernel);

/// The transfers between one level and the next coarser one, with their work space. In the fine arrays the direction
/// that is coarsened is the slow one and the other is contiguous. The coarse arrays are transposed, so that the next
/// semi-coarsening, in the other direction, has its own as the slow one.
class SemiCoarsening {
 public:
  struct Shape {
    Axis along;   ///< direction that is coarsened
    Axis across;  ///< the other one
    int order = 6;
    int patch_along = 7;
    int patch_across = 2;
  };
  SemiCoarsening(const Shape& shape, const kernel::Kernel& kernel, int threads);

  /// u^H = P^T u, transposed. in: u, along.points() rows, each allocated to a multiple of 8: columns after the last may
  /// be read but are not used. out: coarse_u, across.points() rows of coarse().points().
  void anterpolate(const double* u, std::ptrdiff_t stride_u, double* coarse_u, std::ptrdiff_t stride_coarse) const;

  /// w from w^H (transposed) and the correction of u. Rows of w are written up to a multiple of 8 columns; rows of
  /// coarse_w must be allocated to a multiple of 8.
  void interpolate(const double* coarse_w, std::ptrdiff_t stride_coarse, const double* u, std::ptrdiff_t stride_u,
                   double* w, std::ptrdiff_t stride_w);

  const Axis& coarse() const { return coarse_; }
  std::size_t bytes() const;

 private:
  struct Arrays;
  template <int vectors>
  class Strip;

  Shape shape_;
  Axis coarse_;
  std::array<double, 4> weights_;
  Correction correction_;
  int ring_rows_;
  std::vector<Buffer> work_;  // one per thread
  Buffer zero_row_;
};

}  // namespace ehl::mlmi
