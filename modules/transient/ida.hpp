#pragma once
// Variable order, variable step BDF by SUNDIALS IDA: the one place of this module that knows that library.
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>

namespace ehl::transient {

/// The implicit equations of one step as IDA poses them: find y and y' = yp_predicted + cj (y - y_predicted).
struct Stage {
  double T = 0.0;
  double cj = 0.0;  ///< 1/T: alpha/h
  std::span<const double> y_predicted;
  std::span<const double> yp_predicted;
  std::span<const double> weights;  ///< of the norm sqrt(mean((w v)^2)) in which IDA measures errors
  double tolerance = 0.0;           ///< in that norm, for the error that the iteration leaves
};

/// What the solution of a stage came to.
struct StageResult {
  bool solved = true;  ///< false: the step must be shorter
  int cycles = 0;
  int newton_steps = 0;
};

/// What IDA is to integrate. What the functions throw passes through IDA unharmed.
struct DaeProblem {
  std::size_t size = 0;
  /// Writes y - y_predicted.
  std::function<StageResult(const Stage& stage, std::span<double> correction)> solve;
  /// Weights of the error norm at y, all positive.
  std::function<void(double T, std::span<const double> y, std::span<double> weights)> weights;
  /// The step ends where this passes through zero from above; empty: nowhere.
  std::function<double(double T, std::span<const double> y)> event;
};

struct StepLimits {
  int max_order = 5;
  double first = 0.0;  ///< length of the first step; 0: IDA's choice
  double longest = std::numeric_limits<double>::infinity();
  double shortest = 1e-12;
};

/// One accepted step, or the reason why there is none.
struct StepReport {
  enum class End { accepted, at_stop, at_event, failed };
  End end = End::accepted;
  double T = 0.0;  ///< reached
  double length = 0.0;
  int order = 0;
  int cycles = 0;        ///< of all attempts at this step
  int newton_steps = 0;  ///< likewise
  int rejected = 0;      ///< attempts by the error test
  int not_solved = 0;    ///< attempts by the iteration
  std::string reason{};  ///< of a failure, in words
};

/// Owns IDA's memory for one problem, which must outlive it.
class Ida {
 public:
  /// in: y and y' at T, consistent as far as the equations see them. errors: core::SolverError where IDA cannot be set
  /// up (no memory).
  Ida(const DaeProblem& problem, const StepLimits& limits, double T, std::span<const double> y,
      std::span<const double> yp);
  ~Ida();
  Ida(const Ida&) = delete;
  Ida& operator=(const Ida&) = delete;

  /// Starts anew from here, at order one.
  void restart(double T, std::span<const double> y, std::span<const double> yp, double first_step);

  /// One step towards T_stop, which is never passed.
  StepReport step(double T_stop);

  /// After a step: y and y' there.
  std::span<const double> y() const;
  std::span<const double> yp() const;

  /// y at T within the last step. errors: std::logic_error outside it.
  void interpolate(double T, std::span<double> y) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ehl::transient
