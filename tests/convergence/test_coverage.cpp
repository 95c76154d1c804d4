// The error bars of a run compared with its true errors. These 30 runs were not used in the development of the
// estimates. The complete count is made by tests/bench/bench_coverage.cpp.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "support/coverage.hpp"

BOOST_AUTO_TEST_SUITE(test_coverage)

using namespace ehl;

namespace {

constexpr test::Point points[] = {{12, 6, 1.9e-8, 0.62, true},
                                  {36, 14, 1.9e-8, 0.62, true},
                                  {110, 8, 1.9e-8, 0.62, true},
                                  {280, 16, 1.9e-8, 0.62, true},
                                  {750, 7, 1.9e-8, 0.62, true}};
/// The finest grid that is judged has 256 cells. The uncertainty of the reference is a few per cent of the
/// second-order error on that grid.
constexpr int coarse_truth = 384;
constexpr int fine_truth = 512;
constexpr double least_share = 0.9;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

void nine_of_ten_are_within(std::initializer_list<reynolds::Wedge> wedges, bool far_field, double largest_median) {
  std::map<std::string, std::vector<double>> ratios;
  std::map<std::string, int> within;
  for (const test::Point& point : points) {
    const test::Film truth = test::truth_of(point, coarse_truth, fine_truth, far_field);
    for (const reynolds::Wedge wedge : wedges)
      for (const int n : {128, 256}) {
        const steady::Solution solution = steady::solve(test::scene_of(point, wedge, n, far_field));
        BOOST_TEST_REQUIRE(solution.converged);
        for (const test::Judged& one : test::judged(solution, truth)) {
          if (one.name.ends_with("extrapolated")) continue;
          const std::string name(one.name);
          ratios[name].push_back(one.ratio());
          within[name] += one.within();
          if (!one.within())
            BOOST_TEST_MESSAGE("miss: " << test::name_of(point, wedge, n) << " " << name << ": estimate "
                                        << one.estimate << ", true error " << one.error);
        }
      }
  }
  for (const auto& [name, all] : ratios) {
    const double share = within[name] / static_cast<double>(all.size());
    BOOST_TEST_MESSAGE(name << ": " << within[name] << " of " << all.size() << " within (at least 90 %), estimate over "
                            << "error " << median(all) << " in the median (below " << largest_median << ")");
    BOOST_TEST(all.size() == 10u * wedges.size());
    BOOST_TEST(share >= least_share);
    BOOST_TEST(median(all) < largest_median);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(from_the_levels) {
  nine_of_ten_are_within({reynolds::Wedge::upstream1, reynolds::Wedge::upstream2}, false, 3.0);
}

BOOST_AUTO_TEST_CASE(by_weights) { nine_of_ten_are_within({reynolds::Wedge::upstream3}, true, 4.0); }

BOOST_AUTO_TEST_SUITE_END()
