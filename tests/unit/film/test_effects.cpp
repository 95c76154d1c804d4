// Factors on the coefficients: their influence on the fluidity, on epsilon and on the mass that the wedge carries, at
// the nodes and at half points.
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "film/model.hpp"

BOOST_AUTO_TEST_SUITE(test_film_effects)

using namespace ehl;

namespace {

constexpr double fluidity_factor = 3.0, mobility_factor = 1.7, carried_factor = 0.8;
constexpr std::size_t nodes = 4;

struct Values {
  std::vector<double> eps = std::vector<double>(nodes), across = eps, rho = eps, drho = eps;
  std::vector<double> fluidity = eps, log_viscosity = eps, fluidity_across = eps, log_across = eps, oil_rho = eps,
                      oil_drho = eps;
};

Values values_of(bool thins, bool acts) {
  const core::Patch grid{core::Grid{8, nodes - 1, 0.0, 1.0, 0.0, 1.0}};
  film::Model model{.lambda = 0.3, .viscosity = rheology::Barus{5.0}, .density = rheology::make_dowson_higginson(1e9)};
  if (thins) model.thinning = rheology::ShearThinning{rheology::Eyring{}, 0.05};
  model.has_factors = acts;
  film::FactorFields factors = film::unit_factors(grid);
  factors.fluidity.fill(fluidity_factor);
  for (core::Field* mobility : {&factors.mobility, &factors.mobility_across}) mobility->fill(mobility_factor);
  factors.carried.fill(carried_factor);
  const std::vector<double> P{0.1, 0.3, 0.6, 0.9}, H{0.2, 0.15, 0.12, 0.1};
  const film::Station station{grid, 3, P, H, false, acts ? &factors : nullptr};
  film::Buffers buffers = film::make_buffers(model, nodes);
  Values v;
  const auto when = [thins](std::vector<double>& of) { return thins ? std::span<double>(of) : std::span<double>{}; };
  film::coefficients(model, station, buffers, {v.eps, when(v.across), v.rho, v.drho});
  film::oil(model, station, buffers,
            {v.fluidity, v.log_viscosity, when(v.fluidity_across), when(v.log_across), v.oil_rho, v.oil_drho});
  return v;
}

}  // namespace

BOOST_AUTO_TEST_CASE(factors_change_fluidity_epsilon_and_flow) {
  const Values before = values_of(false, false), behind = values_of(false, true);
  for (std::size_t k = 0; k < nodes; ++k) {
    BOOST_TEST(std::abs(behind.eps[k] / before.eps[k] - fluidity_factor * mobility_factor) < 1e-14);
    BOOST_TEST(std::abs(behind.rho[k] / before.rho[k] - carried_factor) < 1e-15);
    BOOST_TEST(std::abs(behind.drho[k] / before.drho[k] - carried_factor) < 1e-15);
    // At half points, epsilon is rho times fluidity and has the same factor.
    const double between = behind.oil_rho[k] * behind.fluidity[k] / (before.oil_rho[k] * before.fluidity[k]);
    BOOST_TEST(std::abs(between - fluidity_factor * mobility_factor) < 1e-14);
    BOOST_TEST(std::abs(std::exp(-behind.log_viscosity[k]) / behind.fluidity[k] - 1) < 1e-13);
    BOOST_TEST(behind.oil_rho[k] == behind.rho[k]);
  }
}

BOOST_AUTO_TEST_CASE(a_thinned_film_meets_the_changed_fluidity) {
  // Eyring with three times the fluidity: eps_x = H^3 rho phi sqrt(1 + s^2), s = k/(H phi).
  const Values before = values_of(true, false), behind = values_of(true, true);
  const std::array<double, nodes> P{0.1, 0.3, 0.6, 0.9}, H{0.2, 0.15, 0.12, 0.1};
  for (std::size_t k = 0; k < nodes; ++k) {
    const double phi = std::exp(-5.0 * P[k]), s = 0.05 / (H[k] * phi), s_behind = s / fluidity_factor;
    const double along = fluidity_factor * std::sqrt((1 + s_behind * s_behind) / (1 + s * s));
    BOOST_TEST(std::abs(behind.eps[k] / before.eps[k] - mobility_factor * along) < 1e-12);
    const double across = fluidity_factor * (s_behind / std::asinh(s_behind)) / (s / std::asinh(s));
    BOOST_TEST(std::abs(behind.across[k] / before.across[k] - mobility_factor * across) < 1e-12);
    for (const auto& [fluidity, log_viscosity] : {std::pair{behind.fluidity[k], behind.log_viscosity[k]},
                                                  std::pair{behind.fluidity_across[k], behind.log_across[k]}})
      BOOST_TEST(std::abs(std::exp(-log_viscosity) / fluidity - 1) < 1e-12);
    BOOST_TEST(std::abs(behind.oil_rho[k] * behind.fluidity[k] / (before.oil_rho[k] * before.fluidity[k]) -
                        mobility_factor * along) < 1e-12);
  }
}

// Beyond the limit the film has the viscosity limit/rate, so the stress of sliding is Lambda P, at least that at which
// thinning begins; and the slopes of epsilon are its differences.
BOOST_AUTO_TEST_CASE(a_limited_film_carries_the_limiting_stress) {
  const core::Patch grid{core::Grid{8, nodes - 1, 0.0, 1.0, 0.0, 1.0}};
  const double tau_c = 0.004, k = 0.05, Lambda = 0.012;
  film::Model model{.lambda = 0.3,
                    .viscosity = rheology::Barus{5.0},
                    .density = rheology::make_dowson_higginson(1e9),
                    .thinning = rheology::ShearThinning{rheology::Eyring{}, k},
                    .has_factors = true,
                    .limit = film::StressLimit{k * tau_c, Lambda}};
  const film::FactorFields factors = film::unit_factors(grid);
  film::Buffers buffers = film::make_buffers(model, nodes);
  const std::vector<double> P{0.1, 0.3, 0.6, 0.9}, H{0.2, 0.15, 0.12, 0.1};
  const auto values_at = [&](double more_P, double more_H) {
    std::vector<double> p = P, h = H;
    for (std::size_t n = 0; n < nodes; ++n) {
      p[n] += more_P;
      h[n] += more_H;
    }
    Values v;
    film::coefficients(model, {grid, 3, p, h, false, &factors, 2.0}, buffers, {v.eps, v.across, v.rho, v.drho});
    return v;
  };
  const Values v = values_at(0.0, 0.0);
  Values slope;
  film::slopes(model, {grid, 3, P, H, false, &factors, 2.0}, {v.eps, v.across, v.rho, v.drho}, buffers,
               {slope.eps, slope.rho, slope.across, slope.drho});
  const double d = 1e-6;
  for (std::size_t n = 0; n < nodes; ++n) {
    const double viscosity = v.rho[n] * std::pow(H[n], 3) / (model.lambda * v.across[n]);
    const double tau = viscosity * 2.0 * k * tau_c / H[n];
    const double free = tau_c * std::asinh(2.0 * k * std::exp(5.0 * P[n]) / H[n]);
    const double expected = std::min(free, std::max(Lambda * P[n], tau_c));
    BOOST_TEST_MESSAGE("stress " << tau << ", expected " << expected << ", without limit " << free << " (1e-10)");
    BOOST_TEST(std::abs(tau / expected - 1.0) < 1e-10);
    const auto off = [&](double by, const Values& up, const Values& down, std::vector<double> Values::*eps) {
      return std::abs(((up.*eps)[n] - (down.*eps)[n]) / (2.0 * d) / by - 1.0);
    };
    const Values P_up = values_at(d, 0), P_down = values_at(-d, 0), H_up = values_at(0, d), H_down = values_at(0, -d);
    BOOST_TEST(off(slope.eps[n], P_up, P_down, &Values::eps) < 1e-6);
    BOOST_TEST(off(slope.rho[n], H_up, H_down, &Values::eps) < 1e-6);
    BOOST_TEST(off(slope.across[n], P_up, P_down, &Values::across) < 1e-6);
    BOOST_TEST(off(slope.drho[n], H_up, H_down, &Values::across) < 1e-6);
  }
}

BOOST_AUTO_TEST_SUITE_END()
