#pragma once
// How the process of a program that solves contacts waits for its threads and takes its memory. Speed only.

namespace ehl::core {

/// For main() to call first, with its argument vector. Standard input, output and error that are closed are occupied,
/// so that no other file takes their place; the process has the program's name. And two wishes that the system's
/// libraries read when a process begins or never hear otherwise:
///   threads that wait spin for a tenth of a millisecond before they sleep. OpenMP's own spin for milliseconds, which
///   on a machine with other work makes two threads many times slower than one; sleeping at once costs as much as a
///   loop over a small grid. OpenMP reads it before main(): the program is started once more, in the same process,
///   unless OMP_WAIT_POLICY or GOMP_SPINCOUNT is set already;
///   arrays of up to 32 MiB are taken side by side out of one piece of memory, so that those smaller than a huge page
///   come to lie on huge pages too (aligned_array.hpp), and what was given back stays for the next.
void prepare_process(char** words);

}  // namespace ehl::core
