#pragma once
// Least-squares fit of positive parameters of an expensive model to measured values: the Levenberg-Marquardt method in
// the logarithms of the parameters.
#include <functional>
#include <vector>

namespace ehl::program {

/// Computes the model for several sets of parameters at once, possibly in parallel. NaN if it has no value.
using Model = std::function<std::vector<std::vector<double>>(const std::vector<std::vector<double>>& parameters)>;

struct Measurement {
  double value = 0.0;
  double sigma = 0.0;  ///< standard error of the value; 0: unknown, and the same for all measurements
};

struct Fit {
  std::vector<double> parameters{};
  std::vector<double> errors{};                    ///< relative standard error of each parameter
  std::vector<std::vector<double>> correlation{};  ///< correlation coefficients of the parameters
  std::vector<double> model{};                     ///< the fitted model, one value per measurement
  double deviation = 0.0;                          ///< root mean square deviation of the measurements from the model
  int rounds = 0;
  bool settled = false;  ///< the last step was small compared with the errors of the parameters
};

/// Minimises the sum of ((value - model)/sigma)^2. The errors of the parameters follow from the scatter about the fit
/// if sigma is unknown; otherwise they are at least those that the scatter implies.
/// in: more measurements than parameters; start > 0.
/// errors: core::SolverError if the model has no value at the start, or does not depend on a parameter there.
Fit least_squares(const Model& model, const std::vector<Measurement>& measured, std::vector<double> start);

}  // namespace ehl::program
