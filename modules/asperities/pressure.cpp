#include "asperities/pressure.hpp"

#include <cmath>
#include <utility>

namespace ehl::asperities {
namespace {

constexpr double sharpness = 8.0;  // of the cap at the hardness

double uncapped(const AsperityPressure& law, double h) {
  return std::exp(-rheology::value(*law.curve.fall, h - law.curve.first_gap));
}

// (1 + (p/hardness)^8)^(-1/8), the capped pressure over p. For p far above the hardness the power would overflow.
double cap(double p, double hardness) {
  const double ratio = p / hardness;
  if (ratio > 1e4) return 1.0 / ratio;
  return std::pow(1.0 + std::pow(ratio, sharpness), -1.0 / sharpness);
}

}  // namespace

PressureCurve pressure_curve(std::span<const double> gaps, std::span<const double> pressures,
                             std::span<const double> slopes) {
  std::vector<double> x, y;
  for (const double gap : gaps) x.push_back(gap - gaps.front());
  for (const double p : pressures) y.push_back(-std::log(p));
  rheology::Curve curve = rheology::monotone_curve(x, y);
  for (std::size_t k = 0; k < slopes.size(); ++k) curve.slope[k] = -slopes[k] / pressures[k];
  return {std::make_shared<const rheology::Curve>(std::move(curve)), gaps.front()};
}

void pressure(const AsperityPressure& law, std::span<const double> H, std::span<double> P) {
  for (std::size_t k = 0; k < H.size(); ++k) {
    const double p = uncapped(law, law.gap_scale * H[k]);
    P[k] = p * cap(p, law.hardness) / law.p_h;
  }
}

// d p_c/dp = (1 + (p/hardness)^8)^(-9/8), and dp/dh = -p d(-ln p)/dh.
void pressure_slope(const AsperityPressure& law, std::span<const double> H, std::span<double> dP) {
  for (std::size_t k = 0; k < H.size(); ++k) {
    const double h = law.gap_scale * H[k];
    const double p = uncapped(law, h);
    const double fall = rheology::slope(*law.curve.fall, h - law.curve.first_gap);
    dP[k] = -p * fall * std::pow(cap(p, law.hardness), sharpness + 1.0) * law.gap_scale / law.p_h;
  }
}

}  // namespace ehl::asperities
