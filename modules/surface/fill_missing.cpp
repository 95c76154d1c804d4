#include "surface/fill_missing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ehl::surface {
namespace {

constexpr double most_missing = 0.2;  // share of all points
/// Number of relaxations of the missing points, and the largest change, relative to the range
/// of heights, that ends them.
constexpr int most_sweeps = 2000;
constexpr double settled = 1e-7;
constexpr double over_relaxation = 1.7;

// Sum and number of the known neighbours.
std::pair<double, int> neighbours(const Heights& z, int k, int l) {
  double sum = 0.0;
  int known = 0;
  const auto take = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= z.nx || j >= z.ny || std::isnan(z(i, j))) return;
    sum += z(i, j);
    ++known;
  };
  take(k - 1, l);
  take(k + 1, l);
  take(k, l - 1);
  take(k, l + 1);
  return {sum, known};
}

// First guess: each missing point becomes the mean of its known neighbours, from the edges of the holes inwards.
void begin_from_edges(Heights& z, std::vector<std::pair<int, int>> holes) {
  while (!holes.empty()) {
    std::vector<std::pair<int, int>> later;
    std::vector<double> values;
    std::vector<std::pair<int, int>> now;
    for (const auto& [k, l] : holes) {
      const auto [sum, known] = neighbours(z, k, l);
      if (known > 0)
        now.emplace_back(k, l), values.push_back(sum / known);
      else
        later.emplace_back(k, l);
    }
    for (std::size_t n = 0; n < now.size(); ++n) z(now[n].first, now[n].second) = values[n];
    holes = std::move(later);
  }
}

}  // namespace

std::string fill_missing(Heights& z, int& filled) {
  std::vector<std::pair<int, int>> holes;
  double least = INFINITY, most = -INFINITY;
  for (int l = 0; l < z.ny; ++l)
    for (int k = 0; k < z.nx; ++k)
      if (std::isnan(z(k, l)))
        holes.emplace_back(k, l);
      else
        least = std::min(least, z(k, l)), most = std::max(most, z(k, l));
  filled = static_cast<int>(holes.size());
  if (holes.empty()) return {};
  const double share = static_cast<double>(holes.size()) / static_cast<double>(z.values.size());
  if (share > most_missing)
    return fmt::format("{} of {} points are missing, {:.0f} %; at most {:.0f} % can be filled", holes.size(),
                       z.values.size(), 100.0 * share, 100.0 * most_missing);
  begin_from_edges(z, holes);
  double change = INFINITY;
  for (int sweep = 0; sweep < most_sweeps && change > settled * (most - least); ++sweep) {
    change = 0.0;
    for (const auto& [k, l] : holes) {
      const auto [sum, known] = neighbours(z, k, l);
      const double step = over_relaxation * (sum / known - z(k, l));
      z(k, l) += step;
      change = std::max(change, std::abs(step));
    }
  }
  return {};
}

}  // namespace ehl::surface
