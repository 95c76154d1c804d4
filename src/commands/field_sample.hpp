#pragma once
// The part of a field that `ehl extract` is asked for.
#include "commands/arguments.hpp"
#include "report/field_on_grid.hpp"

namespace ehl::program {

/// The line that --along and --at of `ehl extract` ask for. errors: core::InputError: no such axis, outside the domain.
struct Section {
  bool along_x = true;
  double at = 0.0;
};
Section wanted_section(const FieldOnGrid& field, const Arguments& arguments);
bool is_section(const Arguments& arguments);

/// What --sample and --window of `ehl extract` ask for; without them the field as it is.
/// errors: core::InputError: no such number of points, a window that does not meet the domain.
FieldOnGrid sampled(const FieldOnGrid& field, const Arguments& arguments);

}  // namespace ehl::program
