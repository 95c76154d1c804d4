#pragma once
// Solves a case by the methods of a study, each in a process of its own, and measures what they cost.
#include <functional>
#include <string>
#include <vector>

#include "case/scene.hpp"
#include "tables/study_point.hpp"

namespace ehl::program {

/// Solves the case by one method and measures it once. in: the case on the grid of this method, with
/// the settings of the deck.
/// errors: core::Interrupted; core::InputError if the evaluator does not fit the grid. A solution that does not
/// converge is not an error but a status.
StudyPoint measure(Case input, const StudyCase& variant);

/// Runs the case in time once. in: samples: the number of equal intervals of comparison, 0: the run is only timed. The
/// samples come from the dense output of the integrator and do not change its steps.
/// errors: core::Interrupted. A run that ends early is not an error but a status.
StudyPoint measure_in_time(Case input, const StudyCase& variant, int samples);

/// The rows of all methods, each computed `times` times in child processes. The repetitions of one method are far apart
/// in time, so that a disturbance of the machine does not affect all of them. A process that died gives a row with the
/// status "failed" and the reason.
/// in: at_once: how many run at a time; note: what follows the name of a method for the reader.
/// errors: core::Interrupted; core::FileError if the system cannot create a process.
std::vector<StudyPoint> measured(const std::vector<StudyCase>& variants, int times, int at_once, bool quiet,
                                 const std::function<StudyPoint(const StudyCase&)>& compute,
                                 const std::string& note = "");

}  // namespace ehl::program
