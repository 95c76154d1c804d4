// Changes of the boundary pressure, extended to the interior, compared with solutions of div(epsilon grad) = 0.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "multigrid/boundary_extension.hpp"
#include "unit/multigrid/circular_contact.hpp"

BOOST_AUTO_TEST_SUITE(test_multigrid_boundary_extension)

using namespace ehl::tests;
namespace multigrid = ehl::multigrid;
using ehl::core::Grid;
using ehl::core::Patch;

namespace {

// The cells are not square, so that a mesh size along the wrong axis is noticed.
const Grid grid{24, 32, -2.5, 1.5, -1.0, 1.0};

multigrid::Hierarchy wet(const Patch& patch) {
  multigrid::Parameters parameters;
  parameters.coarsest_cells = patch.nx;
  multigrid::Hierarchy hierarchy = multigrid::make_hierarchy(circular_contact(20, 10, ehl::reynolds::Wedge::upstream2),
                                                             parameters, {.method = ehl::mlmi::Method::fft}, patch, 1);
  multigrid::Level& level = hierarchy.finest();
  level.P.fill(1.0);
  level.eps.fill(1.0);
  return hierarchy;
}

bool inside(const Patch& patch, int i, int j) { return i > 0 && i < patch.nx && j > 0 && j <= patch.last_line(); }

// The largest difference between the extension of the boundary values `change` and the expected values.
template <class Change, class Expected>
double error_of(multigrid::Hierarchy& hierarchy, Change change, Expected expected) {
  multigrid::Level& level = hierarchy.finest();
  const Patch& patch = level.grid;
  const ehl::core::Field before = level.P;
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j)
      if (!inside(patch, i, j)) level.correction(i, j) = change(i, j);
  multigrid::extend_boundary(hierarchy, level);
  double error = 0.0;
  for (int i = 1; i < patch.nx; ++i)
    for (int j = 1; j <= patch.last_line(); ++j)
      error = std::max(error, std::abs(level.P(i, j) - before(i, j) - expected(i, j)));
  return error;
}

// The part that is equal on all lines along Y comes from the sides in X, and not from the extension along Y.
double wave(const Patch& patch, int i) { return std::sin(2.0 * patch.X(i)); }

constexpr double tolerance = 1e-12;
void check(const char* what, double error) {
  BOOST_TEST_MESSAGE(what << ": off by " << error << " (at most " << tolerance << ")");
  BOOST_TEST(error < tolerance);
}

BOOST_AUTO_TEST_CASE(a_bilinear_change_stays_bilinear) {
  multigrid::Hierarchy hierarchy = wet(grid);
  const Patch& patch = hierarchy.finest().grid;
  const auto change = [&](int i, int j) {
    return 0.1 + 0.02 * patch.X(i) - 0.03 * patch.Y(j) + 0.05 * patch.X(i) * patch.Y(j);
  };
  check("bilinear", error_of(hierarchy, change, change));
}

// For epsilon proportional to exp(2 Y), a change with constant flow along Y decreases as exp(-2 Y).
BOOST_AUTO_TEST_CASE(the_flow_of_a_change_is_the_same_along_a_row) {
  multigrid::Hierarchy hierarchy = wet(grid);
  multigrid::Level& level = hierarchy.finest();
  const Patch& patch = level.grid;
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) level.eps(i, j) = std::exp(2.0 * patch.Y(j));
  std::vector<double> row(static_cast<std::size_t>(patch.ny) + 1, 0.0);
  for (std::size_t j = 1; j < row.size(); ++j)
    row[j] = row[j - 1] + 2.0 / (level.eps(0, static_cast<int>(j) - 1) + level.eps(0, static_cast<int>(j)));
  const auto change = [&](int i, int j) {
    return 0.1 * wave(patch, i) * row[static_cast<std::size_t>(j)] / row.back();
  };
  check("epsilon of its own", error_of(hierarchy, change, change));
}

BOOST_AUTO_TEST_CASE(nothing_flows_through_a_mirror) {
  multigrid::Hierarchy hierarchy = wet(ehl::core::lower_half(grid));
  const Patch& patch = hierarchy.finest().grid;
  BOOST_REQUIRE(patch.north == ehl::core::Edge::mirror);
  const auto change = [&](int i, int) { return 0.1 + 0.02 * std::sin(patch.X(i)); };
  check("mirror", error_of(hierarchy, change, change));
}

// Next to a strip of cavitated nodes, and next to a strip where the film responds more strongly than the pressure.
BOOST_AUTO_TEST_CASE(a_change_ends_where_pressure_does_not_rule) {
  constexpr int first = 12, last = 15;  // lines of the strip
  for (const bool dry : {true, false}) {
    multigrid::Hierarchy hierarchy = wet(grid);
    multigrid::Level& level = hierarchy.finest();
    const Patch& patch = level.grid;
    for (int i = 0; i <= patch.nx; ++i)
      for (int j = first; j <= last; ++j) (dry ? level.P(i, j) : level.eps(i, j)) = 0.0;
    // The face next to a node without epsilon has half the epsilon of the others.
    const int end_south = dry ? first - 1 : first, end_north = dry ? last + 1 : last;
    const auto expected = [&](int i, int j) {
      const auto falls = [&](int from, int to) {
        const double faces = std::abs(to - from) + (dry ? 0.0 : 1.0);
        return 1.0 - std::abs(j - from) / faces;
      };
      if (j < end_south) return 0.1 * wave(patch, i) * falls(0, end_south);
      if (j > end_north) return -0.2 * wave(patch, i) * falls(patch.ny, end_north);
      return 0.0;
    };
    check(dry ? "dry strip" : "strip without epsilon", error_of(hierarchy, expected, expected));
  }
}

BOOST_AUTO_TEST_CASE(no_pressure_falls_below_zero) {
  multigrid::Hierarchy hierarchy = wet(grid);
  const auto change = [](int, int) { return -1.5; };
  check("P = 0", error_of(hierarchy, change, [](int, int) { return -1.0; }));
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
