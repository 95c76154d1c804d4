// Written by tests/structure/tuning.py from tuning.hpp.
#include "judgement/tuning.hpp"

namespace ehl::judgement {

const std::vector<core::TunedNumber<Tuning>>& tuned_numbers() {
  using core::Tunable;
  static const std::vector<core::TunedNumber<Tuning>> table{
      {"algebraic_share", Tunable::share, &Tuning::algebraic_share,
       "algebraic over discretization error; half of the promised tenth"},
      {"loose_residual", Tunable::positive, &Tuning::loose_residual, "relative residual at the discretization error"},
      {"loose_load_error", Tunable::positive, &Tuning::loose_load_error, "load error at the discretization error"},
      {"flow_share", Tunable::share, &Tuning::flow_share, "mass imbalance over the discretization error of Hc"},
      {"least_flow_licence", Tunable::positive, &Tuning::least_flow_licence, "mass imbalance that is always allowed"},
      {"largest_dry_violation", Tunable::positive, &Tuning::largest_dry_violation,
       "residual of a cavitated node that calls for pressure"},
      {"default_tolerance", Tunable::positive, &Tuning::default_tolerance,
       "residual if the discretization error is unknown"},
      {"largest_licence", Tunable::positive, &Tuning::largest_licence,
       "largest discretization error that the checks use"},
      {"largest_oil_imbalance", Tunable::positive, &Tuning::largest_oil_imbalance,
       "largest net outflow of oil over its inflow"},
      {"best_factor", Tunable::share, &Tuning::best_factor, "least convergence factor in the algebraic error"},
      {"worst_factor", Tunable::share, &Tuning::worst_factor, "largest convergence factor in the algebraic error"},
      {"settled_change", Tunable::positive, &Tuning::settled_change,
       "change of Hc and Hm at which a first grid has settled"},
      {"solved_residual", Tunable::positive, &Tuning::solved_residual, "residual of a state that solves the equations"},
      {"safety_of_two", Tunable::positive, &Tuning::safety_of_two, "safety factor with two levels"},
      {"safety", Tunable::positive, &Tuning::safety, "safety factor with more levels; also Roache's"},
      {"cancelled_change", Tunable::positive, &Tuning::cancelled_change,
       "power of 2 by which a change is too small to be believed"},
      {"first_order_share", Tunable::positive, &Tuning::first_order_share,
       "error of the first-order wedge over h/Hm^(2/3)"},
      {"second_order_share", Tunable::positive, &Tuning::second_order_share, "second-order error over its square"},
      {"third_order_floor_of_Hc", Tunable::positive, &Tuning::third_order_floor_of_Hc,
       "upstream3: least error of Hc over this"},
      {"third_order_floor_of_Hm", Tunable::positive, &Tuning::third_order_floor_of_Hm,
       "upstream3: least error of Hm over this"},
      {"unsure_of_Hc", Tunable::share, &Tuning::unsure_of_Hc, "uncertain share of the extrapolation of Hc"},
      {"unsure_of_Hm", Tunable::share, &Tuning::unsure_of_Hm, "uncertain share of the extrapolation of Hm"},
      {"share_of_Hm", Tunable::share, &Tuning::share_of_Hm, "share of the error of Hm in that of Hc beside a meniscus"},
  };
  return table;
}

}  // namespace ehl::judgement
