#include "mlmi/semi_coarsening.hpp"

#include <omp.h>

#include <algorithm>

#include "core/simd.hpp"

namespace ehl::mlmi {
namespace {

using core::Lanes;
using core::lanes;

// Widest strip of columns treated at once [vectors]: its work space must stay in the first-level cache.
constexpr int widest = 4;
constexpr int widest_columns = widest * lanes;
// Coarse rows are transposed eight at a time; 32 hold two groups and the reach of the interpolation.
constexpr int coarse_ring_rows = 32;

int vectors(int columns) { return (columns + lanes - 1) / lanes; }
std::size_t size(std::ptrdiff_t n) { return static_cast<std::size_t>(n); }

// An 8 x 8 block, rows of `in` to columns of `out`.
inline void transpose(const Lanes (&in)[lanes], Lanes (&out)[lanes]) {
  Lanes a[lanes], b[lanes];
  for (int k = 0; k < lanes; k += 2) {
    a[k] = __builtin_shufflevector(in[k], in[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    a[k + 1] = __builtin_shufflevector(in[k], in[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int k = 0; k < lanes; k += 4)
    for (int m = 0; m < 2; ++m) {
      b[k + m] = __builtin_shufflevector(a[k + m], a[k + m + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      b[k + m + 2] = __builtin_shufflevector(a[k + m], a[k + m + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (int k = 0; k < 4; ++k) {
    out[k] = __builtin_shufflevector(b[k], b[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    out[k + 4] = __builtin_shufflevector(b[k], b[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

}  // namespace

SemiCoarsening::SemiCoarsening(const Shape& shape, double factor, int threads)
    : shape_(shape),
      coarse_(coarsened(shape.along, shape.order)),
      weights_(midpoint_weights(shape.order)),
      correction_(correction(shape.along, shape.across, shape.order, shape.patch_along, shape.patch_across, factor)),
      // The sweep holds what the odd row 2p-1 behind the newest even row still needs.
      ring_rows_(2 * shape.patch_along + shape.order + 2),
      zero_row_(size(vectors(shape.across.points())) * lanes) {
  const int row = (shape.patch_across + 1) * widest_columns;
  const int margin = widest_columns + 2 * shape.patch_across;
  for (int t = 0; t < threads; ++t)
    work_.emplace_back(size(ring_rows_ * row + coarse_ring_rows * widest_columns + margin));
}

void SemiCoarsening::anterpolate(const double* u, std::ptrdiff_t stride_u, double* coarse_u,
                                 std::ptrdiff_t stride_coarse) const {
  const int p = shape_.order / 2, columns = shape_.across.points(), coarse_rows = coarse_.points();
  const int blocks = (coarse_rows + lanes - 1) / lanes, threads = static_cast<int>(work_.size());
  const auto row = [&](int i) {
    return i < shape_.along.first || i > shape_.along.last ? zero_row_.data() : u + (i - shape_.along.first) * stride_u;
  };
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int block = 0; block < blocks; ++block) {
    // Eight coarse rows need 16 + 2(2p-1) fine ones.
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

// A strip of `vectors` columns, swept along. Two rings of rows in the first-level cache: the source, with the sums
// u(j-e) + u(j+e) that the correction, even in e, multiplies; and the coarse rows being corrected.
template <int vectors>
void SemiCoarsening::interpolate_strip(const Arrays& arrays, int first_column, Buffer& work) const {
  constexpr int width = vectors * lanes;
  const int p = shape_.order / 2, m1 = correction_.along, m2 = correction_.across, columns = shape_.across.points();
  const Axis& along = shape_.along;
  const int row_size = (m2 + 1) * width;
  double* source_ring = work.data();
  double* coarse_ring = source_ring + ring_rows_ * row_size;
  double* padded = coarse_ring + coarse_ring_rows * width;
  const int lowest = 2 * coarse_.first - m1 - 1;

  const auto load_source = [&](int i) {
    double* to = source_ring + (i - lowest) % ring_rows_ * row_size;
    if (i < along.first || i > along.last) {
      std::fill_n(to, row_size, 0.0);
      return;
    }
    const double* row = arrays.u + (i - along.first) * arrays.stride_u;
    const int begin = std::max(0, first_column - m2), end = std::min(columns, first_column + width + m2);
    const double* from = row + first_column - m2;
    if (end - begin < width + 2 * m2) {
      std::fill_n(padded, width + 2 * m2, 0.0);
      std::copy(row + begin, row + end, padded + (begin - (first_column - m2)));
      from = padded;
    }
    for (int v = 0; v < width; v += lanes) core::store(to + v, core::load(from + m2 + v));
    for (int e = 1; e <= m2; ++e)
      for (int v = 0; v < width; v += lanes)
        core::store(to + e * width + v, core::load(from + m2 - e + v) + core::load(from + m2 + e + v));
  };
  const auto load_coarse = [&](int J) {
    for (int v = 0; v < width; v += lanes) {
      Lanes in[lanes], out[lanes];
      for (int c = 0; c < lanes; ++c) {
        const int j = std::min(first_column + v + c, columns - 1);
        in[c] = core::load(arrays.coarse_w + j * arrays.stride_coarse + (J - coarse_.first));
      }
      transpose(in, out);
      for (int r = 0; r < lanes; ++r)
        core::store(coarse_ring + ((J + r - coarse_.first) % coarse_ring_rows) * width + v, out[r]);
    }
  };
  // sum += correction at row i; step 2 takes the odd distances only.
  const auto add_correction = [&](int i, int step, Lanes(&sum)[vectors]) {
    for (int e = 0; e <= m2; ++e) {
      const int reach = correction_.reach[size(e)];
      const int start = step == 1 ? -reach : -(reach - (reach + 1) % 2);
      const double* C = correction_.row(e);
      const double* base = source_ring + e * width;
      int slot = (i + start - lowest) % ring_rows_;
      for (int d = start; d <= reach; d += step) {
        const double* s = base + slot * row_size;
        for (int v = 0; v < vectors; ++v) sum[v] += C[d] * core::load(s + v * lanes);
        slot += step;
        if (slot >= ring_rows_) slot -= ring_rows_;
      }
    }
  };
  const auto write = [&](int i, const Lanes(&sum)[vectors]) {
    if (i < along.first || i > along.last) return;
    double* to = arrays.w + (i - along.first) * arrays.stride_w + first_column;
    for (int v = 0; v < vectors; ++v) core::store(to + v * lanes, sum[v]);
  };

  for (int i = lowest; i < lowest + 2 * m1; ++i) load_source(i);
  for (int J = coarse_.first; J <= coarse_.last + p; ++J) {
    load_source(2 * J + m1 - 1);
    load_source(2 * J + m1);
    Lanes sum[vectors];
    if (J <= coarse_.last) {
      if ((J - coarse_.first) % lanes == 0) load_coarse(J);
      double* coarse = coarse_ring + ((J - coarse_.first) % coarse_ring_rows) * width;
      for (int v = 0; v < vectors; ++v) sum[v] = core::load(coarse + v * lanes);
      add_correction(2 * J, 2, sum);
      for (int v = 0; v < vectors; ++v) core::store(coarse + v * lanes, sum[v]);
      write(2 * J, sum);
    }
    const int odd = 2 * (J - p) + 1;
    if (odd < along.first || odd > along.last) continue;
    for (int v = 0; v < vectors; ++v) sum[v] = Lanes{};
    for (int k = 1; k <= p; ++k) {
      const double* left = coarse_ring + ((J - p - k + 1 - coarse_.first) % coarse_ring_rows) * width;
      const double* right = coarse_ring + ((J - p + k - coarse_.first) % coarse_ring_rows) * width;
      for (int v = 0; v < vectors; ++v)
        sum[v] += weights_[size(k - 1)] * (core::load(left + v * lanes) + core::load(right + v * lanes));
    }
    add_correction(odd, 1, sum);
    write(odd, sum);
  }
}

void SemiCoarsening::interpolate(const double* coarse_w, std::ptrdiff_t stride_coarse, const double* u,
                                 std::ptrdiff_t stride_u, double* w, std::ptrdiff_t stride_w) {
  const Arrays arrays{coarse_w, stride_coarse, u, stride_u, w, stride_w};
  const int total = vectors(shape_.across.points()), strips = (total + widest - 1) / widest;
  const int threads = static_cast<int>(work_.size());
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int strip = 0; strip < strips; ++strip) {
    // Strips of nearly equal width: a last one of a single column would cost as much as a full one.
    const int begin = strip * total / strips, end = (strip + 1) * total / strips;
    Buffer& work = work_[size(omp_get_thread_num())];
    switch (end - begin) {
      case 1:
        interpolate_strip<1>(arrays, begin * lanes, work);
        break;
      case 2:
        interpolate_strip<2>(arrays, begin * lanes, work);
        break;
      case 3:
        interpolate_strip<3>(arrays, begin * lanes, work);
        break;
      default:
        interpolate_strip<4>(arrays, begin * lanes, work);
        break;
    }
  }
}

std::size_t SemiCoarsening::bytes() const {
  std::size_t total = zero_row_.bytes() + correction_.C.size() * sizeof(double);
  for (const Buffer& work : work_) total += work.bytes();
  return total;
}

}  // namespace ehl::mlmi
