#include "mlmi/semi_coarsening.hpp"

#include <omp.h>

#include <algorithm>

#include "core/simd.hpp"
#include "mlmi/transpose.hpp"

namespace ehl::mlmi {
namespace {

using core::Lanes;
using core::lanes;

// Widest strip of columns that is processed at once [vectors]: its work space must fit in the first-level cache.
constexpr int widest = 4;
constexpr int widest_columns = widest * lanes;
// Coarse rows are transposed `lanes` at a time; 32 rows contain two such groups and the reach of the interpolation.
constexpr int coarse_ring_rows = 32;

/// Index of the stored value of point i: that of its image if it lies beyond an axis of symmetry.
int folded(const Axis& axis, int i) { return axis.end == core::Edge::mirror && i > axis.last ? 2 * axis.last - i : i; }

int vectors(int columns) { return (columns + lanes - 1) / lanes; }
std::size_t size(std::ptrdiff_t n) { return static_cast<std::size_t>(n); }

}  // namespace

SemiCoarsening::SemiCoarsening(const Shape& shape, const kernel::Kernel& kernel, int threads)
    : shape_(shape),
      coarse_(coarsened(shape.along, shape.order)),
      weights_(midpoint_weights(shape.order)),
      correction_(correction(shape.along, shape.across, shape.order, shape.patch_along, shape.patch_across, kernel)),
      // The ring keeps the rows that the odd row 2p-1 behind the newest even row still needs.
      ring_rows_(2 * shape.patch_along + shape.order + 2),
      zero_row_(size(vectors(shape.across.points())) * lanes) {
  const int row = (shape.patch_across + 1) * widest_columns;
  const int ends = widest_columns + 2 * shape.patch_across;
  for (int t = 0; t < threads; ++t)
    work_.emplace_back(size(ring_rows_ * row + coarse_ring_rows * widest_columns + ends));
}

void SemiCoarsening::anterpolate(const double* u, std::ptrdiff_t stride_u, double* coarse_u,
                                 std::ptrdiff_t stride_coarse) const {
  const int p = shape_.order / 2, columns = shape_.across.points(), coarse_rows = coarse_.points();
  const int blocks = (coarse_rows + lanes - 1) / lanes, threads = static_cast<int>(work_.size());
  const auto row = [&](int point) {
    const int i = folded(shape_.along, point);
    return i < shape_.along.first || i > shape_.along.last ? zero_row_.data() : u + (i - shape_.along.first) * stride_u;
  };
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int block = 0; block < blocks; ++block) {
    // `lanes` coarse rows need twice as many fine ones and 2(2p-1) more.
    constexpr int reach = 7;
    const double* fine[2 * lanes + 2 * reach];
    const int J = coarse_.first + block * lanes;
    for (int m = 0; m < 2 * lanes + 2 * reach; ++m) fine[m] = row(2 * J + m - reach);
    const int kept = std::min(lanes, coarse_rows - block * lanes);
    for (int j = 0; j < columns; j += lanes) {
      Lanes sum[lanes], out[lanes];
      for (int r = 0; r < lanes; ++r) {
        const double* const* centre = fine + reach + 2 * r;
        sum[r] = core::load(centre[0] + j);
        for (int k = 1; k <= p; ++k)
          sum[r] += weights_[size(k - 1)] * (core::load(centre[1 - 2 * k] + j) + core::load(centre[2 * k - 1] + j));
      }
      transpose(sum, out);
      double* to = coarse_u + j * stride_coarse + block * lanes;
      for (int c = 0; c < std::min(lanes, columns - j); ++c)
        if (kept == lanes)
          core::store(to + c * stride_coarse, out[c]);
        else
          for (int r = 0; r < kept; ++r) to[c * stride_coarse + r] = out[c][r];
    }
  }
}

struct SemiCoarsening::Arrays {
  const double* coarse_w;
  std::ptrdiff_t stride_coarse;
  const double* u;
  std::ptrdiff_t stride_u;
  double* w;
  std::ptrdiff_t stride_w;
};

// A strip of `lanes` times `vectors` columns, processed along the direction that is coarsened. Two rings of rows stay
// in the first-level cache: the source, with the sums u(j-e) + u(j+e) that the correction, even in e, multiplies; and
// the coarse rows that are being corrected.
template <int vectors>
class SemiCoarsening::Strip {
 public:
  Strip(const SemiCoarsening& step, const Arrays& arrays, int first_column, Buffer& work)
      : shape_(step.shape_),
        coarse_(step.coarse_),
        weights_(step.weights_),
        correction_(step.correction_),
        arrays_(arrays),
        first_column_(first_column),
        ring_rows_(step.ring_rows_),
        lowest_(2 * coarse_.first - correction_.along - 1),
        row_size_((correction_.across + 1) * width),
        source_ring_(work.data()),
        coarse_ring_(source_ring_ + ring_rows_ * row_size_),
        margin_(coarse_ring_ + coarse_ring_rows * width) {}

  // Even points are processed p ahead of the odd points that are interpolated from them.
  void sweep() {
    const int p = shape_.order / 2, m1 = correction_.along;
    for (int i = lowest_; i < lowest_ + 2 * m1; ++i) load_source(i);
    for (int J = coarse_.first; J <= coarse_.last + p; ++J) {
      load_source(2 * J + m1 - 1);
      load_source(2 * J + m1);
      if (J <= coarse_.last)
        correct_even(J);
      else if (coarse_.end == core::Edge::mirror)
        std::copy_n(coarse_row(folded(coarse_, J)), width, coarse_row(J));
      const int odd = 2 * (J - p) + 1;
      if (odd >= shape_.along.first && odd <= shape_.along.last) interpolate_odd(odd);
    }
  }

 private:
  static constexpr int width = vectors * lanes;
  using Row = Lanes[vectors];

  void load_source(int point) {
    double* to = source_ring_ + (point - lowest_) % ring_rows_ * row_size_;
    const Axis& along = shape_.along;
    const int i = folded(along, point);
    if (i < along.first || i > along.last) {
      std::fill_n(to, row_size_, 0.0);
      return;
    }
    const int m2 = correction_.across, columns = shape_.across.points();
    const double* row = arrays_.u + (i - along.first) * arrays_.stride_u;
    const int begin = std::max(0, first_column_ - m2), end = std::min(columns, first_column_ + width + m2);
    const double* from = row + first_column_;
    if (end - begin < width + 2 * m2) {
      std::fill_n(margin_, width + 2 * m2, 0.0);
      std::copy(row + begin, row + end, margin_ + (begin - (first_column_ - m2)));
      if (shape_.across.end == core::Edge::mirror)
        for (int c = columns; c < std::min(2 * columns - 1, first_column_ + width + m2); ++c)
          margin_[c - (first_column_ - m2)] = row[2 * (columns - 1) - c];
      from = margin_ + m2;
    }
    for (int v = 0; v < width; v += lanes) core::store(to + v, core::load(from + v));
    for (int e = 1; e <= m2; ++e)
      for (int v = 0; v < width; v += lanes)
        core::store(to + e * width + v, core::load(from - e + v) + core::load(from + e + v));
  }

  double* coarse_row(int J) { return coarse_ring_ + ((J - coarse_.first) % coarse_ring_rows) * width; }

  // Loads the coarse rows J..J+lanes-1.
  void load_coarse(int J) {
    for (int v = 0; v < width; v += lanes) {
      Lanes in[lanes], out[lanes];
      for (int c = 0; c < lanes; ++c) {
        const int j = std::min(first_column_ + v + c, shape_.across.points() - 1);
        in[c] = core::load(arrays_.coarse_w + j * arrays_.stride_coarse + (J - coarse_.first));
      }
      transpose(in, out);
      for (int r = 0; r < lanes; ++r) core::store(coarse_row(J + r) + v, out[r]);
    }
  }

  // sum += correction at row i, over all distances (step 1) or over the odd ones (step 2).
  void add_correction(int i, int step, Row& sum) const {
    for (int e = 0; e <= correction_.across; ++e) {
      const int reach = correction_.reach[size(e)];
      const int start = step == 1 ? -reach : -(reach - (reach + 1) % 2);
      const double* C = correction_.row(e);
      const double* ring = source_ring_ + e * width;
      int slot = (i + start - lowest_) % ring_rows_;
      for (int d = start; d <= reach; d += step) {
        const double* s = ring + slot * row_size_;
        for (int v = 0; v < vectors; ++v) sum[v] += C[d] * core::load(s + v * lanes);
        slot += step;
        if (slot >= ring_rows_) slot -= ring_rows_;
      }
    }
  }

  void correct_even(int J) {
    if ((J - coarse_.first) % lanes == 0) load_coarse(J);
    double* coarse = coarse_row(J);
    Row sum;
    for (int v = 0; v < vectors; ++v) sum[v] = core::load(coarse + v * lanes);
    add_correction(2 * J, 2, sum);
    for (int v = 0; v < vectors; ++v) core::store(coarse + v * lanes, sum[v]);
    if (2 * J >= shape_.along.first && 2 * J <= shape_.along.last) write(2 * J, sum);
  }

  void interpolate_odd(int i) {
    const int J = (i - 1) / 2;
    Row sum{};
    for (int k = 1; k <= shape_.order / 2; ++k) {
      const double *left = coarse_row(J + 1 - k), *right = coarse_row(J + k);
      for (int v = 0; v < vectors; ++v)
        sum[v] += weights_[size(k - 1)] * (core::load(left + v * lanes) + core::load(right + v * lanes));
    }
    add_correction(i, 1, sum);
    write(i, sum);
  }

  void write(int i, const Row& sum) const {
    double* to = arrays_.w + (i - shape_.along.first) * arrays_.stride_w + first_column_;
    for (int v = 0; v < vectors; ++v) core::store(to + v * lanes, sum[v]);
  }

  const Shape& shape_;
  const Axis& coarse_;
  const std::array<double, 4>& weights_;
  const Correction& correction_;
  const Arrays& arrays_;
  int first_column_, ring_rows_;
  int lowest_;           // first row of all in the source ring
  int row_size_;         // doubles per row of the source ring
  double* source_ring_;  // ring_rows x (m2+1) x width
  double* coarse_ring_;  // coarse_ring_rows x width
  double* margin_;       // a row at the edge of the grid, zeros outside
};

void SemiCoarsening::interpolate(const double* coarse_w, std::ptrdiff_t stride_coarse, const double* u,
                                 std::ptrdiff_t stride_u, double* w, std::ptrdiff_t stride_w) {
  const Arrays arrays{coarse_w, stride_coarse, u, stride_u, w, stride_w};
  const int total = vectors(shape_.across.points()), strips = (total + widest - 1) / widest;
  const int threads = static_cast<int>(work_.size());
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int strip = 0; strip < strips; ++strip) {
    // Strips of nearly equal width, since a last strip of one column would cost as much as a full one.
    const int begin = strip * total / strips, end = (strip + 1) * total / strips;
    Buffer& work = work_[size(omp_get_thread_num())];
    switch (end - begin) {
      case 1: Strip<1>(*this, arrays, begin * lanes, work).sweep(); break;
      case 2: Strip<2>(*this, arrays, begin * lanes, work).sweep(); break;
      case 3: Strip<3>(*this, arrays, begin * lanes, work).sweep(); break;
      default: Strip<4>(*this, arrays, begin * lanes, work).sweep(); break;
    }
  }
}

std::size_t SemiCoarsening::bytes() const {
  std::size_t total = zero_row_.bytes() + correction_.C.size() * sizeof(double);
  for (const Buffer& work : work_) total += work.bytes();
  return total;
}

}  // namespace ehl::mlmi
