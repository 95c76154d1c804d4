#pragma once
// Published formulas for starved films.
#include "contact/ellipse.hpp"
#include "rheology/laws.hpp"

namespace ehl::starvation {

/// Factor on the flooded film by the supply, r/(1 + r^gamma)^(1/gamma), r the layer over it. source: Chevalier,
/// Lubrecht et al. (1998); Damiens, Venner, Cann, Lubrecht (2004): gamma 2 to 5 in circular contacts.
double by_supply(double r, double gamma);
/// The same behind so many passes of one track, no oil flowing back: r_n^-gamma = r^-gamma + n.
double by_passes(double r, double gamma, int passes);
/// The gamma that makes a factor of by_supply. out: NaN where there is none: the factor is not below r and 1, or so
/// near to one of them that the gamma says nothing.
double gamma_of(double r, double factor);

/// Where the meniscus of a flooded contact is, x = -m a: m = 1 + 3.06 Hc^0.58, and the factor by a meniscus that is
/// closer, ((m - 1)/(m* - 1))^0.29. limits: circles; far too thick where m - 1 < 0.25. source: Hamrock and Dowson
/// (1977).
double flooded_inlet(double Hc_flooded);
double by_meniscus(double m, double Hc_flooded);

/// What a pass adds to Q^-2 on y = 0 of a thin layer, 2 I/lambda for a circle, I = int d phi/(eta_bar rho_bar^2)(P =
/// cos phi) over -pi/2 .. pi/2: side flow in the Hertz pressure. In units of H. limits: the entrainment along an axis
/// of the ellipse; else NaN. source: van Zoelen, Venner, Lugt (2012).
double lost_by_pass(const contact::Ellipse& shape, double lambda, const rheology::ViscosityLaw& viscosity,
                    const rheology::DensityLaw& density);

}  // namespace ehl::starvation
