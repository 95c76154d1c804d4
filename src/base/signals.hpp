#pragma once
namespace ehl::program {

/// Installs the handlers. Ctrl-C, a request to terminate, and SIGUSR1 (which schedulers send shortly before the time
/// limit) set a flag; a second signal ends the program at once. A file that exceeds the allowed size, or a pipe without
/// a reader, becomes an error of the write instead of ending the program.
void install_signal_handlers();

/// Ends the program silently, as a pipe without a reader ends any other program.
void end_by_closed_pipe();

/// True once the user asked to stop.
bool stop_requested();

}  // namespace ehl::program
