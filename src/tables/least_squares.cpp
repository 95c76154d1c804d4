#include "tables/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/errors.hpp"

namespace ehl::program {
namespace {

using Vector = std::vector<double>;
using Matrix = std::vector<Vector>;

// Change of the logarithm of a parameter in a finite-difference slope. The change of friction is then large compared
// with the iteration error of its solutions.
constexpr double slope_step = 0.05;
constexpr int most_rounds = 20;
// Step limit: no parameter changes by more than a factor of e in one step.
constexpr double most_step = 1.0;
// A step is small if it is below this share of the error of its parameter, or below `small_step`.
constexpr double small_beside_error = 0.05, small_step = 1e-4;
constexpr double first_damping = 1e-3, damping_factor = 10.0, most_damping = 1e8;

// Gauss-Jordan elimination without pivoting, for symmetric positive definite matrices.
Matrix inverse(Matrix m) {
  const std::size_t n = m.size();
  Matrix result(n, Vector(n, 0.0));
  for (std::size_t k = 0; k < n; ++k) result[k][k] = 1.0;
  for (std::size_t k = 0; k < n; ++k) {
    const double pivot = m[k][k];
    for (std::size_t j = 0; j < n; ++j) {
      m[k][j] /= pivot;
      result[k][j] /= pivot;
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = m[i][k];
      for (std::size_t j = 0; j < n; ++j) {
        m[i][j] -= factor * m[k][j];
        result[i][j] -= factor * result[k][j];
      }
    }
  }
  return result;
}

double weight(const Measurement& one) { return one.sigma > 0.0 ? 1.0 / (one.sigma * one.sigma) : 1.0; }

double squares(const std::vector<Measurement>& measured, const Vector& model) {
  double sum = 0.0;
  for (std::size_t i = 0; i < measured.size(); ++i)
    sum += weight(measured[i]) * std::pow(measured[i].value - model[i], 2);
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

// The normal equations: products of the slopes, and the slopes times the deviations.
struct Normal {
  Matrix products;
  Vector right;
};
Normal normal_of(const std::vector<Measurement>& measured, const std::vector<Vector>& values) {
  const std::size_t n = values.size() - 1;
  Normal normal{Matrix(n, Vector(n, 0.0)), Vector(n, 0.0)};
  for (std::size_t i = 0; i < measured.size(); ++i)
    for (std::size_t a = 0; a < n; ++a) {
      const double slope = (values[a + 1][i] - values[0][i]) / slope_step;
      normal.right[a] += weight(measured[i]) * slope * (measured[i].value - values[0][i]);
      for (std::size_t b = 0; b < n; ++b)
        normal.products[a][b] += weight(measured[i]) * slope * (values[b + 1][i] - values[0][i]) / slope_step;
    }
  for (std::size_t a = 0; a < n; ++a)
    if (!(normal.products[a][a] > 0.0) || !std::isfinite(normal.products[a][a]))
      throw core::SolverError(
          "the model does not depend on a free parameter at this point: fix the parameter, or start elsewhere");
  return normal;
}

Vector step_of(const Normal& normal, double damping) {
  Matrix damped = normal.products;
  for (std::size_t a = 0; a < damped.size(); ++a) damped[a][a] *= 1.0 + damping;
  const Matrix inverted = inverse(damped);
  Vector step(damped.size(), 0.0);
  for (std::size_t a = 0; a < step.size(); ++a) {
    for (std::size_t b = 0; b < step.size(); ++b) step[a] += inverted[a][b] * normal.right[b];
    step[a] = std::clamp(step[a], -most_step, most_step);
  }
  return step;
}

void take_errors(const std::vector<Measurement>& measured, const Normal& normal, double sum, Fit& fit) {
  const bool known = std::ranges::all_of(measured, [](const Measurement& one) { return one.sigma > 0.0; });
  const double scatter = sum / static_cast<double>(measured.size() - fit.parameters.size());
  const Matrix covariance = inverse(normal.products);
  const std::size_t n = covariance.size();
  fit.errors.assign(n, 0.0);
  fit.correlation.assign(n, Vector(n, 0.0));
  for (std::size_t a = 0; a < n; ++a) {
    fit.errors[a] = std::sqrt(covariance[a][a] * (known ? std::max(1.0, scatter) : scatter));
    for (std::size_t b = 0; b < n; ++b)
      fit.correlation[a][b] = covariance[a][b] / std::sqrt(covariance[a][a] * covariance[b][b]);
  }
}

std::vector<Vector> with_slopes(const Vector& parameters) {
  std::vector<Vector> sets(parameters.size() + 1, parameters);
  for (std::size_t a = 0; a < parameters.size(); ++a) sets[a + 1][a] *= std::exp(slope_step);
  return sets;
}

bool small(const Vector& step, const Vector& errors) {
  for (std::size_t a = 0; a < step.size(); ++a)
    if (std::abs(step[a]) > std::max(small_step, small_beside_error * errors[a])) return false;
  return true;
}

}  // namespace

Fit least_squares(const Model& model, const std::vector<Measurement>& measured, std::vector<double> start) {
  Fit fit{.parameters = std::move(start)};
  Vector tried = fit.parameters;
  Normal normal;
  double least = std::numeric_limits<double>::infinity(), damping = first_damping;
  while (fit.rounds < most_rounds && damping < most_damping) {
    ++fit.rounds;
    const std::vector<Vector> values = model(with_slopes(tried));
    const double sum = squares(measured, values[0]);
    if (sum < least) {
      least = sum;
      fit.parameters = tried;
      fit.model = values[0];
      normal = normal_of(measured, values);
      take_errors(measured, normal, sum, fit);
      damping /= damping_factor;
    } else if (fit.model.empty()) {
      throw core::SolverError(
          "the model has no value at the start, because some cases did not converge: start elsewhere");
    } else {
      damping *= damping_factor;
    }
    const Vector step = step_of(normal, damping);
    if (small(step, fit.errors)) {
      fit.settled = true;
      break;
    }
    for (std::size_t a = 0; a < step.size(); ++a) tried[a] = fit.parameters[a] * std::exp(step[a]);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < measured.size(); ++i) sum += std::pow(measured[i].value - fit.model[i], 2);
  fit.deviation = std::sqrt(sum / static_cast<double>(measured.size()));
  return fit;
}

}  // namespace ehl::program
