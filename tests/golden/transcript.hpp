#pragma once
// A transcript: commands, and what they print. Each line begins with a mark:
//
//   # words about the commands below
//   $ a command that computes nothing: its numbers are compared
//   ~ a command that computes: its numbers are not compared
//   | a line on standard output
//   ! a line on standard error
//   = the exit status, where it is not 0
//
// Everything but the last three is input. The commands of a transcript run one after the other in one folder, which
// begins with a copy of tests/golden/files; `ehl` is the built program.
#include <string>

namespace golden {

/// The transcript with what its commands print now.
std::string performed(const std::string& transcript);

}  // namespace golden
