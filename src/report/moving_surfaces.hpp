#pragma once
// What a run in time does with features and maps that move with their surfaces.
#include "case/scene.hpp"
#include "core/warning.hpp"

namespace ehl::program {

/// Warnings of a run in time, known before it is solved: a feature or a map that does not reach the contact before the
/// end, with the time at which it would, and a feature with fewer cells than a moving one needs
/// (modules/transient/README.md). in: any case; none without [transient].
core::Warnings moving_surface_warnings(const Case& input);

}  // namespace ehl::program
