// Sums over the film: forces, heat, largest temperatures.
#include "thermal/film_columns.hpp"

namespace ehl::thermal {

double FilmColumns::theta(int i, int j, int k) const { return value(theta_, i, j, k); }

Balance FilmColumns::balance() const {
  const core::Patch& patch = setup_.patch;
  Balance sum;
  double load = 0.0;
  const auto compare = [](Extreme& most, double theta, int i, int j) {
    if (theta > most.theta) most = {theta, i, j};
  };
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) {
      const double lines = patch.lines(j), cell = lines * patch.hx() * patch.hy();
      load += lines * P_(i, j);
      sum.friction += lines * tau_(i, j);
      sum.heat += cell * heat_(i, j);
      sum.into_1 += cell * q_1_(i, j);
      sum.into_2 += cell * q_2_(i, j);
      sum.carried += cell * carried_(i, j);
      sum.stored += cell * stored_(i, j);
      sum.clipped = sum.clipped || clipped_(i, j) > 0.0;
      for (int k = 0; k <= nodes_.intervals; ++k) compare(sum.film, theta(i, j, k), i, j);
      compare(sum.surface_1, theta(i, j, nodes_.intervals), i, j);
      compare(sum.surface_2, theta(i, j, 0), i, j);
    }
  sum.friction *= (laws_.sliding < 0.0 ? -1.0 : 1.0) / (load * setup_.stress_of_P);
  sum.defect = sum.heat != 0.0 ? (sum.heat - sum.into_1 - sum.into_2 - sum.carried - sum.stored) / sum.heat : 0.0;
  return sum;
}

}  // namespace ehl::thermal
