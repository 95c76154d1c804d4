// A study without solving: its reference, its Pareto front, its rows and its lists.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/errors.hpp"
#include "support/text.hpp"
#include "tables/csv.hpp"
#include "tables/study_report.hpp"

using namespace ehl;
using Texts = std::vector<std::string>;

namespace {

using support::contains;
using support::refusal;

program::StudyPoint point(int cells, double seconds, double Hc, const std::string& status = "converged") {
  program::StudyPoint made;
  made.variant = {.cells = cells, .wedge = "upstream2", .evaluator = "mlmi8", .cycles = "2W"};
  made.nx = made.ny = cells;
  made.status = status;
  made.seconds = seconds;
  made.Hc = made.Hm = Hc;
  made.residual = 1e-11;
  return made;
}

program::StudyPoint from_text(const std::string& text) {
  program::StudyPoint point;
  program::read_text(text, point);
  return point;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_study)

// Fully converged second-order films of an independent program, and the limits at which both schemes agree.
BOOST_AUTO_TEST_CASE(the_extrapolated_film_is_the_limit) {
  struct Case {
    const char* name;
    std::vector<double> values;  // on 64 to 1024 or 512 cells
    double limit;
    double known_to;
  };
  for (const Case& one :
       std::vector<Case>{{"(50,10) Hc", {0.2048788, 0.2165305, 0.2195099, 0.2202619, 0.2204508}, 0.22051, 1e-5},
                         {"(50,10) Hm", {0.1250491, 0.1310840, 0.1328261, 0.1331309, 0.1332160}, 0.13324, 6e-5},
                         {"(20,10) Hc", {0.4195678, 0.4292066, 0.4316474, 0.4322618}, 0.43247, 1e-5},
                         {"(20,10) Hm", {0.2866922, 0.2912435, 0.2924931, 0.2926796}, 0.29275, 1e-5},
                         {"(1000,10) Hc", {0.0099379, 0.0205906, 0.0235827, 0.0243671}, 0.02463, 1e-5},
                         {"(1000,10) Hm", {0.0004252, 0.0057630, 0.0079207, 0.0083204}, 0.00849, 1e-5}})
    for (std::size_t n = 3; n <= one.values.size(); ++n) {
      const program::Extrapolated found =
          program::extrapolated(std::span(one.values).first(n),
                                contains(one.name, "Hc") ? program::smooth_share : program::node_minimum_share);
      const double off = std::abs(found.value - one.limit);
      const double allowed = found.error * found.value + one.known_to;
      BOOST_TEST_MESSAGE(one.name << ", " << n << " grids: " << found.value << " off by " << off << ", allowed "
                                  << allowed);
      BOOST_TEST(off <= allowed, one.name << " of " << n << " grids");
      // The error bar must be narrower than the correction; a bar of any width would be right.
      BOOST_TEST(found.error * found.value < std::abs(one.values[n - 1] - one.values[n - 2]), one.name);
    }
  BOOST_TEST(std::isnan(program::extrapolated({}, 0.05).value));
}

// v = 1 + h^2 exactly: the limit is 1, and the error is its lower bound, a twentieth of the correction.
BOOST_AUTO_TEST_CASE(chance_is_no_accuracy) {
  const std::vector<double> values{1.0 + 1.0 / 4, 1.0 + 1.0 / 16, 1.0 + 1.0 / 64};
  const program::Extrapolated found = program::extrapolated(values, 0.05);
  BOOST_TEST(std::abs(found.value - 1.0) < 1e-15);
  BOOST_TEST(std::abs(found.error - 0.05 / 64) < 1e-15);
  const program::Extrapolated two = program::extrapolated(std::span(values).last(2), 0.05);
  BOOST_TEST(std::abs(two.error - 1.0 / 64) < 1e-15);
}

BOOST_AUTO_TEST_CASE(the_reference_needs_what_converged) {
  const std::vector<program::StudyPoint> good{point(64, 1, 1.25), point(128, 1, 1.0625), point(256, 1, 1.015625)};
  BOOST_TEST(program::reference_of(good).cells == (std::vector<int>{64, 128, 256}), boost::test_tools::per_element());
  std::vector<program::StudyPoint> coarse_bad = good;
  coarse_bad[0].status = "not-converged";
  BOOST_TEST(program::reference_of(coarse_bad).cells == (std::vector<int>{128, 256}), boost::test_tools::per_element());
  std::vector<program::StudyPoint> fine_bad = good;
  fine_bad[2].status = "failed";
  const program::Reference below = program::reference_of(fine_bad);
  BOOST_TEST(below.cells == (std::vector<int>{64, 128}), boost::test_tools::per_element());
  BOOST_TEST(std::abs(below.Hc.value - 1.0) < 1e-15);
  std::vector<program::StudyPoint> none = good;
  for (program::StudyPoint& one : none) one.status = "not-converged";
  BOOST_TEST(program::reference_of(none).cells.size() < 2u);
}

// The limit is 1 with an error of 1e-3. Columns: seconds, error, status, on the front or not.
BOOST_AUTO_TEST_CASE(pareto_front) {
  program::Reference reference;
  reference.Hc = reference.Hm = {1.0, 1e-3};
  struct Expected {
    double seconds;
    double error;
    const char* status;
    bool front;
  };
  const std::vector<Expected> all{
      {1.0, 0.10, "converged", true},       // the cheapest
      {2.0, 0.10, "converged", false},      // as accurate and more expensive
      {1.5, 0.05, "stopped", true},         // not converged, but with a film
      {1.4, 0.01, "not-converged", false},  // no film to judge
      {1.4, 0.01, "failed", false},         //
      {3.0, 0.06, "converged", false},      // less accurate than a cheaper point
      {4.0, 0.02, "converged", true},       //
      {4.0, 0.03, "converged", false},      // as expensive and less accurate
      {6.0, 5e-4, "converged", true},       // below the error of the reference
      {7.0, 1e-4, "converged", false},      // the reference cannot distinguish these two
  };
  std::vector<program::StudyPoint> points;
  for (const Expected& one : all) points.push_back(point(64, one.seconds, 1.0 + one.error, one.status));
  program::judge(reference, points);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const program::Judged Hc = points[k].of(program::of_Hc);
    BOOST_TEST(Hc.front == all[k].front, "point " << k << ", " << all[k].seconds << " s");
    BOOST_TEST(points[k].of(program::of_Hm).front == Hc.front);
    BOOST_TEST(std::abs(Hc.deviation - all[k].error) < 1e-15);
    BOOST_TEST(Hc.at_reference == (all[k].error < 1e-3));
  }
}

// A method whose error passes through zero on a coarse grid has not reached the accuracy.
BOOST_AUTO_TEST_CASE(an_accuracy_lasts) {
  program::Reference reference;
  reference.Hc = reference.Hm = {1.0, 1e-6};
  std::vector<program::StudyPoint> points{point(64, 1.0, 1.001), point(128, 2.0, 1.02), point(256, 4.0, 1.005),
                                          point(64, 1.5, 1.05), point(128, 3.0, 1.009)};
  points[3].variant.cycles = points[4].variant.cycles = "1V";
  program::judge(reference, points);
  BOOST_TEST(program::cheapest(points, program::of_Hc, 0.01) == 4u);
  BOOST_TEST(program::cheapest(points, program::of_Hc, 0.006) == 2u);
  BOOST_TEST(program::cheapest(points, program::of_Hc, 0.001) == points.size());
}

BOOST_AUTO_TEST_CASE(a_row_reads_back) {
  program::StudyPoint made = point(128, 0.1, 1.0 / 3.0, "stopped");
  made.Hm = 0.25;
  made.cycles_by_level = "6;2";
  made.attempts = 2;
  made.reason = "the residual, 1e-3, is above";
  const program::StudyPoint read = from_text(program::text_of(made));
  BOOST_TEST((read.variant.cells == 128 && read.variant.wedge == "upstream2" && read.variant.evaluator == "mlmi8"));
  BOOST_TEST((read.variant.cycles == "2W" && read.status == "stopped" && read.cycles_by_level == "6;2"));
  BOOST_TEST((read.Hc == 1.0 / 3.0 && read.Hm == 0.25 && read.seconds == 0.1 && std::isnan(read.estimate_Hc) &&
              read.attempts == 2));
  BOOST_TEST((read.judged.empty() && read.reason == made.reason && read.nx == 128));
  BOOST_TEST(program::text_of(read) == program::text_of(made));
  BOOST_TEST(refusal([] { from_text("64,upstream2"); }) != "(none)");
  std::string damaged = program::text_of(made);
  damaged.replace(0, 3, "x28");
  BOOST_TEST(refusal([&] { from_text(damaged); }) != "(none)");
}

// The judge marks every quantity of the table; a table without judgement has no numbers there.
BOOST_AUTO_TEST_CASE(the_judge_fills_columns) {
  program::Reference reference;
  reference.Hc = reference.Hm = {1.0, 1e-3};
  std::vector<program::StudyPoint> points{point(64, 1.0, 1.25)};
  const std::string before = program::csv_text(program::study_columns(), points[0]);
  program::judge(reference, points);
  const std::string after = program::csv_text(program::study_columns(), points[0]);
  BOOST_TEST(contains(before, ",NaN,NaN,NaN,NaN,"), before);
  BOOST_TEST(contains(before, ",0,0,0,0,"), before);
  BOOST_TEST(contains(after, ",0.25,0.25,NaN,NaN,"), after);
  BOOST_TEST(contains(after, ",0,0,1,1,"), after);
}

// Three runs of one method: the least and the greatest time; a run that failed counts only if all failed.
BOOST_AUTO_TEST_CASE(repetitions) {
  program::StudyPoint kept = point(64, 3.0, 1.0, "failed");
  for (const double seconds : {2.0, 1.0, 4.0}) {
    program::StudyPoint again = point(64, seconds, 1.0);
    again.seconds_most = seconds;
    program::add_repetition(again, kept);
    program::add_repetition(point(64, 0.1, 1.0, "failed"), kept);
  }
  BOOST_TEST((kept.status == "converged" && kept.seconds == 1.0 && kept.seconds_most == 4.0));
}

BOOST_AUTO_TEST_CASE(levels) {
  const auto any = [](int) { return true; };
  BOOST_TEST(program::levels_between("64:512") == (std::vector<int>{64, 128, 256, 512}),
             boost::test_tools::per_element());
  BOOST_TEST(program::levels_between("80") == (std::vector<int>{80}), boost::test_tools::per_element());
  BOOST_TEST(program::levels_of_deck(320, any) == (std::vector<int>{80, 160, 320}), boost::test_tools::per_element());
  BOOST_TEST(program::levels_of_deck(256, [](int cells) { return cells >= 128; }) == (std::vector<int>{128, 256}),
             boost::test_tools::per_element());
  for (const char* wrong : {"", "64:", ":64", "64:100", "128:64", "64:128:256", "a:b", "64.5:129", "-64:64", "1e9"})
    BOOST_TEST(contains(refusal([&] { program::levels_between(wrong); }), "--levels"), wrong);
}

BOOST_AUTO_TEST_CASE(variants) {
  for (const char* good : {"1V", "2W", "12F", "run"}) BOOST_TEST(program::is_study_cycles(good), good);
  for (const char* wrong : {"", "V", "0V", "1", "1X", "V1", "123V", "-1V", "Run"})
    BOOST_TEST(!program::is_study_cycles(wrong), wrong);
  program::StudyPlan plan{{64, 256}, {"upstream1", "upstream2"}, {"mlmi6", "direct"}, {"1V", "run"}};
  const auto cases = program::cases_of(plan, [](int cells) { return (cells + 1.0) * (cells + 1.0); });
  BOOST_TEST(cases.size() == 8u + 4u);  // no direct sum on 257 x 257 nodes
  steady::Scene scene;
  scene.solver.max_cycles = 60;
  program::use_way({.cells = 64, .wedge = "upstream1", .evaluator = "mlmi6", .cycles = "3V"}, scene);
  BOOST_TEST((scene.wedge == reynolds::Wedge::upstream1 && scene.deformation.order == 6));
  BOOST_TEST((scene.solver.cycle == multigrid::Cycle::V && scene.solver.cycles == 3 && scene.solver.max_cycles == 3 &&
              scene.solver.extra_cycles == 0));
  steady::Scene as_it_is;
  program::use_way({.cells = 64, .wedge = "upstream2", .evaluator = "fft", .cycles = "run"}, as_it_is);
  BOOST_TEST((as_it_is.solver.max_cycles == 60 && as_it_is.deformation.method == mlmi::Method::fft));
}

BOOST_AUTO_TEST_SUITE_END()
