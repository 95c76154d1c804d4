#include "effects/heat/factors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "transfer/transfer.hpp"

namespace ehl::heat {
namespace {

constexpr auto all = {&GridFactors::fluidity, &GridFactors::mobility, &GridFactors::mobility_across,
                      &GridFactors::carried};

GridFactors ones(const core::Patch& grid) {
  GridFactors factors{grid, core::Field(grid), core::Field(grid), core::Field(grid), core::Field(grid)};
  for (const auto field : all) (factors.*field).fill(1.0);
  return factors;
}

void restrict_weighted(const core::Patch& fine, const core::Patch& coarse, core::Field& from, core::Field& to) {
  core::fill_ghosts(fine, from);
  transfer::restrict_full_weighting(coarse, from, to);
}

}  // namespace

Factors::Factors(const std::vector<core::Patch>& grids) : before_(ones(grids.front())) {
  for (const core::Patch& grid : grids) grids_.push_back(ones(grid));
}

Factors::Factors(const std::vector<core::Patch>& grids, const Factors& coarse) : Factors(grids) {
  GridFactors& finest = grids_.front();
  for (const auto field : all) transfer::prolong_bilinear(coarse.grids_.front().*field, finest.*field, 1);
  restrict_all();
}

double Factors::take(const thermal::FilmTemperature& film, double weight) {
  GridFactors& finest = grids_.front();
  for (const auto field : all) core::copy(finest.*field, before_.*field);
  double largest = 0.0;
  const auto mean = [weight](double asked, double now) {
    return weight == 1.0 ? asked : now * std::pow(asked / now, weight);
  };
  for (int i = 0; i <= finest.grid.nx; ++i)
    for (int j = 0; j <= finest.grid.ny; ++j) {
      double &I0 = finest.fluidity(i, j), &mobility = finest.mobility(i, j), &C = finest.carried(i, j);
      double& across = finest.mobility_across(i, j);
      const double M2 = film.M2()(i, j), asked = M2 * film.more_x()(i, j);
      largest = std::max(largest, std::abs(std::log(asked / (I0 * mobility))));
      mobility = mean(asked / film.I0()(i, j), mobility);
      across = mean(M2 * film.more_y()(i, j) / film.I0()(i, j), across);
      I0 = mean(film.I0()(i, j), I0);
      // C is averaged arithmetically, because it may pass through zero if a surface stands still.
      C += weight * (film.C()(i, j) - C);
    }
  restrict_all();
  return largest;
}

void Factors::give_back() {
  for (const auto field : all) core::copy(before_.*field, grids_.front().*field);
  restrict_all();
}

void Factors::restrict_all() {
  for (std::size_t l = 1; l < grids_.size(); ++l) {
    GridFactors &fine = grids_[l - 1], &coarse = grids_[l];
    restrict_weighted(fine.grid, coarse.grid, fine.fluidity, coarse.fluidity);
    restrict_weighted(fine.grid, coarse.grid, fine.mobility, coarse.mobility);
    restrict_weighted(fine.grid, coarse.grid, fine.mobility_across, coarse.mobility_across);
    transfer::restrict_injection(fine.carried, coarse.carried);
  }
}

film::CoefficientEffect Factors::effect(std::shared_ptr<const Factors> factors) {
  return [factors = std::move(factors)](const film::Station& station, const film::Factors& at) {
    const auto here = std::ranges::find(factors->grids_, station.grid, &GridFactors::grid);
    if (here == factors->grids_.end()) return;  // a grid of another hierarchy, for which no temperature is known yet
    const auto multiply = [&](const core::Field& by, std::span<double> values) {
      const double* value = by.at_x(station.i) + (station.along ? 1 : 0);
      const std::ptrdiff_t next = station.along ? by.stride() : 1;
      for (double& one : values) {
        one *= *value;
        value += next;
      }
    };
    multiply(here->fluidity, at.fluidity);
    multiply(here->mobility, at.mobility);
    multiply(here->mobility_across, at.mobility_across);
    multiply(here->carried, at.carried);
  };
}

}  // namespace ehl::heat
