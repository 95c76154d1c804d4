#pragma once
// What the report and the numbers of a roller are made of.
#include <string>
#include <vector>

#include "base/column.hpp"
#include "case/computed.hpp"
#include "case/scene.hpp"
#include "core/warning.hpp"

namespace ehl::program {

/// Relative errors from the grid of half as many cells; NaN: not known.
struct RollerBars {
  double P_middle = core::unknown, P_end = core::unknown, H_end = core::unknown;
  double mises_middle = core::unknown, mises_end = core::unknown;
};
RollerBars bars_of(const roller::Analysis& result);
/// The end with the higher pressure, and the least film of both.
const roller::End& harder(const roller::Distribution& found);
double least_at_ends(const roller::Distribution& found);
/// Moment of the pressure about the x axis [N m]; NaN without SI.
double moment_Nm(const Case& input, const roller::Distribution& found);
std::vector<Column<roller::Slice>> slice_columns();
/// Warnings about loaded ends, where the assumption of half-spaces fails. In a sweep, which computes no coarser grid,
/// these are the only warnings about a roller.
core::Warnings edge_warnings(const roller::Distribution& found);
/// All warnings about a roller, and its part of the summary.
core::Warnings roller_warnings(const roller::Analysis& result);
std::string roller_summary(const Case& input, const Computed& computed);

}  // namespace ehl::program
