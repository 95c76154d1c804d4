#pragma once
#include "commands/arguments.hpp"

namespace ehl::program {

/// All commands of this version: their options, help texts and functions.
const std::vector<Command>& commands();

/// One function per command. out: the exit status (exit_status.hpp). errors: core::InputError, core::FileError,
/// core::SolverError, core::Interrupted; main() converts them to messages and exit statuses.
int run(const Arguments& arguments);
int check(const Arguments& arguments);
int resume(const Arguments& arguments);
int sweep(const Arguments& arguments);
int study(const Arguments& arguments);
int fit(const Arguments& arguments);
int asperities(const Arguments& arguments);
int extract(const Arguments& arguments);
int plot(const Arguments& arguments);
int report(const Arguments& arguments);
int keys(const Arguments& arguments);
int help(const Arguments& arguments);
int version(const Arguments& arguments);

/// The number of threads that --threads asks for; by default all usable cores. errors: core::InputError.
int requested_threads(const Arguments& arguments);

/// The name of the table that a command writes: --output, or the name of the deck with the ending "_<command>.csv".
/// errors: core::InputError if the name does not end with .csv.
std::string table_name(const Arguments& arguments);

/// Prints to stdout and flushes it, so that a full disk is noticed here. errors: core::FileError.
void print(const std::string& text);

}  // namespace ehl::program
