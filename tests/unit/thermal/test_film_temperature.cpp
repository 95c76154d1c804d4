// The energy equation of the film with two moving bodies, for a given pressure and film: heat shared by two bodies,
// plug flow in a slot, compression, the heat balance, mirrored bodies, threads.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "core/errors.hpp"
#include "unit/thermal/base_case.hpp"

BOOST_AUTO_TEST_SUITE(test_thermal_film_temperature)

using namespace ehl::thermal;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using support::BaseCase, support::filled, support::hertz, support::settle;

namespace {

// A film with walls at one temperature and constant viscosity, that is a slot.
Setup slot(const Patch& patch) {
  const ehl::rheology::ViscosityLaw viscosity = ehl::rheology::Barus{0.0};
  return {
      .patch = patch,
      .stress_of_P = 1.0,
      .viscosity = viscosity,
      .thermal_viscosity = ehl::rheology::make_thermal_viscosity(viscosity, {1.0, ehl::rheology::Exponential{1e-12}}),
      .density =
          ehl::rheology::make_thermal_density(ehl::rheology::Incompressible{}, 1.0, ehl::rheology::Expansion{0.0}),
      .pressure_flow = false,
      .theta_least = -1e3,
      .theta_most = 1e9};
}
Field ones(const Patch& patch) {
  return filled(patch, [](double, double) { return 1.0; });
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_bodies_share_the_heat) {
  // For a heat source Q = 1 from X = 0: q1 = E/2 + (1 - E) s1/(s1 + s2), E = erfcx[sqrt(pi) (b1 + b2) sqrt X], s = 1/b,
  // where b is the temperature rise of a surface in q sqrt(X)/sqrt(pi).
  constexpr double u_1 = 1.5, u_2 = 0.5, stress = 2.0;  // stress: Pe = u 20
  double before = 0.0;
  for (const int cells : {40, 80, 160}) {
    const Grid grid{cells, 2, 0.0, 1.0, 0.0, 1.0};
    Setup setup = slot(grid);
    setup.srr = u_1 - u_2;
    setup.Br = 1.0;
    setup.body_1 = {.Pe = 20 * u_1, .resistance = stress};
    setup.body_2 = {.Pe = 20 * u_2, .resistance = stress};
    setup.lines = true;
    FilmTemperature film(setup);
    film.take(ones(grid), ones(grid));
    settle(film, 1e-12);
    double worst = 0.0;
    const double b_1 = stress / std::sqrt(std::numbers::pi * setup.body_1.Pe),
                 b_2 = stress / std::sqrt(std::numbers::pi * setup.body_2.Pe);
    for (int i = cells / 4; i <= cells; ++i) {
      const double c = std::sqrt(std::numbers::pi) * (b_1 + b_2) * std::sqrt(grid.X(i));
      const double E = std::exp(c * c) * std::erfc(c);
      const double share = E / 2 + (1 - E) * (1 / b_1) / (1 / b_1 + 1 / b_2);
      worst = std::max(worst, std::abs(film.q_1()(i, 1) / share - 1));
      BOOST_TEST(std::abs(film.q_1()(i, 1) + film.q_2()(i, 1) - 1) < 1e-10);
    }
    BOOST_TEST_MESSAGE(cells << " cells: share of surface 1 " << worst << " off (tolerance 1e-3 at 160), factor "
                             << before / worst);
    before = worst;
  }
  BOOST_TEST(before < 1e-3);
}

BOOST_AUTO_TEST_CASE(plug_flow_in_a_slot) {
  // Oil with theta = 1 enters: mean = sum 8/((2k+1)^2 pi^2) exp[-(2k+1)^2 pi^2 x], x = X/Pe.
  constexpr double exact[] = {0.7743241666, 0.4959121798, 0.3021180938, 0.1125971252}, at[] = {0.01, 0.05, 0.1, 0.2};
  double error[4][2] = {}, extrapolated = 0.0;
  for (const int level : {0, 1}) {
    const int cells = 400 << level;
    const Grid grid{cells, 2, 0.0, 0.2, 0.0, 1.0};
    Setup setup = slot(grid);
    setup.theta_oil = 1.0;
    setup.Pe = 1.0;
    setup.intervals = 64;
    FilmTemperature film(setup);
    film.take(ones(grid), ones(grid));
    settle(film, 1e-10);
    for (int n = 0; n < 4; ++n) {
      const int i = static_cast<int>(std::lround(at[n] / grid.hx()));
      double mean = 0.0;
      for (int k = 1; k < 64; ++k) mean += film.theta(i, 1, k) / 64;
      error[n][level] = mean / exact[n] - 1;
    }
  }
  for (int n = 0; n < 4; ++n) {
    BOOST_TEST_MESSAGE("x = " << at[n] << ": mean " << error[n][0] << ", " << error[n][1] << " off, extrapolated "
                              << 2 * error[n][1] - error[n][0] << " (tolerance 1e-3)");
    BOOST_TEST(std::abs(error[n][0] / error[n][1] - 2) < 0.25);  // first order along the flow
    extrapolated = std::max(extrapolated, std::abs(2 * error[n][1] - error[n][0]));
  }
  BOOST_TEST(extrapolated < 1e-3);
}

BOOST_AUTO_TEST_CASE(streaks_in_a_slot) {
  // Streaks that fill a share of the width each act as a slot: the same temperatures, and that share of the heat.
  constexpr double share = 0.3;
  const Grid grid{100, 2, 0.0, 0.2, 0.0, 1.0};
  Setup setup = slot(grid);
  setup.theta_oil = 1.0;
  setup.Pe = 1.0;
  FilmTemperature full(setup), streaks(setup);
  const Field nowhere = filled(grid, [](double, double) { return 0.0; });
  const Field theta = filled(grid, [](double, double) { return share; });
  full.take(nowhere, ones(grid));
  streaks.take(nowhere, ones(grid), &theta);
  settle(full, 1e-12);
  settle(streaks, 1e-12);
  double temperature = 0.0, heat = 0.0, speed = 0.0;
  for (int i = 1; i <= grid.nx; ++i) {
    for (int k = 0; k <= setup.intervals; ++k) {
      temperature = std::max(temperature, std::abs(streaks.theta(i, 1, k) - full.theta(i, 1, k)));
      speed = std::max(speed, std::abs(streaks.velocity(i, 1, k) - 1.0));
    }
    heat = std::max(heat, std::abs(streaks.q_1()(i, 1) - share * full.q_1()(i, 1)));
  }
  const double carried = streaks.balance().carried / full.balance().carried;
  BOOST_TEST_MESSAGE("temperature " << temperature << ", heat " << heat << ", speed " << speed
                                    << " off (tolerance 1e-10), heat carried " << carried
                                    << " of that of the full slot");
  BOOST_TEST(std::max(temperature, heat) < 1e-10);
  BOOST_TEST(speed < 1e-12);
  BOOST_TEST(std::abs(carried / share - 1.0) < 1e-10);
}

BOOST_AUTO_TEST_CASE(compression_heats) {
  // No conduction: T = T0 exp[e p/(rho c)], 313.15 K, 6.5e-4 1/K, 1.72e6 J/(m^3 K), 0.9349 GPa: +132.702 K.
  constexpr double T0 = 313.15, e = 6.5e-4, rho_c = 1.72e6, p = 0.9349e9, conduction = 1e-7;
  double rise[2] = {};
  for (const int level : {0, 1}) {
    const int cells = 100 << level;
    const Grid grid{cells, 2, 0.0, 1.0, 0.0, 1.0};
    Setup setup = slot(grid);
    setup.density =
        ehl::rheology::make_thermal_density(ehl::rheology::Incompressible{}, T0, ehl::rheology::Expansion{e});
    setup.Pe = rho_c / conduction;
    setup.compression = p / T0 / conduction;
    FilmTemperature film(setup);
    // A pressure whose central differences add up to its final value: second order.
    film.take(filled(grid, [](double x, double) { return x * x * (3 - 2 * x); }), ones(grid));
    settle(film, 1e-10);
    rise[level] = T0 * film.theta(cells, 1, 8);
  }
  const double extrapolated = 2 * rise[1] - rise[0];
  BOOST_TEST_MESSAGE("rise " << rise[0] << ", " << rise[1] << ", extrapolated " << extrapolated
                             << " K (132.702, tolerance 0.2)");
  BOOST_TEST(std::abs(extrapolated - 132.702) < 0.2);
}

namespace {

// A film like that of a contact: flat inside, with a wide inlet, and with pressure flow.
struct Contact {
  Field P, H;
};
Contact contact(const Patch& patch, const BaseCase& base) {
  return {filled(patch,
                 [](double x, double y) {
                   const double r = std::hypot(x, y);
                   return hertz(x, y) + 0.02 * std::exp(-4 * std::max(0.0, r - 1)) * (x < 0.9 ? 1.0 : 0.0);
                 }),
          filled(patch, [&](double x, double y) {
            const double r2 = x * x + y * y, r = std::sqrt(r2);
            return base.H_of(370e-9) +
                   (r > 1 ? (r * std::sqrt(r2 - 1) - (2 - r2) * std::acos(1 / r)) / std::numbers::pi : 0.0);
          })};
}

}  // namespace

BOOST_AUTO_TEST_CASE(heat_balances) {
  BaseCase base;
  base.srr = 0.5;
  const Grid grid{48, 32, -2.5, 1.5, -2.0, 2.0};
  const Patch half = ehl::core::lower_half(grid);
  const Contact full_contact = contact(grid, base), half_contact = contact(half, base);
  FilmTemperature film(base.setup(grid)), of_half(base.setup(half));
  int sweeps = 0;
  for (int pass = 0; pass < 8; ++pass) {
    film.take(full_contact.P, full_contact.H);
    of_half.take(half_contact.P, half_contact.H);
    sweeps += settle(film, 1e-9);
    settle(of_half, 1e-9);
  }
  const Balance sum = film.balance(), sum_half = of_half.balance();
  BOOST_TEST_MESSAGE("defect " << sum.defect << " of the heat (tolerance 1e-8: the columns' last step), " << sweeps
                               << " sweeps; film " << base.T0 * sum.film.theta << " K, surfaces "
                               << base.T0 * sum.surface_1.theta << ", " << base.T0 * sum.surface_2.theta << "; carried "
                               << sum.carried / sum.heat << " of the heat");
  BOOST_TEST(std::abs(sum.defect) < 1e-8);
  BOOST_TEST((sum.heat > 0.0 && !sum.clipped));
  // The half domain gives the same result.
  BOOST_TEST(std::abs(sum_half.friction / sum.friction - 1) < 1e-8);
  double gap = 0.0;
  for (int i = 0; i <= half.nx; ++i)
    for (int j = 0; j <= half.ny; ++j)
      for (int k = 0; k <= 16; ++k) gap = std::max(gap, std::abs(film.theta(i, j, k) - of_half.theta(i, j, k)));
  BOOST_TEST(gap < 1e-8);
}

BOOST_AUTO_TEST_CASE(mirrored_bodies_and_threads) {
  BaseCase base, mirrored;
  base.srr = 0.8;
  base.body_1 = {1.1, 850, 2510};
  mirrored.srr = -0.8;
  mirrored.body_2 = base.body_1;
  const Grid grid{40, 24, -2.5, 1.5, -1.5, 1.5};
  const Contact c = contact(grid, base);
  Setup setup = base.setup(grid), many = setup;
  many.threads = 3;
  FilmTemperature film(setup), threaded(many), other(mirrored.setup(grid));
  for (int pass = 0; pass < 3; ++pass)
    for (FilmTemperature* f : {&film, &threaded, &other}) {
      f->take(c.P, c.H);
      for (int sweep = 0; sweep < 5; ++sweep) f->sweep();
    }
  double gap = 0.0;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) {
      for (int k = 0; k <= 16; ++k) {
        BOOST_REQUIRE(film.theta(i, j, k) == threaded.theta(i, j, k));
        gap = std::max(gap, std::abs(film.theta(i, j, k) - other.theta(i, j, 16 - k)));
      }
      BOOST_REQUIRE(film.M2()(i, j) == threaded.M2()(i, j));
    }
  BOOST_TEST_MESSAGE("mirrored: theta " << gap << " off (tolerance 1e-10)");
  BOOST_TEST(std::max(gap, std::abs(other.balance().friction + film.balance().friction)) < 1e-10);
}

BOOST_AUTO_TEST_CASE(no_heat_no_change) {
  BaseCase base;
  base.srr = 0.0;
  const Grid grid{32, 24, -2.5, 1.5, -1.5, 1.5};
  const Contact c = contact(grid, base);
  for (const double theta : {0.0, 0.1}) {
    base.expansion = theta == 0.0 ? 0.0 : 6.5e-4;
    Setup setup = base.setup(grid);
    setup.Br = setup.compression = 0.0;
    setup.theta_oil = setup.body_1.theta = setup.body_2.theta = theta;
    FilmTemperature film(setup);
    film.take(c.P, c.H);
    BOOST_TEST(film.flows_back());  // oil enters from all sides with the temperature of the film
    BOOST_TEST(film.sweep() < 1e-15);
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) {
        BOOST_REQUIRE(std::abs(film.theta(i, j, 8) - theta) < 1e-15);
        if (theta > 0.0) continue;
        BOOST_REQUIRE(std::max(std::abs(film.I0()(i, j) - 1), std::abs(film.C()(i, j) - 1)) < 1e-15);
        BOOST_REQUIRE(std::abs(film.M2()(i, j) - 1) < 1e-14);
      }
  }
  // A warm film has a larger mobility and a lower density.
  Setup setup = base.setup(grid);
  setup.theta_oil = setup.body_1.theta = setup.body_2.theta = 0.1;
  FilmTemperature film(setup);
  film.take(c.P, c.H);
  film.sweep();
  const double light = std::exp(-6.5e-4 * 0.1 * base.T0);
  for (const double lighter : {film.C()(4, 12), film.M2()(20, 12) / film.I0()(20, 12)})
    BOOST_TEST(std::abs(lighter / light - 1) < 1e-2);
}

BOOST_AUTO_TEST_CASE(a_surface_that_moves_against_the_entrainment_is_refused) {
  BaseCase base;
  base.srr = 2.5;
  const Grid grid{8, 8, -1.5, 1.5, -1.5, 1.5};
  BOOST_CHECK_THROW(FilmTemperature film(base.setup(grid)), ehl::core::InputError);
}

BOOST_AUTO_TEST_CASE(a_limiting_stress_acts_on_the_flow) {
  // Eyring's stress is asinh(k)/k of the Newtonian, at most limit P, in the flow at least 1/k_m: viscosity limit/rate.
  const Grid grid{8, 8, 0.0, 1.0, 0.0, 1.0};
  constexpr double sliding = 0.5, k_m = 20.0;
  for (const double limit : {0.01, 1.0}) {
    Setup setup = cold_setup(ehl::rheology::Barus{0.0}, ehl::rheology::Incompressible{});
    setup.patch = grid;
    setup.srr = sliding;
    setup.stress_of_P = 1.0;
    setup.limit = limit;
    setup.thinning = ehl::rheology::ShearThinning{ehl::rheology::Eyring{}, k_m * sliding};
    setup.flow_thinning = ehl::rheology::FlowThinning{ehl::rheology::Eyring{}, k_m, sliding};
    FilmTemperature film(setup);
    film.take(ones(grid), ones(grid));
    film.sweep();
    const double law = std::asinh(k_m * sliding) / k_m, over = std::max(1.0, law / std::max(limit, 1.0 / k_m));
    for (const Field* more : {&film.more_x(), &film.more_y()}) BOOST_TEST(std::abs((*more)(4, 4) / over - 1) < 1e-6);
    BOOST_TEST(std::abs(film.tau_m()(4, 4) / std::min(law, limit) - 1) < 1e-6);
  }
}

BOOST_AUTO_TEST_SUITE_END()
