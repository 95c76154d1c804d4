// The sequence of model problems in the paper, on the solver's own grids: the convergence factors of
// V(2,1) and W(2,1) cycles.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <sstream>

#include "support/model_problem.hpp"

BOOST_AUTO_TEST_SUITE(test_model_problems)

using namespace ehl;
using namespace ehl::tests;
using multigrid::Cycle;
using reynolds::Wedge;

namespace {

constexpr Wedge wedges[] = {Wedge::upstream1, Wedge::upstream2};
const char* name(Wedge wedge) { return wedge == Wedge::upstream1 ? "upstream1" : "upstream2"; }

std::string listed(const std::vector<double>& factors) {
  std::ostringstream text;
  text.precision(2);
  for (const double factor : factors) text << " " << factor;
  return text.str();
}

double largest(const std::vector<double>& factors, std::size_t first) {
  return *std::max_element(factors.begin() + static_cast<std::ptrdiff_t>(first), factors.end());
}

}  // namespace

BOOST_AUTO_TEST_CASE(constant_epsilon_of_any_size) {
  // Eqs. (9), (10), from the pure integral equation to Poisson's, on 128^2 ... 8^2 cells. The paper reports "one order
  // of magnitude" per V(2,1) or W(2,1) cycle. V cycles accumulate the errors of six grids, W cycles do not; the limit
  // of 0.3 applies to W cycles.
  for (const double e :
       {0.0, 0.01, 0.03, 0.1, 0.3, 0.6, 1.0, 1.2, 1.4, 1.6, 2.2, 3.0, 5.0, 7.0, 10.0, 20.0, 100.0, 1e6})
    for (const Wedge wedge : wedges) {
      const double W = late_factor(error_factors(constant_epsilon(e, 128, wedge, Cycle::W), 10), 5);
      const double V = late_factor(error_factors(constant_epsilon(e, 128, wedge, Cycle::V), 10), 5);
      BOOST_TEST_MESSAGE("e " << e << " " << name(wedge) << ": W(2,1) " << W << " (at most 0.3), V(2,1) " << V
                              << " (at most 0.6)");
      BOOST_TEST(W < 0.3);
      BOOST_TEST(V < 0.6);
    }
}

BOOST_AUTO_TEST_CASE(constant_epsilon_does_not_depend_on_the_number_of_grids) {
  for (const double e : {0.0, 0.3, 3.0})
    for (const int n : {64, 256}) {
      const double W = late_factor(error_factors(constant_epsilon(e, n, Wedge::upstream2, Cycle::W), 8), 4);
      BOOST_TEST_MESSAGE("e " << e << ", n = " << n << ": W(2,1) " << W << " (at most 0.3)");
      BOOST_TEST(W < 0.3);
    }
}

BOOST_AUTO_TEST_CASE(varying_epsilon) {
  // Eq. (20). The paper reports a factor of 8 per cycle, that is 0.125. The limiting part is the edge of the circle,
  // where epsilon jumps from 0 to 0.125.
  for (const Wedge wedge : wedges)
    for (const int n : {64, 128, 256}) {
      const std::vector<double> factors = error_factors(papers_epsilon(n, wedge, Cycle::W), 16);
      const double first = late_factor({factors.begin(), factors.begin() + 4}, 4);
      const double late = late_factor(factors, 8);
      const double allowed = wedge == Wedge::upstream1 ? 0.2 : 0.25;
      BOOST_TEST_MESSAGE("n = " << n << " " << name(wedge) << ": W(2,1), first four cycles " << first
                                << " (at most 0.125), late ones " << late << " (at most " << allowed
                                << "):" << listed(factors));
      BOOST_TEST(first < 0.125);
      BOOST_TEST(late < allowed);
      BOOST_TEST(largest(factors, 8) < 0.3);
    }
}

BOOST_AUTO_TEST_CASE(constant_epsilon_on_stretched_cells_of_any_shape) {
  // Coarsening in Y only until the cells are square. The limit is that of square grids; test_smoothing.cpp
  // checks the two-grid factor.
  for (const double stretch : {2.0, 4.0, 8.0})
    for (const double e : {0.0, 0.03, 0.3, 1.0, 3.0, 30.0, 1e6}) {
      const double W = late_factor(
          error_factors(constant_epsilon_on_stretched_cells(e, stretch, 128, Wedge::upstream2, Cycle::W), 8), 4);
      BOOST_TEST_MESSAGE("hx = " << stretch << " hy, e " << e << ": W(2,1) " << W << " (at most 0.3)");
      BOOST_TEST(W < 0.3);
    }
}

BOOST_AUTO_TEST_SUITE_END()
