#pragma once
#include "case/computed.hpp"
#include "case/scene.hpp"
#include "results/content.hpp"

namespace ehl::program {

/// The density and the viscosity of a solution, those that the case wants to keep.
DerivedFields derived_fields(const Case& input, const steady::Solution& solution);

/// What each surface that is not smooth carries, and what the mesh holds of a measured map.
void add_surface_records(const Case& input, const core::Grid& grid, results::Content& content);

/// Program, version, machine and date.
std::vector<results::Quantity> provenance(const Case& input);

/// Everything the result file holds but what effects add. The content points to the fields of `computed`.
results::Content result_content(const Case& input, const Computed& computed);

}  // namespace ehl::program
