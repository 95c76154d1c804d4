// A study of a run in time without running: its errors, its rows, and incomplete runs.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/errors.hpp"
#include "support/text.hpp"
#include "tables/csv.hpp"
#include "tables/time_study_report.hpp"

using namespace ehl;

namespace {

using support::contains;

/// Hc = 2 + T, Hm = 1, P_max = 4 - T, P at a probe = T (1 - T), at T = 0, 0.25, ... 1; all multiplied by a factor.
program::StudyPoint made(double factor, double rtol = 1e-4) {
  program::StudyPoint point;
  point.variant = {.rtol = rtol, .longest_step = 0.1};
  point.status = "complete";
  point.T = 1.0;
  point.steps = 10;
  point.cycles = 15;
  point.rejected = 2;
  point.not_solved = 1;
  point.jumps = 3;
  point.seconds = 0.5;
  point.seconds_most = 0.75;
  point.peak_memory = 1e6;
  for (const double T : {0.0, 0.25, 0.5, 0.75, 1.0})
    point.samples.push_back({T, {factor * (2.0 + T), factor, factor * (4.0 - T), factor * T * (1.0 - T)}});
  return point;
}

program::TimeReference reference() {
  program::TimeReference all{made(1.0, 1e-7), made(1.0 + 1e-5, 3e-7), {}, {{0.5, 0.25}}};
  all.errors = program::errors_in_time(all.run, all.coarser);
  return all;
}

program::StudyPoint from_text(const std::string& text) {
  program::StudyPoint point;
  point.variant.rtol = 1e-4;
  program::read_text(text, point);
  return point;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_time_study)

BOOST_AUTO_TEST_CASE(errors_are_the_largest_over_the_run) {
  program::StudyPoint point = made(1.0);
  point.samples[1].values = {2.25 * 1.01, 1.0, 3.75, 0.1875 + 0.01};
  point.samples[4].values = {3.0 * 0.98, 1.0 + 1e-6, 3.0 * 1.005, 0.001};
  const std::vector<double> errors = program::errors_in_time(made(1.0), point);
  // The error at the probe is relative to its largest pressure, 1/4; at T = 1 the pressure is 0.
  const double expected[] = {0.02, 1e-6, 0.005, 0.01 / 0.25};
  BOOST_REQUIRE(errors.size() == 4u);
  for (std::size_t k = 0; k < 4; ++k) BOOST_TEST(std::abs(errors[k] / expected[k] - 1.0) < 1e-9);
  for (const double error : program::errors_in_time(made(1.0), made(1.0))) BOOST_TEST(error == 0.0);
  // A run that stopped early is compared up to its end.
  point.samples.resize(3);
  BOOST_TEST(std::abs(program::errors_in_time(made(1.0), point)[0] / 0.01 - 1.0) < 1e-9);
}

BOOST_AUTO_TEST_CASE(no_error_without_a_complete_run) {
  for (const char* status : {"not-complete", "failed"}) {
    program::StudyPoint point = made(1.001);
    point.status = status;
    point.reason = "no, more than 7 steps";
    for (const double error : program::errors_in_time(made(1.0), point)) BOOST_TEST(std::isnan(error));
    for (const double error : program::errors_in_time(point, made(1.0))) BOOST_TEST(std::isnan(error));
    std::vector<program::StudyPoint> points{point};
    program::judge(reference(), points);
    point = points[0];
    const std::string row = program::csv_text(program::time_study_columns({"Hc", "Hm", "P_max", "P_1"}), point);
    BOOST_TEST(contains(row, std::string(status) + ",NaN,NaN,NaN,NaN,\"no, more than 7 steps\""), row);
    const std::string text = program::time_study_report({}, reference(), {point});
    BOOST_TEST(contains(text, "no, more than 7 steps"), text);
  }
  program::StudyPoint nothing;
  BOOST_TEST(program::errors_in_time(nothing, made(1.0)).empty());
  // If the reference has no pressure at the probe, the error there is unknown; if both have none, it is zero.
  program::StudyPoint dry = made(1.0);
  for (program::TimeSample& sample : dry.samples) sample.values[3] = 0.0;
  BOOST_TEST(std::isnan(program::errors_in_time(dry, made(1.0))[3]));
  BOOST_TEST(program::errors_in_time(dry, dry)[3] == 0.0);
}

BOOST_AUTO_TEST_CASE(a_point_comes_back_from_its_text) {
  program::StudyPoint point = made(1.0 / 3.0);
  point.reason = "a, b";
  const program::StudyPoint back = from_text(program::text_of(point));
  BOOST_TEST(
      (back.variant.rtol == 1e-4 && back.variant.longest_step == 0.1 && back.T == 1.0 && back.status == "complete"));
  BOOST_TEST((back.steps == 10 && back.cycles == 15 && back.rejected == 2 && back.not_solved == 1 && back.jumps == 3));
  BOOST_TEST((back.seconds == 0.5 && back.seconds_most == 0.75 && back.peak_memory == 1e6 && back.reason == "a, b"));
  BOOST_REQUIRE(back.samples.size() == 5u);
  for (std::size_t k = 0; k < 5; ++k) BOOST_TEST((back.samples[k].values == point.samples[k].values));
  program::StudyPoint nothing;
  nothing.variant.rtol = 1e-4;
  const program::StudyPoint empty = from_text(program::text_of(nothing));
  BOOST_TEST((std::isnan(empty.seconds) && empty.samples.empty()));
  BOOST_CHECK_THROW(from_text("1,2,3"), core::FileError);
  BOOST_CHECK_THROW(from_text(program::text_of(point) + "\n1,x"), core::FileError);
}

BOOST_AUTO_TEST_CASE(the_table_says_what_it_is) {
  std::vector<program::StudyPoint> points{made(1.0 + 1e-3, 1e-2), made(1.0 + 1e-6, 1e-6)};
  program::judge(reference(), points);
  const std::string csv = program::time_study_csv({}, reference(), points);
  BOOST_TEST(csv.starts_with(program::time_study_mark));
  for (const char* part : {"\n# reference error P_1: ", "\n# probe 1: P at (0.5, 0.25)\n",
                           ",status,deviation_Hc,deviation_Hm,deviation_P_max,deviation_P_1,reason\n",
                           "\n0.01,0.1,1,10,15,1.5,2,1,3,0.5,"})
    BOOST_TEST(contains(csv, part), part << " is missing in\n" << csv);
  // Errors below that of the reference, 1e-5, are not printed.
  const std::string text = program::time_study_report({}, reference(), points);
  BOOST_TEST(contains(text, " 1.0e-03 "), text);
  BOOST_TEST(contains(text, " < 1.0e-05 "), text);
}

BOOST_AUTO_TEST_SUITE_END()
