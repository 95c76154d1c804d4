#pragma once
namespace ehl::program {

/// From now on Ctrl-C and a request to terminate set a flag; a second one ends the program at once. A file that grows
/// beyond the allowed size is an error of the write, no longer the end of the program.
void install_signal_handlers();

/// True once the user asked to stop.
bool stop_requested();

}  // namespace ehl::program
