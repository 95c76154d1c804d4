#pragma once
// Reading of result files.
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ehl::results {

/// The HDF5 library then runs nothing at the exit of the process, where it crashes after memory has run out and prints
/// messages of its own after a damaged file; every file of this module is closed by its owner. For a program, before
/// any other function of this module; a library must not decide this for the process.
void run_no_hdf5_at_exit();

/// A dataset of numbers.
struct Array {
  std::vector<std::size_t> dims{};  ///< empty: a single number
  std::vector<double> values{};     ///< last dimension fastest
  std::string unit{};
  std::string meaning{};
};

/// An open result file; closed by the destructor.
class ResultFile {
 public:
  /// in: number: of a case in a file with the kept results of a sweep; its groups are then those of a result file.
  /// errors: core::FileError: missing, truncated, not HDF5, or not a result of this program.
  explicit ResultFile(const std::string& path, std::optional<std::size_t> number = std::nullopt);
  ~ResultFile();
  ResultFile(ResultFile&&) noexcept;
  ResultFile& operator=(ResultFile&&) noexcept;

  const std::string& path() const;

  enum class Kind { missing, group, numbers, text };
  Kind kind(const std::string& name) const;

  /// Names directly below a group, sorted. errors: core::FileError.
  std::vector<std::string> names(const std::string& group) const;

  /// errors: core::FileError if there is no such dataset or it cannot be read.
  Array numbers(const std::string& name) const;
  /// Path of the axis "x", "y", "z" or "time" of a field: in the same group, or for x and y that of /grid; empty if
  /// there is none.
  std::string axis(const std::string& field, const std::string& name) const;
  /// The axis of the rows of a field: "y" on planes, "z" on a section along x and in depth.
  std::string rows(const std::string& field) const;
  /// Field number k of a dataset (time or depth, y, x), as (y, x). errors: as above; k out of range.
  Array frame(const std::string& name, std::size_t k) const;
  /// Dimensions of a dataset; empty for a single number.
  std::vector<std::size_t> dims(const std::string& name) const;
  std::string text(const std::string& name) const;

  /// A text attribute of an object; empty if there is none.
  std::string attribute(const std::string& object, const std::string& name) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ehl::results
