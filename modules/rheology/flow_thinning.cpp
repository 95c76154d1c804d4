#include <array>
#include <cmath>
#include <type_traits>

#include "rheology/elementary.hpp"
#include "rheology/thinned_by_flow.hpp"

namespace ehl::rheology {
namespace {

// Stress over tau_c below which thinning is below 1e-7.
constexpr double no_stress = 1e-3;

// Gauss-Legendre points on [-1/2, 1/2]: one half; the other half is symmetric.
struct Point {
  double s, weight;
};
constexpr std::array<Point, 4> points{{{0.5 * 0.18343464249564980, 0.5 * 0.36268378337836198},
                                       {0.5 * 0.52553240991632899, 0.5 * 0.31370664587788729},
                                       {0.5 * 0.79666647741362674, 0.5 * 0.22238103445337447},
                                       {0.5 * 0.96028985649753623, 0.5 * 0.10122853629037626}}};

// F/tau and F' at the stress tau > 0; rates in tau_c/eta.
struct Rate {
  Lanes secant, slope;
};
Rate rate_at(Eyring, Lanes tau) {
  const Lanes up = exp(tau), down = 1.0 / up;
  const Lanes series = 1.0 + tau * tau * (1.0 / 6.0);  // error 1e-14 below 1e-3
  return {tau < no_stress ? series : 0.5 * (up - down) / tau, 0.5 * (up + down)};
}
Rate rate_at(const Carreau& law, Lanes tau) {
  // ln tau = x + (n-1)/2 ln(1 + e^2x), x = ln rate. The slope lies between n and 1, and Newton's method converges
  // downwards from the larger of the power law and the Newtonian law.
  const Lanes log_tau = log1p(tau - 1.0);
  Lanes x = core::max(log_tau, log_tau / law.n);
  Lanes slope{};
  constexpr int steps = 6;  // reaches 1e-12 from the transition, where the initial value is worst
  for (int step = 0; step <= steps; ++step) {
    const Lanes square = exp(2.0 * x);
    slope = 1.0 + (law.n - 1.0) * (square / (1.0 + square));
    if (step < steps) x -= (x + 0.5 * (law.n - 1.0) * log1p(square) - log_tau) / slope;
  }
  const Lanes secant = exp(x - log_tau);
  return {secant, secant / slope};
}

// t_x, t_y, g_x, g_y.
using Four = std::array<Lanes, 4>;

struct Equations {
  Four left;
  std::array<Four, 4> slope;  // symmetric
};

template <class Law>
Equations equations_at(const Law& law, const Four& x) {
  Equations sum{};
  for (const Point& point : points)
    for (const double s : {-point.s, point.s}) {
      const Lanes tau_x = x[0] + s * x[2], tau_y = x[1] + s * x[3];
      const Lanes square = tau_x * tau_x + tau_y * tau_y + 1e-30;
      const Rate rate = rate_at(law, square_root(square));
      const Lanes excess = (rate.slope - rate.secant) / square;
      const Lanes xx = point.weight * (rate.secant + excess * tau_x * tau_x),
                  xy = point.weight * excess * tau_x * tau_y,
                  yy = point.weight * (rate.secant + excess * tau_y * tau_y);
      const std::array<Lanes, 2> mean{point.weight * rate.secant * tau_x, point.weight * rate.secant * tau_y};
      for (std::size_t n : {0U, 1U}) {
        sum.left[n] += mean[n];
        sum.left[n + 2] += s * mean[n];
      }
      const std::array<std::array<Lanes, 2>, 2> block{{{xx, xy}, {xy, yy}}};
      for (std::size_t n : {0U, 1U})
        for (std::size_t m : {0U, 1U}) {
          sum.slope[n][m] += block[n][m];
          sum.slope[n][m + 2] += s * block[n][m];
          sum.slope[n + 2][m + 2] += (s * s) * block[n][m];
        }
    }
  for (std::size_t n : {2U, 3U})
    for (std::size_t m : {0U, 1U}) sum.slope[n][m] = sum.slope[m][n];
  return sum;
}

// The matrix is symmetric and positive definite, so no pivoting is needed.
Four solve_four(std::array<Four, 4> matrix, Four right) {
  for (std::size_t k = 0; k < 4; ++k) {
    const Lanes inverse = 1.0 / matrix[k][k];
    for (std::size_t n = k + 1; n < 4; ++n) {
      const Lanes factor = matrix[n][k] * inverse;
      for (std::size_t m = k; m < 4; ++m) matrix[n][m] -= factor * matrix[k][m];
      right[n] -= factor * right[k];
    }
  }
  for (std::size_t k = 4; k-- > 0;) {
    for (std::size_t m = k + 1; m < 4; ++m) right[k] -= matrix[k][m] * right[m];
    right[k] /= matrix[k][k];
  }
  return right;
}

// Solves for t and g at given mean rate and moments.
template <class Law>
Four stresses_of(const Law& law, const Four& right, Four x) {
  constexpr int most = 40;
  constexpr double tolerance = 1e-9;
  for (int step = 0; step < most; ++step) {
    const Equations at = equations_at(law, x);
    Four rest;
    for (std::size_t n = 0; n < 4; ++n) rest[n] = right[n] - at.left[n];
    const Four change = solve_four(at.slope, rest);
    // Step limit: the stress at the walls changes by at most tau_c or half of itself, because Eyring's rate grows
    // exponentially.
    const auto at_wall = [](const Four& y) {
      return core::max(core::abs(y[0]) + 0.5 * core::abs(y[2]), core::abs(y[1]) + 0.5 * core::abs(y[3]));
    };
    const Lanes wall = at_wall(x), moved = at_wall(change);
    const Lanes most_moved = std::is_same_v<Law, Eyring> ? broadcast(1.0) : core::max(broadcast(1.0), 0.5 * wall);
    const Lanes cut = moved > most_moved ? most_moved / moved : broadcast(1.0);
    for (std::size_t n = 0; n < 4; ++n) x[n] += cut * change[n];
    if (core::all(moved <= tolerance * (1.0 + wall))) break;
  }
  return x;
}

// Factors over thinning by sliding alone, for rates in tau_c/eta. in: near: factors at a similar flow, or nullptr.
template <class Law>
FlowThinned thinned_under(const Law& law, Lanes sliding, Lanes flow_x, Lanes flow_y, const FlowThinned* near) {
  Lanes along, across, per_rate;
  const auto evaluate = [&](Lanes rate, auto write) {
    for (int lane = 0; lane < core::lanes; ++lane) write(lane, thinned(law, rate[lane]));
  };
  sliding = core::max(sliding, broadcast(no_stress));  // the factors are even in it
  evaluate(sliding, [&](int lane, const Thinned& alone) {
    along[lane] = 1.0 / alone.along;
    across[lane] = 1.0 / alone.across;
  });
  const Lanes least_x = (no_stress / 12.0) * along, least_y = (no_stress / 12.0) * across;
  if (core::all((flow_x <= least_x) & (flow_y <= least_y))) return {broadcast(1.0), broadcast(1.0), broadcast(1.0)};
  flow_x = core::max(flow_x, least_x);
  flow_y = core::max(flow_y, least_y);
  const auto factors = [&](const Four& x) {
    return FlowThinned{12.0 * flow_x / (x[2] * along), 12.0 * flow_y / (x[3] * across), x[0] * across / sliding};
  };
  const Four right{sliding, Lanes{}, flow_x, flow_y};
  if (near != nullptr)
    return factors(stresses_of(law, right,
                               {near->stress * sliding / across, Lanes{}, 12.0 * flow_x / (near->along * along),
                                12.0 * flow_y / (near->across * across)}));
  // Initial value: one viscosity, that at the largest rate.
  const Lanes at_wall = sliding + 6.0 * (flow_x + flow_y);
  evaluate(at_wall, [&](int lane, const Thinned& there) { per_rate[lane] = there.across; });
  return factors(
      stresses_of(law, right, {per_rate * sliding, Lanes{}, 12.0 * per_rate * flow_x, 12.0 * per_rate * flow_y}));
}

}  // namespace

FlowThinned thinned_by_flow(const FlowThinning& thinning, Lanes H_fluidity, Lanes flow_x, Lanes flow_y,
                            const FlowThinned* near) {
  constexpr double largest_rate = 1e30;  // for a fluidity that underflows
  const Lanes k = core::min(thinning.k_m / H_fluidity, broadcast(largest_rate));
  return std::visit(
      [&](const auto& law) {
        return thinned_under(law, k * thinning.sliding, k * core::abs(flow_x), k * core::abs(flow_y), near);
      },
      thinning.law);
}

}  // namespace ehl::rheology
