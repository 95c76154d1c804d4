// The grid, the owning field, vector lanes, errors.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/errors.hpp"
#include "core/field.hpp"
#include "core/simd.hpp"
#include "core/store_lines.hpp"
#include "core/timer.hpp"

BOOST_AUTO_TEST_SUITE(test_core_field)

using namespace ehl::core;

namespace {
bool on_cache_line(const double* p) { return reinterpret_cast<std::uintptr_t>(p) % 64 == 0; }

Field numbered(int nodes_x, int nodes_y) {
  Field field(nodes_x, nodes_y);
  for (int i = 0; i < nodes_x; ++i)
    for (int j = 0; j < nodes_y; ++j) field(i, j) = 1000.0 * i + j;
  return field;
}

bool is_numbered(const Field& field) {
  for (int i = 0; i < field.nodes_x(); ++i)
    for (int j = 0; j < field.nodes_y(); ++j)
      if (field(i, j) != 1000.0 * i + j) return false;
  return true;
}

Lanes counting(double first) {
  return first + __builtin_convertvector(lanes_by([](int k) { return k; }), Lanes);
}
bool same(Lanes a, Lanes b) { return all(a == b); }
}  // namespace

BOOST_AUTO_TEST_CASE(a_grid_ends_where_it_should_and_coarsens_to_every_second_node) {
  const Grid fine{24, 10, -4.5, 1.5, -1.0, 1.5};
  BOOST_TEST(fine.hx() == 0.25);
  BOOST_TEST(fine.hy() == 0.25);
  BOOST_TEST(fine.X(24) == 1.5);
  BOOST_TEST(fine.Y(10) == 1.5);
  const Grid coarse = coarsened(fine);
  BOOST_TEST((coarse == Grid{12, 5, -4.5, 1.5, -1.0, 1.5}));
  for (int I = 0; I <= coarse.nx; ++I) BOOST_TEST(coarse.X(I) == fine.X(2 * I));
}

BOOST_AUTO_TEST_CASE(every_station_starts_on_a_cache_line_and_two_vectors_follow_the_last_node) {
  for (const int nodes_y : {1, 7, 8, 9, 16, 17, 65}) {
    const Field field(3, nodes_y);
    BOOST_TEST(field.stride() >= nodes_y + 2 * lanes);
    for (int i = 0; i < 3; ++i) {
      BOOST_TEST(on_cache_line(field.at_x(i)));
      BOOST_TEST(field.station(i).size() == static_cast<std::size_t>(nodes_y));
      for (const double value : field.station(i)) BOOST_TEST(value == 0.0);
      // The entries behind the last node, which a batch of lines may read, exist and are finite.
      for (int j = nodes_y; j < nodes_y + 2 * lanes; ++j) BOOST_TEST(field.at_x(i)[j] == 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(copies_are_independent_and_take_the_shape) {
  const Field original = numbered(5, 9);
  Field second(original);
  BOOST_TEST(is_numbered(second));
  second(2, 3) = -1.0;
  BOOST_TEST(is_numbered(original));

  Field other_shape(2, 30);
  other_shape = original;
  BOOST_TEST((other_shape.nodes_x() == 5 && other_shape.nodes_y() == 9));
  BOOST_TEST(is_numbered(other_shape));

  Field same_shape(5, 9);
  const double* storage = same_shape.at_x(0);
  same_shape = original;
  BOOST_TEST(same_shape.at_x(0) == storage);  // nothing is allocated within a cycle
  BOOST_TEST(is_numbered(same_shape));
  const Field& alias = same_shape;
  same_shape = alias;
  BOOST_TEST(is_numbered(same_shape));

  Field into(5, 9);
  copy(original, into);
  BOOST_TEST(is_numbered(into));
  const double* from = into.at_x(0);
  const Field moved = std::move(into);
  BOOST_TEST(moved.at_x(0) == from);
  BOOST_TEST(is_numbered(moved));
  into = moved;
  BOOST_TEST(is_numbered(into));
  Field nothing;
  nothing = Field();
  BOOST_TEST(nothing.nodes_x() == 0);
}

BOOST_AUTO_TEST_CASE(the_one_line_of_a_line_contact_is_stored_on_all_three_and_read_once) {
  Field field{Patch(line_grid(6, -4.5, 1.5))};
  const std::vector<double> values{2.0, 3.0, 5.0, 7.0};
  store_line(values, field, 2);
  for (int i = 0; i < 7; ++i)
    for (const double value : field.station(i))
      BOOST_TEST(value == (i < 2 || i > 5 ? 0.0 : values[std::size_t(i - 2)]));
  std::vector<double> along(7), first(3);
  load_line(field, along);
  load_line(field, first);
  BOOST_TEST(along == (std::vector<double>{0.0, 0.0, 2.0, 3.0, 5.0, 7.0, 0.0}), boost::test_tools::per_element());
  BOOST_TEST(first == (std::vector<double>{0.0, 0.0, 2.0}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(fields_of_a_line_contact_have_no_padding_and_are_copied_to_those_that_have) {
  const Grid line = line_grid(6, -4.5, 1.5);
  Field packed{Patch(line)};
  BOOST_TEST(packed.stride() < 8);
  for (int i = 0; i < packed.nodes_x(); ++i) fill_lines(packed.at_x(i), i + 1.0);
  const auto is_there = [](const Field& field) {
    bool there = field.nodes_x() == 7 && field.nodes_y() == 3;
    for (int i = 0; i < 7; ++i)
      for (const double value : field.station(i)) there = there && value == i + 1.0;
    return there;
  };
  BOOST_TEST(is_there(packed));
  // A batch of lines may read this far behind the last column.
  for (int j = 3; j < 1 + 2 * lanes; ++j) BOOST_TEST(std::isfinite(packed.at_x(6)[j]));
  Field padded(7, 3);
  copy(packed, padded);
  BOOST_TEST(is_there(padded));
  packed.fill(0.0);
  copy(padded, packed);
  BOOST_TEST(is_there(packed));
  padded = packed;
  BOOST_TEST(is_there(padded));
  BOOST_TEST(is_there(Field(packed)));
}

BOOST_AUTO_TEST_CASE(fill_reaches_every_node) {
  Field field(4, 11);
  field.fill(2.5);
  for (int i = 0; i < 4; ++i)
    for (const double value : field.station(i)) BOOST_TEST(value == 2.5);
}

BOOST_AUTO_TEST_CASE(evens_and_odds_come_apart_and_together_again) {
  const Lanes low = counting(0.0);
  const Lanes high = counting(lanes);
  for (int k = 0; k < lanes; ++k) {
    BOOST_TEST(evens(low, high)[k] == 2.0 * k);
    BOOST_TEST(odds(low, high)[k] == 2.0 * k + 1.0);
  }
  BOOST_TEST(same(interleaved_low(evens(low, high), odds(low, high)), low));
  BOOST_TEST(same(interleaved_high(evens(low, high), odds(low, high)), high));
  const Lanes moved = moved_up(high, low), swapped = swapped_pairs(low);
  for (int k = 0; k < lanes; ++k) {
    BOOST_TEST(moved[k] == (k == 0 ? lanes : k - 1.0));
    BOOST_TEST(swapped[k] == (k % 2 == 0 ? k + 1.0 : k - 1.0));
  }
}

BOOST_AUTO_TEST_CASE(lanes_load_store_and_compare_one_by_one) {
  const double numbers[9] = {1, -2, 3, -4, 5, -6, 7, -8, 9};
  const Lanes v = load(numbers + 1);  // alignment is not required
  double back[lanes];
  store(back, v);
  for (int k = 0; k < lanes; ++k) {
    BOOST_TEST(back[k] == numbers[k + 1]);
    BOOST_TEST(abs(v)[k] == std::abs(numbers[k + 1]));
    BOOST_TEST(max(v, broadcast(0.5))[k] == std::max(numbers[k + 1], 0.5));
    BOOST_TEST(min(v, broadcast(0.5))[k] == std::min(numbers[k + 1], 0.5));
  }
  BOOST_TEST(all(v > broadcast(-9.0)));
  BOOST_TEST(!all(v > broadcast(-2.0)));
  Lanes broken = v;
  broken[lanes - 1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(!all(broken == broken));
}

BOOST_AUTO_TEST_CASE(an_input_error_keeps_every_message) {
  const InputError error(std::vector<std::string>{"a.ini:3: one", "a.ini:7: two"});
  BOOST_TEST(error.messages().size() == 2);
  BOOST_TEST(error.what() == std::string("a.ini:3: one\na.ini:7: two"));
  static_assert(!std::is_base_of_v<InputError, SolverError>);
}

BOOST_AUTO_TEST_CASE(time_goes_to_the_part_that_spent_it) {
  PartTimes times;
  const double start = now();
  {
    const ScopedTimer timer(times, Part::residual);
    while (now() - start < 1e-4) {
    }
  }
  BOOST_TEST(times[Part::residual] > 0.0);
  BOOST_TEST(times[Part::residual] <= now() - start);
  BOOST_TEST(times[Part::transfer] == 0.0);
  const double before = times[Part::residual];
  {
    const EnclosingTimer all(times, Part::coarsest);
    const ScopedTimer timer(times, Part::residual);
    while (times[Part::residual] > 0.0 && now() - start < 3e-4) {
    }
  }
  BOOST_TEST(times[Part::residual] == before);
  BOOST_TEST(times[Part::coarsest] > 0.0);
  for (std::size_t k = 0; k < static_cast<std::size_t>(Part::count); ++k)
    BOOST_TEST(name(static_cast<Part>(k)) != std::string("?"));
}

BOOST_AUTO_TEST_SUITE_END()
