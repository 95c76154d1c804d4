#pragma once
// Flexible GMRES by SUNDIALS; no other file of this module uses that library.
#include <functional>
#include <span>

namespace ehl::newton {

/// A linear system A x = b for GMRES. Exceptions of the functions pass through the library.
struct LinearSystem {
  std::function<void(std::span<const double> v, std::span<double> Av)> product;
  /// v <- approximately A^-1 v.
  std::function<void(std::span<double> v)> precondition;
};

struct GmresResult {
  bool reduced = false;  ///< |b - A x| < |b|
  bool reached = false;  ///< the tolerance was reached
  int iterations = 0;
};

/// Solves A x = b by flexible GMRES from x = 0, preconditioned from the right, until |b - A x| <= tolerance |b| in the
/// Euclidean norm. If that takes more than three times 30 iterations, x is the best that was reached. Nothing is
/// printed. errors: core::SolverError if there is not enough memory.
GmresResult gmres(const LinearSystem& system, std::span<const double> b, double tolerance, std::span<double> x);

}  // namespace ehl::newton
