// The memory of a moving body for the flux into it, against closed forms of one-dimensional conduction (Carslaw and
// Jaeger 1959, 2.9).
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "thermal/body_memory.hpp"
#include "thermal/moving_source.hpp"

BOOST_AUTO_TEST_SUITE(test_thermal_body_memory)

using namespace ehl::thermal;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;

namespace {

Patch patch_of(int cells) { return Patch(Grid{cells, 8, -2.0, 2.0, -1.0, 1.0}); }

Field filled(const Patch& patch, auto f) {
  Field field(patch);
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) field(i, j) = f(patch.X(i));
  return field;
}

// The temperature at the end of a run with steps that grow from a short first one to the length given.
// in: flux(X, T), which the body meets at the nodes of the patch.
Field heated(const Patch& patch, double first, double longest, double end, double speed, auto flux) {
  BodyMemory memory(patch, 1.0, inverse_root(1e-7, end), 1);
  Field history(patch), q(patch);
  double T = 0.0;
  for (double step = first; T < end * (1.0 - 1e-12); step = std::min(longest, 1.5 * step)) {
    const double length = std::min(step, end - T);
    memory.look(0.7 * length, 0.1, history);  // a step that is not taken must leave no trace
    memory.look(length, speed * length, history);
    T += length;
    q = filled(patch, [&](double X) { return flux(X, T); });
    memory.accept(q);
  }
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) history(i, j) += memory.self() * q(i, j);
  return history;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_sum_of_exponentials_is_the_inverse_root) {
  const double shortest = 1e-7, longest = 20.0;
  const ExponentialSum sum = inverse_root(shortest, longest);
  double worst = 0.0;
  for (double t = shortest; t <= longest; t *= 1.01) {
    double value = 0.0;
    for (std::size_t k = 0; k < sum.rate.size(); ++k) value += sum.weight[k] * std::exp(-sum.rate[k] * t);
    worst = std::max(worst, std::abs(value * std::sqrt(t) - 1.0));
  }
  BOOST_TEST_MESSAGE(sum.rate.size() << " terms: relative error " << worst << " (allowed 1e-6)");
  BOOST_TEST(worst <= 1e-6);
  BOOST_TEST(sum.rate.size() <= 80u);
}

BOOST_AUTO_TEST_CASE(a_suddenly_heated_half_space_warms_as_the_root_of_time) {
  const Patch patch = patch_of(32);
  for (const double speed : {0.0, 1.0, 0.31}) {
    const double end = 1.5;
    const Field theta = heated(patch, 1e-6, 0.05, end, speed, [](double, double) { return 1.0; });
    double worst = 0.0;
    for (int i = 0; i <= patch.nx; ++i)  // not the material that has entered the domain, nor that next to it
      if (patch.X(i) - patch.domain.X_a > speed * end + 3.0 * patch.hx() && i < patch.nx - 2)
        worst = std::max(worst, std::abs(theta(i, 3) / (2.0 * std::sqrt(end)) - 1.0));
    BOOST_TEST_MESSAGE("speed " << speed << ": relative error " << worst << " (allowed 1e-5)");
    BOOST_TEST(worst <= 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(a_flux_that_grows_linearly_has_no_error_of_the_steps) {
  const Patch patch = patch_of(32);
  const double end = 1.5;
  const Field theta = heated(patch, 0.3, 0.4, end, 0.0, [](double, double T) { return T; });
  const double exact = 4.0 / 3.0 * std::pow(end, 1.5), error = std::abs(theta(16, 4) / exact - 1.0);
  BOOST_TEST_MESSAGE("four steps: relative error " << error << " (allowed 2e-6)");
  BOOST_TEST(error <= 2e-6);
}

// Second order in the step: a flux that varies as a sine, against a run with very many steps.
BOOST_AUTO_TEST_CASE(the_steps_are_of_second_order) {
  const Patch patch = patch_of(32);
  const auto flux = [](double, double T) { return std::sin(3.0 * T); };
  const auto value = [&](double step) { return heated(patch, step, step, 1.0, 0.0, flux)(16, 4); };
  const double exact = value(1.0 / 2048), coarse = std::abs(value(1.0 / 16) - exact);
  const double fine = std::abs(value(1.0 / 32) - exact), order = std::log2(coarse / fine);
  BOOST_TEST_MESSAGE("errors " << coarse << ", " << fine << ": order " << order << " (at least 1.8)");
  BOOST_TEST(order >= 1.8);
}

// A band from X = -1 to 1 that is heated from T = 0 on, at rest while the body moves: the material at X has met it for
// the shorter of T and the time since it entered the band.
BOOST_AUTO_TEST_CASE(a_band_that_starts_to_heat_a_moving_body) {
  const Patch patch = patch_of(128);
  const double speed = 1.0, h = patch.hx(), largest = 2.0 * std::sqrt(2.0 / speed);
  const auto band = [h](double X, double) { return std::clamp((1.0 - std::abs(X)) / h + 0.5, 0.0, 1.0); };
  for (const double end : {0.25, 0.8, 2.5}) {
    const Field theta = heated(patch, 1e-6, 0.02, end, speed, band);
    double worst = 0.0;
    for (int i = 0; i <= patch.nx; ++i) {
      const double X = patch.X(i), entered = std::min(end, std::max(0.0, (X + 1.0) / speed));
      const double left = std::min(end, std::max(0.0, (X - 1.0) / speed));
      const double exact = 2.0 * (std::sqrt(entered) - std::sqrt(left));
      const bool at_a_corner = std::abs(X + 1.0) < 4 * h || std::abs(X - 1.0) < 4 * h ||
                               std::abs(X - 1.0 - speed * end) < 4 * h || std::abs(X + 1.0 - speed * end) < 4 * h;
      if (!at_a_corner) worst = std::max(worst, std::abs(theta(i, 2) - exact) / largest);
    }
    BOOST_TEST_MESSAGE("time " << end << ": error " << worst << " of the largest temperature (allowed 5e-3)");
    BOOST_TEST(worst <= 5e-3);
  }
}

// After a long time the temperature is that of the steady line sources.
BOOST_AUTO_TEST_CASE(a_flux_that_rests_gives_the_steady_line_sources) {
  const Patch patch = patch_of(128);
  const double speed = 0.8;
  const auto hertz = [](double X, double) { return std::sqrt(std::max(0.0, 1.0 - X * X)); };
  const Field theta = heated(patch, 1e-4, 0.02, 8.0, speed, hertz);
  const std::vector<double> weights = line_weights(patch.nx, patch.hx(), 1.0);
  double worst = 0.0, largest = 0.0;
  for (int i = 0; i <= patch.nx; ++i) {
    double steady = 0.0;
    for (int m = 0; m <= i; ++m) steady += weights[static_cast<std::size_t>(m)] * hertz(patch.X(i - m), 0.0);
    steady *= std::sqrt(std::numbers::pi / speed);  // factor 1 instead of (pi Pe)^-1/2, at this speed
    largest = std::max(largest, steady);
    worst = std::max(worst, std::abs(theta(i, 5) - steady));
  }
  BOOST_TEST_MESSAGE("apart by " << worst / largest << " of the largest temperature (allowed 5e-3)");
  BOOST_TEST(worst <= 5e-3 * largest);
}

// A resting flux at a constant speed, and at the speed 1 + T from T = 0 on: there the material now at X was at X - d at
// the time T' with d = (T - T') + (T^2 - T'^2)/2, and the integral is that of q(X - d) dT'/sqrt(T - T').
BOOST_AUTO_TEST_CASE(material_that_passes_a_resting_flux_at_a_varying_speed) {
  const int n = 64;
  const double h = 3.0 / n;
  const std::vector<double> constant = passing_weights(n, h, [](double d) { return d / 0.7; });
  const std::vector<double> lines = line_weights(n, h, 0.7 / std::numbers::pi);
  double worst = 0.0;
  for (std::size_t m = 0; m < lines.size(); ++m) worst = std::max(worst, std::abs(constant[m] / lines[m] - 1.0));
  BOOST_TEST_MESSAGE("constant speed: relative difference from the line sources " << worst << " (allowed 1e-8)");
  BOOST_TEST(worst <= 1e-8);

  const double T = 0.6;
  const auto place = [](double t) { return t < 0.0 ? t : t + 0.5 * t * t; };
  const auto ago = [&](double d) {
    const double X = place(T) - d;
    return T - (X < 0.0 ? X : std::sqrt(1.0 + 2.0 * X) - 1.0);
  };
  const auto q = [](double X) { return std::exp(-4.0 * X * X); };
  const std::vector<double> weights = passing_weights(n, h, ago);
  double sum = 0.0, exact = 0.0;
  for (int m = 0; m <= n; ++m) sum += weights[static_cast<std::size_t>(m)] * q(0.4 - m * h);
  constexpr int parts = 20000;
  const double longest = std::sqrt(ago(3.0));
  for (int k = 0; k < parts; ++k) {  // T - T' = s^2
    const double s = longest * (k + 0.5) / parts;
    exact += 2.0 * longest / parts * q(0.4 - (place(T) - place(T - s * s)));
  }
  const double error = std::abs(sum / exact - 1.0);
  BOOST_TEST_MESSAGE("varying speed: " << sum << ", exact " << exact << ": " << error << " (allowed 1e-3)");
  BOOST_TEST(error <= 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
