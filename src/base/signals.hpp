#pragma once
namespace ehl::program {

/// From now on Ctrl-C, a request to terminate and SIGUSR1, by which schedulers tell that time runs out, set a flag; a
/// second one ends the program at once. A file that grows
/// beyond the allowed size, or a pipe that nobody reads, is an error of the write, no longer the end of the program.
void install_signal_handlers();

/// Ends the program as a pipe that nobody reads ends any other, without a word.
void end_by_closed_pipe();

/// True once the user asked to stop.
bool stop_requested();

}  // namespace ehl::program
