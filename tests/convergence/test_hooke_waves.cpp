// Low waves that move through a line contact with the speed of their surface, in an oil that thins under shear.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "contact/groups.hpp"
#include "rheology/shear.hpp"
#include "support/roelands_scene.hpp"
#include "unit/transient/marching.hpp"

BOOST_AUTO_TEST_SUITE(test_hooke_waves)

using namespace ehl;
using namespace ehl::tests;
using Complex = std::complex<double>;

namespace {

constexpr double pi = std::numbers::pi;
constexpr Complex i_unit{0.0, 1.0};

// The contact of Hooke 2006. The speed, which he does not state, follows from his |Q|, which is a measure of the film.
constexpr double p_h = 1e9, E_prime = 228e9, tau_0 = 4e6, M = 39.8, L = 7.94;
constexpr double low = 2e-4;  // height of the waves in H, of a film of 0.035

steady::Scene scene_with(int cells, double sliding) {
  steady::Scene scene = roelands_line(M, L, core::line_grid(cells, -2.5, 1.5));
  scene.solver.tolerance = 1e-8;
  scene.viscosity = rheology::Barus{contact::from_moes(M, L, scene.contact.shape).alpha_bar};
  scene.density = rheology::make_dowson_higginson(p_h);
  scene.thinning = rheology::ShearThinning{rheology::Eyring{}, 0.0};
  scene.thinning->k = scene.lambda * (4.0 * p_h / E_prime) / 12.0 * p_h / tau_0 * sliding;
  return scene;
}

// Coefficients of the linearised equations at the centre, where the mean pressure has no gradient:
//   -eps k^2 p = i (k - omega) rho_bar (a + H C p),   a = A + p/k,   C = d ln rho_bar/dP,
// for waves exp(i k X - i omega T); p/k is the elastic response of a half-plane.
struct Centre {
  double eps, rho_bar, HC;
};
Centre centre_of(const steady::Scene& scene, double P, double H) {
  double log_eta = 0.0, rho_bar = 0.0, above = 0.0, along = 0.0, across = 0.0;
  rheology::log_viscosity(scene.viscosity, {&P, 1}, {&log_eta, 1});
  rheology::density(scene.density, {&P, 1}, {&rho_bar, 1});
  const double step = 1e-6, P_above = P + step, fluidity = std::exp(-log_eta);
  rheology::density(scene.density, {&P_above, 1}, {&above, 1});
  rheology::film_fluidity(*scene.thinning, {&H, 1}, {&fluidity, 1}, {&along, 1}, {&across, 1});
  return {rho_bar * H * H * H * along / scene.lambda, rho_bar, H * (above / rho_bar - 1.0) / step};
}

/// Amplitudes over A at the place of the wave: of the pressure, and of the gap.
struct Response {
  Complex p, a;
};
Response of_the_surface(const Centre& at, double k, double v) {
  const double against = k * (1.0 - v) * at.rho_bar;
  const Complex p = -i_unit * against / (at.eps * k * k + i_unit * against * (1.0 / k + at.HC));
  return {p, 1.0 + p / k};
}

// The wave that the oil carries: the same frequency without a wave of the surface. Newton's method. Waves at rest
// change the film as a whole.
Complex wave_number_in_the_oil(const Centre& at, double omega) {
  if (omega == 0.0) return 0.0;
  Complex k = omega;
  for (int step = 0; step < 50; ++step) {
    const Complex f = at.eps * k * k + i_unit * at.rho_bar * (k - omega) * (1.0 / k + at.HC);
    const Complex slope = 2.0 * at.eps * k + i_unit * at.rho_bar * (omega / (k * k) + at.HC);
    k -= f / slope;
  }
  return k;
}

struct Waves {
  Response measured, theory;
  double Q;  ///< Hooke's
};

// The contact while the waves move on by one wave length, in equal parts.
std::vector<transient::Frame> one_period(const steady::Scene& scene, surface::Feature wave, double v) {
  std::vector<transient::Frame> frames;
  constexpr int parts = 32, positions = 4;
  if (v == 0.0) {  // steady states with the waves at several positions
    for (int n = 0; n < positions; ++n) {
      steady::Scene at_rest = scene;
      at_rest.surface = [wave, X = n * wave.width / positions](const core::Patch& grid, core::Field& S) {
        surface::add_gap(wave, grid, X, S);
      };
      const steady::Solution solution = steady::solve(at_rest);
      BOOST_REQUIRE(solution.converged);
      frames.push_back({.T = n * wave.width / positions, .P = solution.P, .H = solution.H});
    }
    return frames;
  }
  const double period = wave.width / v, settled = std::ceil(4.0 / period) * period;
  const transient::Conditions conditions{.u1 = {.points = {{0.0, v}}},
                                         .u2 = {.points = {{0.0, 2.0 - v}}},
                                         .on_1 = wave,
                                         .thinning_k = scene.thinning->k / (2.0 * std::abs(1.0 - v))};
  Marched all = marched(
      scene, conditions,
      {.end = settled + period, .rtol = 1e-5, .longest_step = period / parts, .output_interval = period / parts});
  BOOST_REQUIRE((all.report.end == transient::MarchEnd::end_time));
  for (transient::Frame& frame : all.frames)
    if (frame.T > settled + 1e-9) frames.push_back(std::move(frame));
  BOOST_REQUIRE(frames.size() == static_cast<std::size_t>(parts));
  for (transient::Frame& frame : frames) frame.T *= v;  // how far the waves have moved
  return frames;
}

// in: wave length; speed v of the surface with waves, whose other surface has 2 - v.
Waves waves(double length, double v, int cells) {
  const steady::Scene scene = scene_with(cells, 2.0 * std::abs(1.0 - v));
  const core::Grid& grid = scene.grid;
  const double k = 2.0 * pi / length;
  const surface::Feature wave{
      .shape = surface::Feature::Shape::waviness, .height = low, .width = length, .X = grid.X_b, .front = false};
  const std::vector<transient::Frame> frames = one_period(scene, wave, v);
  const auto coefficient = [&](core::Field transient::Frame::*field, int i, int order) {
    Complex sum = 0.0;
    for (const transient::Frame& frame : frames) sum += (frame.*field)(i, 1) * std::polar(1.0, order * k * frame.T);
    return sum / static_cast<double>(frames.size());
  };
  const int middle = static_cast<int>(std::lround(-grid.X_a / grid.hx()));
  const Centre at = centre_of(scene, coefficient(&transient::Frame::P, middle, 0).real(),
                              coefficient(&transient::Frame::H, middle, 0).real());
  const Complex carried = wave_number_in_the_oil(at, k * v);
  // Least squares over the middle of the contact for the amplitudes of both waves.
  const auto fit = [&](core::Field transient::Frame::*field) {
    double a11 = 0.0, a22 = 0.0;
    Complex a12 = 0.0, b1 = 0.0, b2 = 0.0;
    for (int i = 0; i <= grid.nx; ++i) {
      const double X = grid.X(i);
      if (std::abs(X) > 0.25) continue;
      const Complex value = 2.0 * coefficient(field, i, 1) / (low * std::exp(i_unit * k * (X - wave.X)));
      const Complex other = std::exp(i_unit * (carried - k) * X);
      a11 += 1.0;
      a12 += other;
      a22 += std::norm(other);
      b1 += value;
      b2 += std::conj(other) * value;
    }
    return (b1 * a22 - a12 * b2) / (a11 * a22 - std::norm(a12));
  };
  return {{fit(&transient::Frame::P), fit(&transient::Frame::H)},
          of_the_surface(at, k, v),
          at.rho_bar * std::abs(1.0 - v) / (at.eps * k * k)};
}

double degrees(Complex z) { return std::arg(z) * 180.0 / pi; }

// Relative difference of complex amplitudes: of size and phase together.
double difference(Complex measured, Complex theory) { return std::abs(measured / theory - 1.0); }

void check(double length, double v, int cells) {
  const Waves found = waves(length, v, cells);
  BOOST_TEST_MESSAGE("wave length " << length << " b, v/u " << v << ", |Q| " << found.Q << ": a/A "
                                    << std::abs(found.measured.a) << ", " << degrees(found.measured.a)
                                    << " deg (closed form " << std::abs(found.theory.a) << ", "
                                    << degrees(found.theory.a) << "); p/A " << std::abs(found.measured.p) << ", "
                                    << degrees(found.measured.p) << " deg (" << std::abs(found.theory.p) << ", "
                                    << degrees(found.theory.p) << "); 1 % allowed");
  BOOST_TEST(difference(found.measured.a, found.theory.a) < 0.01);
  BOOST_TEST(difference(found.measured.p, found.theory.p) < 0.01);
}

}  // namespace

BOOST_AUTO_TEST_CASE(moving_waves_agree_with_the_closed_form) {
  for (const double v : {0.25, 0.5, 0.75, 1.25, 1.5}) check(0.2, v, 1024);
  check(0.08, 0.5, 2048);
}

// Published: Hooke 2006, eqs (12) to (14), for waves at rest: |a/A| = 0.6326, -46.1 degrees at |Q| = 1.15.
BOOST_AUTO_TEST_CASE(waves_at_rest_agree_with_the_published_values) {
  const Waves found = waves(0.2, 0.0, 1024);
  const Complex published = std::polar(0.6326, -46.1 * pi / 180.0);
  BOOST_TEST_MESSAGE("waves at rest, |Q| " << found.Q << " (1.15): a/A " << std::abs(found.measured.a) << ", "
                                           << degrees(found.measured.a) << " deg (0.6326, -46.1; 1 % allowed)");
  BOOST_TEST(std::abs(found.Q / 1.15 - 1.0) < 0.01);
  BOOST_TEST(difference(found.measured.a, published) < 0.01);
  BOOST_TEST(difference(found.theory.a, published) < 0.01);
}

BOOST_AUTO_TEST_SUITE_END()
