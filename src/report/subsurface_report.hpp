#pragma once
// The stresses below the contact: from the deck, and into summary, JSON and result.
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/grid.hpp"
#include "effects/subsurface/stress.hpp"
#include "results/content.hpp"

namespace ehl::program {

/// Where and for which body, in words.
std::string subsurface_plan(const subsurface::Parameters& parameters, const core::Grid& contact);

/// in: Hertz pressure [Pa], NaN where it is not known; mark: what follows numbers that did not converge.
std::string subsurface_summary(const subsurface::StressField& field, double p_h, const std::string& mark);

nlohmann::ordered_json subsurface_json(const subsurface::StressField& field);

/// The content points to the fields of `field`.
void add_subsurface(const subsurface::StressField& field, results::Content& content);

}  // namespace ehl::program
