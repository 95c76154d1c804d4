// Multilevel multi-integration of coated bodies compared with the Fourier sum: as accurate as that of a half-space.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/norms.hpp"
#include "mlmi/deformation.hpp"
#include "unit/mlmi/pressures.hpp"

BOOST_AUTO_TEST_SUITE(test_coated_sums)

using namespace ehl;
using core::Field;
using kernel::Coating;
using mlmi::Method;

namespace {

// Largest difference of the default from the exact sum, in units of a^2/R where the bodies yield as much as a
// half-space to the wave number 2/a.
double error_of(const core::Grid& grid, const Field& P, const kernel::Kernel& kernel) {
  Field exact(grid), w(grid);
  mlmi::Deformation(grid, {.method = Method::fft}, 1, kernel).evaluate(P, exact);
  mlmi::Deformation(grid, {}, 1, kernel).evaluate(P, w);
  return core::max_abs_difference(w, exact);
}

kernel::Kernel coated(const Coating& c) {
  const double compliance = 1.0 + c.share * kernel::response(c, 2.0 * c.thickness);
  return {.factor = kernel::circular_factor / compliance, .coatings = {kernel::SmoothPart(c, false)}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_default_is_as_accurate_as_for_a_half_space) {
  const core::Grid grid{256, 256, -4.5, 1.5, -3, 3};
  const Field P = ehl::tests::sampled(grid, ehl::tests::contact_pressure);
  const double half_space = error_of(grid, P, kernel::half_space());
  double worst = 0.0;
  for (const double E : {0.01, 0.1, 10.0})
    for (const double thickness : {0.01, 0.05, 0.1, 0.2, 1.0, 10.0}) {
      const double error = error_of(grid, P, coated({{E, 0.3}, {1.0, 0.3}, thickness, 0.5}));
      BOOST_TEST_MESSAGE("E " << E << ", thickness " << thickness << ": " << error << ", half-space " << half_space);
      worst = std::max(worst, error);
    }
  BOOST_TEST_MESSAGE("largest " << worst / half_space << " times that of a half-space (tolerance 1.5)");
  BOOST_TEST(worst < 1.5 * half_space);
}

BOOST_AUTO_TEST_SUITE_END()
