#include "effects/heat/factors.hpp"

#include <algorithm>
#include <cmath>

#include "multigrid/factors.hpp"
#include "transfer/transfer.hpp"

namespace ehl::heat {

void reset_factors(multigrid::Hierarchy& hierarchy, std::size_t l) {
  for (const auto field : film::factor_fields) (*hierarchy.levels[l].factors.*field).fill(1.0);
  multigrid::restrict_factors(hierarchy, l);
}

void interpolate_factors(multigrid::Hierarchy& hierarchy, std::size_t l) {
  for (const auto field : film::factor_fields)
    transfer::prolong_bilinear(*hierarchy.levels[l - 1].factors.*field, *hierarchy.levels[l].factors.*field, 1);
  multigrid::restrict_factors(hierarchy, l);
}

double take_factors(multigrid::Hierarchy& hierarchy, std::size_t l, const thermal::FilmTemperature& film,
                    double weight) {
  const core::Patch& grid = hierarchy.levels[l].grid;
  film::FactorFields& factors = *hierarchy.levels[l].factors;
  double largest = 0.0;
  const auto mean = [weight](double asked, double now) {
    return weight == 1.0 ? asked : now * std::pow(asked / now, weight);
  };
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) {
      double &I0 = factors.fluidity(i, j), &mobility = factors.mobility(i, j), &C = factors.carried(i, j);
      double& across = factors.mobility_across(i, j);
      const double M2 = film.M2()(i, j), asked = M2 * film.more_x()(i, j);
      largest = std::max(largest, std::abs(std::log(asked / (I0 * mobility))));
      mobility = mean(asked / film.I0()(i, j), mobility);
      across = mean(M2 * film.more_y()(i, j) / film.I0()(i, j), across);
      I0 = mean(film.I0()(i, j), I0);
      // C is averaged arithmetically, because it may pass through zero if a surface stands still.
      C += weight * (film.C()(i, j) - C);
    }
  multigrid::restrict_factors(hierarchy, l);
  return largest;
}

}  // namespace ehl::heat
