#pragma once
// Reading a result file back.
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ehl::results {

/// A dataset of numbers.
struct Array {
  std::vector<std::size_t> dims{};  ///< none: a single number
  std::vector<double> values{};     ///< last dimension fastest
  std::string unit{};
  std::string meaning{};
};

/// An open result file; closed when it goes.
class ResultFile {
 public:
  /// errors: core::FileError: missing, truncated, no HDF5, or HDF5 but no result of this program.
  /// in: number: of a case in a file with the kept results of a sweep; its groups are then those of a result file.
  explicit ResultFile(const std::string& path, std::optional<std::size_t> number = std::nullopt);
  ~ResultFile();
  ResultFile(ResultFile&&) noexcept;
  ResultFile& operator=(ResultFile&&) noexcept;

  const std::string& path() const;

  enum class Kind { missing, group, numbers, text };
  Kind kind(const std::string& name) const;

  /// Names directly below a group, sorted. errors: core::FileError.
  std::vector<std::string> names(const std::string& group) const;

  /// errors: core::FileError when there is no such dataset or it cannot be read.
  Array numbers(const std::string& name) const;
  /// Name of the axis "x", "y", "z" or "time" of a field: the one beside it, or for x and y the one of /grid.
  /// out: empty where there is none.
  std::string axis(const std::string& field, const std::string& name) const;
  /// Number k of the fields in a dataset (time or depth, y, x), as (y, x). errors: as above; k out of range.
  Array frame(const std::string& name, std::size_t k) const;
  /// Lengths of a dataset; empty for a single number.
  std::vector<std::size_t> dims(const std::string& name) const;
  std::string text(const std::string& name) const;

  /// A text attribute of an object; empty when it has none.
  std::string attribute(const std::string& object, const std::string& name) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ehl::results
