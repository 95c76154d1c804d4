#pragma once
// Published formulas for starved films.
#include "contact/ellipse.hpp"
#include "rheology/laws.hpp"

namespace ehl::starvation {

/// Film over the flooded film as a function of r = layer over flooded film: r/(1 + r^gamma)^(1/gamma). source:
/// Chevalier, Lubrecht et al. (1998); Damiens, Venner, Cann, Lubrecht (2004): gamma = 2 to 5 in circular contacts.
double by_supply(double r, double gamma);
/// The formula after a number of overrollings of one track without reflow: r_n^-gamma = r^-gamma + n.
double by_passes(double r, double gamma, int passes);
/// The gamma with which by_supply() gives this factor. returns NaN if there is none: the factor must be below r and 1,
/// and so far from both that gamma can be determined.
double gamma_of(double r, double factor);

/// Meniscus position x = -m a needed for a flooded contact, m* = 1 + 3.06 Hc^0.58, and the film factor for a closer
/// meniscus, ((m - 1)/(m* - 1))^0.29. limits: circular contacts; much too thick for m - 1 < 0.25. source: Hamrock and
/// Dowson (1977).
double flooded_inlet(double Hc_flooded);
/// The film factor for a meniscus at -m a: 1 for m >= m*, 0 for m <= 1. in: Hc_flooded in H.
double by_meniscus(double m, double Hc_flooded);

/// Increase of Q^-2 per overrolling of a thin layer on y = 0, by side flow in the Hertz pressure: 2 I/(lambda kappa^2),
/// I = int d phi/(eta_bar rho_bar^2)(P = cos phi) over -pi/2 .. pi/2. Q in units of H. limits: entrainment along an
/// axis of the ellipse, else NaN. source: van Zoelen, Venner, Lugt (2012).
double lost_by_pass(const contact::Ellipse& shape, double lambda, const rheology::ViscosityLaw& viscosity,
                    const rheology::DensityLaw& density);

}  // namespace ehl::starvation
