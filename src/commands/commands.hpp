#pragma once
#include "commands/arguments.hpp"

namespace ehl::program {

/// All commands of this version: what each takes, its help, and its function.
const std::vector<Command>& commands();

/// One function per command. out: the exit status (exit_status.hpp). errors: core::InputError, core::FileError,
/// core::SolverError, core::Interrupted; main turns them into messages and exit statuses.
int run(const Arguments& arguments);
int check(const Arguments& arguments);
int resume(const Arguments& arguments);
int sweep(const Arguments& arguments);
int study(const Arguments& arguments);
int fit(const Arguments& arguments);
int extract(const Arguments& arguments);
int plot(const Arguments& arguments);
int report(const Arguments& arguments);
int keys(const Arguments& arguments);
int help(const Arguments& arguments);
int version(const Arguments& arguments);

/// Number of threads that --threads asks for; the usable cores without it. errors: core::InputError.
int requested_threads(const Arguments& arguments);

/// Name of the table that a command writes: --output, or the name of the deck with "_<command>.csv".
/// errors: core::InputError where it does not end with .csv.
std::string table_name(const Arguments& arguments);

/// To stdout, and out of this process: a full disk behind it shows here. errors: core::FileError.
void print(const std::string& text);

}  // namespace ehl::program
