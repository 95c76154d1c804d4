// The laws compared with their formulas in long double, their derivatives with differences, and their limits.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "core/errors.hpp"
#include "support/law_at.hpp"

BOOST_AUTO_TEST_SUITE(test_rheology_laws)

using namespace ehl::rheology;

namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();
constexpr double alpha = 1.7e-8;  // the mineral oil of the papers on circular contacts
constexpr double p_h = 0.789e9;

using support::value;

// ln(eta_bar) from the constants of the law, in long double.
long double exact_log_eta(const Roelands& law, long double P) {
  const auto A = static_cast<long double>(law.alpha_p0_over_z);
  return A * std::expm1(static_cast<long double>(law.z) * std::log1p(static_cast<long double>(law.p_h_over_p0) * P));
}

// The derivative by a five-point difference in double; its error is about ulp/step + step^4.
template <class Law, class F>
double difference(F f, const Law& law, double P) {
  const double h = 1e-3;
  return (value(f, law, P - 2 * h) - 8 * value(f, law, P - h) + 8 * value(f, law, P + h) - value(f, law, P + 2 * h)) /
         (12 * h);
}

}  // namespace

BOOST_AUTO_TEST_CASE(roelands_against_long_double) {
  double worst_log = 0.0, worst_fluidity = 0.0;
  for (const double z : {0.45, 0.6, 0.68, 1.0}) {
    const Roelands law = make_roelands(alpha, roelands_p0, z, p_h);
    for (int k = 1; k <= 4000; ++k) {
      const double P = 2.5 * k / 4000.0;
      const long double exact = exact_log_eta(law, P);
      const long double exact_fluidity = std::exp(-exact);
      worst_log =
          std::max(worst_log, std::abs(static_cast<double>((value(log_viscosity, law, P) - exact) / exact)) / ulp);
      // A relative error e of the exponent causes a relative error e*exponent of the fluidity.
      const double allowed = 4.0 + 4.0 * static_cast<double>(exact);
      const auto error = static_cast<double>(std::abs(value(fluidity, law, P) - exact_fluidity) / exact_fluidity) / ulp;
      worst_fluidity = std::max(worst_fluidity, error / allowed);
    }
  }
  BOOST_TEST_MESSAGE("ln(eta): " << worst_log << " ulp (tolerance 4); fluidity: " << worst_fluidity
                                 << " of the allowed 4 (1 + ln eta) ulp");
  BOOST_TEST(worst_log <= 4.0);
  BOOST_TEST(worst_fluidity <= 1.0);
}

BOOST_AUTO_TEST_CASE(barus_against_long_double_up_to_underflow) {
  double worst = 0.0;
  for (const double alpha_bar : {13.42, 100.0, 700.0}) {
    for (int k = 0; k <= 2000; ++k) {
      const double P = k / 2000.0;
      const double exponent = alpha_bar * P;
      const long double exact = std::exp(-static_cast<long double>(exponent));
      worst = std::max(worst, static_cast<double>(std::abs(value(fluidity, Barus{alpha_bar}, P) - exact) / exact));
    }
  }
  BOOST_TEST_MESSAGE("fluidity with the rounded exponent: " << worst / ulp << " ulp (tolerance 4)");
  BOOST_TEST(worst <= 4.0 * ulp);
}

BOOST_AUTO_TEST_CASE(extreme_pressures_neither_overflow_nor_turn_into_nan) {
  for (const double alpha_bar : {700.0, 745.0, 800.0, 5000.0}) {
    double previous = 1.0;
    for (int k = 0; k <= 1500; ++k) {
      const double phi = value(fluidity, Barus{alpha_bar}, k / 1000.0);
      BOOST_REQUIRE(phi >= 0.0);
      BOOST_REQUIRE(phi <= previous);
      previous = phi;
    }
    BOOST_TEST(value(log_viscosity, Barus{alpha_bar}, 1.5) == 1.5 * alpha_bar);
  }
  BOOST_TEST(value(fluidity, Barus{700.0}, 1.0) > 0.0);
  BOOST_TEST(value(fluidity, Barus{5000.0}, 1.0) == 0.0);
  // At 40 GPa the exponent of Roelands' law exceeds 745.
  const Roelands steep = make_roelands(4e-8, roelands_p0, 0.7, 4e10);
  BOOST_TEST(value(log_viscosity, steep, 1.0) > 0.0);
  BOOST_TEST(std::isfinite(value(log_viscosity, steep, 1.0)));
  BOOST_TEST(value(fluidity, steep, 2.5) >= 0.0);
}

BOOST_AUTO_TEST_CASE(ambient_pressure_changes_nothing) {
  const ViscosityLaw laws[] = {Isoviscous{}, Barus{20.0}, make_roelands(alpha, roelands_p0, 0.6, p_h)};
  for (const ViscosityLaw& law : laws) {
    BOOST_TEST(value(fluidity, law, 0.0) == 1.0);
    BOOST_TEST(value(log_viscosity, law, 0.0) == 0.0);
  }
  for (const DensityLaw& law : {DensityLaw{Incompressible{}}, DensityLaw{make_dowson_higginson(p_h)}}) {
    BOOST_TEST(value(density, law, 0.0) == 1.0);
  }
}

BOOST_AUTO_TEST_CASE(roelands_becomes_barus) {
  // For p0 -> infinity at fixed alpha, ln eta = alpha p + (z-1) alpha p^2/(2 p0) + ..., so the
  // difference decreases as 1/p0.
  const Barus barus = make_barus(alpha, p_h);
  double gap_before = 0.0;
  for (const double p0 : {1e12, 1e13, 1e14}) {
    const Roelands law = make_roelands(alpha, p0, 0.6, p_h);
    const double gap = value(log_viscosity, law, 1.0) / value(log_viscosity, barus, 1.0) - 1.0;
    const double expected = (0.6 - 1.0) * p_h / (2.0 * p0);
    BOOST_TEST_MESSAGE("p0 = " << p0 << ": relative gap " << gap << ", second term of the series " << expected);
    BOOST_TEST(std::abs(gap / expected - 1.0) < 2.0 * p_h / p0);
    if (gap_before != 0.0) BOOST_TEST(std::abs(gap_before / gap - 10.0) < 0.02);
    gap_before = gap;
  }
  const Roelands at_one = make_roelands(alpha, roelands_p0, 1.0, p_h);
  for (const double P : {0.1, 0.5, 1.0, 1.7}) {
    const double gap = value(log_viscosity, at_one, P) / value(log_viscosity, barus, P) - 1.0;
    BOOST_TEST(std::abs(gap) <= 4.0 * ulp);
  }
}

BOOST_AUTO_TEST_CASE(roelands_exponent_of_a_known_oil) {
  // Mourier et al. (2006): eta0 = 0.25 Pa s, alpha = 22/GPa gives z = 0.5205.
  const double z = roelands_z(22e-9, roelands_p0, 0.25);
  BOOST_TEST_MESSAGE("z = " << z << ", expected 0.5205 to the digits given");
  BOOST_TEST(std::abs(z - 0.5205) < 0.5e-4);
  // Roelands' pole: for any oil, eta0 eta_bar -> exp(-9.67) at p = -p0.
  const Roelands law = make_roelands(22e-9, roelands_p0, z, roelands_p0);
  BOOST_TEST(std::abs(std::log(0.25) + value(log_viscosity, law, -1.0 + 1e-15) - (-9.67)) < 1e-6);
  BOOST_CHECK_THROW(roelands_z(22e-9, roelands_p0, 5e-5), ehl::core::InputError);
}

BOOST_AUTO_TEST_CASE(slopes_against_differences) {
  const Roelands roelands = make_roelands(alpha, roelands_p0, 0.6, p_h);
  const DowsonHigginson dowson_higginson = make_dowson_higginson(p_h);
  double worst = 0.0;
  for (int k = 1; k <= 200; ++k) {
    const double P = 0.01 * k;
    const double slope = value(log_viscosity_slope, roelands, P);
    worst = std::max(
        worst, std::abs(difference<ViscosityLaw>(support::OfViscosity(log_viscosity), roelands, P) / slope - 1.0));
    const double density_s = value(density_slope, dowson_higginson, P);
    const auto f = static_cast<void (*)(const DensityLaw&, std::span<const double>, std::span<double>)>(density);
    worst = std::max(worst, std::abs(difference<DensityLaw>(f, dowson_higginson, P) / density_s - 1.0));
  }
  BOOST_TEST_MESSAGE("slopes: relative gap to a fourth-order difference " << worst << " (tolerance 1e-9)");
  BOOST_TEST(worst < 1e-9);
  BOOST_TEST(value(log_viscosity_slope, Barus{13.0}, 0.7) == 13.0);
  BOOST_TEST(value(log_viscosity_slope, Isoviscous{}, 0.7) == 0.0);
  BOOST_TEST(value(density_slope, Incompressible{}, 0.7) == 0.0);
}

BOOST_AUTO_TEST_CASE(dowson_higginson_values_and_limits) {
  // p = 0.59 GPa: (1 + 1.34)/2. p = 1 GPa: 1.93/1.59. p -> infinity: 1.34.
  BOOST_TEST(std::abs(value(density, make_dowson_higginson(5.9e8), 1.0) - 1.17) < 2 * ulp);
  BOOST_TEST(std::abs(value(density, make_dowson_higginson(1e9), 1.0) - 1.93 / 1.59) < 2 * ulp);
  BOOST_TEST(std::abs(value(density, make_dowson_higginson(1e9), 1e18) - 1.34) < 2 * ulp);
  // At ambient pressure the derivative is 0.34 p_h/B.
  BOOST_TEST(std::abs(value(density_slope, make_dowson_higginson(1e9), 0.0) - 0.34 / 0.59) < 2 * ulp);
}

BOOST_AUTO_TEST_CASE(slightly_negative_pressure_continues_the_formula_up_to_the_pole) {
  const Roelands law = make_roelands(alpha, roelands_p0, 0.6, p_h);
  const double P = -1e-3;
  const long double exact = std::exp(-exact_log_eta(law, P));
  BOOST_TEST(std::abs(static_cast<double>(value(fluidity, law, P) / exact) - 1.0) < 8 * ulp);
  BOOST_TEST(value(fluidity, law, P) > 1.0);
  const double pole = -1.0 / law.p_h_over_p0;
  BOOST_TEST(std::isnan(value(fluidity, law, 1.0001 * pole)));
  BOOST_TEST(std::isnan(value(fluidity, make_roelands(alpha, 2e8, 0.6, 2e8), -1.0)));
  BOOST_TEST(std::isnan(value(log_viscosity_slope, law, 2.0 * pole)));
  BOOST_TEST(std::isnan(value(log_viscosity_slope, make_roelands(alpha, 2e8, 0.6, 2e8), -1.0)));
  BOOST_TEST(std::isnan(value(fluidity, law, std::nan(""))));
  BOOST_TEST(std::isnan(value(fluidity, Barus{10.0}, std::nan(""))));
}

BOOST_AUTO_TEST_CASE(a_value_depends_neither_on_length_nor_on_position) {
  const ViscosityLaw law = make_roelands(alpha, roelands_p0, 0.6, p_h);
  const DensityLaw rho = make_dowson_higginson(p_h);
  std::vector<double> P(333);
  // There are long intervals of zero between the peaks, so that whole chunks are skipped.
  for (std::size_t k = 0; k < P.size(); ++k) P[k] = std::max(0.0, 1.3 * std::sin(0.021 * static_cast<double>(k)));
  for (std::size_t length = 0; length <= P.size(); length = length < 20 ? length + 1 : length + 31) {
    for (const std::size_t offset : {std::size_t{0}, std::size_t{1}, P.size() - length}) {
      if (offset + length > P.size()) continue;
      const auto part = std::span<const double>(P).subspan(offset, length);
      // A guard value behind the end, which must not be changed.
      std::vector<double> phi(length + 1, -7.0), dense(length + 1, -7.0), phi_alone(length + 1, -7.0);
      film_properties(law, rho, part, {phi.data(), length}, {dense.data(), length});
      fluidity(law, part, {phi_alone.data(), length});
      for (std::size_t k = 0; k < length; ++k) {
        BOOST_REQUIRE(phi[k] == value(fluidity, law, part[k]));
        BOOST_REQUIRE(phi_alone[k] == phi[k]);
        BOOST_REQUIRE(dense[k] == value(density, rho, part[k]));
      }
      BOOST_REQUIRE(phi[length] == -7.0);
      BOOST_REQUIRE(dense[length] == -7.0);
      BOOST_REQUIRE(phi_alone[length] == -7.0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
