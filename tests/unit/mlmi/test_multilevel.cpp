// Multilevel multi-integration compared with the direct sum and the Fourier sum.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "mlmi/deformation.hpp"
#include "unit/mlmi/pressures.hpp"

namespace mlmi = ehl::mlmi;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::tests::deformation;
using mlmi::Deformation;
using mlmi::Method;
using mlmi::Parameters;

// All allocations of this program are counted here. (noinline: otherwise the compiler would see malloc and free without
// the operators around them and warn.)
namespace {
long allocations = 0;
}
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

BOOST_AUTO_TEST_SUITE(test_multilevel)

namespace {
double relative_error(const Field& w, const Field& truth) {
  return ehl::core::max_abs_difference(w, truth) / ehl::core::max_abs(truth);
}

bool same_bits(const Field& a, const Field& b) { return ehl::core::max_abs_difference(a, b) == 0.0; }

// The inner product over all nodes.
double product(const Field& a, const Field& b) {
  double sum = 0.0;
  for (int i = 0; i < a.nodes_x(); ++i)
    for (int j = 0; j < a.nodes_y(); ++j) sum += a(i, j) * b(i, j);
  return sum;
}
}  // namespace

BOOST_AUTO_TEST_CASE(a_patch_as_large_as_the_grid_makes_it_exact_for_any_pressure) {
  // The pressure is rough and not zero on the boundary, so that ghost points, parities and corrections must all be
  // correct. The remaining differences come from the far corners of the patch, which are omitted because they are
  // smaller than the part outside the patch.
  for (const Grid& grid : {Grid{32, 32, -3, 3, -3, 3}, Grid{40, 16, -4, 2, -1, 1}, Grid{17, 35, -2, 2, -3, 3}}) {
    const Field P = ehl::tests::rough(grid);
    const Field truth = deformation(grid, P, {.method = Method::direct});
    double worst = 0.0;
    for (const int order : {4, 6, 8})
      for (int coarsenings = 0; coarsenings <= 3; ++coarsenings)
        for (const bool direct : {false, true}) {
          const Parameters parameters{.order = order,
                                      .patch_along = 64,
                                      .patch_across = 64,
                                      .coarsenings = coarsenings,
                                      .coarsest_direct = direct};
          if (coarsenings == 3 && grid.nx < 32) continue;
          worst = std::max(worst, relative_error(deformation(grid, P, parameters), truth));
        }
    BOOST_TEST_MESSAGE(grid.nx << " x " << grid.ny << ": largest error " << worst << " (tolerance 1e-8)");
    BOOST_TEST(worst < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(order_and_patch_buy_accuracy) {
  // The tolerances belong to n = 64, with a margin for the rounding of other processors.
  const Grid grid{64, 64, -4.5, 1.5, -3.0, 3.0};
  const Field P = ehl::tests::sampled(grid, ehl::tests::contact_pressure);
  const Field truth = deformation(grid, P, {.method = Method::direct});
  struct {
    int order, along, across;
    double measured;
  } const rows[] = {{4, 7, 2, 5.1e-4}, {4, 7, 3, 2.8e-4}, {6, 7, 3, 6.3e-5}, {8, 9, 4, 1.2e-5}, {8, 11, 5, 7.4e-6}};
  for (const auto& row : rows) {
    const Field w = deformation(
        grid, P, {.order = row.order, .patch_along = row.along, .patch_across = row.across, .coarsenings = 2});
    const double error = relative_error(w, truth);
    BOOST_TEST_MESSAGE("order " << row.order << ", patch " << row.along << " x " << row.across << ": error " << error
                                << " (measured: " << row.measured << ", tolerance 20 % above)");
    BOOST_TEST(error < 1.2 * row.measured);
  }
}

BOOST_AUTO_TEST_CASE(defaults_stay_below_a_tenth_of_the_discretization_error) {
  struct {
    int n;
    double wanted;
  } const levels[] = {{32, 2e-3}, {64, 5e-4}, {128, 1e-4}, {256, 3e-5}, {512, 8e-6}, {1024, 2e-6}};
  for (const auto& level : levels) {
    const Grid grid{level.n, level.n, -4.5, 1.5, -3.0, 3.0};
    const Field P = ehl::tests::sampled(grid, ehl::tests::contact_pressure);
    const Field truth = deformation(grid, P, {.method = Method::fft});
    const Field w = deformation(grid, P, {});
    const double error = relative_error(w, truth);
    BOOST_TEST_MESSAGE("n = " << level.n << ": error " << error << " (wanted " << level.wanted << "), of dw/dX "
                              << ehl::tests::slope_difference(grid, w, truth) << " (tolerance 1e-3)");
    BOOST_TEST(error < level.wanted);
    BOOST_TEST(ehl::tests::slope_difference(grid, w, truth) < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(rectangular_grids_and_cells) {
  for (const Grid& grid : {Grid{128, 96, -4.5, 1.5, -2.0, 2.0}, Grid{96, 160, -4.5, 1.5, -3.0, 3.0},
                           Grid{200, 64, -4.5, 1.5, -1.5, 1.5}, Grid{131, 77, -4.5, 1.5, -2.0, 2.0}}) {
    const Field P = ehl::tests::sampled(grid, ehl::tests::contact_pressure);
    const double error = relative_error(deformation(grid, P, {}), deformation(grid, P, {.method = Method::fft}));
    BOOST_TEST_MESSAGE(grid.nx << " x " << grid.ny << ", hx/hy = " << grid.hx() / grid.hy() << ": error " << error
                               << " (tolerance 1e-4, as at n = 128)");
    BOOST_TEST(error < 1e-4);
  }
  for (const Grid& grid : {Grid{2, 2, -1, 1, -1, 1}, Grid{4, 300, -1, 1, -3, 3}, Grid{7, 3, -1, 1, -1, 1}}) {
    const Field P = ehl::tests::rough(grid);
    BOOST_TEST(relative_error(deformation(grid, P, {}), deformation(grid, P, {.method = Method::direct})) < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(same_bits_for_any_number_of_threads) {
  for (const Grid& grid : {Grid{256, 256, -4.5, 1.5, -3.0, 3.0}, Grid{300, 141, -4.5, 1.5, -1.5, 1.5}}) {
    const Field P = ehl::tests::sampled(grid, ehl::tests::contact_pressure);
    for (const Method method : {Method::mlmi, Method::fft}) {
      const Field one = deformation(grid, P, {.method = method}, 1);
      for (const int threads : {2, 3}) BOOST_TEST(same_bits(one, deformation(grid, P, {.method = method}, threads)));
    }
  }
}

BOOST_AUTO_TEST_CASE(linear_symmetric_and_without_memory) {
  const Grid grid{128, 128, -4.5, 1.5, -3.0, 3.0};
  const Field P = ehl::tests::sampled(grid, ehl::tests::contact_pressure);
  const Field Q =
      ehl::tests::sampled(grid, [](double X, double Y) { return std::exp(-4.0 * (X * X + X * Y + Y * Y)); });
  Field combined(grid), wP(grid), wQ(grid), w(grid), again(grid);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) combined(i, j) = 2.0 * P(i, j) - 3.0 * Q(i, j);
  Deformation evaluator(grid, {}, 1);
  evaluator.evaluate(P, wP);
  evaluator.evaluate(Q, wQ);
  evaluator.evaluate(combined, w);
  evaluator.evaluate(P, again);
  double nonlinearity = 0.0, asymmetry = 0.0;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) {
      nonlinearity = std::max(nonlinearity, std::abs(w(i, j) - 2.0 * wP(i, j) + 3.0 * wQ(i, j)));
      asymmetry = std::max(asymmetry, std::abs(wP(i, j) - wP(i, grid.ny - j)));
    }
  // (P, K Q) = (Q, K P) holds for the kernel; the multilevel sum satisfies it to its own error.
  const double adjoint = std::abs(product(P, wQ) / product(Q, wP) - 1.0);
  BOOST_TEST_MESSAGE("nonlinearity " << nonlinearity << ", asymmetry in Y " << asymmetry
                                     << " (tolerance 1e-13), (P,KQ)/(Q,KP)-1 " << adjoint << " (tolerance 1e-5)");
  BOOST_TEST(nonlinearity < 1e-13);
  BOOST_TEST(asymmetry < 1e-13);
  BOOST_TEST(adjoint < 1e-5);
  BOOST_TEST(same_bits(wP, again));
}

BOOST_AUTO_TEST_CASE(neither_padding_nor_the_allocator_is_touched) {
  const Grid grid{66, 67, -4.5, 1.5, -3.0, 3.0};
  const Field P = ehl::tests::sampled(grid, ehl::tests::contact_pressure);
  for (const Method method : {Method::mlmi, Method::fft, Method::direct}) {
    const Field clean = deformation(grid, P, {.method = method});
    Field dirty = P, w(grid);
    for (int i = 0; i <= grid.nx; ++i)
      for (std::ptrdiff_t j = grid.nodes_y(); j < dirty.stride(); ++j)
        dirty.at_x(i)[j] = std::numeric_limits<double>::quiet_NaN();
    Deformation evaluator(grid, {.method = method}, 1);
    const long before = allocations;
    evaluator.evaluate(dirty, w);
    const long during = allocations - before;
    BOOST_TEST(during == 0);
    BOOST_TEST(same_bits(clean, w));
  }
}

BOOST_AUTO_TEST_CASE(wrong_parameters_are_refused) {
  const Grid grid{64, 32, -3, 3, -1.5, 1.5};
  using ehl::core::InputError;
  BOOST_CHECK_THROW(Deformation(grid, {.order = 5}, 1), InputError);
  BOOST_CHECK_THROW(Deformation(grid, {.patch_along = 65}, 1), InputError);
  BOOST_CHECK_THROW(Deformation(grid, {.patch_across = 65}, 1), InputError);
  BOOST_CHECK_THROW(Deformation(grid, {.coarsenings = 6}, 1), InputError);
  BOOST_CHECK_THROW(Deformation(grid, {.coarsenings = 1000}, 1), InputError);
  BOOST_CHECK_NO_THROW(Deformation(grid, {.coarsenings = 5}, 1));
  BOOST_TEST(Deformation(grid, {.order = 6, .patch_along = 9, .patch_across = 3, .coarsenings = 2}, 1).description() ==
             "mlmi, order 6, patch 9x3, 2 coarsenings, FFT on 37x21");
  BOOST_TEST(Deformation(grid, {}, 1).bytes() > 0u);
}

BOOST_AUTO_TEST_SUITE_END()
