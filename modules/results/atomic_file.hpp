#pragma once
// Files appear whole or not at all.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ehl::results {

/// Refuses, before any work is done, an output that could not be written in the end.
/// in: path, of a symbolic link the file that it leads to is meant; overwrite an existing regular file; bytes that will
/// be needed. errors: core::FileError: it exists, is no regular file, its folder is missing or not writable, the disk
/// has no room. What a command reads and what it may replace: check_files() in outputs.hpp.
void check_writable(const std::string& path, bool overwrite, std::size_t bytes);

/// Writes to a new file beside the path, makes sure it has reached the disk, and renames it: whoever looks sees the old
/// file or the new one, and a failure leaves nothing behind. What a killed process left, ".NAME.PID.part", goes with
/// the next check_writable() of the same path. A symbolic link stays, and the file that it leads to is replaced.
/// errors: core::FileError with the system's reason.
void write_atomically(const std::string& path, std::span<const std::byte> bytes, bool overwrite);

/// ".NAME.PID.part" beside the file: what check_writable() cleans up when this process was killed.
std::string temporary_name(const std::string& path);

}  // namespace ehl::results
