// Fourier transforms by Eigen (kissfft, not under the GPL).
#include <algorithm>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "mlmi/fourier_transform.hpp"

namespace ehl::mlmi {
namespace {
using Complex = std::complex<double>;
using Library = Eigen::FFT<double>;
constexpr Library::Flag unscaled_half = static_cast<Library::Flag>(Library::Unscaled | Library::HalfSpectrum);
}  // namespace

const char* fourier_library() { return "Eigen"; }

struct RealTransform::Implementation {
  int length;
  mutable Library library{Library::impl_type(), unscaled_half};
};

RealTransform::RealTransform(int length) : implementation_(std::make_unique<Implementation>()) {
  implementation_->length = length;
  // The library makes its tables at the first call, which must not be within an evaluation.
  std::vector<double> row(static_cast<std::size_t>(length));
  std::vector<double> spectrum(static_cast<std::size_t>(length) + 2);
  forward(row.data(), spectrum.data());
  inverse(spectrum.data(), row.data());
}
RealTransform::~RealTransform() = default;
RealTransform::RealTransform(RealTransform&&) noexcept = default;
RealTransform& RealTransform::operator=(RealTransform&&) noexcept = default;

void RealTransform::forward(const double* row, double* spectrum) const {
  implementation_->library.fwd(reinterpret_cast<Complex*>(spectrum), row, implementation_->length);
}
void RealTransform::inverse(double* spectrum, double* row) const {
  implementation_->library.inv(row, reinterpret_cast<const Complex*>(spectrum), implementation_->length);
}

struct ComplexTransform::Implementation {
  Eigen::Index length;
  mutable Library library{Library::impl_type(), Library::Unscaled};
};

ComplexTransform::ComplexTransform(int length) : implementation_(std::make_unique<Implementation>()) {
  implementation_->length = length;
  std::vector<double> from(2 * static_cast<std::size_t>(length)), to(from);
  forward(from.data(), to.data());  // makes the tables
}
ComplexTransform::~ComplexTransform() = default;
ComplexTransform::ComplexTransform(ComplexTransform&&) noexcept = default;
ComplexTransform& ComplexTransform::operator=(ComplexTransform&&) noexcept = default;

void ComplexTransform::forward(const double* in, double* out) const {
  if (implementation_->length == 1) {  // Eigen's own transform of one number crashes
    std::copy_n(in, 2, out);
    return;
  }
  implementation_->library.fwd(reinterpret_cast<Complex*>(out), reinterpret_cast<const Complex*>(in),
                               implementation_->length);
}

struct ColumnTransform::Implementation {
  std::size_t length;
  mutable Library library{Library::impl_type(), Library::Unscaled};
  mutable std::vector<Complex> in, out;

  // One column at a time: gather, transform, scatter.
  template <class Transform>
  void each_column(const double* from, double* to, Transform transform) const {
    const auto* source = reinterpret_cast<const Complex*>(from);
    auto* result = reinterpret_cast<Complex*>(to);
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t n = 0; n < length; ++n) in[n] = source[n * columns + c];
      transform(out.data(), in.data());
      for (std::size_t n = 0; n < length; ++n) result[n * columns + c] = out[n];
    }
  }
};

ColumnTransform::ColumnTransform(int length) : implementation_(std::make_unique<Implementation>()) {
  implementation_->length = static_cast<std::size_t>(length);
  implementation_->in.resize(implementation_->length);
  implementation_->out.resize(implementation_->length);
  std::vector<double> from(implementation_->length * 2 * columns), to(from);
  forward(from.data(), to.data());
  inverse(from.data(), to.data());
}
ColumnTransform::~ColumnTransform() = default;
ColumnTransform::ColumnTransform(ColumnTransform&&) noexcept = default;

void ColumnTransform::forward(double* in, double* out) const {
  implementation_->each_column(in, out, [this](Complex* to, const Complex* from) {
    implementation_->library.fwd(to, from, static_cast<Eigen::Index>(implementation_->length));
  });
}
void ColumnTransform::inverse(double* in, double* out) const {
  implementation_->each_column(in, out, [this](Complex* to, const Complex* from) {
    implementation_->library.inv(to, from, static_cast<Eigen::Index>(implementation_->length));
  });
}

}  // namespace ehl::mlmi
