#pragma once
// Factors by which temperature changes the coefficients, on every grid: I0 on the fluidity, M2/I0 (times the thinning
// by the pressure flow) on the flow driven by pressure, and C on what the surfaces carry.
#include <memory>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "film/model.hpp"
#include "thermal/film_temperature.hpp"

namespace ehl::heat {

/// Factors on one grid; 1 until the temperature is known.
struct GridFactors {
  core::Patch grid;
  core::Field fluidity, mobility, mobility_across, carried;
};

/// Factors on all grids of a hierarchy. They are constant while cycles run, so that a cycle has one operator.
class Factors {
 public:
  /// in: grids, the finest first, as from multigrid::grids_below().
  explicit Factors(const std::vector<core::Patch>& grids);
  /// Factors on finer grids, by bilinear interpolation from the grid of every second node.
  Factors(const std::vector<core::Patch>& grids, const Factors& coarse);

  /// Weighted geometric mean of new and old factors: ln f = weight ln f_film + (1 - weight) ln f. Full weighting
  /// carries I0 and M2/I0 to the coarser grids, injection carries C. returns the largest change of ln M2 that the film
  /// requires.
  double take(const thermal::FilmTemperature& film, double weight);
  /// Restores the factors from before the last take().
  void give_back();

  /// The effect for film::Model, on any column or line of any of the grids. It shares ownership of the factors.
  static film::CoefficientEffect effect(std::shared_ptr<const Factors> factors);

 private:
  void restrict_all();
  std::vector<GridFactors> grids_;
  GridFactors before_;  // factors of the finest grid before the last take()
};

}  // namespace ehl::heat
