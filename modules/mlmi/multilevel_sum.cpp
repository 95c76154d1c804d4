#include "mlmi/multilevel_sum.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ehl::mlmi {
namespace {

std::ptrdiff_t padded(int columns) { return (static_cast<std::ptrdiff_t>(columns) + 7) / 8 * 8; }

// The interpolation error of the kernel decays with the distance in units of the spacing that is being coarsened, so
// the patch covers the same distance in the other direction, whatever the spacing there.
int points_across(int patch_across, const Axis& along, const Axis& across) {
  const double ratio = along.every * along.h / (across.every * across.h);
  return std::max(1, static_cast<int>(std::ceil(patch_across * ratio - 1e-9)));
}

}  // namespace

bool holds_mirror(const Axis& y, const MultilevelChoice& choice) {
  return choice.coarsenings % 2 == 0 && !choice.coarsest_direct && y.last % (1 << (choice.coarsenings / 2)) == 0;
}

MultilevelSum::MultilevelSum(const Axis& x, const Axis& y, const MultilevelChoice& choice, const kernel::Kernel& kernel,
                             int threads) {
  Axis along = x, across = y;
  for (int l = 0; l < choice.coarsenings; ++l) {
    // The dropped part of the kernel contributes in proportion to the spacing, and the work falls with its square:
    // deeper levels get larger patches.
    const int pair = l / 2;
    const int m1 = choice.patch_along + 2 * pair;
    const int m2 = points_across(choice.patch_across + pair, along, across);
    steps_.emplace_back(SemiCoarsening::Shape{along, across, choice.order, m1, m2}, kernel, threads);
    along = std::exchange(across, steps_.back().coarse());
    const std::ptrdiff_t stride = padded(across.points());
    const auto size = static_cast<std::size_t>(along.points() * stride);
    grids_.push_back({stride, Buffer(size), Buffer(size)});
  }
  coarsest_rows_ = along.points();
  const FourierConvolution::Shape shape{coarsest_rows_, across.points(), across.end == core::Edge::mirror};
  coarsest_columns_ = shape.all_columns();
  const auto table = kernel::influence_table(kernel, coarsest_rows_ - 1, coarsest_columns_ - 1, along.h, across.h,
                                             along.every, across.every);
  if (choice.coarsest_direct)
    direct_.emplace(coarsest_rows_, coarsest_columns_, table, kernel.factor, threads);
  else
    fourier_.emplace(shape, table, kernel.factor, threads);
}

void MultilevelSum::apply(const double* u, std::ptrdiff_t stride_u, double* w, std::ptrdiff_t stride_w) {
  const auto coarsest_sum = [&](const double* source, std::ptrdiff_t stride_source, double* sum,
                                std::ptrdiff_t stride) {
    if (direct_) direct_->apply(source, stride_source, sum, stride);
    if (fourier_) fourier_->apply(source, stride_source, sum, stride);
  };
  if (steps_.empty()) return coarsest_sum(u, stride_u, w, stride_w);

  for (std::size_t l = 0; l < steps_.size(); ++l) {
    const double* fine = l == 0 ? u : grids_[l - 1].u.data();
    steps_[l].anterpolate(fine, l == 0 ? stride_u : grids_[l - 1].stride, grids_[l].u.data(), grids_[l].stride);
  }
  Coarse& coarsest = grids_.back();
  coarsest_sum(coarsest.u.data(), coarsest.stride, coarsest.w.data(), coarsest.stride);
  for (std::size_t l = steps_.size(); l-- > 0;) {
    const bool finest = l == 0;
    const double* source = finest ? u : grids_[l - 1].u.data();
    double* sum = finest ? w : grids_[l - 1].w.data();
    steps_[l].interpolate(grids_[l].w.data(), grids_[l].stride, source, finest ? stride_u : grids_[l - 1].stride, sum,
                          finest ? stride_w : grids_[l - 1].stride);
  }
}

std::size_t MultilevelSum::bytes() const {
  std::size_t total = 0;
  for (const SemiCoarsening& step : steps_) total += step.bytes();
  for (const Coarse& grid : grids_) total += grid.u.bytes() + grid.w.bytes();
  if (direct_) total += direct_->bytes();
  if (fourier_) total += fourier_->bytes();
  return total;
}

}  // namespace ehl::mlmi
