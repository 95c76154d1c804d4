#pragma once
// A result file whose numbers are returned in the units of the contact or in SI.
#include <cstddef>
#include <optional>

#include "base/si_units.hpp"
#include "results/read.hpp"

namespace ehl::program {

struct ResultSource {
  results::ResultFile file;
  std::optional<SiScales> si{};  ///< empty: the numbers keep the units of the file

  /// The numbers, in the units chosen; in SI the meaning names the factor.
  results::Array numbers(const std::string& name) const;
  results::Array frame(const std::string& name, std::size_t k) const;
  /// Unit and meaning without the values.
  results::Array described(const std::string& name) const;
};

/// A result file in its own units. in: number: the number of a case of a sweep with --keep. errors: core::FileError.
ResultSource open_result(const std::string& path, std::optional<std::size_t> number = std::nullopt);

/// The scales of a contact that is given in SI; empty for any other contact. errors: core::FileError.
std::optional<SiScales> scales_of(const results::ResultFile& file);

}  // namespace ehl::program
