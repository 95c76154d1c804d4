#pragma once
// Settings of the process for waiting threads and memory. They affect only speed.

namespace ehl::core {

/// To be called first in main(), with its argument vector. Closed standard input, output and error are occupied, so
/// that no other file takes their numbers; the process gets the program's name. Two further settings:
/// - Waiting threads spin for about a tenth of a millisecond before they sleep. The default of OpenMP is much longer,
///   which on a busy machine makes two threads slower than one; sleeping at once costs as much as a loop over a small
///   grid. OpenMP reads this setting before main(), so the program is started again in the same process, unless
///   OMP_WAIT_POLICY or GOMP_SPINCOUNT is set.
/// - Arrays of up to 32 MiB come from one region of memory, so that arrays smaller than a huge page also lie on huge
///   pages (aligned_array.hpp), and released memory is kept for the next arrays.
void prepare_process(char** words);

}  // namespace ehl::core
