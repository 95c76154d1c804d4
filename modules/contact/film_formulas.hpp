#pragma once
// Published film thickness formulas, for comparison with a result. They are fits to their authors' computations;
// tests/bench/film_formulas.csv has their deviations from solutions of this program.
#include <string>

#include "contact/groups.hpp"

namespace ehl::contact {

/// Central and minimum film, h/R.
struct FilmThickness {
  double central;
  double minimum;
};

/// Groups are based on R = R_x; R_e is the radius along the entrainment, R_s that across it (contact/ellipse.hpp). With
/// U and W based on R_e, and the ellipticity k,
///   h_c/R_e = 2.69 U^0.67 G^0.53 W^-0.067 (1 - 0.61 e^(-0.73 k))
///   h_m/R_e = 3.63 U^0.68 G^0.49 W^-0.073 (1 - e^(-0.68 k))
/// in: groups with W, U, G. out: h/R_x; NaN if W, U, G are unknown. limits: fitted for hard contacts with M of about 20
/// to 1000, L of about 5 to 20 and k of 1 to 8, thus R_e <= R_s along an axis; meaningless for G = 0.
/// source: Hamrock and Dowson (1977), coefficients as quoted in the EHL literature. Their approximation k = 1.03
/// (R_s/R_e)^0.64 gives 1.03 for a circle and slightly thicker films; here k is exact.
FilmThickness hamrock_dowson(const Groups& groups);

/// For any direction of entrainment:
///   h_c/R_e = 4.31 U^0.68 G^0.49 W^-0.073 (1 - e^(-1.23 (R_s/R_e)^(2/3)))
///   h_m/R_e = 3.68 U^0.68 G^0.49 W^-0.073 (1 - e^(-0.67 (R_s/R_e)^(2/3)))
/// in: groups with W, U, G. out: h/R_x. limits: as above; inaccurate for contacts elongated in the rolling direction.
/// source: Chittenden, Dowson, Dunn and Taylor (1985), coefficients as quoted in the EHL literature.
FilmThickness chittenden(const Groups& groups);

/// True if the shape is within the range of the other two formulas: entrainment along the smaller radius, R_e <= R_s.
/// out: false for entrainment at an angle to the axes.
bool along_smaller_radius(const Ellipse& shape);

/// True if Chittenden's formula is reported, because it is within 20 % of solutions of this program: the shapes above,
/// and radius ratios up to 2 in any direction.
bool near_chittenden(const Ellipse& shape);

/// Asymptotes of the central film in Moes' units, H_M = (h/R_e)(2U)^(-1/2) with U based on R_e.
struct Asymptotes {
  double rigid_isoviscous;
  double rigid_piezoviscous;
  double elastic_isoviscous;
  double elastic_piezoviscous;
  double unloaded;  ///< limit of the elastic isoviscous film for M -> 0
};

/// With the ratio q = R_e/R_s:
///   H_RI = 145 (1 + 0.796 q^(14/15))^(-15/7) q^-1 M^-2        H_RP = 1.29 (1 + 0.691 q)^(-2/3) L^(2/3)
///   H_EI = 3.18 (1 + 0.006 ln q + 0.63 q^(4/7))^(-14/25) q^(-1/15) M^(-2/15)
///   H_EP = 1.48 (1 + 0.006 ln q + 0.63 q^(4/7))^(-7/20) q^(-1/24) M^(-1/12) L^(3/4)      H_00 = 1.8 q^-1
/// in: M > 0, L >= 0, both based on R_e; q > 0. limits: fitted for q <= 1. source: Nijenbanning, Venner and Moes
/// (1994), as quoted in the EHL literature.
/// For q = 0, a line contact, with its own M:
///   H_RI = 3 M^-1     H_RP = 1.287 L^(2/3)     H_EI = 2.621 M^(-1/5)     H_EP = 1.311 M^(-1/8) L^(3/4)
/// source: Moes (1992), Optimum similarity analysis, as quoted in the EHL literature. The exact coefficient of H_RI is
/// 2.45.
Asymptotes asymptotes(double M, double L, double radius_ratio = 1.0);

/// Central film by joining the asymptotes:
///   H_M = {[H_RI^(3/2) + (H_EI^-4 + H_00^-4)^(-3/8)]^(2s/3) + (H_RP^-8 + H_EP^-8)^(-s/8)}^(1/s),
///   s = 1.5 [1 + exp(-1.2 H_EI/H_EP)];
/// for a line contact, with its own asymptotes (source: Moes (1992), as quoted in the EHL literature):
///   H_M = {(H_RI^(7/3) + H_EI^(7/3))^(3s/7) + (H_RP^(-7/2) + H_EP^(-7/2))^(-2s/7)}^(1/s),
///   s = [7 + 8 exp(-2 H_EI/H_RI)]/5.
/// in: M > 0, L >= 0, based on R_x. out: central film in Moes' units based on R_x. limits: L = 0 gives the isoviscous
/// part; fitted for R_e <= R_s, an extrapolation otherwise. source: as for asymptotes().
double nijenbanning_venner_moes(double M, double L, const Ellipse& shape = {});

/// Film of a line contact:
///   h_c/R = 3.06 U^0.69 G^0.56 W^-0.10,   h_m/R = 2.65 U^0.7 G^0.54 W^-0.13.
/// in: groups of a line contact. limits: hard contacts of steel and mineral oil; meaningless for G = 0. source: Dowson
/// and Higginson (1968) for the minimum, Dowson and Toyoda (1979) for the centre, as quoted in the EHL literature.
FilmThickness dowson_higginson(const Groups& groups);

/// The asymptote that determines the central film.
enum class Regime { rigid_isoviscous, rigid_piezoviscous, elastic_isoviscous, elastic_piezoviscous };
/// The larger of the isoviscous asymptote (the larger of rigid and elastic) and the piezoviscous one (the smaller of
/// both).
/// in: M > 0, L >= 0.
Regime regime(double M, double L, const Ellipse& shape = {});
/// "rigid isoviscous" and so on.
const char* name(Regime regime);
/// Text for reports: the regime, and the one into which it passes if the two competing asymptotes differ by less than a
/// factor of 1.5: "rigid piezoviscous, passing into elastic piezoviscous". in: M > 0, L >= 0.
std::string regime_text(double M, double L, const Ellipse& shape = {});

}  // namespace ehl::contact
