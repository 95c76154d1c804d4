#pragma once
#include "case/computed.hpp"
#include "case/scene.hpp"
#include "results/content.hpp"

namespace ehl::program {

/// The density and viscosity fields of a solution, as far as the case asks to save them.
DerivedFields derived_fields(const Case& input, const steady::Solution& solution);

/// The content of any result: title, deck, provenance, grid, the summary (`numbers`), the warnings, and the surfaces.
results::Content content_of(const Case& input, const Computed& computed, std::vector<results::Quantity> numbers);

/// The whole content of the result file except that of the effects. It points to the fields of `computed`.
results::Content result_content(const Case& input, const Computed& computed);

}  // namespace ehl::program
