#pragma once
// What the film's temperature makes of the coefficients, on every grid: I0 on the fluidity, M2/I0 on what pressure
// moves beyond that, times what its own flow thins; C on what the surfaces carry.
#include <memory>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "film/model.hpp"
#include "thermal/film_temperature.hpp"

namespace ehl::heat {

/// Of one grid; 1 before anything is known.
struct GridFactors {
  core::Patch grid;
  core::Field fluidity, mobility, mobility_across, carried;
};

/// Of all grids of a hierarchy. They stay as they are while cycles run: a cycle has one operator.
class Factors {
 public:
  /// in: grids, the finest first, as fmg::grids_below() has them.
  explicit Factors(const std::vector<core::Patch>& grids);
  /// The same with those of the grid of every second node, between its nodes by bilinear interpolation.
  Factors(const std::vector<core::Patch>& grids, const Factors& coarse);

  /// Those of the film, as a geometric mean with those of before: ln f = weight ln f_film + (1 - weight) ln f. Coarser
  /// grids by full weighting, C by injection. out: the largest change of ln M2 that the film asks for.
  double take(const thermal::FilmTemperature& film, double weight);
  /// Those before the last take().
  void give_back();

  /// For film::Model, of a station of any of the grids. It holds the factors: they live as long as it does.
  static film::CoefficientEffect effect(std::shared_ptr<const Factors> factors);

 private:
  void restrict_all();
  std::vector<GridFactors> grids_;
  GridFactors before_;  // of the finest
};

}  // namespace ehl::heat
