#pragma once
// epsilon half-way between two nodes of a line, made of what the nodes on the line have: not the mean of their
// epsilons, which is far too large where epsilon falls by factors from cell to cell, as in the rim of the inlet.
// For a double or a batch of them.
#include <array>
#include <span>

namespace ehl::film {

/// How epsilon there is made. least: share of the mean of the two fluidities that theirs at the half point has at
/// least; 0: the logarithmic mean, whatever it is. From half to one and a half of that share a parabola leads over: a
/// kink there costs steps in time.
struct Between {
  double lambda;
  double least = 0.0;
};

/// Of the nodes on a line around a half point: the two beside it, and for the film the next two beyond them too.
template <class Number>
struct AroundHalfPoint {
  std::array<Number, 4> H;
  std::array<Number, 2> rho_bar;        ///< of the two in the middle, and so on
  std::array<Number, 2> fluidity;       ///< 1/eta_bar
  std::array<Number, 2> log_viscosity;  ///< ln eta_bar
};

/// Below this difference of ln eta_bar the logarithmic mean is a series; its error then is below 1e-15.
inline constexpr double series_below = 0.01;

/// (phi_0 - phi_1)/(a_1 - a_0), phi = e^-a: the fluidity that carries the same flow as one that falls exponentially
/// between the nodes. Barus' oil under a linear pressure has exactly that.
template <class Number>
Number logarithmic_mean(const AroundHalfPoint<Number>& at) {
  const auto [phi0, phi1] = at.fluidity;
  const Number d = at.log_viscosity[1] - at.log_viscosity[0];
  const Number d2 = d * d;
  // tanh(d/2)/(d/2) of the arithmetic mean.
  const Number series = 0.5 * (phi0 + phi1) * (1.0 - d2 * (1.0 / 12.0 - d2 * (1.0 / 120.0)));
  const auto close = d2 < series_below * series_below;
  const Number safe = close ? Number{} + 1.0 : d;
  return close ? series : (phi0 - phi1) / safe;
}

/// How much of a change of the logarithmic mean f the fluidity follows. in: f; the least that it may be, both >= 0.
/// out: 0 below half of the least, 1 from one and a half of it on.
template <class Number>
Number followed(Number f, Number least) {
  const Number above = f - 0.5 * least;
  const auto over = above < least;  // still led over, or held
  const Number share = (over ? above : Number{} + 1.0) / (over ? least : Number{} + 1.0);
  return share < 0.0 ? Number{} : share;
}

/// What the flux eps (P_1 - P_0) answers to the two pressures, over epsilon, when the viscosity follows them and falls
/// exponentially: phi_0/f and phi_1/f, f the logarithmic mean. Their difference is that of ln eta_bar. 1 and 1, epsilon
/// held, where the fluidity is the least share of the mean; between them where it leads over. With that share following
/// the mean, 1 + d phi_0/(phi_0 + phi_1) there, d the difference of ln eta_bar: what the flux answers in truth.
template <class Number>
struct Answers {
  Number before, behind;
};
enum class LeastShare { held, follows };
template <LeastShare bound = LeastShare::held, class Number>
Answers<Number> answers(double least, Number phi0, Number phi1, Number a0, Number a1) {
  const Number d = a1 - a0;
  const Number fall = phi0 - phi1;
  const auto close = d * d < series_below * series_below;
  const auto flat = close | (fall == 0.0);  // both fluidities may be too small for a double
  const Number limit = close ? 1.0 + d * (0.5 + d * (1.0 / 12.0)) : (d > 0.0 ? d : Number{});
  const Number before = flat ? limit : d * phi0 / (flat ? Number{} + 1.0 : fall);
  // f = fall/d and the least fluidity, both times d^2.
  const Number share = followed(fall * d, (0.5 * least) * (phi0 + phi1) * d * d);
  if constexpr (bound == LeastShare::held) {
    return {1.0 + share * (before - 1.0), 1.0 + share * (before - d - 1.0)};
  } else {
    const Number sum = phi0 + phi1;
    const Number of_mean = 1.0 + d * phi0 / (sum > 0.0 ? sum : Number{} + 1.0);
    const Number of_f = share * (share + 0.5) / (1.0 + 0.5 * share * share);  // what f has of fluidity_between()
    const Number both = of_mean + of_f * (before - of_mean);
    return {both, both - d};
  }
}

/// Third-degree interpolation, but at least half the mean of the two beside it; H < 0 counts as 0.
template <class Number>
Number film_between(const std::array<Number, 4>& H) {
  const auto film = [](Number h) { return h < 0.0 ? Number{} : h; };
  const Number two = film(H[1]) + film(H[2]);
  const Number four = (9.0 * two - (film(H[0]) + film(H[3]))) * (1.0 / 16.0);
  const Number least = 0.25 * two;
  return four < least ? least : four;
}
/// H of the node that is missing beyond the boundary, the three nodes before it given from the boundary inwards: with
/// it film_between() is the mean of the two.
inline double beyond_boundary(double at, double next, double third) { return at + next - third; }

/// 1/eta_bar at the half point.
template <class Number>
Number fluidity_between(const AroundHalfPoint<Number>& at, double least) {
  const Number f = logarithmic_mean(at);
  const Number bound = (0.5 * least) * (at.fluidity[0] + at.fluidity[1]);
  const Number share = followed(f, bound);
  const Number led = bound * (1.0 + 0.5 * share * share);
  return f - 0.5 * bound < bound ? led : f;
}

/// rho_bar H^3/(eta_bar lambda) at the half point.
template <class Number>
Number epsilon_between(const AroundHalfPoint<Number>& at, const Between& how) {
  const Number H = film_between(at.H);
  return (0.5 / how.lambda) * (at.rho_bar[0] + at.rho_bar[1]) * (H * H * H) * fluidity_between(at, how.least);
}

/// What changes of the nodes' H, rho_bar and log_viscosity change of it; that of the fluidity follows.
double epsilon_change(const AroundHalfPoint<double>& at, const AroundHalfPoint<double>& change, const Between& how);

/// Spans of one length, one value per line: H of the four stations around, the rest of the two in the middle.
struct AroundLines {
  std::array<std::span<const double>, 4> H;
  std::array<std::span<const double>, 2> rho_bar, fluidity, log_viscosity;
};
/// epsilon half-way between the two stations in the middle.
void epsilon_between_stations(const AroundLines& around, const Between& how, std::span<double> eps);

/// The nodes of one station. H has a value more before the first node and one behind the last.
struct AlongStation {
  std::span<const double> H, rho_bar, fluidity, log_viscosity;
};
/// epsilon half-way between a node and the next; nothing behind the last.
void epsilon_between_nodes(const AlongStation& along, const Between& how, std::span<double> eps);

}  // namespace ehl::film
