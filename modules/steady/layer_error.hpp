#pragma once
// The error that the passes before the last one leave in its film.
#include <vector>

#include "steady/error_bars.hpp"
#include "steady/starvation.hpp"

namespace ehl::steady {

/// Writes the relative error of the supply into each row. The pressure ends at the edge of the contact like a square
/// root, and the loss of a pass converges slowly and with changing sign as long as the mesh does not resolve that edge:
/// the supply counts as of first order, and as no better than in any pass before.
/// in: coarse, the supplies on half as many cells, of as many passes as are known. out: NaN for the other passes.
void judge_layers(const std::vector<double>& coarse, std::vector<Pass>& passes);

/// Errors that the error of the supply of the last pass makes in its Hc and Hm: times d ln H/d ln supply.
struct SupplyErrors {
  double Hc = 0.0, Hm = 0.0;
};
/// The derivative is that from an earlier pass, the last whose supply differs enough, to this one; where there is none
/// the film counts as in proportion to the layer. in: at least one pass. out: NaN where the error is not known.
SupplyErrors errors_of_supply(const std::vector<Pass>& passes);

/// Adds them to the errors of the mesh.
void add_errors_of_supply(const std::vector<Pass>& passes, ErrorBars& bars);

}  // namespace ehl::steady
