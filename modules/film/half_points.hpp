#pragma once
// epsilon half-way between two nodes of a line, from the values at the nodes along it. It is not the mean of the two
// epsilons, which is far too large where epsilon falls by factors from cell to cell, as at the edge of the inlet. For a
// double or for a batch of them.
#include <array>
#include <span>

namespace ehl::film {

/// Parameters of epsilon at a half point. least: least share of the mean fluidity of the two nodes that the fluidity at
/// the half point has; 0: the logarithmic mean without a bound. From half of that share to one and a half of it a
/// parabola blends the two, since a kink there costs time steps.
struct Between {
  double lambda;
  double least = 0.0;
};

/// Values at the nodes on a line around a half point: at the two next to it, and for the film also at one more on each
/// side.
template <class Number>
struct AroundHalfPoint {
  std::array<Number, 4> H;
  std::array<Number, 2> rho_bar;        ///< at the two nodes next to the half point, like all below
  std::array<Number, 2> fluidity;       ///< 1/eta_bar
  std::array<Number, 2> log_viscosity;  ///< ln eta_bar
};

/// Difference of ln eta_bar below which the logarithmic mean is computed by a series, whose error is then at rounding.
inline constexpr double series_below = 0.01;

/// Logarithmic mean (phi_0 - phi_1)/(a_1 - a_0), phi = e^-a: the constant fluidity that carries the same flow as one
/// that varies exponentially between the nodes. This is exact for Barus' oil under a linear pressure.
template <class Number>
Number logarithmic_mean(const AroundHalfPoint<Number>& at) {
  const auto [phi0, phi1] = at.fluidity;
  const Number d = at.log_viscosity[1] - at.log_viscosity[0];
  const Number d2 = d * d;
  // The arithmetic mean times tanh(d/2)/(d/2).
  const Number series = 0.5 * (phi0 + phi1) * (1.0 - d2 * (1.0 / 12.0 - d2 * (1.0 / 120.0)));
  const auto close = d2 < series_below * series_below;
  const Number safe = close ? Number{} + 1.0 : d;
  return close ? series : (phi0 - phi1) / safe;
}

/// Share of a change of the logarithmic mean f that the bounded fluidity follows. in: f; the bound, both >= 0. out: 0
/// below half of the bound, 1 from one and a half of it on.
template <class Number>
Number followed(Number f, Number least) {
  const Number above = f - 0.5 * least;
  const auto over = above < least;  // in the transition, or below it
  const Number share = (over ? above : Number{} + 1.0) / (over ? least : Number{} + 1.0);
  return share < 0.0 ? Number{} : share;
}

/// Derivatives of the flux eps (P_1 - P_0), over epsilon, by -P_0 (before) and by P_1 (behind), when the viscosity
/// follows the pressures and varies exponentially between the nodes: phi_0/f and phi_1/f, f the logarithmic mean. Their
/// difference is that of ln eta_bar. Where the fluidity is at its bound they depend on LeastShare:
/// - held: 1 and 1, the derivatives with epsilon held;
/// - follows: the exact ones, as the bound follows the mean fluidity: 1 + d phi_0/(phi_0 + phi_1) and that minus d,
///   with d the difference of ln eta_bar.
/// In the transition both are blended.
template <class Number>
struct Answers {
  Number before, behind;
};
enum class LeastShare { held, follows };
/// in: least, as Between::least; phi and a, 1/eta_bar and ln eta_bar, of the nodes before and after the half point.
template <LeastShare bound = LeastShare::held, class Number>
Answers<Number> answers(double least, Number phi0, Number phi1, Number a0, Number a1) {
  const Number d = a1 - a0;
  const Number fall = phi0 - phi1;
  const auto close = d * d < series_below * series_below;
  const auto flat = close | (fall == 0.0);  // both fluidities may underflow
  const Number limit = close ? 1.0 + d * (0.5 + d * (1.0 / 12.0)) : (d > 0.0 ? d : Number{});
  const Number before = flat ? limit : d * phi0 / (flat ? Number{} + 1.0 : fall);
  // f = fall/d and the bound, both multiplied by d^2.
  const Number share = followed(fall * d, (0.5 * least) * (phi0 + phi1) * d * d);
  if constexpr (bound == LeastShare::held) {
    return {1.0 + share * (before - 1.0), 1.0 + share * (before - d - 1.0)};
  } else {
    const Number sum = phi0 + phi1;
    const Number of_mean = 1.0 + d * phi0 / (sum > 0.0 ? sum : Number{} + 1.0);
    const Number of_f = share * (share + 0.5) / (1.0 + 0.5 * share * share);  // share of f in fluidity_between()
    const Number both = of_mean + of_f * (before - of_mean);
    return {both, both - d};
  }
}

/// Film at the half point: cubic interpolation, but at least half the mean of the two nodes next to it. H < 0 counts as
/// 0.
template <class Number>
Number film_between(const std::array<Number, 4>& H) {
  const auto film = [](Number h) { return h < 0.0 ? Number{} : h; };
  const Number two = film(H[1]) + film(H[2]);
  const Number four = (9.0 * two - (film(H[0]) + film(H[3]))) * (1.0 / 16.0);
  const Number least = 0.25 * two;
  return four < least ? least : four;
}
/// H of the missing node beyond the boundary, from the three nodes on the other side, the nearest first: with it
/// film_between() gives the mean of the two nodes next to the half point.
inline double beyond_boundary(double at, double next, double third) { return at + next - third; }

/// 1/eta_bar at the half point. in: least, as Between::least.
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

/// Change of epsilon_between() with changes of H, rho_bar and log_viscosity at the nodes; the change of the fluidity
/// follows from that of log_viscosity.
double epsilon_change(const AroundHalfPoint<double>& at, const AroundHalfPoint<double>& change, const Between& how);

/// Spans of one length, one value per line: H of four neighbouring columns, the rest of the two in the middle.
struct AroundLines {
  std::array<std::span<const double>, 4> H;
  std::array<std::span<const double>, 2> rho_bar, fluidity, log_viscosity;
};
/// epsilon half-way between the two columns in the middle.
void epsilon_between_stations(const AroundLines& around, const Between& how, std::span<double> eps);

/// The nodes of one column. H has one more value before the first node and one after the last.
struct AlongStation {
  std::span<const double> H, rho_bar, fluidity, log_viscosity;
};
/// epsilon half-way between each node and the next. out: eps, whose last value is not written.
void epsilon_between_nodes(const AlongStation& along, const Between& how, std::span<double> eps);

}  // namespace ehl::film
