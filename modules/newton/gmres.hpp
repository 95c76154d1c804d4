#pragma once
// Flexible GMRES by SUNDIALS: the one place of this module that knows that library.
#include <functional>
#include <span>

namespace ehl::newton {

/// A x = b as GMRES sees it. What the functions throw passes through the library unharmed.
struct LinearSystem {
  std::function<void(std::span<const double> v, std::span<double> Av)> product;
  /// v <- approximately A^-1 v.
  std::function<void(std::span<double> v)> precondition;
};

struct GmresResult {
  bool reduced = false;  ///< |b - A x| < |b|
  bool reached = false;  ///< the tolerance
  int iterations = 0;
};

/// x with |b - A x| <= tolerance |b| in the Euclidean norm, from x = 0, preconditioned from the right; where it does
/// not get so far within three times 30 iterations, as far as it got. Nothing is printed. errors: core::SolverError
/// without enough memory.
GmresResult gmres(const LinearSystem& system, std::span<const double> b, double tolerance, std::span<double> x);

}  // namespace ehl::newton
