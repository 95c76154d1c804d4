// A moving body: the exact squeeze film of a rigid paraboloid, free vibration, impact and rebound.
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "multigrid/hierarchy.hpp"
#include "unit/transient/marching.hpp"

BOOST_AUTO_TEST_SUITE(test_moving_body)

using namespace ehl;
using namespace ehl::tests;
using namespace ehl::transient;

namespace {

/// An isoviscous, incompressible oil on n x n cells from -side to side.
steady::Scene plain_scene(int n, double side, double M) {
  steady::Scene scene = marching_scene(n, M, 0.0);
  scene.viscosity = rheology::Isoviscous{};
  scene.density = rheology::Incompressible{};
  scene.grid = {n, n, -side, side, -side, side};
  return scene;
}

const Schedule none{.points = {{0.0, 0.0}}};

/// Separated bodies without rolling; the only load is inertia.
Conditions flying(const Body& body) { return {.load = none, .u1 = none, .u2 = none, .body = body}; }

/// Starts with separated bodies, for which no steady state is needed.
Marched released(const steady::Scene& scene, const Conditions& conditions, const MarchParameters& parameters) {
  steady::Solution start;
  start.P = core::Field(scene.grid);
  start.H00 = 1.0;
  return marched_from(start, scene, conditions, parameters);
}

/// The dissipation: the sum of eps |grad P|^2 over the domain, with eps at half points as the mean of the nodes.
double dissipation(const steady::Scene& scene, const Frame& frame) {
  const core::Patch& grid = scene.grid;
  const auto eps = [&](int i, int j) { return std::pow(frame.H(i, j), 3) / scene.lambda; };
  double sum = 0.0;
  const auto between = [&](int i, int j, int k, int l, double step) {
    const double slope = (frame.P(k, l) - frame.P(i, j)) / step;
    sum += 0.5 * (eps(i, j) + eps(k, l)) * slope * slope;
  };
  for (int i = 0; i < grid.nx; ++i)
    for (int j = 0; j < grid.ny; ++j) {
      if (j > 0) between(i, j, i + 1, j, grid.hx());
      if (i > 0) between(i, j, i, j + 1, grid.hy());
    }
  return sum * grid.hx() * grid.hy();
}

/// The largest |P(X, Y) - P(-X, Y)| relative to the largest P; 0 without rolling.
double asymmetry(const core::Field& P) {
  const int nx = P.nodes_x() - 1;
  double largest = 0.0, difference = 0.0;
  for (int i = 0; i <= nx; ++i)
    for (int j = 0; j < P.nodes_y(); ++j) {
      largest = std::max(largest, P(i, j));
      difference = std::max(difference, std::abs(P(i, j) - P(nx - i, j)));
    }
  return difference / largest;
}

constexpr double W = 2.0 * std::numbers::pi / 3.0;

}  // namespace

// With a damping d the equation is mass V dV/dH + d V = -(3/4) lambda V/H, and V = V_0 + (3/4)(lambda/mass)
// ln(H_0/H) + (d/mass)(H_0 - H).
BOOST_AUTO_TEST_CASE(damping_takes_its_share) {
  const steady::Scene scene = plain_scene(256, 40.0, 5000.0);
  const Body body{.mass = 0.5 * scene.lambda, .damping = 1.5 * scene.lambda, .gap = 3.0, .velocity = -3.0};
  const Marched all = released(scene, flying(body), {.end = 0.4, .rtol = 1e-5});
  BOOST_REQUIRE_MESSAGE((all.report.end == MarchEnd::end_time), all.report.reason);
  double speed = 0.0, path = 0.0, H00 = body.gap.value(), last_T = 0.0, last_V = body.velocity;
  for (const StepRow& row : all.rows) {
    H00 += 0.5 * (row.velocity + last_V) * (row.T - last_T);
    last_T = row.T;
    last_V = row.velocity;
    path = std::max(path, std::abs(H00 - row.H00));
    if (row.T < 0.01) continue;
    const double V = body.velocity + 0.75 * scene.lambda / body.mass * std::log(body.gap.value() / row.H00) +
                     body.damping / body.mass * (body.gap.value() - row.H00);
    speed = std::max(speed, std::abs((row.velocity - V) / body.velocity));
  }
  const StepRow& last = all.rows.back();
  const double uneven = asymmetry(all.frames.back().P);
  BOOST_TEST_MESSAGE("P uneven by " << uneven << " (allowed 1e-9)");
  BOOST_TEST(uneven < 1e-9);
  BOOST_TEST_MESSAGE("damped squeeze: " << all.report.steps << " steps, H00 = " << last.H00 << ", V = " << last.velocity
                                        << "; V(H00) off by " << speed
                                        << " of V_0 (allowed 0.005), H00 - integral of V " << path
                                        << " (allowed 1e-4)");
  BOOST_TEST(last.velocity > 0.5 * body.velocity);  // most of the velocity remains
  BOOST_TEST(speed < 0.005);
  BOOST_TEST(path < 1e-4);
}

// With p = 3 eta_0 V R/h^2 the squeeze film carries W_s = (pi/2) lambda |V|/H00 in the units of P and X. A body that
// only its film slows down obeys mass V dV/dH = -(3/4) lambda V/H, so V = V_0 + (3/4)(lambda/mass) ln(H_0/H). The share
// 1/(1 + X^2/(2 H00)) of the force lies outside the domain, and P = 0 on its boundary removes about as much again.
BOOST_AUTO_TEST_CASE(a_rigid_paraboloid_is_squeezed_by_the_exact_law) {
  const steady::Scene scene = plain_scene(448, 40.0, 5000.0);
  const Body body{.mass = 0.5 * scene.lambda, .gap = 3.0, .velocity = -3.0};
  const Marched all = released(scene, flying(body), {.end = 0.4, .rtol = 1e-5});
  BOOST_REQUIRE_MESSAGE((all.report.end == MarchEnd::end_time), all.report.reason);
  double force = 0.0, speed = 0.0;
  for (const StepRow& row : all.rows) {
    if (row.T < 0.01) continue;
    const double exact = 0.5 * std::numbers::pi * scene.lambda * -row.velocity / row.H00 / W;
    force = std::max(force, std::abs(row.carried / exact - 1.0));
    const double V = body.velocity + 0.75 * scene.lambda / body.mass * std::log(body.gap.value() / row.H00);
    speed = std::max(speed, std::abs(row.velocity / V - 1.0));
  }
  const StepRow& last = all.rows.back();
  BOOST_TEST_MESSAGE("squeeze: " << all.report.steps << " steps, " << all.report.cycles << " cycles, H00 = " << last.H00
                                 << ", V = " << last.velocity << "; force off by " << force
                                 << " (allowed 0.01), V(H00) by " << speed << " (allowed 0.005)");
  BOOST_TEST(last.H00 < 2.1);
  BOOST_TEST(force < 0.01);
  BOOST_TEST(speed < 0.005);
  BOOST_TEST(all.report.worst_load_error < 1e-6);
}

// With the far field in closed form, a domain of 6 radii is more accurate than one of 40 radii without it: P on the
// boundary and the force outside are exact. The tolerance is relative to very small pressures.
BOOST_AUTO_TEST_CASE(likewise_on_a_small_domain_with_the_far_field) {
  double force[2] = {0.0, 0.0};
  for (const int finer : {0, 1}) {
    steady::Scene scene = plain_scene(finer ? 128 : 64, 6.0, 1000.0);
    scene.far_field = true;
    const Body body{.mass = 0.5 * scene.lambda, .gap = 3.0, .velocity = -3.0};
    const Marched all = released(scene, flying(body), {.end = 0.1, .rtol = 1e-6});
    BOOST_REQUIRE_MESSAGE((all.report.end == MarchEnd::end_time), all.report.reason);
    for (const StepRow& row : all.rows) {
      if (row.T < 0.01) continue;
      const double exact = 0.5 * std::numbers::pi * scene.lambda * -row.velocity / row.H00 / W;
      force[finer] = std::max(force[finer], std::abs(row.carried / exact - 1.0));
    }
    BOOST_TEST(all.report.worst_load_error < 1e-6);
  }
  BOOST_TEST_MESSAGE("force off by " << force[0] << " and " << force[1] << " (allowed 0.002), order "
                                     << std::log2(force[0] / force[1]));
  BOOST_TEST(force[1] < 0.002);
  BOOST_TEST(std::log2(force[0] / force[1]) > 1.8);
}

// The kinetic energy mass W (V_0^2 - V_1^2)/2 that the body loses equals the dissipation, the sum of eps |grad P|^2
// over space and time, once the bodies are separated again and no elastic energy remains. Since P (L(P) - H') = 0 at
// every node, this is exact on any grid. Without a film, Hertzian impact has the largest load (mass V^2/0.8)^(3/5) and
// returns the whole velocity.
BOOST_AUTO_TEST_CASE(an_elastic_impact_loses_what_the_film_takes) {
  const steady::Scene scene = plain_scene(64, 5.0, 50.0);
  const Body body{.mass = 2.0, .gap = 1.0, .velocity = -1.0};
  const Marched all = released(scene, flying(body), {.end = 8.0, .rtol = 1e-4, .output_interval = 0.02});
  BOOST_REQUIRE_MESSAGE((all.report.end == MarchEnd::end_time), all.report.reason);
  double lost = 0.0, last_power = 0.0, last_T = 0.0;
  for (const Frame& frame : all.frames) {
    const double power = dissipation(scene, frame);
    lost += 0.5 * (power + last_power) * (frame.T - last_T);
    last_power = power;
    last_T = frame.T;
  }
  double peak = 0.0, impulse = 0.0;
  for (std::size_t k = 0; k < all.rows.size(); ++k) {
    peak = std::max(peak, all.rows[k].carried);
    if (k > 0) impulse += 0.5 * (all.rows[k].carried + all.rows[k - 1].carried) * (all.rows[k].T - all.rows[k - 1].T);
  }
  const StepRow& last = all.rows.back();
  const double energy = 0.5 * body.mass * W * (body.velocity * body.velocity - last.velocity * last.velocity);
  const double momentum = body.mass * (last.velocity - body.velocity);
  const double hertz = std::pow(body.mass * body.velocity * body.velocity / 0.8, 0.6);
  BOOST_TEST_MESSAGE("impact: " << all.report.steps << " steps, " << all.report.cycles << " cycles; peak " << peak
                                << " (Hertz without a film " << hertz << "), restitution "
                                << last.velocity / -body.velocity << ", energy lost " << energy << ", in the film "
                                << lost << " (allowed 1 %); momentum " << momentum << ", impulse " << impulse);
  BOOST_TEST(last.carried < 1e-6);
  BOOST_TEST(last.velocity > 0.0);
  BOOST_TEST(std::abs(lost / energy - 1.0) < 0.01);
  BOOST_TEST(std::abs(impulse / momentum - 1.0) < 0.002);
  BOOST_TEST(std::abs(peak / hertz - 1.0) < 0.2);
}

// A velocity is imposed on the body. At high load the thin film contributes little compared with the Hertzian
// stiffness, mass Omega^2 = 3/2, and the damping by the rolling contact is small.
BOOST_AUTO_TEST_CASE(a_kicked_body_vibrates_upon_the_dry_contact) {
  const steady::Scene scene = marching_scene(64, 500.0, 10.0);
  const Body body{.mass = 0.05, .velocity = -0.05};
  const double period = 2.0 * std::numbers::pi / natural_frequency(body);
  const Marched all = marched(scene, {.body = body}, {.end = 2.2 * period});
  BOOST_REQUIRE_MESSAGE((all.report.end == MarchEnd::end_time), all.report.reason);
  std::vector<double> turns;  // times at which the velocity changes its sign
  for (std::size_t k = 1; k < all.rows.size(); ++k) {
    const StepRow& a = all.rows[k - 1];
    const StepRow& b = all.rows[k];
    if (a.velocity * b.velocity < 0.0) turns.push_back(a.T + (b.T - a.T) * a.velocity / (a.velocity - b.velocity));
  }
  BOOST_REQUIRE(turns.size() >= 3);
  const double measured = turns[2] - turns[0];
  BOOST_TEST_MESSAGE("vibration: " << all.report.steps << " steps, " << all.report.cycles << " cycles; period "
                                   << measured << ", upon the dry contact " << period << " (allowed 1.5 %)");
  BOOST_TEST(std::abs(measured / period - 1.0) < 0.015);
}

BOOST_AUTO_TEST_SUITE_END()
