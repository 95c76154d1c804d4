#include "mlmi/even_convolution.hpp"

#include <algorithm>
#include <complex>

#include "core/constants.hpp"
#include "mlmi/fourier_convolution.hpp"

namespace ehl::mlmi {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

std::complex<double> number(const Buffer& values, int k) { return {values[2 * at(k)], values[2 * at(k) + 1]}; }
void put(Buffer& values, int k, double real, double imaginary) {
  values[2 * at(k)] = real;
  values[2 * at(k) + 1] = imaginary;
}

}  // namespace

// The largest distances n - 1 and 1 - n share a place, as K is even, so that the padded length is one less than in two
// dimensions. For a grid of 2^k cells it is a power of two.
EvenConvolution::EvenConvolution(std::span<const double> kernel)
    : points_(kernel.size()),
      half_(padded_length(std::max(2, 2 * static_cast<int>(kernel.size()) - 2)) / 2),
      transform_(half_),
      line_(2 * at(half_)),
      spectrum_(2 * at(half_)) {
  for (std::size_t d = 0; d < points_; ++d) line_[d] = line_[d > 0 ? 2 * at(half_) - d : 0] = kernel[d];
  transform_.forward(line_.data(), spectrum_.data());
  // Let a and b be the transforms of the even and of the odd points and w = exp(-2 pi i k/length). The spectrum, which
  // is real and even, is a + w b at k and a - w b at half - k.
  for (int k = 0; k <= half_ / 2; ++k) {
    const std::complex<double> Z = number(spectrum_, k), other = std::conj(number(spectrum_, k > 0 ? half_ - k : 0));
    const std::complex<double> b = std::complex<double>(0.0, -0.5) * (Z - other);
    const std::complex<double> w = std::polar(1.0, -core::pi * k / half_);
    factors_.push_back({0.5 * (Z + other).real() / half_, (w * b).real() / half_, w.real(), w.imag()});
  }
}

// With Z = a + i b and w = exp(-2 pi i k/length) the product with the spectrum of the kernel has
//   a' = mean a + difference w b, b' = mean b + difference conj(w) a.
// The conjugate of a' + i b' is stored: the inverse transform is the conjugate of the forward transform of that.
void EvenConvolution::multiply() {
  for (int k = 0; k <= half_ / 2; ++k) {
    const Factor& f = factors_[at(k)];
    const int other = k > 0 ? half_ - k : 0;
    const double Zr = spectrum_[2 * at(k)], Zi = spectrum_[2 * at(k) + 1];
    const double Yr = spectrum_[2 * at(other)], Yi = spectrum_[2 * at(other) + 1];
    const double ar = 0.5 * (Zr + Yr), ai = 0.5 * (Zi - Yi);  // a
    const double br = 0.5 * (Zr - Yr), bi = 0.5 * (Zi + Yi);  // i b
    const double wbr = f.cosine * br - f.sine * bi, wbi = f.cosine * bi + f.sine * br;
    const double war = f.cosine * ar + f.sine * ai, wai = f.cosine * ai - f.sine * ar;
    const double sum_r = f.difference * (war + wbr), sum_i = f.difference * (wai + wbi);
    const double less_r = f.difference * (war - wbr), less_i = f.difference * (wai - wbi);
    put(spectrum_, k, f.mean * Zr - less_i, -(f.mean * Zi + less_r));
    put(spectrum_, other, f.mean * Yr + sum_i, -(f.mean * Yi + sum_r));
  }
}

void EvenConvolution::apply(std::span<const double> u, std::span<double> w) {
  std::ranges::copy(u, line_.data());
  std::fill(line_.data() + points_, line_.data() + line_.size(), 0.0);
  transform_.forward(line_.data(), spectrum_.data());
  multiply();
  transform_.forward(spectrum_.data(), line_.data());
  for (std::size_t i = 0; i < points_; ++i) w[i] = i % 2 == 0 ? line_[i] : -line_[i];
}

std::size_t EvenConvolution::bytes() const {
  return line_.bytes() + spectrum_.bytes() + factors_.size() * sizeof(Factor);
}

}  // namespace ehl::mlmi
