#include "case/course_of_run.hpp"

#include <algorithm>
#include <cmath>

#include "case/effects.hpp"
#include "case/numbers/names.hpp"

namespace ehl::program {
namespace {

using transient::StepRow;

/// Times that differ by less, relative, are equal but for rounding.
constexpr double rounding_of_time = 1e-9;

}  // namespace

Window window_of_means(const Case& input, const TransientResult& run) {
  const transient::MarchParameters& march = input.transient->parameters;
  const double end = run.rows.empty() ? 0.0 : run.rows.back().T;
  if (!std::isnan(march.start_of_means)) return {march.start_of_means, end};
  const double periods = std::floor(end / march.period * (1.0 + rounding_of_time));
  if (!(periods >= 1.0)) return {0.0, end};
  return {(periods - 1.0) * march.period, std::min(end, periods * march.period)};
}

Extremes extremes_of(const TransientResult& run, const Window& window, const std::vector<double>& values) {
  Extremes made;
  if (values.empty()) return made;
  double sum = 0.0, time = 0.0;
  const double slack = rounding_of_time * window.to;
  const std::vector<StepRow>& rows = run.rows;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double T = rows[k].T;
    if (T >= window.from - slack && T <= window.to + slack) {
      const auto take = [&](double& extreme, double& its_time, bool more) {
        if (std::isnan(values[k]) || !(std::isnan(extreme) || more)) return;
        extreme = values[k];
        its_time = T;
      };
      take(made.least, made.time_of_least, values[k] < made.least);
      take(made.largest, made.time_of_largest, values[k] > made.largest);
    }
    if (k == 0 || std::isnan(values[k - 1] + values[k])) continue;
    const double before = rows[k - 1].T;
    const double from = std::clamp(window.from, before, T), to = std::clamp(window.to, before, T);
    if (!(to > from)) continue;
    const auto at = [&](double t) {
      return values[k - 1] + (values[k] - values[k - 1]) * ((t - before) / (T - before));
    };
    sum += 0.5 * (to - from) * (at(from) + at(to));
    time += to - from;
  }
  if (time > 0.0) made.mean = sum / time;
  return made;
}

std::vector<double> values_of(const TransientResult& run, const std::string& number) {
  const auto of_rows = [&](double StepRow::*part) {
    std::vector<double> values;
    for (const StepRow& row : run.rows) values.push_back(row.*part);
    return values;
  };
  if (number == id::Hc) return of_rows(&StepRow::Hc);
  if (number == id::Hm) return of_rows(&StepRow::Hm);
  if (number == id::P_max) return of_rows(&StepRow::P_max);
  return column_of(run, number);
}

Extremes extremes_of(const Case& input, const TransientResult& run, const std::string& number) {
  return extremes_of(run, window_of_means(input, run), values_of(run, number));
}

Extremes extremes_of_magnitude(const Case& input, const TransientResult& run, const std::string& number) {
  std::vector<double> values = values_of(run, number);
  for (double& value : values) value = std::abs(value);
  return extremes_of(run, window_of_means(input, run), values);
}

}  // namespace ehl::program
