#pragma once
// Files are written completely or not at all.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ehl::results {

/// Checks, before any work is done, that the output can be written.
/// in: path (of a symbolic link, the target counts); overwrite: an existing regular file may be replaced; bytes needed.
/// errors: core::FileError if it exists, is not a regular file, its folder is missing or not writable, or the disk is
/// full. check_files() in outputs.hpp checks what a command reads and may replace.
void check_writable(const std::string& path, bool overwrite, std::size_t bytes);

/// Writes to a new file next to the path, waits until it is on disk, and renames it. Other programs see either the old
/// or the new file, and a failure leaves nothing behind. The temporary file of a killed process, ".NAME.PID.part", is
/// removed by the next check_writable() of the same path. A symbolic link stays, and its target is replaced.
/// errors: core::FileError with the reason given by the system.
void write_atomically(const std::string& path, std::span<const std::byte> bytes, bool overwrite);

/// ".NAME.PID.part" next to the file, which check_writable() removes if this process was killed.
std::string temporary_name(const std::string& path);

}  // namespace ehl::results
