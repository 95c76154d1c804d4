#pragma once
// The numbers on which the word "converged" rests, for the final state on the finest level.
#include <limits>

namespace ehl::judgement {

struct LastCycle;
struct Tuning;

/// Every number is NaN until a state has been examined.
struct Verification {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  double residual = unknown;          ///< relative: root mean square over that of the wedge term
  double largest_residual = unknown;  ///< at one node, relative to the same wedge term
  double largest_residual_X = unknown;
  double largest_residual_Y = unknown;
  double least_P = unknown;        ///< over all nodes: complementarity requires P >= 0
  double least_content = unknown;  ///< least Q over all nodes, with mass conservation, in units of H; must be >= 0
  double dry_violation = unknown;  ///< largest residual of a cavitated node that calls for P > 0; relative
  double load_error = unknown;     ///< relative
  double change_Hc = unknown;      ///< |change in the last cycle|, relative
  double change_Hm = unknown;
  double algebraic_error_Hc = unknown;  ///< estimate of what further cycles would still change; relative
  double algebraic_error_Hm = unknown;
  double Hm = unknown;  ///< minimum film, which must be positive
  double Hm_X = unknown;
  double Hm_Y = unknown;
  double flow_through = unknown;          ///< integral of rho_bar H over |Y| <= 1 at X = 0
  double flow_imbalance = unknown;        ///< (out - in)/flow_through of the pressurised region within |X|, |Y| <= 1.5
  double flow_imbalance_whole = unknown;  ///< of the whole pressurised region; recorded, not judged
};

/// The numbers by which unmet_check() in stopping.hpp judges this cycle.
Verification verification_of(const Tuning& tuning, const LastCycle& cycle);

}  // namespace ehl::judgement
