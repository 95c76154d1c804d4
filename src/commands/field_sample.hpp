#pragma once
// The part of a field that `ehl extract` prints.
#include "commands/arguments.hpp"
#include "report/field_on_grid.hpp"

namespace ehl::program {

/// The line that --along and --at of `ehl extract` select. errors: core::InputError for an unknown axis or a
/// place outside the domain.
struct Section {
  bool along_x = true;
  double at = 0.0;
};
Section wanted_section(const FieldOnGrid& field, const Arguments& arguments);
/// True if --along or --at was given.
bool is_section(const Arguments& arguments);

/// The field on the points that --sample and --window of `ehl extract` select; without these options the field itself.
/// errors: core::InputError for a wrong number of points or a window outside the domain.
FieldOnGrid sampled(const FieldOnGrid& field, const Arguments& arguments);

}  // namespace ehl::program
