#pragma once
// What the figures of a file need: its kind, its datasets or columns, and the variables for the scripts.
#include <string>

#include "commands/arguments.hpp"
#include "commands/curves.hpp"
#include "commands/figures.hpp"

namespace ehl::program {

/// The source of a result (FILE.h5) or of a table (FILE.csv). in: arguments: --time, --x, --y and --by, if the command
/// has them. errors: core::InputError for a time outside the run; core::FileError for a damaged or foreign file.
FigureSource source_of(const std::string& path, const Arguments& arguments);

/// True if --x, --y or --by was given.
bool names_axes(const Arguments& arguments);

/// The curves of a figure of a sweep: --x, --y and --by for `curves`; for the other figure, friction and film against
/// the slide-roll ratio.
CurvesWanted curves_for(const Figure& figure, const SweepData& table, const Arguments& arguments);

}  // namespace ehl::program
