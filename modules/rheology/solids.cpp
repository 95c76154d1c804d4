#include "rheology/solids.hpp"

#include <string>

#include "core/errors.hpp"

namespace ehl::rheology {

const Solid& solid_by_name(std::string_view name) {
  if (const Solid* solid = find_solid(name)) return *solid;
  std::string known;
  for (const Solid& solid : solids) known.append(known.empty() ? "" : ", ").append(solid.name);
  throw core::InputError("solid = " + std::string(name) + " is not known: must be one of " + known);
}

}  // namespace ehl::rheology
