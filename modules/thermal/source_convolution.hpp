#pragma once
// The sum theta = G*q over all pairs of nodes for a kernel that is even across but not along the motion: by zero-padded
// Fourier transforms, exact up to rounding; of a line contact term by term.
#include <cstddef>
#include <variant>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "mlmi/buffer.hpp"
#include "mlmi/fourier_transform.hpp"
#include "thermal/moving_source.hpp"

namespace ehl::thermal {

/// theta_ij = sum_kl G(i-k, j-l) q_kl over all nodes of the domain; what stands behind a mirror is taken from its
/// image. cost: O(N ln N). The same bits for any number of threads.
class SourceConvolution {
 public:
  /// in: table with n_x >= domain.nx, n_y >= domain.ny.
  SourceConvolution(const core::Patch& patch, const SourceTable& table, int threads);

  /// in: q on the patch. out: theta on the patch. The two may be the same field.
  void apply(const core::Field& q, core::Field& theta);

  std::size_t bytes() const;

 private:
  struct Worker {
    mlmi::RealTransform row;
    mlmi::ColumnTransform column;
    mlmi::Buffer real, block, transformed;
  };
  void prepare_spectrum(const SourceTable& table);
  void convolve_block(int block, Worker& worker);

  core::Patch patch_;
  int length_rows_, length_columns_;  // padded
  int blocks_;                        // of columns of complex numbers
  std::ptrdiff_t stride_;             // doubles per row of the half transformed array
  mlmi::Buffer half_;                 // rows x numbers: transformed along the columns only
  mlmi::Buffer spectrum_;             // of the kernel, block by block
  std::vector<Worker> workers_;
};

/// The same of a line contact, along its one line: theta_i = sum_k G(i-k) q_k. Upstream of itself a fast body feels few
/// cells, and a plan of transforms takes as long as a hundred such sums. cost: nodes times entries that are not zero.
class LineConvolution {
 public:
  /// in: table with n_x >= domain.nx, of which the strips' own line (n_y = 0) is taken.
  LineConvolution(const core::Patch& patch, const SourceTable& table);

  /// in: q on the patch. out: theta, the same on all lines. The two may be the same field.
  void apply(const core::Field& q, core::Field& theta);

  std::size_t bytes() const { return sizeof(double) * (G_.size() + q_.size() + theta_.size()); }

 private:
  core::Patch patch_;
  int first_;              // d of the first entry of G_
  std::vector<double> G_;  // from the first to the last that is not zero
  std::vector<double> q_, theta_;
};

/// The kernel of the body beside this patch.
using Source = std::variant<SourceConvolution, LineConvolution>;
Source make_source(const core::Patch& patch, const SourceTable& table, int threads);

}  // namespace ehl::thermal
