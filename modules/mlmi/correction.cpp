#include <algorithm>
#include <cmath>

#include "kernel/influence.hpp"
#include "mlmi/semi_coarsening.hpp"

namespace ehl::mlmi {
namespace {

int floor_half(int i) { return i >= 0 ? i / 2 : -((1 - i) / 2); }

}  // namespace

Axis coarsened(const Axis& fine, int order) {
  const int p = order / 2;
  // An odd point 2J+1 takes J-p+1 ... J+p; the outermost odd points reach further than the outermost even ones.
  const int first_odd = fine.first % 2 == 0 ? fine.first + 1 : fine.first;
  const int last_odd = fine.last % 2 == 0 ? fine.last - 1 : fine.last;
  return {floor_half(first_odd - 1) - p + 1, floor_half(last_odd - 1) + p, 2 * fine.every, fine.h};
}

std::array<double, 4> midpoint_weights(int order) {
  if (order == 4) return {9.0 / 16.0, -1.0 / 16.0, 0.0, 0.0};
  if (order == 6) return {150.0 / 256.0, -25.0 / 256.0, 3.0 / 256.0, 0.0};
  return {1225.0 / 2048.0, -245.0 / 2048.0, 49.0 / 2048.0, -5.0 / 2048.0};
}

Correction correction(const Axis& along, const Axis& across, int order, int m1, int m2, double factor) {
  const int p = order / 2;
  const std::array<double, 4> weights = midpoint_weights(order);
  // A margin around the patch shows what is dropped.
  const int margin = 1, rows = m1 + margin, columns = m2 + margin;
  const auto K = kernel::influence_table(rows + 2 * p, columns, along.h, across.h, along.every, across.every);
  const auto interpolation_error = [&](int d, int e) {
    double error = K(d, e);
    for (int k = 1; k <= p; ++k)
      error -= weights[static_cast<std::size_t>(k - 1)] * (K(d - (2 * k - 1), e) + K(d + (2 * k - 1), e));
    return error;
  };
  double dropped = 0.0;
  for (int d = 0; d <= rows; ++d)
    for (int e = 0; e <= columns; ++e)
      if (d > m1 || e > m2) dropped = std::max(dropped, std::abs(interpolation_error(d, e)));

  Correction result{m1, m2, std::vector<int>(static_cast<std::size_t>(m2) + 1), {}};
  for (int e = 0; e <= m2; ++e) {
    for (int d = -m1; d <= m1; ++d) result.C.push_back(factor * interpolation_error(d, e));
    int reach = m1;
    while (reach > 0 && std::abs(interpolation_error(reach, e)) < dropped) --reach;
    result.reach[static_cast<std::size_t>(e)] = reach;
  }
  return result;
}

}  // namespace ehl::mlmi
