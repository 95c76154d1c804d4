#include "effects/roller/slices.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/ellipse.hpp"

namespace ehl::roller {

Bearing bearing(const Profile& profile) {
  constexpr int slices = 4000;
  const double width = profile.length / slices, mean = contact::roller_contact(profile.length).approach;
  std::vector<double> gap;
  for (int k = 0; k < slices; ++k) {
    const double Y = -0.5 * profile.length + (k + 0.5) * width;
    gap.push_back(drop(profile, Y) + profile.tilt * Y);
  }
  const double nearer_end = std::min(gap.front(), gap.back());
  std::ranges::sort(gap);
  // If the n slices with the smallest gaps carry the load, n approach - sum of their gaps = slices mean. n grows as
  // long as the approach exceeds the gap of the next slice.
  double sum = 0.0, approach = 0.0;
  int loaded = 0;
  do {
    sum += gap[static_cast<std::size_t>(loaded++)];
    approach = (slices * mean + sum) / loaded;
  } while (loaded < slices && gap[static_cast<std::size_t>(loaded)] < approach);
  const double heaviest = (approach - gap.front()) / mean;
  return {loaded * width, heaviest, std::max(0.0, approach - nearer_end) / mean, std::pow(heaviest, 0.5 * 1.3)};
}

}  // namespace ehl::roller
