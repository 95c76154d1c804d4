#pragma once
// A contact without lubricant, from the case to what is printed and kept.
#include <string>

#include "case/scene.hpp"
#include "commands/arguments.hpp"

namespace ehl::program {

/// Solves the case, prints summary or JSON and writes the result. out: the exit status.
/// errors: core::SolverError, core::Interrupted, core::FileError.
int run_dry(const Arguments& arguments, const Case& input, const std::string& path, bool overwrite);

/// What `ehl check` says.
std::string derived_dry(const Case& input);

}  // namespace ehl::program
