#pragma once
// Positive parameters of a model that costs much, from measured values: Gauss and Newton's method in their logarithms,
// damped as Levenberg and Marquardt do it.
#include <functional>
#include <vector>

namespace ehl::program {

/// The model at several sets of parameters at once: they may be computed side by side. NaN where it has no value.
using Model = std::function<std::vector<std::vector<double>>(const std::vector<std::vector<double>>& parameters)>;

struct Measurement {
  double value = 0.0;
  double sigma = 0.0;  ///< its standard error; 0: unknown, the same for all
};

struct Fit {
  std::vector<double> parameters{};
  std::vector<double> errors{};                    ///< relative standard error of each
  std::vector<std::vector<double>> correlation{};  ///< between them
  std::vector<double> model{};                     ///< at them, one for each measurement
  double deviation = 0.0;                          ///< of the measurements from it, root of the mean square
  int rounds = 0;
  bool settled = false;  ///< the last step is a small part of the errors
};

/// Minimises the sum of ((value - model)/sigma)^2. The errors follow from the scatter about the fit where no sigma is
/// known, and are never less than it says. in: more measurements than parameters; start > 0.
/// errors: core::SolverError where the model has no value at the start, or does not depend on a parameter there.
Fit least_squares(const Model& model, const std::vector<Measurement>& measured, std::vector<double> start);

}  // namespace ehl::program
