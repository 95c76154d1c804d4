#pragma once
// The sum w = K*u along one line, K the kernel of a line contact: multilevel multi-integration as in two
// dimensions (semi_coarsening.hpp defines the notation), with every coarsening along the line.
#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/kernel.hpp"
#include "mlmi/even_convolution.hpp"
#include "mlmi/multilevel_sum.hpp"

namespace ehl::mlmi {

/// w_i = factor sum_k K(i-k) u_k. Owns every level. limits: an axis that begins at 0; patch_across is not used.
class LineSum {
 public:
  LineSum(const Axis& axis, const MultilevelChoice& choice, const kernel::Kernel& kernel);

  /// in: u(i), i = 0..last. out: write(i, w_i).
  template <class Source, class Write>
  void apply(Source u, Write write) {
    Level& finest = levels_.front();
    for (std::size_t i = 0; i < finest.u.size(); ++i) finest.u[i] = u(static_cast<int>(i));
    sum();
    for (std::size_t i = 0; i < finest.w.size(); ++i) write(static_cast<int>(i), finest.w[i]);
  }

  bool coarsest_direct() const { return !transformed_; }
  int coarsest_points() const { return levels_.back().axis.points(); }
  std::size_t bytes() const;

 private:
  struct Level {
    Axis axis;
    std::vector<double> u, w;
    std::vector<double> correction;  // C(d), d = -patch..patch, between this level and the next
  };
  void sum();
  void anterpolate(const Level& fine, Level& coarse) const;
  void interpolate(Level& coarse, Level& fine) const;
  void sum_directly(Level& level) const;

  int order_, patch_;
  std::vector<Level> levels_;   // the finest first
  std::vector<double> kernel_;  // of the direct sum over n points: factor K(d), d = 1 - n .. n - 1, then zeros
  std::optional<EvenConvolution> transformed_;  // else the direct sum
};

}  // namespace ehl::mlmi
