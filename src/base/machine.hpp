#pragma once
// Properties of the machine that the program runs on.
#include <cstddef>
#include <string>

namespace ehl::program {

/// Cores that this process may use.
int usable_cores();
/// Memory that this process may use [bytes]: the machine's, or the limit of its control group or shell (ulimit -v).
double usable_memory();
/// The part of it that is free now [bytes]: what other programs and this one use is subtracted.
double free_memory();
/// The largest memory that this process has held so far [bytes].
double peak_memory();
/// Name of the processor.
std::string processor();
/// The present date and time in UTC: 2024-05-01T12:00:00Z.
std::string utc_date();
/// Path of the running program.
std::string program_path();

}  // namespace ehl::program
