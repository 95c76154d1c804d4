#pragma once
// The only access to a library for discrete Fourier transforms. One of two files implements it:
// fourier_transform_fftw.cpp (FFTW, with the build option EHL_FFTW) or fourier_transform_eigen.cpp (Eigen's transform).
// Complex numbers are pairs of doubles, real part first. Nothing is normalised: forward and then inverse multiplies by
// the length. Arrays must start on a 64-byte boundary. An object serves one thread at a time.
#include <memory>

namespace ehl::mlmi {

/// Name of the library.
const char* fourier_library();

/// Transforms of real rows of one length. limits: length even.
class RealTransform {
 public:
  explicit RealTransform(int length);
  ~RealTransform();
  RealTransform(RealTransform&&) noexcept;
  RealTransform& operator=(RealTransform&&) noexcept;
  /// spectrum_k = sum_n row_n exp(-2 pi i k n/length), k = 0..length/2. in: row of length doubles.
  void forward(const double* row, double* spectrum) const;
  /// row_n = sum_k spectrum_k exp(2 pi i k n/length) over the whole symmetric spectrum. The spectrum is destroyed.
  void inverse(double* spectrum, double* row) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Transforms of complex rows of one length, from one array to another: sum_n in_n exp(-2 pi i k n/length). The input
/// is kept.
class ComplexTransform {
 public:
  explicit ComplexTransform(int length);
  ~ComplexTransform();
  ComplexTransform(ComplexTransform&&) noexcept;
  ComplexTransform& operator=(ComplexTransform&&) noexcept;
  void forward(const double* in, double* out) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Transforms of `columns` complex columns at once, element n of column c at data[2 (n columns + c)], from one array to
/// another (faster than in place). The input may be destroyed.
class ColumnTransform {
 public:
  static constexpr int columns = 8;            ///< a row of them is two cache lines
  static constexpr int doubles = 2 * columns;  ///< doubles in a row of columns, real and imaginary parts
  explicit ColumnTransform(int length);
  ~ColumnTransform();
  ColumnTransform(ColumnTransform&&) noexcept;
  void forward(double* in, double* out) const;
  void inverse(double* in, double* out) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ehl::mlmi
