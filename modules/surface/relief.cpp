#include "surface/relief.hpp"

#include "surface/resample.hpp"

namespace ehl::surface {

void add_gap(const Relief& relief, const core::Patch& grid, double distance, core::Field& S) {
  if (const auto* feature = std::get_if<Feature>(&relief))
    add_gap(*feature, grid, distance, S);
  else
    add_average(std::get<HeightMap>(relief), grid, distance, S);
}

void add_cell_average(const Relief& relief, const core::Patch& grid, core::Field& S) {
  if (const auto* feature = std::get_if<Feature>(&relief))
    add_cell_average(*feature, grid, S);
  else
    add_average(std::get<HeightMap>(relief), grid, 0.0, S);
}

bool symmetric(const Relief& relief) {
  return std::visit([](const auto& one) { return symmetric(one); }, relief);
}

double resolving_distance(const Relief& relief) {
  if (const auto* map = std::get_if<HeightMap>(&relief)) return map->step;
  return resolving_distance(std::get<Feature>(relief));
}

}  // namespace ehl::surface
