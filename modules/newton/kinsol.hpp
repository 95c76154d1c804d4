#pragma once
// Newton-Krylov steps by SUNDIALS KINSOL: the one place of this module that knows that library.
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace ehl::newton {

/// F(u) = 0 as KINSOL sees it. What the functions throw passes through KINSOL unharmed.
struct KrylovProblem {
  std::size_t size = 0;
  /// F(u). false: F has no value there; KINSOL tries half the step.
  std::function<bool(std::span<const double> u, std::span<double> F)> residual;
  /// Before the linear solve at u, where residual() was called last. false: singular.
  std::function<bool(std::span<const double> u)> linearize;
  /// Jv = F'(u) v.
  std::function<void(std::span<const double> v, std::span<double> Jv)> jacobian;
  /// v <- approximately F'(u)^-1 v.
  std::function<void(std::span<double> v)> precondition;
};

struct KinsolStep {
  std::string reason;  ///< what went wrong, in words; empty where nothing did
  long linear_iterations = 0;
};

/// Owns KINSOL's memory for one problem, which must outlive it.
class Kinsol {
 public:
  /// errors: core::SolverError when KINSOL cannot be set up (no memory).
  explicit Kinsol(const KrylovProblem& problem);
  ~Kinsol();
  Kinsol(const Kinsol&) = delete;
  Kinsol& operator=(const Kinsol&) = delete;

  /// One inexact Newton step: u <- u + d, |F(u) + F'(u) d| <= linear_tolerance |F(u)| in the Euclidean norm, by
  /// flexible GMRES preconditioned from the right. Where GMRES does not get so far, as far as it got. Nothing is
  /// printed.
  KinsolStep step(std::span<double> u, double linear_tolerance);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ehl::newton
