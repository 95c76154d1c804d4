#include "asperities/cosine_transform.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace ehl::asperities {
namespace {

std::size_t size(int n) { return static_cast<std::size_t>(n); }

void quarter_waves(int n, std::vector<double>& cosines, std::vector<double>& sines) {
  for (int k = 0; k <= n; ++k) {
    cosines.push_back(std::cos(core::pi * k / (2.0 * n)));
    sines.push_back(std::sin(core::pi * k / (2.0 * n)));
  }
}

// With v = x0, x2, x4, ... x5, x3, x1 and its spectrum V, W_k = exp(-i pi k/(2n)) V_k gives s_k = Re W_k and
// s_(n-k) = -Im W_k.
void row_forward(const mlmi::RealTransform& transform, int n, const double* cosines, const double* sines, double* row,
                 double* waves, double* data) {
  for (int j = 0; j < n / 2; ++j) {
    row[j] = data[2 * j];
    row[n - 1 - j] = data[2 * j + 1];
  }
  transform.forward(row, waves);
  data[0] = waves[0];
  for (int k = 1; k <= n / 2; ++k) {
    const double re = waves[2 * k], im = waves[2 * k + 1];
    data[k] = cosines[k] * re + sines[k] * im;
    data[n - k] = sines[k] * re - cosines[k] * im;
  }
}

void row_inverse(const mlmi::RealTransform& transform, int n, const double* cosines, const double* sines, double* row,
                 double* waves, double* data) {
  waves[0] = data[0];
  waves[1] = 0.0;
  for (int k = 1; k <= n / 2; ++k) {
    const double re = data[k], im = -data[n - k];
    waves[2 * k] = cosines[k] * re - sines[k] * im;
    waves[2 * k + 1] = sines[k] * re + cosines[k] * im;
  }
  waves[n + 1] = 0.0;
  transform.inverse(waves, row);
  for (int j = 0; j < n / 2; ++j) {
    data[2 * j] = row[j] / n;
    data[2 * j + 1] = row[n - 1 - j] / n;
  }
}

}  // namespace

double Cell::wave_number_x(int k) const { return core::pi * k / length_x(); }
double Cell::wave_number_y(int l) const { return core::pi * l / length_y(); }

CosineTransform::CosineTransform(const Cell& cell, int threads) : cell_(cell), other_(cell.points()) {
  quarter_waves(cell.nx, cos_x_, sin_x_);
  quarter_waves(cell.ny, cos_y_, sin_y_);
  const std::size_t longest = size(std::max(cell.nx, cell.ny));
  for (int t = 0; t < threads; ++t)
    workers_.push_back(
        {mlmi::RealTransform(cell.nx), mlmi::RealTransform(cell.ny), mlmi::Buffer(longest), mlmi::Buffer(longest + 2)});
}

void CosineTransform::rows(Way way, double* data, int length, int count, bool along_x) {
  const double* cosines = along_x ? cos_x_.data() : cos_y_.data();
  const double* sines = along_x ? sin_x_.data() : sin_y_.data();
  const auto one_row = way == Way::forward ? row_forward : row_inverse;
  const int threads = static_cast<int>(workers_.size());
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int r = 0; r < count; ++r) {
    Worker& worker = workers_[size(omp_get_thread_num())];
    one_row(along_x ? worker.along_x : worker.along_y, length, cosines, sines, worker.row.data(), worker.waves.data(),
            data + size(r) * size(length));
  }
}

// In blocks that fit into the cache.
void CosineTransform::transpose(const double* from, double* to, int rows, int columns) const {
  constexpr int block = 16;
  const int threads = static_cast<int>(workers_.size());
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int r0 = 0; r0 < rows; r0 += block)
    for (int c0 = 0; c0 < columns; c0 += block)
      for (int r = r0; r < std::min(r0 + block, rows); ++r)
        for (int c = c0; c < std::min(c0 + block, columns); ++c)
          to[size(c) * size(rows) + size(r)] = from[size(r) * size(columns) + size(c)];
}

void CosineTransform::forward(const std::vector<double>& values, std::vector<double>& spectrum) {
  other_ = values;
  spectrum.resize(values.size());
  rows(Way::forward, other_.data(), cell_.nx, cell_.ny, true);
  transpose(other_.data(), spectrum.data(), cell_.ny, cell_.nx);
  rows(Way::forward, spectrum.data(), cell_.ny, cell_.nx, false);
}

void CosineTransform::inverse(std::vector<double>& spectrum, std::vector<double>& values) {
  values.resize(spectrum.size());
  rows(Way::inverse, spectrum.data(), cell_.ny, cell_.nx, false);
  transpose(spectrum.data(), values.data(), cell_.nx, cell_.ny);
  rows(Way::inverse, values.data(), cell_.nx, cell_.ny, true);
}

CellDeformation::CellDeformation(const Cell& cell, double E_prime, int threads)
    : transform_(cell, threads), response_(cell.points()) {
  for (int k = 0; k < cell.nx; ++k)
    for (int l = 0; l < cell.ny; ++l) {
      const double q = std::hypot(cell.wave_number_x(k), cell.wave_number_y(l));
      response_[size(k) * size(cell.ny) + size(l)] = k + l > 0 ? 4.0 / (E_prime * q) : 0.0;
    }
}

void CellDeformation::evaluate(const std::vector<double>& p, std::vector<double>& u) {
  transform_.forward(p, spectrum_);
  for (std::size_t n = 0; n < spectrum_.size(); ++n) spectrum_[n] *= response_[n];
  transform_.inverse(spectrum_, u);
}

void CellDeformation::invert(const std::vector<double>& u, std::vector<double>& p) {
  transform_.forward(u, spectrum_);
  spectrum_[0] = 0.0;
  for (std::size_t n = 1; n < spectrum_.size(); ++n) spectrum_[n] /= response_[n];
  transform_.inverse(spectrum_, p);
}

}  // namespace ehl::asperities
