#pragma once
// What the program asks the machine.
#include <cstddef>
#include <string>

namespace ehl::program {

/// Cores that this process may use.
int usable_cores();
/// Memory that this process may use [bytes]: the machine's, or the limit of its control group.
double usable_memory();
/// The most memory this process has held so far [bytes].
double peak_memory();
/// Name of the processor.
std::string processor();
/// Now, in UTC: 2024-05-01T12:00:00Z.
std::string utc_date();
/// Path of the running program.
std::string program_path();

}  // namespace ehl::program
