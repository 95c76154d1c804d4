#pragma once
// The error in the film of the last pass that stems from the supplies of earlier passes.
#include <vector>

#include "steady/error_bars.hpp"
#include "steady/starvation.hpp"
#include "steady/tuning.hpp"

namespace ehl::steady {

struct Scene;

/// Writes the relative error of the supply into each row. The pressure ends at the edge of the contact like a square
/// root. As long as the mesh does not resolve that edge, the loss of a pass converges slowly and with changing sign.
/// The supply therefore counts as first-order accurate, and its error as at least that of any earlier pass.
/// in: coarse, the supplies on half as many cells, for as many passes as are known. out: NaN for the other passes.
void judge_layers(const Scene& scene, const std::vector<double>& coarse, std::vector<Pass>& passes);

/// Errors of Hc and Hm due to the error of the last pass's supply: that error times d ln H/d ln supply.
struct SupplyErrors {
  double Hc = 0.0, Hm = 0.0;
};
/// The derivative is taken between the last pass and the latest one whose supply differs enough; without such a pass
/// the film counts as proportional to the layer. in: at least one pass. out: NaN if the error is not known.
SupplyErrors errors_of_supply(const Tuning& tuning, const std::vector<Pass>& passes);

/// Adds these errors to the mesh errors.
void add_errors_of_supply(const Tuning& tuning, const std::vector<Pass>& passes, ErrorBars& bars);

}  // namespace ehl::steady
