// Laws of pressure and temperature: compared with the isothermal laws at the other temperature and with closed forms,
// and their derivatives with differences; at its own temperature, each law is exactly isothermal. Solids by name.
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "core/errors.hpp"
#include "rheology/solids.hpp"
#include "rheology/thermal_properties.hpp"
#include "rheology/thermal_viscosity.hpp"

BOOST_AUTO_TEST_SUITE(test_rheology_thermal_laws)

using namespace ehl::rheology;

namespace {

constexpr double p_h = 1e9, T0 = 313.15;

struct At {
  double D, slope;
};
At change(const ThermalViscosity& law, const ViscosityLaw& isothermal, double P, double theta) {
  const double log_eta = log_viscosity_at(isothermal, P);
  At at{};
  log_viscosity_change(law, {&P, 1}, {&log_eta, 1}, {&theta, 1}, {&at.D, 1}, {&at.slope, 1});
  return at;
}

struct Case {
  const char* name;
  ViscosityLaw isothermal;
  TemperatureConstants constants;
  double P_max;
};

const DoolittleConstants squalane{4.71, 0.6568, 1.192e9, 11.74, 0.0156};
constexpr VolumeOfTemperature volume{8.36e-4, 6.332e-3};
constexpr double occupied = -7e-4;
const YasutomiConstants glassy{40.0, -83.2, 188.95, 0.719e-9, 8.2e-9, -0.53, 16.09, 17.38, 1e12};
constexpr double kv40 = 68, kv100 = 8.53, density15 = 881;

DataSheet data_sheet() { return {make_walther(kv40, kv100), density15}; }
double data_sheet_eta(double T_celsius) {
  return 1e-6 * kinematic_viscosity(make_walther(kv40, kv100), T_celsius) * oil_density(density15, T_celsius);
}
Roelands roelands_at(double T_celsius, double z) {
  return make_roelands(z * roelands_log_ratio(data_sheet_eta(T_celsius)) / roelands_p0, roelands_p0, z, p_h);
}

std::vector<Case> all_laws() {
  const Roelands roelands = roelands_at(40, 0.6);
  const double eta0 = data_sheet_eta(40);
  return {{"barus, beta", make_barus(20e-9, p_h), {T0, Exponential{0.042}}, 1.0},
          {"roelands, Houpert", roelands, {T0, make_houpert(0.042, eta0, T0)}, 2.0},
          {"roelands, Vogel", roelands, {T0, Vogel{900.0, 180.0}}, 2.0},
          {"roelands, D341", roelands, {T0, data_sheet()}, 2.0},
          {"roelands, D341 of a thin oil", roelands, {T0, DataSheet{make_walther(1.5, 0.7), 750}}, 2.0},
          {"doolittle", make_doolittle(squalane, p_h), {T0, {}, volume, occupied}, 3.0},
          {"yasutomi", make_yasutomi(glassy, p_h), {T0}, 3.0}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_changes_at_its_own_temperature) {
  for (const Case& c : all_laws()) {
    const ThermalViscosity law = make_thermal_viscosity(c.isothermal, c.constants);
    for (int k = 0; k <= 300; ++k) BOOST_REQUIRE_EQUAL(change(law, c.isothermal, c.P_max * k / 300, 0.0).D, 0.0);
  }
  std::vector<double> P, theta(37, 0.0), ratio(37), expansion(37), heat(37), k_bar(37);
  for (int k = 0; k < 37; ++k) P.push_back(0.07 * k);
  for (const DensityLaw& at : {DensityLaw{make_dowson_higginson(p_h)}, DensityLaw{make_tait(1.2e9, 11.7, p_h)},
                               DensityLaw{make_murnaghan(1.2e9, 11.7, p_h)}}) {
    const bool liquid = !std::holds_alternative<DowsonHigginson>(at);
    std::variant<Expansion, EquationOfState> expands = Expansion{6.5e-4, 0.7};
    if (liquid) expands = EquationOfState{volume};
    density_change(make_thermal_density(at, T0, expands), P, theta, ratio, expansion);
    for (const double r : ratio) BOOST_REQUIRE_EQUAL(r, 1.0);
  }
}

BOOST_AUTO_TEST_CASE(slopes_against_differences) {
  constexpr double step = 1e-4;
  for (const Case& c : all_laws()) {
    const ThermalViscosity law = make_thermal_viscosity(c.isothermal, c.constants);
    double worst = 0.0;
    for (int k = 0; k <= 60; ++k)
      for (const double theta : {-0.05, 0.0, 0.03, 0.15, 0.4}) {
        const double P = c.P_max * k / 60;
        const auto D = [&](double t) { return change(law, c.isothermal, P, t).D; };
        const double difference =
            (D(theta - 2 * step) - 8 * D(theta - step) + 8 * D(theta + step) - D(theta + 2 * step)) / (12 * step);
        const double slope = change(law, c.isothermal, P, theta).slope;
        worst = std::max(worst, std::abs(slope / difference - 1.0));
        BOOST_REQUIRE(slope < 0.0);
      }
    // The tolerance covers the rounding of D divided by the step, and the kink where the oil becomes a glass.
    const double tolerance = c.P_max > 2.0 ? 2e-5 : 1e-8;
    BOOST_TEST_MESSAGE(c.name << ": slope " << worst << " off (tolerance " << tolerance << ")");
    BOOST_TEST(worst < tolerance);
  }
}

BOOST_AUTO_TEST_CASE(closed_forms) {
  const double eta0 = data_sheet_eta(40), A = roelands_log_ratio(eta0), z = 0.6;
  const Roelands roelands = roelands_at(40, z);
  const Houpert houpert = make_houpert(0.042, eta0, T0);
  const ThermalViscosity law = make_thermal_viscosity(roelands, {T0, houpert});
  double worst = 0.0;
  for (const double p : {0.0, 0.3e9, 1e9, 2e9})
    for (const double T : {280.0, 320.0, 400.0, 600.0}) {
      const double exact = A * (std::pow(1 + p / roelands_p0, z) * std::pow((T - 138) / (T0 - 138), -houpert.S0) - 1);
      const double found = log_viscosity_at(roelands, p / p_h) + change(law, roelands, p / p_h, (T - T0) / T0).D;
      worst = std::max(worst, std::abs(found - exact));
    }
  BOOST_TEST_MESSAGE("Houpert: ln eta_bar " << worst << " off (tolerance 1e-12, rounding of 30)");
  BOOST_TEST(worst < 1e-12);
  BOOST_TEST(std::abs(change(law, roelands, 0.0, 0.0).slope + 0.042 * T0) < 1e-12);
  const double vogel = log_ambient_change(Vogel{900, 180}, T0, 373.15);
  BOOST_TEST(std::abs(vogel - (900 / (373.15 - 180) - 900 / (T0 - 180))) < 1e-13);
  // Below the pole there is no viscosity.
  BOOST_TEST(std::isnan(change(law, roelands, 0.5, (120.0 - T0) / T0).D));
  BOOST_TEST(std::isnan(log_ambient_change(Vogel{900, 180}, T0, 170)));
}

BOOST_AUTO_TEST_CASE(an_oil_at_another_temperature_is_the_isothermal_oil_of_there) {
  constexpr double other = 80.0, theta = (other - 40.0) / T0;
  double worst = 0.0;
  const auto compare = [&](const ThermalViscosity& law, const ViscosityLaw& here, const ViscosityLaw& there,
                           double log_ratio, const char* name) {
    double gap = 0.0;
    for (int k = 0; k <= 300; ++k) {
      const double P = 2.5 * k / 300;
      const double found = log_viscosity_at(here, P) + change(law, here, P, theta).D;
      gap = std::max(gap, std::abs(found - log_viscosity_at(there, P) - log_ratio));
    }
    BOOST_TEST_MESSAGE(name << " at 80 C: ln eta " << gap << " off (tolerance 1e-11)");
    worst = std::max(worst, gap);
  };
  const Roelands at_40 = roelands_at(40, 0.6), at_80 = roelands_at(80, 0.6);
  compare(make_thermal_viscosity(at_40, {T0, data_sheet()}), at_40, at_80,
          std::log(data_sheet_eta(80) / data_sheet_eta(40)), "roelands with D341");
  YasutomiConstants warm = glassy;
  warm.T = other;
  compare(make_thermal_viscosity(make_yasutomi(glassy, p_h), {T0}), make_yasutomi(glassy, p_h),
          make_yasutomi(warm, p_h), std::log(yasutomi_eta0(warm) / yasutomi_eta0(glassy)), "yasutomi");
  // Doolittle: occupied volume relative to the volume at ambient pressure and 80 C.
  const double expanded = 1 + volume.a_V * 40, R = squalane.R0 * (1 + occupied * 40);
  DoolittleConstants hot = squalane;
  hot.R0 = R / expanded;
  hot.B = squalane.B;
  hot.K0 = squalane.K0 * std::exp(-volume.beta_K * 40);
  const double log_ratio = squalane.B * (R / (expanded - R) - squalane.R0 / (1 - squalane.R0));
  hot.eta0 = squalane.eta0 * std::exp(log_ratio);
  compare(make_thermal_viscosity(make_doolittle(squalane, p_h), {T0, {}, volume, occupied}),
          make_doolittle(squalane, p_h), make_doolittle(hot, p_h), log_ratio, "doolittle");
  BOOST_TEST(worst < 1e-11);
}

BOOST_AUTO_TEST_CASE(density_and_heat) {
  const std::array<double, 3> P{0.0, 0.5, 1.5};
  for (const double T : {280.0, 353.15, 450.0}) {
    const double theta = (T - T0) / T0;
    const std::array<double, 3> thetas{theta, theta, theta};
    std::array<double, 3> ratio{}, expansion{}, up{}, down{}, scratch{};
    const double K0 = 1.3e9, K0_prime = 10.5;
    for (const bool tait : {true, false}) {
      const auto at = [&](double K) {
        return tait ? DensityLaw{make_tait(K, K0_prime, p_h)} : DensityLaw{make_murnaghan(K, K0_prime, p_h)};
      };
      const ThermalDensity law = make_thermal_density(at(K0), T0, EquationOfState{volume});
      density_change(law, P, thetas, ratio, expansion);
      std::array<double, 3> here{}, there{};
      density(at(K0), P, here);
      density(at(K0 * std::exp(-volume.beta_K * (T - T0))), P, there);
      constexpr double step = 1e-5;
      density_change(law, P, std::array{theta + step, theta + step, theta + step}, up, scratch);
      density_change(law, P, std::array{theta - step, theta - step, theta - step}, down, scratch);
      for (std::size_t k = 0; k < 3; ++k) {
        const double exact = there[k] / here[k] / (1 + volume.a_V * (T - T0));
        BOOST_TEST(std::abs(ratio[k] / exact - 1.0) < 1e-14);
        const double difference = -std::log(up[k] / down[k]) / (2 * step);
        BOOST_TEST(std::abs(expansion[k] - difference) < 1e-9);
      }
    }
  }
  // k and rho c relative to ambient pressure. source: Larsson and Andersson (2000).
  const std::array<double, 4> p{0.0, 0.5, 1.0, 2.0}, cold{};
  std::array<double, 4> k_bar{}, heat{};
  conductivity(LarssonAndersson{T0, 1.0}, p, k_bar);
  heat_capacity(LarssonAndersson{T0, 1.0}, p, cold, heat);
  const std::array<double, 4> k_known{1.0, 1.68, 2.12, 2.65}, heat_known{1.0, 1.17, 1.26, 1.36};
  for (std::size_t k = 0; k < 4; ++k) {
    BOOST_TEST(std::abs(k_bar[k] - k_known[k]) < 0.005 + 1e-12);
    BOOST_TEST(std::abs(heat[k] - heat_known[k]) < 0.005 + 1e-12);
  }
  conductivity(ConstantHeat{}, p, k_bar);
  for (const double k : k_bar) BOOST_TEST(k == 1.0);
}

BOOST_AUTO_TEST_CASE(laws_without_a_temperature_are_refused) {
  using ehl::core::InputError;
  const auto names = [](const char* word) {
    return [word](const InputError& error) { return std::string(error.what()).find(word) != std::string::npos; };
  };
  BOOST_CHECK_EXCEPTION(make_thermal_viscosity(Isoviscous{}, {T0, Exponential{0.04}}), InputError, names("isoviscous"));
  BOOST_CHECK_EXCEPTION(make_thermal_viscosity(roelands_at(40, 0.6), {T0}), InputError, names("beta"));
  BOOST_CHECK_EXCEPTION(make_thermal_viscosity(make_doolittle(squalane, p_h), {T0}), InputError, names("a_V"));
  const std::array<double, 4> p{0, 1e8, 5e8, 1e9}, eta{0.01, 0.1, 1, 10};
  BOOST_CHECK_EXCEPTION(make_thermal_viscosity(make_tabulated_viscosity(p, eta, p_h), {T0, Exponential{0.04}}),
                        InputError, names("table"));
  BOOST_CHECK_EXCEPTION(make_thermal_density(make_dowson_higginson(p_h), T0, EquationOfState{volume}), InputError,
                        names("a_V"));
}

BOOST_AUTO_TEST_CASE(solids_by_name) {
  for (const Solid& solid : solids) {
    BOOST_TEST(find_solid(solid.name) == &solid);
    BOOST_TEST(!solid.source.empty());
    // kappa = k/(rho c): 0.5e-6 (glass) to 3e-5 m^2/s (tungsten carbide).
    const double kappa = solid.k / (solid.rho * solid.c);
    BOOST_TEST((kappa > 4e-7 && kappa < 4e-5 && solid.nu > 0.1 && solid.nu < 0.4 && solid.E > 5e10), solid.name);
  }
  BOOST_TEST(solid_by_name("steel").k == 46.0);
  BOOST_CHECK_EXCEPTION(solid_by_name("cheese"), ehl::core::InputError, [](const auto& error) {
    const std::string text = error.what();
    return text.find("cheese") != std::string::npos && text.find("sapphire") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
