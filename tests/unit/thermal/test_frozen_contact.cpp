// A frozen contact, P = sqrt(1 - r^2) with a film of 370 nm, compared with an independent program: friction and
// temperatures, with and without convection; the full source in the bodies and the moving line source.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "unit/thermal/base_case.hpp"

BOOST_AUTO_TEST_SUITE(test_thermal_frozen_contact)

using namespace ehl::thermal;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using support::BaseCase, support::filled, support::hertz, support::settle;

namespace {

// P = sqrt(1 - r^2), h = 370 nm everywhere, no pressure flow.
struct Frozen {
  double mu = 0, mu_isothermal = 0, centre = 0, largest = 0, surface_1 = 0, surface_2 = 0, centre_1 = 0, centre_2 = 0;
  int sweeps = 0;
};
Frozen frozen(int cells_per_radius, bool convection, bool lines, int intervals = 16) {
  const BaseCase base;
  const int n = 3 * cells_per_radius;
  const Grid grid{n, n, -1.5, 1.5, -1.5, 1.5};
  const Patch patch = ehl::core::lower_half(grid);
  Setup setup = base.setup(patch);
  setup.intervals = intervals;
  setup.lines = lines;
  setup.pressure_flow = false;
  setup.compression = 0.0;
  if (!convection) setup.Pe = 0.0;
  const Field P = filled(patch, hertz), H = filled(patch, [&](double, double) { return base.H_of(370e-9); });
  Frozen found;
  {
    Setup cold = setup;
    cold.Br = cold.Pe = 0.0;
    cold.lines = true;
    FilmTemperature film(cold);
    film.take(P, H);
    film.sweep();
    found.mu_isothermal = film.balance().friction;
  }
  FilmTemperature film(setup);
  for (int pass = 0; pass < (convection ? 5 : 1); ++pass) {
    film.take(P, H);
    found.sweeps += settle(film, 1e-8);
  }
  const Balance sum = film.balance();
  BOOST_TEST(!sum.clipped);
  BOOST_TEST(std::abs(sum.defect) < 1e-8);
  found.mu = sum.friction;
  const int i = n / 2, j = n / 2;
  found.centre = base.T0 * film.theta(i, j, intervals / 2);
  found.largest = base.T0 * sum.film.theta;
  found.surface_1 = base.T0 * sum.surface_1.theta;
  found.surface_2 = base.T0 * sum.surface_2.theta;
  found.centre_1 = base.T0 * film.theta(i, j, intervals);
  found.centre_2 = base.T0 * film.theta(i, j, 0);
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(frozen_contact) {
  // Reference: an independent program with 64 cells per radius and 32 intervals across the film;
  // the last digit is uncertain.
  const Frozen found = frozen(64, false, true);
  struct Row {
    const char* name;
    double value, reference, tolerance;
  };
  for (const Row& row : {Row{"mu isothermal", found.mu_isothermal, 0.051058, 2e-3},
                         {"mu", found.mu, 0.03283, 2e-3},
                         {"middle of the film, centre", found.centre, 46.20, 5e-3},
                         {"largest", found.largest, 47.56, 5e-3},
                         {"surface 1, largest", found.surface_1, 19.00, 5e-3},
                         {"surface 2, largest", found.surface_2, 30.39, 5e-3},
                         {"surface 1, centre", found.centre_1, 15.58, 5e-3},
                         {"surface 2, centre", found.centre_2, 25.80, 5e-3}}) {
    BOOST_TEST_MESSAGE(row.name << ": " << row.value << ", reference " << row.reference << ", "
                                << row.value / row.reference - 1 << " off (tolerance " << row.tolerance << ")");
    BOOST_TEST(std::abs(row.value / row.reference - 1) < row.tolerance);
  }
  BOOST_TEST_MESSAGE(found.sweeps << " sweeps");
}

BOOST_AUTO_TEST_CASE(frozen_contact_with_convection) {
  const Frozen found = frozen(32, true, true);
  BOOST_TEST_MESSAGE("mu " << found.mu << " (0.03287, tolerance 2e-3), centre " << found.centre
                           << " K (46.13, tolerance 5e-3), " << found.sweeps << " sweeps");
  BOOST_TEST(std::abs(found.mu / 0.03287 - 1) < 2e-3);
  BOOST_TEST(std::abs(found.centre / 46.13 - 1) < 5e-3);
}

BOOST_AUTO_TEST_CASE(the_whole_source_is_cooler_than_lines) {
  // Surface Peclet numbers of 10 to 30: on a Hertzian circle the rise is 0.905 to 0.97 of the
  // line source (moving_source).
  const Frozen lines = frozen(32, false, true), whole = frozen(32, false, false);
  BOOST_TEST_MESSAGE("surfaces " << whole.surface_1 << ", " << whole.surface_2 << " K, by lines " << lines.surface_1
                                 << ", " << lines.surface_2 << "; mu " << whole.mu << " and " << lines.mu << "; "
                                 << whole.sweeps << " sweeps");
  for (const double ratio : {whole.surface_1 / lines.surface_1, whole.surface_2 / lines.surface_2}) {
    BOOST_TEST(ratio > 0.90);
    BOOST_TEST(ratio < 0.98);
  }
  BOOST_TEST(whole.sweeps < 15);
}

BOOST_AUTO_TEST_SUITE_END()
