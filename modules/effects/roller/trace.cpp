#include "effects/roller/trace.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "surface/gaussian_filter.hpp"

namespace ehl::roller {
namespace {

/// Share of the length on which the roughness is measured; the ends lie outside the contact.
constexpr double inner = 0.8;

// Slope of the least-squares line.
double slope_of(const std::vector<double>& Y, const std::vector<double>& H) {
  double Y_mean = 0.0, H_mean = 0.0;
  const auto n = static_cast<double>(Y.size());
  for (std::size_t k = 0; k < Y.size(); ++k) Y_mean += Y[k] / n, H_mean += H[k] / n;
  double YH = 0.0, YY = 0.0;
  for (std::size_t k = 0; k < Y.size(); ++k) {
    YH += (Y[k] - Y_mean) * (H[k] - H_mean);
    YY += (Y[k] - Y_mean) * (Y[k] - Y_mean);
  }
  return YH / YY;
}

double roughness_of(const std::vector<double>& Y, const std::vector<double>& H, double length) {
  const std::vector<double> form = surface::long_waves(Y, H, longest_of_roughness);
  double squares = 0.0, share = 0.0;
  for (std::size_t k = 1; k + 1 < Y.size(); ++k) {
    if (std::abs(Y[k]) > 0.5 * inner * length) continue;
    const double step = 0.5 * (Y[k + 1] - Y[k - 1]), rough = H[k] - form[k];
    squares += step * rough * rough;
    share += step;
  }
  return share > 0.0 ? std::sqrt(squares / share) : 0.0;
}

}  // namespace

void condition(const std::vector<double>& Y, std::vector<double>& H, bool mirrored, Profile& profile) {
  std::vector<double> all_Y = Y, all_H = H;
  const std::size_t half = mirrored ? Y.size() - 1 : 0;  // mirrored points
  for (std::size_t k = 0; k < half; ++k) {
    all_Y.insert(all_Y.begin(), -Y[k + 1]);
    all_H.insert(all_H.begin(), H[k + 1]);
  }
  Trace& trace = profile.trace;
  if (trace.level) {
    trace.slope = slope_of(all_Y, all_H);
    for (std::size_t k = 0; k < all_Y.size(); ++k) all_H[k] -= trace.slope * all_Y[k];
  }
  trace.rough_before = trace.rough = roughness_of(all_Y, all_H, profile.length);
  if (trace.shortest_wave > 0.0) {
    all_H = surface::long_waves(all_Y, all_H, trace.shortest_wave);
    trace.rough = roughness_of(all_Y, all_H, profile.length);
  }
  if (trace.level || trace.shortest_wave > 0.0)
    H.assign(all_H.begin() + static_cast<std::ptrdiff_t>(half), all_H.end());
}

}  // namespace ehl::roller
