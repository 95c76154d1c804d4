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

/// The radius R is R_x of the groups; in the entrainment's frame R_e along it and R_s across it
/// (contact/ellipse.hpp). With U, W made with R_e and the ellipticity k,
///   h_c/R_e = 2.69 U^0.67 G^0.53 W^-0.067 (1 - 0.61 e^(-0.73 k))
///   h_m/R_e = 3.63 U^0.68 G^0.49 W^-0.073 (1 - e^(-0.68 k))
/// in: groups with W, U, G. out: h/R_x; NaN where W, U, G are unknown. limits: fitted for hard contacts with
/// M of about 20 to 1000 and L of about 5 to 20 and k of 1 to 8, so for R_e <= R_s along an axis; meaningless without
/// piezoviscosity (G = 0).
/// source: Hamrock and Dowson (1977), coefficients as quoted in the EHL literature. Their fit of the ellipticity,
/// k = 1.03 (R_s/R_e)^0.64, gives 1.03 for a circle and films thicker by 1 and 2 %; here k is the exact one.
FilmThickness hamrock_dowson(const Groups& groups);

/// Any direction of entrainment:
///   h_c/R_e = 4.31 U^0.68 G^0.49 W^-0.073 (1 - e^(-1.23 (R_s/R_e)^(2/3)))
///   h_m/R_e = 3.68 U^0.68 G^0.49 W^-0.073 (1 - e^(-0.67 (R_s/R_e)^(2/3)))
/// in: groups with W, U, G. out: h/R_x. limits: as above; how far it is from our own solutions, half of the film for
/// slender contacts, stands in the README of this module. source: Chittenden, Dowson, Dunn and Taylor (1985),
/// coefficients as quoted in the EHL literature.
FilmThickness chittenden(const Groups& groups);

/// The ratios for which the other two formulas were fitted: entrainment along the smaller radius, R_e <= R_s.
/// in: any shape. out: false too for an entrainment at an angle to the axes.
bool along_smaller_radius(const Ellipse& shape);

/// The ratios for which Chittenden's formula is within 20 % of our own solutions: those above, and ratios of the radii
/// up to 2 in any direction.
bool near_chittenden(const Ellipse& shape);

/// The four asymptotes of the central film, in Moes' H_M = (h/R_e)(2U)^(-1/2) with R_e in U.
struct Asymptotes {
  double rigid_isoviscous;
  double rigid_piezoviscous;
  double elastic_isoviscous;
  double elastic_piezoviscous;
  double unloaded;  ///< bound on the film as M -> 0 of the elastic isoviscous one
};

/// With the ratio q = R_e/R_s:
///   H_RI = 145 (1 + 0.796 q^(14/15))^(-15/7) q^-1 M^-2        H_RP = 1.29 (1 + 0.691 q)^(-2/3) L^(2/3)
///   H_EI = 3.18 (1 + 0.006 ln q + 0.63 q^(4/7))^(-14/25) q^(-1/15) M^(-2/15)
///   H_EP = 1.48 (1 + 0.006 ln q + 0.63 q^(4/7))^(-7/20) q^(-1/24) M^(-1/12) L^(3/4)      H_00 = 1.8 q^-1
/// in: M > 0, L >= 0, both with R_e; q > 0. limits: fitted for q <= 1. source: Nijenbanning, Venner and Moes (1994),
/// as quoted in the EHL literature.
/// q = 0, a line, with its own M:
///   H_RI = 3 M^-1     H_RP = 1.287 L^(2/3)     H_EI = 2.621 M^(-1/5)     H_EP = 1.311 M^(-1/8) L^(3/4)
/// source: Moes (1992), Optimum similarity analysis, as quoted in the EHL literature. H_RI is the exact 2.45 rounded
/// up.
Asymptotes asymptotes(double M, double L, double radius_ratio = 1.0);

/// H_M = {[H_RI^(3/2) + (H_EI^-4 + H_00^-4)^(-3/8)]^(2s/3) + (H_RP^-8 + H_EP^-8)^(-s/8)}^(1/s),
/// s = 1.5 [1 + exp(-1.2 H_EI/H_EP)].
/// in: M > 0, L >= 0, with R_x. out: central film in Moes' units with R_x. limits: L = 0 leaves the isoviscous part;
/// fitted for R_e <= R_s, beyond it a guess (README of this module).
/// source: as above; the way of joining the asymptotes agrees with our own solutions at (20,10), (100,10), (500,10)
/// to 2, 7 and 14 %.
double nijenbanning_venner_moes(double M, double L, const Ellipse& shape = {});

/// Of a line contact, with the asymptotes above:
/// H_M = {(H_RI^(7/3) + H_EI^(7/3))^(3s/7) + (H_RP^(-7/2) + H_EP^(-7/2))^(-2s/7)}^(1/s), s = [7 + 8 exp(-2
/// H_EI/H_RI)]/5. source: Moes (1992), as quoted in the EHL literature. nijenbanning_venner_moes() gives it for a line.

/// The film of a line contact: h_c/R = 3.06 U^0.69 G^0.56 W^-0.10, h_m/R = 2.65 U^0.7 G^0.54 W^-0.13. in: groups of a
/// line. limits: hard contacts of steel and mineral oil; meaningless without piezoviscosity (G = 0). source: Dowson and
/// Higginson (1968) the minimum, Dowson and Toyoda (1979) the centre, as quoted in the EHL literature.
FilmThickness dowson_higginson(const Groups& groups);

/// The asymptote that governs the central film.
enum class Regime { rigid_isoviscous, rigid_piezoviscous, elastic_isoviscous, elastic_piezoviscous };
/// The larger of the isoviscous (larger of rigid and elastic) and the piezoviscous (smaller of the two) asymptotes.
/// in: M > 0, L >= 0.
Regime regime(double M, double L, const Ellipse& shape = {});
/// "rigid isoviscous" and so on.
const char* name(Regime regime);
/// What a report prints: the governing regime, and the one it passes into where the two asymptotes that compete
/// are closer than a factor of 1.5: "rigid piezoviscous, passing into elastic piezoviscous".
/// in: M > 0, L >= 0.
std::string regime_text(double M, double L, const Ellipse& shape = {});

}  // namespace ehl::contact
