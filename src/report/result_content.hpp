#pragma once
#include "core/field.hpp"
#include "report/outcome.hpp"
#include "results/content.hpp"

namespace ehl::program {

/// Fields that are computed from the solution for the result only.
struct DerivedFields {
  core::Field rho_bar{};
  core::Field ln_eta_bar{};
  core::Field S{};  ///< of surfaces at rest
};

/// The density and the viscosity of a solution, those that the case wants to keep.
DerivedFields derived_fields(const Case& input, const steady::Solution& solution);

/// What each surface that is not smooth carries, and what the mesh holds of a measured map.
void add_surface_records(const Case& input, const core::Grid& grid, results::Content& content);

/// Program, version, machine and date.
std::vector<results::Quantity> provenance(const Case& input);

/// Everything the result file holds. The content points to the fields of `solution` and `derived`.
results::Content result_content(const Case& input, const steady::Solution& solution, const Outcome& outcome,
                                const DerivedFields& derived);

}  // namespace ehl::program
