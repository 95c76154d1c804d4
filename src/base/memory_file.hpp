#pragma once
// Text that passes between processes.
#include <string>

namespace ehl::program {

/// A file in memory that this process and its children can read and write. It ends with this object.
class MemoryFile {
 public:
  /// errors: core::FileError if the system cannot create it.
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// Replaces the contents. errors: core::FileError if the memory is full.
  void hold(const std::string& text) const;
  std::string text() const;
  /// Its name for this process and its children.
  std::string name() const;

 private:
  int descriptor_;
};

}  // namespace ehl::program
