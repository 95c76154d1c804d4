#include <algorithm>
#include <cmath>

#include "mlmi/semi_coarsening.hpp"

namespace ehl::mlmi {
namespace {

int floor_half(int i) { return i >= 0 ? i / 2 : -((1 - i) / 2); }
std::size_t index(int k) { return static_cast<std::size_t>(k); }

}  // namespace

Axis coarsened(const Axis& fine, int order) {
  const int p = order / 2;
  // An odd point 2J+1 needs J-p+1 .. J+p; the outermost odd points need more than the outermost even ones.
  const int first_odd = fine.first % 2 == 0 ? fine.first + 1 : fine.first;
  const int last_odd = fine.last % 2 == 0 ? fine.last - 1 : fine.last;
  const int last = fine.end == core::Edge::mirror ? fine.last / 2 : floor_half(last_odd - 1) + p;
  return {floor_half(first_odd - 1) - p + 1, last, 2 * fine.every, fine.h, fine.end};
}

std::array<double, 4> midpoint_weights(int order) {
  if (order == 4) return {9.0 / 16.0, -1.0 / 16.0, 0.0, 0.0};
  if (order == 6) return {150.0 / 256.0, -25.0 / 256.0, 3.0 / 256.0, 0.0};
  return {1225.0 / 2048.0, -245.0 / 2048.0, 49.0 / 2048.0, -5.0 / 2048.0};
}

Correction correction(const Axis& along, const Axis& across, int order, int m1, int m2, const kernel::Kernel& kernel) {
  const int p = order / 2;
  const std::array<double, 4> weights = midpoint_weights(order);
  const int rows = m1 + margin, columns = m2 + margin;
  const auto K = kernel::influence_table(kernel, rows + 2 * p, columns, along.h, across.h, along.every, across.every);
  const auto interpolation_error = [&](int d, int e) {
    double error = K(d, e);
    for (int k = 1; k <= p; ++k) error -= weights[index(k - 1)] * (K(d - (2 * k - 1), e) + K(d + (2 * k - 1), e));
    return kernel.factor * error;
  };
  // Entries inside the patch are dropped if they are smaller than the largest one just outside it.
  double threshold = 0.0;
  for (int d = 0; d <= m1 + 1; ++d) threshold = std::max(threshold, std::abs(interpolation_error(d, m2 + 1)));
  for (int e = 0; e <= m2 + 1; ++e) threshold = std::max(threshold, std::abs(interpolation_error(m1 + 1, e)));

  Correction result{m1, m2, std::vector<int>(index(m2) + 1), {}};
  for (int e = 0; e <= m2; ++e) {
    for (int d = -m1; d <= m1; ++d) result.C.push_back(interpolation_error(d, e));
    int reach = m1;
    while (reach > 1 && std::abs(interpolation_error(reach, e)) < threshold) --reach;
    result.reach[index(e)] = reach;
  }
  // Where u is smooth the dropped entries act through their sum alone, so the sum is added at the edge of the patch:
  // separately for even and odd distances, because the even points of the grid use the odd distances only.
  double even = 0.0, odd = 0.0;
  for (int d = -rows; d <= rows; ++d)
    for (int e = -columns; e <= columns; ++e) {
      const bool kept = std::abs(e) <= m2 && std::abs(d) <= result.reach[index(std::abs(e))];
      if (!kept) (d % 2 == 0 ? even : odd) += interpolation_error(d, e);
    }
  double* edge = result.C.data() + m2 * (2 * m1 + 1) + m1;
  const double sides = m2 == 0 ? 1.0 : 2.0;
  edge[0] += even / sides;
  edge[1] += odd / (2.0 * sides);
  edge[-1] += odd / (2.0 * sides);
  return result;
}

}  // namespace ehl::mlmi
