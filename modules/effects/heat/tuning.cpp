// Written by tests/structure/tuning.py from tuning.hpp.
#include "effects/heat/tuning.hpp"

namespace ehl::heat {

const std::vector<core::TunedNumber<Tuning>>& tuned_numbers() {
  using core::Tunable;
  static const std::vector<core::TunedNumber<Tuning>> table{
      {"least_weight", Tunable::share, &Tuning::least_weight, "smallest under-relaxation factor"},
      {"half_of_it", Tunable::share, &Tuning::half_of_it, "share of the expected fall that keeps the under-relaxation"},
      {"less", Tunable::reduction, &Tuning::less, "factor on under-relaxation that falls; grows by the inverse"},
      {"unknown_error", Tunable::positive, &Tuning::unknown_error, "assumed discretization error on a single grid"},
      {"least_error", Tunable::positive, &Tuning::least_error, "least error, of the criterion and of error bars"},
      {"zero", Tunable::positive, &Tuning::zero, "friction, and temperature rise over T0, that count as zero"},
      {"enough_of_a_pass", Tunable::share, &Tuning::enough_of_a_pass, "factor on the residual at which a pass ends"},
      {"most_cycles", Tunable::count, &Tuning::most_cycles, "most cycles of a pass"},
      {"quick", Tunable::count, &Tuning::quick, "first passes, with one sweep of the temperature"},
      {"sweeps_when_slow", Tunable::count, &Tuning::sweeps_when_slow, "sweeps in the later passes"},
      {"order", Tunable::positive, &Tuning::order, "order of friction and temperatures"},
      {"cells_of_first_line", Tunable::count, &Tuning::cells_of_first_line,
       "most cells of a line contact's first grid"},
      {"change_below", Tunable::positive, &Tuning::change_below, "residual and change on the coarser grids"},
      {"change_of_first", Tunable::positive, &Tuning::change_of_first, "change on the first grid"},
      {"gentle", Tunable::share, &Tuning::gentle, "first under-relaxation factor of a second attempt"},
      {"order_of_two_grids", Tunable::positive, &Tuning::order_of_two_grids, "order of temperatures with two grids"},
      {"wider", Tunable::positive, &Tuning::wider, "safety factor on the errors of temperatures"},
      {"grows_on", Tunable::positive, &Tuning::grows_on, "further rise under a spike over its last rise"},
      {"share_of_warm_inlet", Tunable::positive, &Tuning::share_of_warm_inlet, "inlet error per change of ln epsilon"},
  };
  return table;
}

}  // namespace ehl::heat
