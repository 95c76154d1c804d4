#include "report/result_source.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "case/numbers/number.hpp"

namespace ehl::program {
namespace {

results::Array converted(results::Array array, const std::optional<SiScales>& si) {
  if (!si) return array;
  const SiUnit unit = si_unit(array.unit, *si);
  if (unit.name == array.unit) return array;
  for (double& value : array.values) value *= unit.factor;
  array.meaning += (array.meaning.empty() ? "" : ", ") + fmt::format("times {:.6g} {}", unit.factor, unit.name);
  array.unit = unit.name;
  return array;
}

}  // namespace

results::Array ResultSource::numbers(const std::string& name) const { return converted(file.numbers(name), si); }

results::Array ResultSource::frame(const std::string& name, std::size_t k) const {
  return converted(file.frame(name, k), si);
}

results::Array ResultSource::described(const std::string& name) const {
  return converted({file.dims(name), {}, file.attribute(name, "unit"), file.attribute(name, "meaning")}, si);
}

ResultSource open_result(const std::string& path, std::optional<std::size_t> number) {
  return {results::ResultFile(path, number)};
}

std::optional<SiScales> scales_of(const results::ResultFile& file) {
  const auto scale = [&](const char* name) {
    const std::string path = numbers::path_of(name);
    const bool known = file.kind(path) == results::ResultFile::Kind::numbers && file.dims(path).empty();
    return known ? file.numbers(path).values[0] : std::nan("");
  };
  const SiScales si{.a = scale(id::a),
                    .h = scale(id::h),
                    .p_h = scale(id::p_h),
                    .time = 2.0 * scale(id::a) / scale(id::u_s),
                    .load = scale(id::load)};
  return std::isnan(si.a) ? std::nullopt : std::optional(si);
}

}  // namespace ehl::program
