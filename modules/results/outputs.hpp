#pragma once
// Joint check of all files that a command reads and writes, before any work is done.
#include <cstddef>
#include <string>
#include <vector>

namespace ehl::results {

/// Kinds of files written by this program. A file is recognized by its content, not by its name.
enum class FileKind { result, kept_results, xdmf, table, page, picture };

/// Reason why a file may not be replaced by one of this kind, "is no result of ehl"; empty if it may, because it does
/// not exist, is empty, or is of this kind. errors: core::FileError if it cannot be read.
std::string foreign_to(FileKind kind, const std::string& path);

/// A file to be written.
struct Output {
  std::string path{};
  FileKind kind = FileKind::result;
  bool overwrite = false;  ///< an existing file of this kind is replaced or continued
  std::size_t bytes = 0;   ///< needed size
};

/// Refuses, before the work, every output that could not be written or would destroy something.
/// in: all files that the command reads and writes. Files are compared on disk, whatever path, symbolic or hard link
/// leads to them.
/// errors: core::FileError: an output is an input or another output; an existing file is not of its kind, with or
/// without `overwrite`; those of check_writable().
void check_files(const std::vector<std::string>& inputs, const std::vector<Output>& outputs);

}  // namespace ehl::results
