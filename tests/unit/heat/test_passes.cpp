// A contact with heat, with pressure and temperature coupled, compared with an independent program:
// friction, film and temperatures of a ball on a disc, the film reduced by inlet heating; order of
// convergence; without heat nothing changes.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "unit/heat/heated_contact.hpp"

BOOST_AUTO_TEST_SUITE(test_heat_passes)

using namespace ehl;
using support::BaseCase, support::Found, support::solve, support::square;

namespace {

void lines(thermal::Setup& setup) { setup.lines = true; }
void nothing(thermal::Setup&) {}

}  // namespace

BOOST_AUTO_TEST_CASE(ball_on_disc_with_lines) {
  // An independent program with 16 intervals across the film on the same grids; Carslaw and Jaeger's moving
  // line source in the bodies.
  struct Row {
    double srr;
    int n;
    double mu, Hc, Hm, film, surface_1, surface_2;
  };
  constexpr Row rows[] = {{0.1, 64, .030812, .21307, .12948, NAN, NAN, NAN},
                          {0.1, 128, .030700, .22632, .13821, 4.98, 2.72, 2.83},
                          {1.0, 64, .032500, .19881, .12420, NAN, NAN, NAN},
                          {1.0, 128, .031937, .21209, .13236, 46.9, 20.7, 33.0}};
  for (const Row& row : rows) {
    BaseCase base;
    base.srr = row.srr;
    const Found found = solve(base, square(row.n), lines, 0.005);
    const auto check = [&](const char* name, double value, double reference, double tolerance) {
      BOOST_TEST_MESSAGE("srr = " << row.srr << ", " << row.n << " cells, " << name << ": " << value << ", reference "
                                  << reference << ", " << value / reference - 1 << " off (tolerance " << tolerance
                                  << ")");
      BOOST_TEST(std::abs(value / reference - 1) < tolerance);
    };
    BOOST_TEST_MESSAGE(found.result.passes.size() << " passes; " << found.result.unmet);
    BOOST_TEST(found.result.unmet.empty());
    check("mu", found.mu, row.mu, 5e-3);
    check("Hc", found.Hc, row.Hc, 2e-3);
    check("Hm", found.Hm, row.Hm, 2e-3);
    if (std::isnan(row.film)) continue;
    check("film", found.film, row.film, 2e-2);
    check("surface 1", found.surface_1, row.surface_1, 2e-2);
    check("surface 2", found.surface_2, row.surface_2, 2e-2);
  }
}

BOOST_AUTO_TEST_CASE(the_whole_source_cools_the_surfaces) {
  // A heat flux q0 sqrt(1 - r^2) on a circle, integrated in polar coordinates about the hottest point, gives 0.9674 of
  // the line source at Pe = 29.8 (3 m/s) and 0.9048 at 9.93 (1 m/s). The flux of the contact differs slightly; mu and
  // film depend weakly on it.
  const Found of_lines = solve(BaseCase{}, square(64), lines), whole = solve(BaseCase{}, square(64), nothing);
  const double ratio_1 = whole.surface_1 / of_lines.surface_1, ratio_2 = whole.surface_2 / of_lines.surface_2;
  BOOST_TEST_MESSAGE("surfaces " << whole.surface_1 << ", " << whole.surface_2 << " K, over those by lines " << ratio_1
                                 << " (0.9674 +- 0.01), " << ratio_2 << " (0.9048 +- 0.01); "
                                 << whole.result.passes.size() << " passes");
  BOOST_TEST(whole.result.unmet.empty());
  BOOST_TEST(std::abs(ratio_1 - 0.9674) < 0.01);
  BOOST_TEST(std::abs(ratio_2 - 0.9048) < 0.01);
  BOOST_TEST(std::abs(whole.mu / of_lines.mu - 1) < 0.01);
}

BOOST_AUTO_TEST_CASE(inlet_heating_of_pure_rolling) {
  // 10 m/s: an independent program finds that Hc falls from .66948 to .57628, +-1 %.
  BaseCase base;
  base.srr = 0.0;
  base.u_m = 10.0;
  const Found found =
      solve(base, {96, 96, -7.5, 1.5, -4.5, 4.5}, [](thermal::Setup& setup) { setup.thinning.reset(); });
  BOOST_TEST_MESSAGE("Hc " << found.Hc_cold << " -> " << found.Hc << ", ratio " << found.Hc / found.Hc_cold
                           << " (0.861 +- 0.015); " << found.result.passes.size() << " passes; " << found.result.unmet);
  BOOST_TEST(found.result.unmet.empty());
  BOOST_TEST(std::abs(found.Hc / found.Hc_cold - 0.861) < 0.015);
  BOOST_TEST(found.mu == 0.0);
}

BOOST_AUTO_TEST_CASE(second_order_with_heat) {
  Found found[3];
  for (const int level : {0, 1, 2}) found[level] = solve(BaseCase{}, square(64 << level), nothing, 0.005);
  const auto order = [&](double Found::*value) {
    return std::log2(std::abs((found[1].*value - found[0].*value) / (found[2].*value - found[1].*value)));
  };
  BOOST_TEST_MESSAGE("65^2, 129^2, 257^2: mu " << found[0].mu << ", " << found[1].mu << ", " << found[2].mu
                                               << ", order " << order(&Found::mu) << "; Hc order " << order(&Found::Hc)
                                               << "; film " << found[0].film << ", " << found[1].film << ", "
                                               << found[2].film << " K");
  BOOST_TEST(order(&Found::mu) > 1.4);
  BOOST_TEST(order(&Found::Hc) > 1.6);
  // The hottest point lies between nodes.
  BOOST_TEST(std::abs(found[2].film / found[1].film - 1) < 0.01);
}

BOOST_AUTO_TEST_CASE(no_heat_is_the_isothermal_contact) {
  BaseCase base;
  base.expansion = 0.0;
  for (const bool conducts_well : {false, true}) {
    const Found found = solve(base, square(64), [&](thermal::Setup& setup) {
      // Either there is no heat, or all of it is conducted away.
      if (conducts_well) {
        for (double* group : {&setup.Br, &setup.Pe, &setup.compression}) *group *= 1e-12;
        setup.body_1.resistance = setup.body_2.resistance = 0.0;
      } else {
        setup.Br = setup.compression = 0.0;
      }
    });
    BOOST_TEST(found.result.unmet.empty());
    const double off = std::max(std::abs(found.Hc / found.Hc_cold - 1), std::abs(found.Hm / found.Hm_cold - 1));
    BOOST_TEST_MESSAGE("film " << off << " off (tolerance 1e-6: what two more cycles change)");
    BOOST_TEST(off < 1e-6);
    BOOST_TEST(std::abs(found.C_centre - 1) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(fast_and_sliding) {
  // Cases that need damping of the iteration: each must converge, or say why not.
  for (const auto& [u_m, srr] : {std::pair{7.0, 1.5}, {7.0, 2.0}, {20.0, 0.5}, {20.0, 1.5}}) {
    BaseCase base;
    base.u_m = u_m;
    base.srr = srr;
    const Found found = solve(base, square(128), nothing, 0.2);
    int undone = 0;
    for (const heat::Pass& pass : found.result.passes) undone += pass.undone;
    BOOST_TEST_MESSAGE(u_m << " m/s, srr = " << srr << ": mu " << found.mu << ", Hc " << found.Hc << " of "
                           << found.Hc_cold << ", film " << found.film << " K; " << found.result.passes.size()
                           << " passes, " << undone << " undone; " << found.result.unmet);
    BOOST_TEST(found.result.unmet.empty());
    BOOST_TEST(found.Hm > 0.0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
