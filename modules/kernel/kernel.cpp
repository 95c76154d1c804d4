#include "kernel/kernel.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/cell_quadrature.hpp"

namespace ehl::kernel {
namespace {

// Distances, in cells, from which on Gauss' rule with 6, 4 and 3 points integrates the smooth part to 1e-12. The
// nearest singularity of the smooth part is at least the thickness away.
constexpr double from_6 = 3.0, from_4 = 10.0, from_3 = 24.0;

double integral(const SmoothPart& smooth, double X, double Y, double hx, double hy) {
  const double side = std::max(hx, hy);
  const double distance = std::hypot(X, Y, smooth.thickness()) / side;
  const auto value = [&](double x, double y) { return smooth(std::hypot(x, y)); };
  if (distance >= from_3) return integrate_over_cell<3>(X, Y, hx, hy, value);
  if (distance >= from_4) return integrate_over_cell<4>(X, Y, hx, hy, value);
  if (distance >= from_6) return integrate_over_cell<6>(X, Y, hx, hy, value);
  double sum = 0.0;
  for (const double x : {X - 0.25 * hx, X + 0.25 * hx})
    for (const double y : {Y - 0.25 * hy, Y + 0.25 * hy}) sum += integral(smooth, x, y, 0.5 * hx, 0.5 * hy);
  return sum;
}

double line_integral(const SmoothPart& smooth, double X, double hx) {
  if (std::hypot(X, smooth.thickness()) < from_6 * hx)
    return line_integral(smooth, X - 0.25 * hx, 0.5 * hx) + line_integral(smooth, X + 0.25 * hx, 0.5 * hx);
  using Rule = GaussRule<6>;
  double sum = 0.0;
  for (std::size_t k = 0; k < Rule::node.size(); ++k) sum += Rule::weight[k] * smooth(std::abs(X + Rule::node[k] * hx));
  return hx * sum;
}

double uncoated(const Kernel& kernel, double r) { return kernel.plane ? -std::log(r) : 1.0 / r; }

// Makes the coefficient K of the uncoated bodies that of the coated ones. in: of(smooth), the integral of a smooth
// part.
template <class Integral>
void add_coatings(const Kernel& kernel, double& K, Integral of) {
  double local = 1.0;
  for (const SmoothPart& smooth : kernel.coatings) local += smooth.local();
  K *= local;
  for (const SmoothPart& smooth : kernel.coatings) K += of(smooth);
}

}  // namespace

double by_coatings(const Kernel& kernel, double r) {
  double sum = 0.0;
  for (const SmoothPart& smooth : kernel.coatings) sum += smooth.local() * uncoated(kernel, r) + smooth(r);
  return sum;
}

double at_distance(const Kernel& kernel, double r) { return uncoated(kernel, r) + by_coatings(kernel, r); }

double influence(const Kernel& kernel, int d_x, int d_y, double hx, double hy) {
  double K = influence(d_x, d_y, hx, hy);
  add_coatings(kernel, K, [&](const SmoothPart& smooth) { return integral(smooth, d_x * hx, d_y * hy, hx, hy); });
  return K;
}

double distributed_influence(const Kernel& kernel, int d_x, int d_y, double hx, double hy) {
  if (kernel.coatings.empty()) return distributed_influence(d_x, d_y, hx, hy);
  const auto K = [&](int i, int j) { return influence(kernel, i, j, hx, hy); };
  return K(d_x, d_y) - 0.25 * (K(d_x + 1, d_y) + K(d_x - 1, d_y) + K(d_x, d_y + 1) + K(d_x, d_y - 1));
}

InfluenceTable influence_table(const Kernel& kernel, int n_x, int n_y, double hx, double hy, int every_x, int every_y) {
  InfluenceTable table = influence_table(n_x, n_y, hx, hy, every_x, every_y);
  if (kernel.coatings.empty()) return table;
  double* K = table.K.data();
  for (int i = 0; i <= n_x; ++i)
    for (int j = 0; j <= n_y; ++j, ++K)
      add_coatings(kernel, *K, [&](const SmoothPart& smooth) {
        return integral(smooth, i * every_x * hx, j * every_y * hy, hx, hy);
      });
  return table;
}

double line_influence(const Kernel& kernel, int d, double hx) {
  double K = line_influence(d, hx);
  add_coatings(kernel, K, [&](const SmoothPart& smooth) { return line_integral(smooth, d * hx, hx); });
  return K;
}

double distributed_line_influence(const Kernel& kernel, int d, double hx) {
  return line_influence(kernel, d, hx) - 0.5 * (line_influence(kernel, d - 1, hx) + line_influence(kernel, d + 1, hx));
}

std::vector<double> line_influence_table(const Kernel& kernel, int n, double hx, int every) {
  std::vector<double> table = line_influence_table(n, hx, every);
  if (kernel.coatings.empty()) return table;
  for (int d = 0; d <= n; ++d)
    add_coatings(kernel, table[static_cast<std::size_t>(d)],
                 [&](const SmoothPart& smooth) { return line_integral(smooth, d * every * hx, hx); });
  return table;
}

}  // namespace ehl::kernel
