// The oil content of cavitated nodes behind a film on few cells.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "reynolds/content.hpp"

using namespace ehl;
using reynolds::Wedge;

BOOST_AUTO_TEST_SUITE(test_reynolds_content)

// Behind the film the gap opens by ten times its height from node to node, as in a heavy contact on few cells. The flux
// out of a cavitated node equals the flux into it, and the whole third-order flux of its gap exceeds that.
BOOST_AUTO_TEST_CASE(contents_behind_a_film_are_never_negative) {
  const std::vector<double> gap{0.0018, 0.0018, 0.0018, 0.0019, 0.019, 0.047, 0.084, 0.127, 0.177};
  constexpr std::size_t last_full = 3;
  constexpr double h = 0.0625;
  for (const double theta : {0.0, 0.5, 1.0}) {
    reynolds::March<double> march(Wedge::upstream3, h, gap[0], gap[0]);
    double before = gap[0], least = gap[0];
    for (std::size_t i = 1; i + 1 < gap.size(); ++i) {
      const double third = i == last_full ? 0.0 : theta;  // of the face behind the last full node
      const double r = march.residual(gap[i], gap[i + 1], {theta, third}, 0.0);
      march.go_on(gap[i], i > last_full, r);
      least = std::min(least, march.Q());
      if (i > last_full) BOOST_TEST(std::abs(march.flux() / before - 1.0) <= 1e-12);
      before = march.flux();
    }
    BOOST_TEST_MESSAGE("theta " << theta << ": least content " << least << " (at least 1e-4)");
    BOOST_TEST(least >= 1e-4);
    BOOST_TEST(march.Q() == before, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_SUITE_END()
