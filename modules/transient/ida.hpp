#pragma once
// Integration by BDF of variable order and step (SUNDIALS IDA). Only ida.cpp includes that library.
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>

namespace ehl::transient {

/// The equations of one implicit step: find y and y' = yp_predicted + cj (y - y_predicted).
struct Stage {
  double T = 0.0;
  double cj = 0.0;  ///< alpha/h, in 1/T
  std::span<const double> y_predicted;
  std::span<const double> yp_predicted;
  std::span<const double> weights;  ///< w of the norm sqrt(mean((w v)^2)) in which IDA measures errors
  double tolerance = 0.0;           ///< bound of the algebraic error, in that norm
};

/// Outcome of one implicit step.
struct StageResult {
  bool solved = true;  ///< false: the step must be shorter
  int cycles = 0;
  int newton_steps = 0;
};

/// The system that IDA integrates. Exceptions of the functions reach the caller of Ida::step().
struct DaeProblem {
  std::size_t size = 0;
  /// Solves the step and writes y - y_predicted.
  std::function<StageResult(const Stage& stage, std::span<double> correction)> solve;
  /// Weights of the error norm at y, all positive.
  std::function<void(double T, std::span<const double> y, std::span<double> weights)> weights;
  /// The step ends where this function falls through zero; empty: no such event.
  std::function<double(double T, std::span<const double> y)> event;
};

/// Limits of order and step length for IDA; times in T.
struct StepLimits {
  int max_order = 5;
  double first = 0.0;  ///< length of the first step; 0: IDA's choice
  double longest = std::numeric_limits<double>::infinity();
  double shortest = 1e-12;
};

/// One accepted step, or the reason why it failed.
struct StepReport {
  enum class End { accepted, at_stop, at_event, failed };
  End end = End::accepted;
  double T = 0.0;  ///< time reached
  double length = 0.0;
  int order = 0;
  int cycles = 0;        ///< of all attempts at this step
  int newton_steps = 0;  ///< of all attempts at this step
  int rejected = 0;      ///< attempts that failed the error test
  int not_solved = 0;    ///< attempts whose equations were not solved
  std::string reason{};  ///< why the step failed
};

/// Owns IDA's memory for one problem, which must outlive it.
class Ida {
 public:
  /// in: y and y' at T, consistent. errors: core::SolverError if IDA cannot be set up (no memory).
  Ida(const DaeProblem& problem, const StepLimits& limits, double T, std::span<const double> y,
      std::span<const double> yp);
  ~Ida();
  Ida(const Ida&) = delete;
  Ida& operator=(const Ida&) = delete;

  /// Starts again from this state at order one.
  void restart(double T, std::span<const double> y, std::span<const double> yp, double first_step);

  /// One step towards T_stop, which it never passes.
  StepReport step(double T_stop);

  /// y and y' after a step.
  std::span<const double> y() const;
  std::span<const double> yp() const;

  /// y at T within the last step. errors: std::logic_error outside it.
  void interpolate(double T, std::span<double> y) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ehl::transient
