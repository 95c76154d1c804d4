#pragma once
// Published film thickness formulas, to print beside a result: fits to their authors' computations, a check to
// within 10 to 15 % on the central film. For the minimum film they can be off by half.
#include <string>

#include "contact/groups.hpp"

namespace ehl::contact {

/// Central and minimum film, h/R.
struct FilmThickness {
  double central;
  double minimum;
};

/// Circular contact, ellipticity k = 1:
///   h_c/R = 2.69 U^0.67 G^0.53 W^-0.067 (1 - 0.61 e^(-0.73 k))
///   h_m/R = 3.63 U^0.68 G^0.49 W^-0.073 (1 - e^(-0.68 k))
/// in: groups with W, U, G. out: h/R; NaN where W, U, G are unknown. limits: fitted for hard contacts with
/// M of about 20 to 1000 and L of about 5 to 20; meaningless without piezoviscosity (G = 0).
/// source: Hamrock and Dowson (1977), coefficients as quoted in the EHL literature. Their fit of the ellipticity,
/// k = 1.03 (R_y/R_x)^0.64, gives 1.03 for a circle and films thicker by 1 and 2 %; the circle's own k is 1.
FilmThickness hamrock_dowson(const Groups& groups);

/// The four asymptotes of the central film of a circular contact, in Moes' H_M = (h/R)(2U)^(-1/2).
struct Asymptotes {
  double rigid_isoviscous;
  double rigid_piezoviscous;
  double elastic_isoviscous;
  double elastic_piezoviscous;
  double unloaded;  ///< bound on the film as M -> 0 of the elastic isoviscous one
};

/// With the radius ratio at 1: H_RI = 145 (1.796)^(-15/7) M^-2, H_RP = 1.29 (1.691)^(-2/3) L^(2/3),
/// H_EI = 3.18 (1.63)^(-14/25) M^(-2/15), H_EP = 1.48 (1.63)^(-7/20) M^(-1/12) L^(3/4), H_00 = 1.8.
/// in: M > 0, L >= 0. source: Nijenbanning, Venner and Moes (1994), as quoted in the EHL literature.
Asymptotes asymptotes(double M, double L);

/// H_M = {[H_RI^(3/2) + (H_EI^-4 + H_00^-4)^(-3/8)]^(2s/3) + (H_RP^-8 + H_EP^-8)^(-s/8)}^(1/s),
/// s = 1.5 [1 + exp(-1.2 H_EI/H_EP)].
/// in: M > 0, L >= 0. out: central film in Moes' units. limits: L = 0 leaves the isoviscous part.
/// source: as above; the way of joining the asymptotes agrees with our own solutions at (20,10), (100,10), (500,10)
/// to 2, 7 and 14 %.
double nijenbanning_venner_moes(double M, double L);

/// The asymptote that governs the central film.
enum class Regime { rigid_isoviscous, rigid_piezoviscous, elastic_isoviscous, elastic_piezoviscous };
/// The larger of the isoviscous (larger of rigid and elastic) and the piezoviscous (smaller of the two) asymptotes.
/// in: M > 0, L >= 0.
Regime regime(double M, double L);
/// "rigid isoviscous" and so on.
const char* name(Regime regime);
/// What a report prints: the governing regime, and the one it passes into where the two asymptotes that compete
/// are closer than a factor of 1.5: "rigid piezoviscous, passing into elastic piezoviscous".
/// in: M > 0, L >= 0.
std::string regime_text(double M, double L);

}  // namespace ehl::contact
