#include "judgement/error_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ehl::judgement {
namespace {

// Mesh size over the width of the zones in which the film forms; infinite for a film that is not positive.
double step_in_zones(double h, double Hm) {
  return Hm > 0.0 ? h / std::pow(Hm, 2.0 / 3.0) : std::numeric_limits<double>::infinity();
}

}  // namespace

ErrorEstimate estimate_error(const Tuning& tuning, std::span<const double> values, double scheme_order, double least,
                             std::optional<double> slowest_order) {
  const std::size_t n = values.size();
  if (n < 2) return {core::unknown, core::unknown};
  const double last_change = values[n - 1] - values[n - 2];
  double observed = core::unknown;
  if (n > 2) observed = std::log2((values[n - 2] - values[n - 3]) / last_change);
  double order = scheme_order;
  const double lowest_order = 0.5 * scheme_order;
  if (n > 2)
    order = std::isfinite(observed) ? std::clamp(observed, slowest_order.value_or(lowest_order), scheme_order)
                                    : lowest_order;
  const double factor = n > 2 ? tuning.safety : tuning.safety_of_two;
  double change = std::abs(last_change);
  if (n > 2) {
    const double before = std::abs(values[n - 2] - values[n - 3]);
    // A change that is far smaller than the scheme's order predicts is the difference of cancelling errors.
    if (change < before / std::exp2(scheme_order + tuning.cancelled_change)) {
      // Such changes have no order, and the next change may be as large as the one before.
      change = before / std::exp2(scheme_order);
      order = lowest_order;
    } else {
      // Changes that fall much faster than the scheme's order are about to change sign.
      change = std::max(change, before / std::exp2(scheme_order + 1.0));
    }
  }
  const double error = factor * std::abs(change / (std::exp2(order) - 1.0) / values[n - 1]);
  return {std::max(error, least), observed};
}

FilmErrors errors_beside_meniscus(const Tuning& tuning, std::span<const double> Hc, std::span<const double> Hm) {
  const std::size_t n = Hc.size();
  if (n < 2) return {core::unknown, core::unknown};
  const auto change = [](std::span<const double> of, std::size_t k) {
    return std::abs((of[k] - of[k - 1]) / of.back());
  };
  const double of_Hm =
      n > 2 ? std::max(change(Hm, n - 1), 0.5 * change(Hm, n - 2)) : tuning.safety_of_two * change(Hm, n - 1);
  return {(n > 2 ? tuning.safety : tuning.safety_of_two) * change(Hc, n - 1) / 3.0 + tuning.share_of_Hm * of_Hm, of_Hm};
}

double first_order_floor(const Tuning& tuning, double h, double Hm) {
  return tuning.first_order_share * step_in_zones(h, Hm);
}

double third_order_floor(double h, double Hm, double share) {
  const double step = step_in_zones(h, Hm);
  return share * step * step;
}

double error_of_one_grid(const Tuning& tuning, double h, double Hm, double scheme_order) {
  const double step = step_in_zones(h, Hm);
  return scheme_order > 1.0 ? tuning.second_order_share * step * step
                            : tuning.first_order_share * step * std::max(1.0, step);
}

Extrapolation extrapolate(std::span<const double> values, double scheme_order, double unsure) {
  const std::size_t n = values.size();
  if (n < 3) return {};
  const double share = 1.0 / (std::exp2(scheme_order) - 1.0);
  const double correction = share * (values[n - 1] - values[n - 2]);
  const double value = values[n - 1] + correction;
  const double before = values[n - 2] + share * (values[n - 2] - values[n - 3]);
  const double error = std::max(std::abs(value - before), unsure * std::abs(correction)) / std::abs(value);
  if (!(error < 1.0 && value * values[n - 1] > 0.0)) return {};
  return {value, error};
}

}  // namespace ehl::judgement
