// Eigen's own transform (kissfft, free of the GPL) behind the door.
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
  // The library builds its tables at the first call; they must not be built inside an evaluation.
  std::vector<double> row(static_cast<std::size_t>(length));
  std::vector<double> spectrum(static_cast<std::size_t>(length) + 2);
  forward(row.data(), spectrum.data());
  inverse(spectrum.data(), row.data());
}
RealTransform::~RealTransform() = default;
RealTransform::RealTransform(RealTransform&&) noexcept = default;

void RealTransform::forward(const double* row, double* spectrum) const {
  implementation_->library.fwd(reinterpret_cast<Complex*>(spectrum), row, implementation_->length);
}
void RealTransform::inverse(double* spectrum, double* row) const {
  implementation_->library.inv(row, reinterpret_cast<const Complex*>(spectrum), implementation_->length);
}

struct ColumnTransform::Implementation {
  std::size_t length;
  mutable Library library{Library::impl_type(), Library::Unscaled};
  mutable std::vector<Complex> in, out;

  // One column at a time: gather, transform, scatter.
  template <class Transform>
  void each_column(double* data, Transform transform) const {
    auto* p = reinterpret_cast<Complex*>(data);
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t n = 0; n < length; ++n) in[n] = p[n * columns + c];
      transform(out.data(), in.data());
      for (std::size_t n = 0; n < length; ++n) p[n * columns + c] = out[n];
    }
  }
};

ColumnTransform::ColumnTransform(int length) : implementation_(std::make_unique<Implementation>()) {
  implementation_->length = static_cast<std::size_t>(length);
  implementation_->in.resize(implementation_->length);
  implementation_->out.resize(implementation_->length);
  std::vector<double> data(implementation_->length * 2 * columns);
  forward(data.data());
  inverse(data.data());
}
ColumnTransform::~ColumnTransform() = default;
ColumnTransform::ColumnTransform(ColumnTransform&&) noexcept = default;

void ColumnTransform::forward(double* data) const {
  implementation_->each_column(data, [this](Complex* out, const Complex* in) {
    implementation_->library.fwd(out, in, static_cast<Eigen::Index>(implementation_->length));
  });
}
void ColumnTransform::inverse(double* data) const {
  implementation_->each_column(data, [this](Complex* out, const Complex* in) {
    implementation_->library.inv(out, in, static_cast<Eigen::Index>(implementation_->length));
  });
}

}  // namespace ehl::mlmi
