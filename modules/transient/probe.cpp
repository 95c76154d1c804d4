#include "transient/probe.hpp"

#include <algorithm>

#include "judgement/measures.hpp"

namespace ehl::transient {

std::vector<Probed> probed_at(const core::Patch& grid, const core::Field& P, const core::Field& H,
                              const std::vector<Place>& places) {
  std::vector<Probed> all;
  for (const Place& place : places)
    all.push_back({std::max(0.0, judgement::value_at(grid, P, place.X, place.Y)),
                   judgement::value_at(grid, H, place.X, place.Y)});
  return all;
}

}  // namespace ehl::transient
