#pragma once
// The sum theta = G*q over all pairs of nodes, for a kernel that is even in Y but not in X: zero-padded Fourier
// transforms, exact to rounding; direct summation for line contacts.
#include <cstddef>
#include <variant>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "mlmi/buffer.hpp"
#include "mlmi/fourier_transform.hpp"
#include "thermal/moving_source.hpp"

namespace ehl::thermal {

/// theta_ij = sum_kl G(i-k, j-l) q_kl over all nodes of the domain, including mirror images. cost: O(N ln N). The
/// result does not depend on the number of threads.
class SourceConvolution {
 public:
  /// in: table with n_x >= domain.nx, n_y >= domain.ny.
  SourceConvolution(const core::Patch& patch, const SourceTable& table, int threads);

  /// in: q on the patch. out: theta on the patch; it may be the same field.
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
  int length_rows_, length_columns_;  // padded lengths
  int blocks_;                        // number of blocks of complex columns
  std::ptrdiff_t stride_;             // doubles per row of half_
  mlmi::Buffer half_;                 // transformed along Y only
  mlmi::Buffer spectrum_;             // of the kernel, block by block
  std::vector<Worker> workers_;
};

/// Sum along the line of a line contact, theta_i = sum_k G(i-k) q_k, directly: the upstream response of a fast body
/// spans few cells, and planning a transform would take longer than many such sums. cost: nodes times nonzero entries.
class LineConvolution {
 public:
  /// in: table of strips (n_y = 0) with n_x >= domain.nx.
  LineConvolution(const core::Patch& patch, const SourceTable& table);

  /// in: q on the patch. out: theta, equal on all lines; it may be the same field.
  void apply(const core::Field& q, core::Field& theta);

  std::size_t bytes() const { return sizeof(double) * (G_.size() + q_.size() + theta_.size()); }

 private:
  core::Patch patch_;
  int first_;              // d of the first entry of G_
  std::vector<double> G_;  // nonzero entries
  std::vector<double> q_, theta_;
};

/// The kind of sum that suits a patch.
using Source = std::variant<SourceConvolution, LineConvolution>;
/// The sum for a patch: LineConvolution for a line contact, else SourceConvolution. in: table, see their constructors.
Source make_source(const core::Patch& patch, const SourceTable& table, int threads);

}  // namespace ehl::thermal
