#pragma once
// The numbers on which the word "converged" rests, for the final state on the finest level.
#include "judgement/measures.hpp"

namespace ehl::judgement {

struct LastCycle;
struct Tuning;

/// The measures of the state, and those of its last cycle.
struct Verification : Measures {
  double change_Hc = core::unknown;  ///< |change in the last cycle|, relative
  double change_Hm = core::unknown;
  double algebraic_error_Hc = core::unknown;  ///< estimate of what further cycles would still change; relative
  double algebraic_error_Hm = core::unknown;
};

/// The numbers by which unmet_check() in stopping.hpp judges this cycle.
Verification verification_of(const Tuning& tuning, const LastCycle& cycle);

}  // namespace ehl::judgement
