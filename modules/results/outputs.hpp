#pragma once
// What a command reads and what it writes: looked at together, before any work is done.
#include <cstddef>
#include <string>
#include <vector>

namespace ehl::results {

/// What this program writes. A file is recognized by what it holds and not by its name.
enum class FileKind { result, kept_results, journal, xdmf, table, page, picture };

/// Why a file may not be replaced by one of this kind, "is no result of ehl"; empty where it may: there is no file, it
/// is empty, or it is of this kind. errors: core::FileError: it cannot be read.
std::string foreign_to(FileKind kind, const std::string& path);

/// A file that will be written.
struct Output {
  std::string path{};
  FileKind kind = FileKind::result;
  bool overwrite = false;  ///< an existing file of this kind is replaced, or continued
  std::size_t bytes = 0;   ///< that will be needed
};

/// Refuses, before the work, every output that could not be written in the end or that would destroy something.
/// in: all files that the command reads, and all that it writes. Files are the same where they are the same on disk,
/// whatever leads to them: another path, a symbolic or a hard link.
/// errors: core::FileError: an output is an input or another output; what stands there is not of its kind, with or
/// without `overwrite`; those of check_writable().
void check_files(const std::vector<std::string>& inputs, const std::vector<Output>& outputs);

}  // namespace ehl::results
