#include "commands/extract_source.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

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

results::Array ExtractSource::numbers(const std::string& name) const { return converted(file.numbers(name), si); }

results::Array ExtractSource::frame(const std::string& name, std::size_t k) const {
  return converted(file.frame(name, k), si);
}

results::Array ExtractSource::described(const std::string& name) const {
  return converted({file.dims(name), {}, file.attribute(name, "unit"), file.attribute(name, "meaning")}, si);
}

ExtractSource open_source(const Arguments& arguments) {
  ExtractSource source{results::ResultFile(arguments.operands[0])};
  if (!arguments.has("si")) return source;
  const auto scale = [&](const std::string& name) {
    const std::string path = "/scales/" + name;
    const bool known = source.file.kind(path) == results::ResultFile::Kind::numbers && source.file.dims(path).empty();
    return known ? source.file.numbers(path).values[0] : std::nan("");
  };
  source.si = {.a = scale("a"), .h = scale("h"), .p_h = scale("p_h"), .time = 2.0 * scale("a") / scale("u_s")};
  if (std::isnan(source.si->a)) refuse("--si: the contact of " + source.file.path() + " is not given in SI");
  return source;
}

}  // namespace ehl::program
