#pragma once
// Integrals over the Gaussian distribution of asperity heights.

namespace ehl::asperities {

/// F_n(l) = integral over s > l of (s - l)^n exp(-s^2/2)/sqrt(2 pi) ds; its derivative is dF_n/dl = -n F_(n-1)(l).
/// in: n > -1. error: relative 1e-12, by double-exponential quadrature.
/// source: Greenwood and Tripp (1970), Proc. Inst. Mech. Engrs 185, 625.
double gauss_moment(double n, double l);

}  // namespace ehl::asperities
