// Written by tests/structure/tuning.py from tuning.hpp.
#include "newton/tuning.hpp"

namespace ehl::newton {

const std::vector<core::TunedNumber<Tuning>>& tuned_numbers() {
  using core::Tunable;
  static const std::vector<core::TunedNumber<Tuning>> table{
      {"longest_change", Tunable::positive, &Tuning::longest_change,
       "largest change of a pressure in one step, in p_h"},
      {"small_change", Tunable::positive, &Tuning::small_change,
       "change of a step below which the iteration converges"},
      {"loose", Tunable::share, &Tuning::loose, "largest tolerance of a linear system"},
      {"tight", Tunable::share, &Tuning::tight, "least tolerance of a linear system"},
      {"last_bit", Tunable::share, &Tuning::last_bit, "last linear tolerance over what is needed"},
      {"patience", Tunable::count, &Tuning::patience, "steps without a better state until it fails"},
      {"patience_at_the_end", Tunable::count, &Tuning::patience_at_the_end,
       "steps without a better state near the solution"},
      {"near", Tunable::positive, &Tuning::near, "residual that counts as near the solution"},
      {"step_tolerance", Tunable::share, &Tuning::step_tolerance, "tolerance of the linear systems in time"},
      {"step_worn_out", Tunable::count, &Tuning::step_worn_out, "iterations at which factors are replaced in time"},
  };
  return table;
}

}  // namespace ehl::newton
