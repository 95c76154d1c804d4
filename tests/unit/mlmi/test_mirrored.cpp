// The deformation on the lower half of a symmetric domain, compared with the sum over the whole domain.
#include <boost/test/unit_test.hpp>

#include "core/errors.hpp"
#include "support/mirrored.hpp"
#include "unit/mlmi/pressures.hpp"

BOOST_AUTO_TEST_SUITE(test_mlmi_mirrored)

using namespace ehl::tests;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using ehl::mlmi::Method;
using ehl::mlmi::Parameters;

namespace {

double difference_from_whole(const Grid& grid, const Parameters& parameters, int threads = 1) {
  Random random(static_cast<std::uint64_t>(grid.nx + grid.ny));
  const SymmetricField P = symmetric_field(grid, random, 0.0, 1.0);
  const Field w = deformation(grid, P.whole, parameters, threads);
  const Field half = deformation(ehl::core::lower_half(grid), P.half, parameters, threads);
  // Only the lower half is compared. If a coarsening puts the axis between two points, the multilevel sum over the
  // whole domain is symmetric only to its own error.
  const double difference = ehl::core::max_abs_difference(half_of(grid, w), half) / ehl::core::max_abs(w);
  BOOST_TEST_MESSAGE(grid.nx << " x " << grid.ny << ": difference " << difference << " (tolerance 1e-13)");
  return difference;
}

// The axis is on a line of every coarsening of y, of the first one only, or of none; strips
// end at, before and after it.
const Grid grids[] = {{48, 32, -3, 1.5, -1.5, 1.5}, {64, 64, -4.5, 1.5, -3, 3}, {40, 36, -3, 1.5, -2, 2},
                      {33, 50, -3, 1.5, -2, 2},     {32, 112, -1, 1, -3, 3},    {64, 72, -2, 2, -1, 1},
                      {128, 128, -4.5, 1.5, -3, 3}, {96, 16, -4, 2, -0.5, 0.5}};

}  // namespace

BOOST_AUTO_TEST_CASE(every_method_on_the_half_is_the_sum_over_the_whole) {
  for (const Grid& grid : grids) {
    BOOST_TEST(difference_from_whole(grid, {.method = Method::fft}) < 1e-13);
    BOOST_TEST(difference_from_whole(grid, {}) < 1e-13);
    for (int coarsenings = 1; coarsenings <= std::min(4, ehl::mlmi::most_coarsenings(grid)); ++coarsenings)
      for (const int order : {4, 6, 8})
        BOOST_TEST(difference_from_whole(grid, {.order = order, .coarsenings = coarsenings}) < 1e-13);
  }
  BOOST_TEST(difference_from_whole(grids[0], {.method = Method::direct}) < 1e-13);
  BOOST_TEST(difference_from_whole(grids[1], {.coarsenings = 2, .coarsest_direct = true}) < 1e-13);
}

BOOST_AUTO_TEST_CASE(a_patch_wider_than_what_lies_before_the_axis) {
  BOOST_TEST(difference_from_whole(grids[7], {.patch_along = 20, .patch_across = 15, .coarsenings = 2}) < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_description_and_the_limits_are_those_of_the_whole) {
  const Grid& grid = grids[6];
  const ehl::mlmi::Deformation whole(grid, {}, 1);
  const ehl::mlmi::Deformation half(ehl::core::lower_half(grid), {}, 1);
  BOOST_TEST_MESSAGE(whole.description() << " / " << half.description());
  BOOST_TEST(half.description() == whole.description());
  BOOST_TEST(half.bytes() < 0.75 * static_cast<double>(whole.bytes()));
  BOOST_CHECK_THROW(ehl::mlmi::Deformation(ehl::core::lower_half(grid), {.coarsenings = 11}, 1), ehl::core::InputError);
}

BOOST_AUTO_TEST_CASE(two_threads_give_the_same_bits_on_the_half) {
  const Grid grid{256, 256, -4.5, 1.5, -3, 3};
  const ehl::core::Patch half = ehl::core::lower_half(grid);
  Random random(9);
  const SymmetricField P = symmetric_field(grid, random, 0.0, 1.0);
  for (const Method method : {Method::mlmi, Method::fft}) {
    const Field one = deformation(half, P.half, {.method = method}, 1);
    const Field two = deformation(half, P.half, {.method = method}, 2);
    BOOST_TEST(ehl::core::max_abs_difference(one, two) == 0.0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
