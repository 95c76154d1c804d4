// The mass-conserving cavitation model in time: parallel plates in an oil bath that separate and approach again
// (Optasanu and Bonneau; Ausas 2009). The edge of the film moves inwards through the oil that remained in the cavity.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "reynolds/content.hpp"
#include "unit/reynolds/fields.hpp"

BOOST_AUTO_TEST_SUITE(test_reynolds_content)

using namespace ehl;
using namespace ehl::tests;

namespace {

/// d(h^3 p_x)/dx = 2 dQ/dt on 0 < x < 1, with backward Euler steps: d(h^3/2 p_x)/dx - c Q = -c Q_before.
constexpr double p_bath = 0.025;
double gap(double t) { return 0.125 * std::cos(4.0 * std::numbers::pi * t) + 0.375; }

struct Plates {
  int n;
  double dt;
  double t = 0.0;
  std::vector<double> P, Q;
  double worst_sum = 0.0;  ///< largest rate of oil created in a step; the inflow is up to 1.6
  Plates(int cells, double step) : n(cells), dt(step) {
    P.assign(static_cast<std::size_t>(n) + 1, p_bath);
    Q.assign(P.size(), gap(0.0));
  }
  double hx() const { return 1.0 / n; }
};

/// r of the full nodes, and Q, from upstream to downstream; f = -c Q_before.
struct Rows {
  std::vector<double> r, Q;
};
Rows rows_of(const Plates& plates, const std::vector<double>& P, double h) {
  const double c = 1.0 / plates.dt, e = 0.5 * h * h * h / (plates.hx() * plates.hx());
  Rows rows{std::vector<double>(P.size()), std::vector<double>(P.size(), h)};
  reynolds::March<double> march({reynolds::Wedge::upstream2, 0.0, c}, plates.hx(), h, h);
  for (std::size_t k = 1; k + 1 < P.size(); ++k) {
    const double inflow = e * (P[k - 1] - 2.0 * P[k] + P[k + 1]);
    rows.r[k] = march.residual(h, h, {}, inflow + c * plates.Q[k]);
    march.go_on(h, P[k] <= 0.0, rows.r[k]);
    rows.Q[k] = march.Q();
  }
  return rows;
}

/// For a known set of wet nodes, the rows form a tridiagonal system.
void solve_wet(std::vector<double>& P, const std::vector<char>& wet, const std::vector<double>& lacks, double e) {
  std::vector<double> u(P.size(), 0.0), g(P.size(), 0.0);
  g[0] = P[0];
  for (std::size_t k = 1; k + 1 < P.size(); ++k) {
    if (!wet[k]) continue;
    const double pivot = 2.0 * e - e * u[k - 1];
    u[k] = e / pivot;
    g[k] = (e * g[k - 1] - lacks[k]) / pivot;
  }
  for (std::size_t k = P.size() - 2; k > 0; --k) P[k] = wet[k] ? g[k] + u[k] * P[k + 1] : 0.0;
}

void step(Plates& plates) {
  plates.t += plates.dt;
  const double h = gap(plates.t);
  const double e = 0.5 * h * h * h / (plates.hx() * plates.hx());
  std::vector<double> dry(plates.P.size(), 0.0);
  std::vector<char> wet(plates.P.size(), 0);
  for (std::size_t k = 0; k < wet.size(); ++k) wet[k] = plates.P[k] > 0.0;
  std::vector<double> P = plates.P;
  constexpr int most = 2000;
  for (int sets = 1;; ++sets) {
    std::vector<double> lacks(P.size());
    for (std::size_t k = 1; k + 1 < P.size(); ++k) lacks[k] = (h - plates.Q[k]) / plates.dt;
    solve_wet(P, wet, lacks, e);
    bool changed = false;
    for (std::size_t k = 1; k + 1 < P.size(); ++k)
      if (wet[k] && P[k] <= 0.0) {
        wet[k] = 0;
        P[k] = 0.0;
        changed = true;
      }
    const Rows rows = rows_of(plates, P, h);
    for (std::size_t k = 1; k + 1 < P.size(); ++k)
      if (!wet[k] && !changed && rows.r[k] < 0.0) {
        wet[k] = 1;
        changed = true;
      }
    if (!changed) {
      double sum = 0.0;
      for (std::size_t k = 1; k + 1 < P.size(); ++k) sum += plates.hx() * (rows.Q[k] - plates.Q[k]) / plates.dt;
      const double in = e * plates.hx() * (P[0] - P[1] + P[P.size() - 1] - P[P.size() - 2]);
      plates.worst_sum = std::max(plates.worst_sum, std::abs(sum - in));
      plates.P = P;
      plates.Q = rows.Q;
      return;
    }
    BOOST_REQUIRE_MESSAGE(sets < most, "no set of wet nodes at t = " << plates.t);
  }
}

/// The edge of the film that begins at the bath; the first dry node is filled according to its oil content.
double edge(const Plates& plates) {
  std::size_t k = 1;
  while (plates.P[k] > 0.0) ++k;
  const double ahead = plates.Q[k + 1];
  return plates.hx() * (static_cast<double>(k) - 0.5 + (plates.Q[k] - ahead) / (gap(plates.t) - ahead));
}

struct Run {
  std::vector<double> edges;  ///< at the times asked for
  double full_at = 0.0;       ///< the time at which the cavity has disappeared
  double worst_sum = 0.0;
};
Run run(int n, double dt, const std::vector<double>& times) {
  Plates plates(n, dt);
  Run result;
  std::size_t next = 0;
  while (plates.t < 0.74 && result.full_at == 0.0) {
    step(plates);
    if (next < times.size() && plates.t > times[next] - 0.5 * dt) {
      result.edges.push_back(edge(plates));
      ++next;
    }
    const bool full = std::ranges::none_of(plates.P, [](double P) { return P <= 0.0; });
    if (plates.t > 0.4 && full) result.full_at = plates.t;
  }
  result.worst_sum = plates.worst_sum;
  return result;
}

}  // namespace

// Exact solution: rupture at s = sqrt(p0 h^3/h') from t = 0.25008; then ds/dt = (p0 h^3/s - h' s)/(2 (h - h(t_r(s)))),
// where t_r(x) is the time of rupture at x; full again at 0.732390.
BOOST_AUTO_TEST_CASE(film_edge_runs_in_at_first_order_in_time) {
  const std::vector<double> times{0.4, 0.5, 0.6, 0.65, 0.7};
  const std::vector<double> exact{0.026781, 0.039087, 0.062777, 0.090792, 0.176938};
  constexpr double exact_full = 0.732390;
  std::vector<double> errors;
  for (const double dt : {1e-3, 5e-4, 2.5e-4}) {
    const Run found = run(800, dt, times);
    BOOST_REQUIRE(found.edges.size() == times.size());
    double worst = 0.0;
    for (std::size_t k = 0; k < times.size(); ++k) {
      worst = std::max(worst, std::abs(found.edges[k] - exact[k]));
      BOOST_TEST_MESSAGE("dt = " << dt << ", t = " << times[k] << ": edge at " << found.edges[k] << " (" << exact[k]
                                 << ")");
    }
    errors.push_back(found.edges.front() - exact.front());
    BOOST_TEST_MESSAGE("dt = " << dt << ": full at " << found.full_at << " (0.732390 +- dt), oil from nowhere "
                               << found.worst_sum << " (allowed 1e-10)");
    BOOST_TEST(worst <= 4.0 * dt);
    BOOST_TEST(std::abs(found.full_at - exact_full) <= 2.0 * dt);
    BOOST_TEST(found.worst_sum <= 1e-10);
  }
  // The error of the mesh is the same in all of them.
  const double ratio = (errors[0] - errors[1]) / (errors[1] - errors[2]);
  BOOST_TEST_MESSAGE("errors at 0.4: " << errors[0] << ", " << errors[1] << ", " << errors[2]
                                       << "; their changes have a ratio of " << ratio << " (2 +- 0.3)");
  BOOST_TEST(std::abs(ratio - 2.0) <= 0.3);
}

// Over four halvings, second order gives a factor of 256 and first order 16; the position of the edge in its
// cell changes this somewhat.
BOOST_AUTO_TEST_CASE(film_edge_is_of_second_order_in_space) {
  constexpr double exact = 0.176938;
  const double coarse = run(25, 2.5e-4, {0.7}).edges.back() - exact;
  const double fine = run(400, 2.5e-4, {0.7}).edges.back() - exact;
  BOOST_TEST_MESSAGE("edge at 0.7 off by " << coarse << " on 25 cells, by " << fine << " on 400: a factor of "
                                           << coarse / fine << " (at least 150)");
  BOOST_TEST(std::abs(coarse / fine) >= 150.0);
}

// residual() gives the same rows.
BOOST_AUTO_TEST_CASE(residual_has_the_rows_of_the_march_in_time) {
  Plates plates(60, 2e-3);
  while (plates.t < 0.5) step(plates);
  const Plates before = plates;
  step(plates);
  const double h = gap(plates.t);
  const core::Grid grid{60, 2, 0.0, 1.0, 0.0, 2.0};
  Fields fields = zero_fields(grid);
  core::Field across(grid), Q(grid), r(grid), f(grid);
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 2; ++j) {
      const auto k = static_cast<std::size_t>(i);
      fields.rho_bar(i, j) = 1.0;
      fields.H(i, j) = h;
      fields.eps(i, j) = 0.5 * h * h * h;
      f(i, j) = -before.Q[k] / plates.dt;
      if (j == 1) fields.P(i, j) = plates.P[k];
    }
  const std::vector<double> supply(3, 1.0);
  const reynolds::Transport transport(reynolds::Wedge::upstream2, 0.0, 1.0 / plates.dt);
  reynolds::residual(grid, {fields.P, fields.H, fields.rho_bar, fields.eps, f, across}, {Q, supply}, transport, 1, r);
  double worst = 0.0, worst_Q = 0.0;
  for (int i = 1; i < 60; ++i) {
    const auto k = static_cast<std::size_t>(i);
    worst = std::max(worst, fields.P(i, 1) > 0.0 ? std::abs(r(i, 1)) : -std::min(0.0, r(i, 1)));
    worst_Q = std::max(worst_Q, std::abs(Q(i, 1) - plates.Q[k]));
  }
  BOOST_TEST_MESSAGE("residual(): r " << worst << ", Q off by " << worst_Q << " (allowed 1e-9: rounding of eps/h^2)");
  BOOST_TEST(worst <= 1e-9);
  BOOST_TEST(worst_Q <= 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
