// The mirrored half of a grid compared with the whole grid.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/mirrored.hpp"

BOOST_AUTO_TEST_SUITE(test_core_mirrored)

using namespace ehl::core;
using namespace ehl::tests;

namespace {
const Grid grids[] = {{5, 4, -2, 1, -1.5, 1.5}, {8, 14, -3, 1.5, -2, 2}, {12, 16, -4.5, 1.5, -3, 3}};
}

BOOST_AUTO_TEST_CASE(the_half_and_the_whole_are_each_others_inverse) {
  for (const Grid& grid : grids) {
    const Patch half = lower_half(grid);
    BOOST_TEST((half.domain == grid));
    BOOST_TEST((Patch(grid).domain == grid));
    BOOST_TEST(!(half == Patch(grid)));
    BOOST_TEST(half.hy() == grid.hy());
    BOOST_TEST(std::abs(half.Y(half.ny)) < 1e-15);
    BOOST_TEST(half.last_line() == grid.ny / 2);
    BOOST_TEST(Patch(grid).last_line() == grid.ny - 1);
  }
  const Patch coarse = coarsened(lower_half(grids[2]));
  BOOST_TEST((coarse == lower_half(coarsened(grids[2]))));
}

BOOST_AUTO_TEST_CASE(image_lines_stand_behind_the_axis) {
  Random random(1);
  for (const Grid& grid : grids) {
    const SymmetricField f = symmetric_field(grid, random, -1.0, 1.0);
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny / 2 + ghost_lines; ++j) BOOST_TEST(f.half(i, j) == f.whole(i, j));
    BOOST_TEST(difference_of_half(grid, f.whole, f.half) == 0.0);
    Field untouched = f.whole;
    fill_ghosts(grid, untouched);
    for (int i = 0; i <= grid.nx; ++i) BOOST_TEST(untouched(i, grid.ny + 1) == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(sums_count_every_line_of_the_whole) {
  Random random(2);
  for (const Grid& grid : grids) {
    const SymmetricField f = symmetric_field(grid, random, -1.0, 1.0);
    const double all = interior_sum(grid, f.whole);
    BOOST_TEST(all == interior_sum(f.whole));
    const double error = std::abs(interior_sum(lower_half(grid), f.half) - all);
    BOOST_TEST_MESSAGE("sum of the half: error " << error << " (tolerance 1e-13)");
    BOOST_TEST(error < 1e-13);
    double lines = 0.0;
    for (int j = 1; j <= lower_half(grid).last_line(); ++j) lines += lower_half(grid).lines(j);
    BOOST_TEST(lines == grid.ny - 1.0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
