#pragma once
// Stresses at the stored times of a run in time, and what the material of the bodies meets during the over-rolling.
#include "case/effects.hpp"
#include "case/numbers/number.hpp"

namespace ehl::program {

/// Reports a deck whose run in time stores no fields from which the stresses follow.
void check_subsurface_in_time(Case& input);

/// Computes computed.stress_course from the frames of the run in time. The traction on body 1 is mu_1(t) P, that on
/// body 2 mu_2(t) P if [friction] computes them; a given `friction` acts on body 1, and its opposite on body 2. The
/// stored times are the samples of the history of the material. If the user asks to stop, the rest of the times is left
/// out, with a warning.
void compute_stress_course(const Case& input, RunSettings& settings, Computed& computed);

/// The numbers of the history of each body.
std::vector<numbers::Group> stress_history_numbers();

std::string stress_course_summary(const Case& input, const StressCourse& course);
void add_stress_course(const Case& input, const Computed& computed, results::Content& content);

}  // namespace ehl::program
