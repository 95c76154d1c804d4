#pragma once
#include "case/computed.hpp"
#include "case/scene.hpp"
#include "results/content.hpp"

namespace ehl::program {

/// The density and the viscosity of a solution, those that the case wants to keep.
DerivedFields derived_fields(const Case& input, const steady::Solution& solution);

/// What the result of any case holds: title, deck, provenance, grid; in the summary `numbers`, then warnings and what
/// the surfaces carry.
results::Content content_of(const Case& input, const Computed& computed, std::vector<results::Quantity> numbers);

/// Everything the result file holds but what effects add. The content points to the fields of `computed`.
results::Content result_content(const Case& input, const Computed& computed);

}  // namespace ehl::program
