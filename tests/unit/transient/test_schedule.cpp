// Schedules in time: values, exact integrals, and the times at which steps must end.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/random.hpp"
#include "transient/schedule.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_schedule)

using namespace ehl::transient;
using ehl::tests::Random;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
const std::vector<double> nowhere{};

/// Four points with a ramp up to 2, a jump down to 1 and a ramp to 3.
const Schedule ramps{.points = {{1, 0}, {3, 2}, {3, 1}, {5, 3}}};

/// Ramps and jumps between -1 and 2 in [-1, 9]; half of the schedules have a wave.
Schedule random_schedule(Random& random) {
  Schedule schedule;
  double T = random.between(-1.0, 1.0);
  for (int k = 0; k < 6 && T < 9.0; ++k) {
    schedule.points.push_back({T, random.between(-1.0, 2.0)});
    if (random.chance(0.4)) schedule.points.push_back({T, random.between(-1.0, 2.0)});
    T += random.between(0.1, 2.5);
  }
  if (random.chance(0.5))
    schedule.wave = {random.between(-1.5, 1.5), random.between(0.3, 4.0), random.between(-2.0, 6.0)};
  return schedule;
}

/// The pieces of [0, end] between the times at which a schedule is not smooth.
std::vector<double> knots_of(const Schedule& schedule, double end) {
  std::vector<double> knots{0.0, end};
  for (const Schedule::Point& point : schedule.points) knots.push_back(std::clamp(point.T, 0.0, end));
  if (schedule.wave) knots.push_back(std::clamp(schedule.wave->start, 0.0, end));
  std::ranges::sort(knots);
  return knots;
}

/// Midpoint rule, which never uses the value at a jump; second order in the cell size.
double quadrature(const Schedule& schedule, double end) {
  constexpr int cells = 2000;
  double sum = 0.0;
  const std::vector<double> knots = knots_of(schedule, end);
  for (std::size_t k = 1; k < knots.size(); ++k) {
    const double h = (knots[k] - knots[k - 1]) / cells;
    for (int n = 0; n < cells; ++n) sum += h * value(schedule, knots[k - 1] + (n + 0.5) * h);
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(values_at_between_before_and_behind_points) {
  BOOST_TEST(value({}, -3.0) == 1.0);
  BOOST_TEST(value({}, 7.0) == 1.0);
  const struct {
    double T, value;
  } expected[] = {{-1, 0}, {0, 0}, {1, 0}, {2, 1}, {2.5, 1.5}, {3, 2}, {3.5, 1.5}, {4, 2}, {5, 3}, {6, 3}};
  for (const auto& at : expected) {
    BOOST_TEST_MESSAGE("value " << value(ramps, at.T) << " at " << at.T << " (exact " << at.value << ")");
    BOOST_TEST(value(ramps, at.T) == at.value);
  }
  // At a jump, the value is that before the jump; immediately after it, the new one.
  BOOST_TEST(std::abs(value(ramps, std::nextafter(3.0, 4.0)) - 1.0) < 1e-14);
  const Schedule at_start{.points = {{0, 1.3}, {0, 1}}};
  BOOST_TEST(value(at_start, 0.0) == 1.3);
  BOOST_TEST(value(at_start, 1e-300) == 1.0);
  const Schedule single{.points = {{2, 0.7}}};
  BOOST_TEST(value(single, 0.0) == 0.7);
  BOOST_TEST(value(single, 3.0) == 0.7);
}

BOOST_AUTO_TEST_CASE(a_wave_multiplies_from_its_start_on) {
  const Schedule sine{.wave = Schedule::Wave{0.3, 4.0, 1.0}};
  BOOST_TEST(value(sine, 0.5) == 1.0);
  BOOST_TEST(value(sine, 1.0) == 1.0);
  const struct { double T, value; } expected[] = {{2, 1.3}, {3, 1.0}, {4, 0.7}, {5, 1.0}, {1.0 + 1.0 / 3.0, 1.15}};
  for (const auto& at : expected) {
    const double error = std::abs(value(sine, at.T) - at.value);
    BOOST_TEST_MESSAGE("sine at " << at.T << ": error " << error << " (allowed 1e-15)");
    BOOST_TEST(error <= 1e-15);
  }
  Schedule both = ramps;
  both.wave = Schedule::Wave{-0.5, 8.0, 2.0};
  BOOST_TEST(std::abs(value(both, 4.0) - 2.0 * 0.5) < 1e-15);
  BOOST_TEST(value(both, 1.5) == 0.5);
}

BOOST_AUTO_TEST_CASE(integrals_in_closed_form) {
  Schedule from_start = ramps;
  from_start.wave = Schedule::Wave{0.5, 2.0, 0.0};
  // The integral of 2t (1 + sin(pi t)/2) from 0 to 1 is 1 + 1/pi; with the constant 2 afterwards it is 2 (T - 1) +
  // [cos(pi) - cos(pi T)]/pi.
  const Schedule ramped{.points = {{0, 0}, {1, 2}}, .wave = Schedule::Wave{0.5, 2.0, -4.0}};
  const struct {
    const char* what;
    double integral, exact;
  } expected[] = {{"one", integral({}, 3.5), 3.5},
                  {"nothing", integral(ramps, 0.0), 0.0},
                  {"before the first point", integral(ramps, 1.0), 0.0},
                  {"half a ramp", integral(ramps, 2.0), 0.5},
                  {"up to the jump", integral(ramps, 3.0), 2.0},
                  {"past the jump", integral(ramps, 4.0), 3.5},
                  {"behind the last point", integral(ramps, 7.0), 12.0},
                  {"a jump at the start", integral({.points = {{0, 1.3}, {0, 1}}}, 2.0), 2.0},
                  {"a wave that starts late", integral({.wave = Schedule::Wave{0.3, 4.0, 1.0}}, 3.0), 3.0 + 1.2 / pi},
                  {"a wave not begun", integral({.wave = Schedule::Wave{0.3, 4.0, 1.0}}, 1.0), 1.0},
                  {"a wave on a ramp", integral(ramped, 1.0), 1.0 + 1.0 / pi},
                  {"a wave on a constant", integral(ramped, 2.5), 4.0 + (1.0 - 1.0 - std::cos(2.5 * pi)) / pi}};
  for (const auto& at : expected) {
    const double error = std::abs(at.integral - at.exact);
    BOOST_TEST_MESSAGE(at.what << ": " << at.integral << ", error " << error << " (allowed 1e-14: rounding)");
    BOOST_TEST(error <= 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(integrals_of_random_schedules_against_a_quadrature) {
  Random random(51);
  double worst = 0.0;
  for (int k = 0; k < 40; ++k) {
    const Schedule schedule = random_schedule(random);
    const double end = random.between(0.0, 10.0);
    worst = std::max(worst, std::abs(integral(schedule, end) - quadrature(schedule, end)));
  }
  // Midpoint rule: the error is end w^2 h^2/24 times the magnitude of the value, for w = 2 pi/0.3
  // and pieces of h = 1/1000.
  BOOST_TEST_MESSAGE("largest difference " << worst << " (allowed 1e-5: the quadrature)");
  BOOST_TEST(worst <= 1e-5);
}

BOOST_AUTO_TEST_CASE(jumps_and_corners) {
  BOOST_TEST(jumps({}, 10.0) == nowhere);
  BOOST_TEST(corners({}, 10.0) == nowhere);
  BOOST_TEST(jumps(ramps, 10.0) == std::vector<double>{3});
  BOOST_TEST(corners(ramps, 10.0) == (std::vector<double>{1, 5}));
  BOOST_TEST(jumps(ramps, 3.0) == nowhere);  // a jump at the end has no effect
  BOOST_TEST(corners(ramps, 5.0) == std::vector<double>{1});
  const Schedule many{.points = {{-1, 0}, {-1, 5}, {0, 1.3}, {0, 1}, {2, 1}, {2, 1}, {4, 1}, {4, 2}, {4, 3}, {9, 3}},
                      .wave = Schedule::Wave{0.1, 1.0, 6.0}};
  BOOST_TEST(jumps(many, 8.0) == (std::vector<double>{0, 4}));
  BOOST_TEST(corners(many, 8.0) == (std::vector<double>{2, 6}));
  // A wave that begins at a jump adds no stop, because a step ends there anyway.
  const Schedule together{.points = {{1, 1}, {1, 2}}, .wave = Schedule::Wave{0.1, 1.0, 1.0}};
  BOOST_TEST(jumps(together, 8.0) == std::vector<double>{1});
  BOOST_TEST(corners(together, 8.0) == nowhere);
}

BOOST_AUTO_TEST_CASE(least_is_below_every_value_and_reached_without_a_wave) {
  BOOST_TEST(least({}, 5.0) == 1.0);
  BOOST_TEST(least(ramps, 10.0) == 0.0);
  BOOST_TEST(least({.points = {{0, 1.3}, {0, 1}}}, 5.0) == 1.0);
  BOOST_TEST(least({.points = {{0, 1.3}, {0, 1}, {1, 2}}}, 5.0) == 1.0);  // the value just after T = 0
  BOOST_TEST(least({.points = {{0, 3}, {4, 1}}}, 2.0) == 2.0);            // the ramp continues beyond the end
  BOOST_TEST(least({.points = {{0, 3}, {2, 3}, {2, 1}}}, 2.0) == 3.0);
  BOOST_TEST(std::abs(least({.wave = Schedule::Wave{0.3, 4.0, 1.0}}, 10.0) - 0.7) < 1e-15);
  BOOST_TEST(least({.wave = Schedule::Wave{0.3, 4.0, 1.0}}, 1.0) == 1.0);
  Random random(52);
  double below = infinity;
  double gap = 0.0;
  for (int k = 0; k < 200; ++k) {
    const Schedule schedule = random_schedule(random);
    const double end = random.between(0.1, 10.0);
    const double bound = least(schedule, end);
    double taken = value(schedule, 0.0);
    for (const double knot : knots_of(schedule, end)) {
      taken = std::min(taken, value(schedule, knot));
      if (knot < end) taken = std::min(taken, value(schedule, std::nextafter(knot, infinity)));
    }
    for (int n = 0; n <= 400; ++n) taken = std::min(taken, value(schedule, end * n / 400.0));
    below = std::min(below, taken - bound);
    if (!schedule.wave) gap = std::max(gap, taken - bound);
  }
  BOOST_TEST_MESSAGE("least value over the bound " << below << " (allowed -1e-12), without a wave at most " << gap
                                                   << " (allowed 1e-12: the value next to a jump)");
  BOOST_TEST(below >= -1e-12);
  BOOST_TEST(gap <= 1e-12);
}

// A ramp within a time in which the film does not change counts as a jump at its beginning, and its end is no corner.
BOOST_AUTO_TEST_CASE(the_steepest_slope) {
  const Schedule jagged{.points = {{1, 1}, {1.5, 2}, {2, 2}, {4, -2}}};
  BOOST_TEST(steepest({}, 10.0) == 0.0);
  BOOST_TEST(steepest(jagged, 10.0) == 2.0);
  BOOST_TEST(steepest(jagged, 1.0) == 0.0);  // before all jagged
  BOOST_TEST(std::isinf(steepest({.points = {{1, 1}, {1, 2}}}, 10.0)));
  BOOST_TEST(std::isinf(steepest({.points = {{1, 1}, {1.0005, 2}}}, 10.0)));  // equivalent to a jump
  const double two_pi = 2.0 * std::numbers::pi;
  BOOST_TEST(std::abs(steepest({.wave = Schedule::Wave{0.3, 2.0, 0.0}}, 10.0) - 0.15 * two_pi) < 1e-14);
}

BOOST_AUTO_TEST_CASE(steep_ramps_are_jumps) {
  const Schedule steep{.points = {{0, 1}, {1, 1}, {1.0005, 1.5}, {2, 1.5}, {2.5, 2}}};
  BOOST_TEST(jumps(steep, 10.0) == std::vector<double>{1});
  BOOST_TEST(corners(steep, 10.0) == (std::vector<double>{2, 2.5}));
  const Schedule slow{.points = {{0, 1}, {1, 1}, {1.0005, 1.01}, {2, 1.5}}};
  BOOST_TEST(jumps(slow, 10.0) == nowhere);
  BOOST_TEST(corners(slow, 10.0) == (std::vector<double>{1, 1.0005, 2}));
}

// A short ramp has its own stops and does not shorten the other steps.
BOOST_AUTO_TEST_CASE(short_ramps) {
  const Schedule ramp{.points = {{0, 1}, {1, 1}, {1.015625, 2}, {3, 2}, {5, 1}}};
  BOOST_TEST(quarters(ramp, 10.0) == (std::vector<double>{1.00390625, 1.0078125, 1.01171875}));
  BOOST_TEST(quarters(ramp, 1.01) == (std::vector<double>{1.00390625, 1.0078125}));
  BOOST_TEST(resolving_step(ramp) == 0.5);
  BOOST_TEST(quarters({.points = {{0, 1}, {0.015625, 1}, {0.5, 2}}}, 10.0) == nowhere);
}

BOOST_AUTO_TEST_CASE(resolving_steps) {
  BOOST_TEST(resolving_step({}) == infinity);
  BOOST_TEST(resolving_step({.points = {{0, 1}, {1, 1}, {1, 2}, {5, 2}}}) == infinity);
  BOOST_TEST(resolving_step(ramps) == 0.5);
  BOOST_TEST(resolving_step({.points = {{0, 1}, {4, 2}, {4.5, 2}, {5.5, 1}}}) == 0.25);
  BOOST_TEST(resolving_step({.wave = Schedule::Wave{0.3, 4.0, 1.0}}) == 0.2);
  BOOST_TEST(resolving_step({.points = {{0, 1}, {0.4, 2}}, .wave = Schedule::Wave{0.3, 4.0, 1.0}}) == 0.1);
}

// Rows of a table that sample a smooth course are no corners; a time given twice remains a jump.
BOOST_AUTO_TEST_CASE(a_sampled_course_has_jumps_only) {
  const Schedule sampled{.points = {{0, 1}, {1, 2}, {1.01, 1.5}, {2, 1}, {2, 3}, {4, 1}}, .sampled_over = 4.0};
  BOOST_TEST(corners(sampled, 4.0).empty());
  BOOST_TEST(quarters(sampled, 4.0).empty());
  BOOST_TEST(jumps(sampled, 4.0) == std::vector{2.0});
  BOOST_TEST(resolving_step(sampled) == 4.0 / 20.0);
}

BOOST_AUTO_TEST_SUITE_END()
