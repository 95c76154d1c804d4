#pragma once
// A result file whose numbers come in the contact's units or, where that is asked for, in SI.
#include <optional>

#include "base/si_units.hpp"
#include "commands/arguments.hpp"
#include "results/read.hpp"

namespace ehl::program {

struct ExtractSource {
  results::ResultFile file;
  std::optional<SiScales> si{};  ///< nothing: the file's own units

  /// As those of the file; in SI the meaning says what was multiplied.
  results::Array numbers(const std::string& name) const;
  results::Array frame(const std::string& name, std::size_t k) const;
  /// Unit and meaning without the values.
  results::Array described(const std::string& name) const;
};

/// The result that `ehl extract` is asked for. errors: core::FileError; core::InputError: --si of a contact that is not
/// given in SI.
ExtractSource open_source(const Arguments& arguments);

}  // namespace ehl::program
