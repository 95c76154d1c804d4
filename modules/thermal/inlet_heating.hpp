#pragma once
// Published reduction factors for the film by shear heating in the inlet, for comparison with a thermal solution.

namespace ehl::thermal {

/// Parameters of the formulas. L = eta0 beta u_m^2/k with the mean speed u_m. With the sum of the speeds instead, the
/// coefficient 0.241 would be 0.1; both forms are in use.
struct InletGroups {
  double L = 0.0;
  double srr = 0.0;         ///< (u1 - u2)/u_m
  double p_h_over_E = 0.0;  ///< p_h/E', 1/E' = half the sum of (1 - nu^2)/E
};

/// 1/{1 + 0.241 [(1 + 14.8 Z^0.83) L^0.64]}, Z = |srr|/2. limits: line contacts, Grubin's inlet. source: Wilson and
/// Sheu 1983.
double wilson_sheu(const InletGroups& groups);
/// 1/(1 + 0.254 L^0.62), pure rolling. source: Murch and Wilson 1975.
double murch_wilson(const InletGroups& groups);
/// (1 - 13.2 p_h/E' L^0.42)/[1 + 0.213 (1 + 2.23 |srr|^0.83) L^0.64], 0 if negative. source: Gupta, Cheng, Zhu, Forster
/// and Schrand 1992.
double gupta(const InletGroups& groups);

}  // namespace ehl::thermal
