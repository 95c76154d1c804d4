// The energy equation of the film in time: steady states, a film and bodies that are suddenly sheared, the order of the
// steps, and the balance of the heat.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "core/errors.hpp"
#include "unit/thermal/base_case.hpp"

BOOST_AUTO_TEST_SUITE(test_thermal_film_in_time)

using namespace ehl::thermal;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::line_grid;
using ehl::core::Patch;
using support::BaseCase, support::filled, support::settle;

namespace {

constexpr double pi = std::numbers::pi;

// A film of constant viscosity without sliding: no heat is made.
Setup cool(const Patch& patch, int intervals = 16) {
  const ehl::rheology::ViscosityLaw viscosity = ehl::rheology::Barus{0.0};
  return {
      .patch = patch,
      .intervals = intervals,
      .stress_of_P = 1.0,
      .viscosity = viscosity,
      .thermal_viscosity = ehl::rheology::make_thermal_viscosity(viscosity, {1.0, ehl::rheology::Exponential{1e-12}}),
      .density =
          ehl::rheology::make_thermal_density(ehl::rheology::Incompressible{}, 1.0, ehl::rheology::Expansion{0.0}),
      .Br = 1.0,
      .pressure_flow = false,
      .theta_least = -1e3,
      .theta_most = 1e9};
}
Field ones(const Patch& patch) {
  return filled(patch, [](double, double) { return 1.0; });
}

// Slides by 1 from T = 0 on, without slip before. returns the film at the time `end`. in: first step, growth of the
// steps up to end/count. out: the worst balance of a step.
FilmTemperature sheared(const Setup& setup, double end, int count, double first, double& worst_balance) {
  FilmTemperature film(setup);
  const Field P = ones(setup.patch), H = ones(setup.patch);
  film.take(P, H);
  settle(film, 1e-14);
  film.begin_in_time(end);
  double T = 0.0;
  worst_balance = 0.0;
  for (double step = first; T < end * (1.0 - 1e-12); step = std::min(end / count, 1.5 * step)) {
    const double length = std::min(step, end - T);
    film.begin_step({.length = 0.5 * length, .u_1 = 1.5, .u_2 = 0.5, .moved_1 = 0.1, .moved_2 = 0.1});  // not taken
    film.begin_step({.length = length, .u_1 = 1.5, .u_2 = 0.5, .moved_1 = 1.5 * length, .moved_2 = 0.5 * length});
    film.take(P, H);
    film.sweep();
    film.sweep();
    worst_balance = std::max(worst_balance, std::abs(film.balance().defect));
    film.accept_step();
    T += length;
  }
  return film;
}

}  // namespace

// Steps of any length leave the temperatures of a steady film where they are, also with a body of finite Peclet number,
// and in a line contact.
BOOST_AUTO_TEST_CASE(a_steady_film_stays_steady) {
  for (const bool line : {false, true})
    for (const bool lines : {false, true}) {
      const Patch patch = line ? Patch(line_grid(64, -4.5, 1.5)) : Patch(Grid{64, 64, -4.5, 1.5, -3.0, 3.0});
      BaseCase base{.line = line};
      if (line) base.load = 2e5;
      Setup setup = base.setup(patch);
      setup.lines = lines;
      const auto film_of = [](double x, double y) {
        const double r2 = x * x + y * y;
        return 0.2 + (r2 > 1.0 ? 0.8 * std::pow(std::sqrt(r2) - 1.0, 1.5) : 0.0);
      };
      const Field P = filled(patch, [](double x, double y) { return support::hertz(x, y); });
      const Field H = filled(patch, film_of);
      FilmTemperature film(setup);
      double change = 1.0;
      for (int n = 0; n < 200 && change > 1e-13; ++n) {  // the flows follow the temperatures
        film.take(P, H);
        change = film.sweep();
      }
      const Balance before = film.balance();
      film.begin_in_time(10.0);
      double T = 0.0, worst = 0.0, worst_surface = 0.0, worst_balance = 0.0;
      for (int n = 0; T < 10.0; ++n) {
        const double length = 0.05 * (1.0 + 0.9 * std::sin(n));
        film.begin_step({.length = length,
                         .u_1 = 1.5,
                         .u_2 = 0.5,
                         .thinning_k = setup.thinning->k,
                         .moved_1 = 1.5 * length,
                         .moved_2 = 0.5 * length});
        film.take(P, H);
        film.sweep();
        const Balance now = film.balance();
        worst = std::max(worst, std::abs(now.film.theta / before.film.theta - 1.0));
        worst_surface = std::max({worst_surface, std::abs(now.surface_1.theta / before.surface_1.theta - 1.0),
                                  std::abs(now.surface_2.theta / before.surface_2.theta - 1.0)});
        worst_balance = std::max(worst_balance, std::abs(now.defect));
        film.accept_step();
        T += length;
      }
      BOOST_TEST_MESSAGE((line ? "line" : "point")
                         << (lines ? ", lines" : ", full") << ": film " << 313.15 * before.film.theta
                         << " K, changes by " << worst << ", surfaces by " << worst_surface
                         << " (allowed 1e-7); heat balance " << worst_balance << " (allowed 1e-6)");
      BOOST_TEST(worst <= 1e-7);
      BOOST_TEST(worst_surface <= 1e-7);
      BOOST_TEST(worst_balance <= 1e-6);
    }
}

// Cold walls: theta = (1/2) zeta (1 - zeta) - sum over odd n of 4/(n pi)^3 sin(n pi zeta) exp(-(n pi)^2 T/Pe), far
// downstream of the oil that enters.
BOOST_AUTO_TEST_CASE(a_film_that_is_suddenly_sheared_warms_by_conduction) {
  constexpr double Pe = 8.0, end = 0.5;
  const Patch patch(Grid{64, 2, 0.0, 4.0, 0.0, 1.0});
  double exact = 0.125;
  for (int n = 1; n < 40; n += 2)
    exact -= 4.0 / std::pow(n * pi, 3) * std::sin(0.5 * n * pi) * std::exp(-n * n * pi * pi * end / Pe);
  const auto middle = [&](int intervals, int count, double first) {
    Setup setup = cool(patch, intervals);
    setup.Pe = Pe;
    double balance = 0.0;
    const double theta = sheared(setup, end, count, first, balance).theta(60, 1, intervals / 2);
    BOOST_TEST_MESSAGE(count << " steps: heat balance " << balance << " (allowed 1e-9)");
    BOOST_TEST(balance <= 1e-9);
    return theta;
  };
  const double theta = middle(32, 100, 1e-4), error = std::abs(theta / exact - 1.0);
  BOOST_TEST_MESSAGE("theta " << theta << ", exact " << exact << ": " << error << " (allowed 2e-3)");
  BOOST_TEST(error <= 2e-3);
  const double finest = middle(16, 1280, end / 1280);
  const double coarse = std::abs(middle(16, 40, end / 40) - finest), fine = std::abs(middle(16, 80, end / 80) - finest);
  const double order = std::log2(coarse / fine);
  BOOST_TEST_MESSAGE("errors " << coarse << ", " << fine << ": order " << order << " (at least 1.8)");
  BOOST_TEST(order >= 1.8);
}

// Two equal bodies take half of the heat each: theta = 2 (1/2) factor sqrt T of both surfaces, where no cold material
// has come from upstream.
BOOST_AUTO_TEST_CASE(two_bodies_below_a_film_that_is_suddenly_sheared) {
  constexpr double end = 0.8, resistance = 2.0, Pe = 20.0;
  const Patch patch(Grid{64, 2, 0.0, 4.0, 0.0, 1.0});
  Setup setup = cool(patch);
  setup.body_1 = setup.body_2 = {.Pe = Pe, .resistance = resistance};
  double balance = 0.0;
  const FilmTemperature film = sheared(setup, end, 40, 1e-6, balance);
  const double exact = resistance / std::sqrt(pi * Pe) * std::sqrt(end);
  const double error =
      std::max(std::abs(film.theta(60, 1, 0) / exact - 1.0), std::abs(film.theta(60, 1, 16) / exact - 1.0));
  BOOST_TEST_MESSAGE("surfaces " << film.theta(60, 1, 16) << ", exact " << exact << ": " << error << " (allowed 1e-5)");
  BOOST_TEST(error <= 1e-5);
}

// A pressure that rises everywhere heats an adiabatic film: d theta/dT = e p_h (1 + theta)/(rho c T0), as in steady
// compression. in: theta stays small.
BOOST_AUTO_TEST_CASE(a_rising_pressure_heats_the_oil) {
  constexpr double Pe = 1e9, heat = 0.02, end = 0.5;  // conduction is negligible at the middle of the film
  const Patch patch(Grid{64, 2, 0.0, 4.0, 0.0, 1.0});
  Setup setup = cool(patch);
  setup.Br = 0.0;
  setup.Pe = Pe;
  setup.compression = heat * Pe;
  setup.density =
      ehl::rheology::make_thermal_density(ehl::rheology::Incompressible{}, 1.0, ehl::rheology::Expansion{1.0});
  FilmTemperature film(setup);
  const Field H = ones(patch);
  const auto P_at = [&](double T) { return filled(patch, [T](double, double) { return 1.0 + T; }); };
  film.take(P_at(0.0), H);
  settle(film, 1e-14);
  film.begin_in_time(end);
  constexpr int count = 50;
  for (int n = 1; n <= count; ++n) {
    film.begin_step({.length = end / count, .u_1 = 1.0, .u_2 = 1.0, .moved_1 = end / count, .moved_2 = end / count});
    film.take(P_at(n * end / count), H);
    film.sweep();
    film.accept_step();
  }
  const double exact = std::exp(heat * end) - 1.0, theta = film.theta(60, 1, 8), error = std::abs(theta / exact - 1.0);
  BOOST_TEST_MESSAGE("theta " << theta << ", exact " << exact << ": " << error << " (allowed 1e-3)");
  BOOST_TEST(error <= 1e-3);
}

BOOST_AUTO_TEST_CASE(a_surface_that_stands_still_is_refused_in_time) {
  const Patch patch(Grid{16, 2, 0.0, 4.0, 0.0, 1.0});
  FilmTemperature film(cool(patch));
  film.take(ones(patch), ones(patch));
  film.begin_in_time(1.0);
  BOOST_CHECK_THROW(film.begin_step({.length = 0.1, .u_1 = 2.0, .u_2 = 0.0}), ehl::core::InputError);
}

BOOST_AUTO_TEST_SUITE_END()
