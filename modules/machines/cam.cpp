#include "machines/cam.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace ehl::machines {
namespace {

constexpr double revolution = 2.0 * core::pi;

// The angle that the table has, whole revolutions away from phi.
double in_table(const Spline& spline, double phi) {
  return phi - revolution * std::floor((phi - spline.x.front()) / revolution);
}

}  // namespace

CamState state_at(const Cam& cam, double phi, double omega) {
  const double angle = in_table(cam.lift, phi);
  const bool rises = angle <= cam.lift.x.back();
  const SplineValue s = rises ? at(cam.lift, angle) : SplineValue{};
  const double R = cam.base_radius + s.value + s.second;
  const double sprung = cam.spring_force + cam.spring_stiffness * s.value + cam.mass * omega * omega * s.second;
  const double load = cam.load ? at(*cam.load, std::min(angle, cam.load->x.back())).value : sprung;
  return {s.value, s.second, R, omega * R, omega * s.second, load};
}

double error_of_second(const Cam& cam) {
  const Spline& all = cam.lift;
  std::vector<double> x, y;
  for (std::size_t k = 0; k < all.x.size(); k += 2) {
    x.push_back(all.x[k]);
    y.push_back(all.y[k]);
  }
  if (x.back() != all.x.back()) {
    x.push_back(all.x.back());
    y.push_back(all.y.back());
  }
  const Spline half = clamped_spline(x, y);
  double largest = 0.0;
  for (std::size_t k = 2; k + 2 < half.x.size(); ++k)  // the ends may be those of a period
    largest = std::max(largest, std::abs(half.second[k] - at(all, half.x[k]).second));
  return largest / 3.0;
}

}  // namespace ehl::machines
