// The error that earlier passes cause in the film of the last pass.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "steady/layer_error.hpp"
#include "steady/scene.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_layer_error)

using namespace ehl;
using steady::Pass;

namespace {

std::vector<Pass> passes_of(const std::vector<double>& supplies, double power) {
  std::vector<Pass> passes;
  for (const double supply : supplies)
    passes.push_back({.number = static_cast<int>(passes.size()) + 1,
                      .supply = supply,
                      .Hc = std::pow(supply, power),
                      .Hm = 0.5 * std::pow(supply, 2.0 * power)});
  return passes;
}

}  // namespace

// 2 % between the two meshes give 3 % for two levels and first order; later passes inherit the error of a pass.
BOOST_AUTO_TEST_CASE(errors_add_up_from_pass_to_pass) {
  std::vector<Pass> passes = passes_of({1.0, 0.8, 0.5, 0.4}, 0.5);
  steady::judge_layers({}, {1.0, 0.81, 0.51, 0.4}, passes);
  BOOST_TEST(passes[0].supply_error == 0.0);
  BOOST_TEST(std::abs(passes[1].supply_error - 1.5 * 0.0125) < 1e-12);
  BOOST_TEST(std::abs(passes[2].supply_error - 1.5 * 0.02) < 1e-12);
  BOOST_TEST(passes[3].supply_error == passes[2].supply_error);
  const steady::SupplyErrors errors = steady::errors_of_supply({}, passes);
  BOOST_TEST(std::abs(errors.Hc - 0.5 * 0.03) < 1e-12);
  BOOST_TEST(std::abs(errors.Hm - 0.03) < 1e-12);
  steady::ErrorBars bars;
  bars.Hc.discretization = 0.004;
  bars.Hm.discretization = 0.02;
  steady::add_errors_of_supply({}, passes, bars);
  BOOST_TEST(std::abs(bars.Hc.discretization - 0.019) < 1e-12);
  BOOST_TEST(std::abs(bars.Hm.discretization - 0.05) < 1e-12);
}

// If the layers hardly change, no derivative can be formed; the film is then at most proportional to the layer.
BOOST_AUTO_TEST_CASE(film_in_proportion_where_layers_stay) {
  std::vector<Pass> passes = passes_of({1.0, 0.99, 0.98}, 0.5);
  steady::judge_layers({}, {1.0, 0.98, 0.97}, passes);
  BOOST_TEST(std::abs(steady::errors_of_supply({}, passes).Hc - passes.back().supply_error) < 1e-15);
}

BOOST_AUTO_TEST_CASE(not_known_where_the_coarse_mesh_does_not_follow) {
  std::vector<Pass> passes = passes_of({1.0, 0.8, 0.5}, 0.5);
  steady::judge_layers({}, {1.0, 0.81}, passes);
  BOOST_TEST(std::isfinite(passes[1].supply_error));
  BOOST_TEST(std::isnan(passes[2].supply_error));
  BOOST_TEST(std::isnan(steady::errors_of_supply({}, passes).Hc));
}

BOOST_AUTO_TEST_SUITE_END()
