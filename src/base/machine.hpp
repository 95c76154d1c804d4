#pragma once
// What the program asks the machine.
#include <cstddef>
#include <string>

namespace ehl::program {

/// Cores that this process may use.
int usable_cores();
/// Memory that this process may use [bytes]: the machine's, or the limit of its control group or shell (ulimit -v).
double usable_memory();
/// What of it is free now [bytes], less what others and this process use.
double free_memory();
/// The most memory this process has held so far [bytes].
double peak_memory();
/// Name of the processor.
std::string processor();
/// Now, in UTC: 2024-05-01T12:00:00Z.
std::string utc_date();
/// Path of the running program.
std::string program_path();

}  // namespace ehl::program
