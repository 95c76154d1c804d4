// Laws of liquids compared with their closed forms in long double, their limits, and values of real liquids.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "rheology/fluids.hpp"
#include "rheology/range.hpp"
#include "support/law_at.hpp"

BOOST_AUTO_TEST_SUITE(test_rheology_liquids)

using namespace ehl::rheology;

namespace {

constexpr double p_h = 1e9;
using Real = long double;

using support::value;

// Squalane at 40 C, an oil similar to Shell T9 at 25 C, and the lowest bulk modulus of oils.
const DoolittleConstants squalane{4.71, 0.6568, 1.192e9, 11.74, 0.0156};
const YasutomiConstants turbine_oil{25.0, -83.2, 188.95, 0.719e-9, 8.2e-9, -0.53, 16.09, 17.38, 1e12};

Real tait_volume(Real p, Real K0, Real K0_prime) { return 1 - std::log(1 + (1 + K0_prime) * p / K0) / (1 + K0_prime); }

Real doolittle_formula(const DoolittleConstants& c, Real p) {
  const Real v = tait_volume(p, c.K0, c.K0_prime), R0 = c.R0;
  return c.B * R0 * (1 / (v - R0) - 1 / (1 - R0));
}

// ln(eta/eta_g), as in the papers.
Real yasutomi_formula(const YasutomiConstants& c, Real p) {
  const Real Tg = c.Tg0 + c.A1 * std::log(1 + c.A2 * p), F = std::pow(1 + c.b1 * p, Real(c.b2));
  return -std::log(Real(10)) * c.C1 * (c.T - Tg) * F / (c.C2 + (c.T - Tg) * F);
}

}  // namespace

BOOST_AUTO_TEST_CASE(doolittle_against_its_formula) {
  const Doolittle law = make_doolittle(squalane, p_h);
  const double P_glass = law.u_glass / law.p_h_over_K0;
  double worst = 0.0;
  for (int k = 1; k <= 2000; ++k) {
    const double P = P_glass * k / 2000.0;
    const Real exact = doolittle_formula(squalane, Real(P) * p_h);
    worst = std::max(worst, std::abs(static_cast<double>(value(log_viscosity, law, P) / exact - 1)));
  }
  BOOST_TEST_MESSAGE("Doolittle up to " << P_glass << " GPa: relative error of ln eta " << worst
                                        << " (tolerance 1e-13)");
  BOOST_TEST(worst < 1e-13);
  // At this pressure the oil is a glass, 1e12 Pa s by definition.
  const double eta = squalane.eta0 * std::exp(value(log_viscosity, law, P_glass));
  BOOST_TEST(std::abs(eta / glass_viscosity - 1.0) < 1e-11);
  BOOST_TEST(value(log_viscosity, law, 0.0) == 0.0);
}

BOOST_AUTO_TEST_CASE(yasutomi_against_its_formula) {
  const Yasutomi law = make_yasutomi(turbine_oil, p_h);
  const double P_glass = law.p_glass / p_h;
  double worst = 0.0;
  for (int k = 1; k <= 2000; ++k) {
    const double P = P_glass * k / 2000.0;
    const Real exact = yasutomi_formula(turbine_oil, Real(P) * p_h) - yasutomi_formula(turbine_oil, 0);
    worst = std::max(worst, std::abs(static_cast<double>(value(log_viscosity, law, P) / exact - 1)));
  }
  BOOST_TEST_MESSAGE("Yasutomi up to " << P_glass << " GPa: relative error of ln eta " << worst
                                       << " (tolerance 1e-13)");
  BOOST_TEST(worst < 1e-13);
  // The glass transition: T = Tg(p), eta = eta_g.
  BOOST_TEST(std::abs(turbine_oil.Tg0 + turbine_oil.A1 * std::log1p(turbine_oil.A2 * law.p_glass) - 25.0) < 1e-12);
  const double eta = yasutomi_eta0(turbine_oil) * std::exp(value(log_viscosity, law, P_glass));
  BOOST_TEST(std::abs(eta / turbine_oil.eta_g - 1.0) < 1e-11);
  BOOST_TEST(value(log_viscosity, law, 0.0) == 0.0);
}

BOOST_AUTO_TEST_CASE(the_universal_constants_of_williams_landel_and_ferry) {
  // log10 of the shift 50 K above Tg, for the universal constants. source: Williams, Landel and Ferry (1955).
  YasutomiConstants universal = turbine_oil;
  universal.C1 = 17.44;
  universal.C2 = 51.6;
  universal.T = universal.Tg0 + 50.0;
  const double shift = std::log10(yasutomi_eta0(universal) / universal.eta_g);
  BOOST_TEST_MESSAGE("log10 of the shift " << shift << ", published -8.58");
  BOOST_TEST(std::abs(shift + 8.58) < 0.005);
}

BOOST_AUTO_TEST_CASE(beyond_the_glass_the_tangent) {
  const Doolittle doolittle = make_doolittle(squalane, p_h);
  const Yasutomi yasutomi = make_yasutomi(turbine_oil, p_h);
  for (const auto& [law, P_glass] :
       {std::pair<ViscosityLaw, double>{doolittle, doolittle.u_glass * 1.192}, {yasutomi, yasutomi.p_glass / p_h}}) {
    const double inside = P_glass * (1 - 1e-9), outside = P_glass * (1 + 1e-9);
    BOOST_TEST(std::abs(value(log_viscosity, law, outside) / value(log_viscosity, law, inside) - 1.0) < 1e-7);
    const double slope = value(log_viscosity_slope, law, outside);
    BOOST_TEST(std::abs(value(log_viscosity_slope, law, inside) / slope - 1.0) < 1e-7);
    const double rise = value(log_viscosity, law, P_glass + 7.0) - value(log_viscosity, law, P_glass + 1.0);
    BOOST_TEST(std::abs(rise / (6.0 * slope) - 1.0) < 1e-12);
    BOOST_TEST(std::isfinite(value(log_viscosity, law, 100.0)));
  }
}

BOOST_AUTO_TEST_CASE(equations_of_state_have_their_bulk_modulus) {
  // K = rho dp/drho. Murnaghan: K0 + K0' p at all pressures. Tait: K0 v [1 + (1 + K0') p/K0], with K0 and K0' at p = 0.
  const double K0 = 1.3e9, K0_prime = 11.0;
  const DensityLaw tait = make_tait(K0, K0_prime, p_h), murnaghan = make_murnaghan(K0, K0_prime, p_h);
  double worst_tait = 0.0, worst_murnaghan = 0.0, worst_volume = 0.0;
  for (int k = 0; k <= 400; ++k) {
    const double P = 0.01 * k, p = P * p_h;
    const auto modulus = [&](const DensityLaw& law) {
      return value(density, law, P) / value(density_slope, law, P) * p_h;
    };
    worst_murnaghan = std::max(worst_murnaghan, std::abs(modulus(murnaghan) / (K0 + K0_prime * p) - 1.0));
    const auto v = static_cast<double>(tait_volume(p, K0, K0_prime));
    worst_tait = std::max(worst_tait, std::abs(modulus(tait) / (K0 * v * (1.0 + (1.0 + K0_prime) * p / K0)) - 1.0));
    worst_volume = std::max(worst_volume, std::abs(value(density, tait, P) * v - 1.0));
  }
  BOOST_TEST_MESSAGE("bulk modulus 0-4 GPa: Tait " << worst_tait << ", Murnaghan " << worst_murnaghan
                                                   << "; volume of Tait " << worst_volume << " (tolerance 1e-13)");
  BOOST_TEST(worst_tait < 1e-13);
  BOOST_TEST(worst_murnaghan < 1e-13);
  BOOST_TEST(worst_volume < 1e-13);
  // With equal K0 and K0', the two laws differ by the third power of the pressure.
  const auto gap = [&](double P) { return value(density, murnaghan, P) - value(density, tait, P); };
  BOOST_TEST_MESSAGE("Murnaghan - Tait at 4 and 2 MPa: ratio " << gap(4e-3) / gap(2e-3) << ", third power 8");
  BOOST_TEST(std::abs(gap(4e-3) / gap(2e-3) - 8.0) < 0.5);
  for (const DensityLaw& law : {tait, murnaghan}) BOOST_TEST(value(density, law, 0.0) == 1.0);
}

BOOST_AUTO_TEST_CASE(tait_is_near_dowson_and_higginson_where_that_was_fitted) {
  // Both describe oils near room temperature; the law of Dowson and Higginson was fitted up to 0.4 GPa.
  const DensityLaw tait = make_tait(1.3e9, 11.0, p_h), fitted = make_dowson_higginson(p_h);
  double worst = 0.0;
  for (int k = 1; k <= 40; ++k)
    worst = std::max(worst, std::abs(value(density, tait, 0.01 * k) / value(density, fitted, 0.01 * k) - 1.0));
  BOOST_TEST_MESSAGE("Tait against Dowson-Higginson up to 0.4 GPa: " << worst << " (tolerance 0.02)");
  BOOST_TEST(worst < 0.02);
}

BOOST_AUTO_TEST_CASE(slopes_against_differences_from_0_to_4_GPa) {
  const auto fluid_table = [](auto law, std::vector<double>& p, std::vector<double>& column, double at_zero) {
    for (int k = 0; k <= 80; ++k) {
      p.push_back(0.05e9 * k);
      column.push_back(at_zero * law(p.back() / p_h));
    }
  };
  std::vector<double> p, eta, again, rho_column;
  const ViscosityLaw roelands = make_roelands(1.7e-8, roelands_p0, 0.6, p_h);
  const DensityLaw higginson = make_dowson_higginson(p_h);
  fluid_table([&](double P) { return std::exp(value(log_viscosity, roelands, P)); }, p, eta, 0.1);
  fluid_table([&](double P) { return value(density, higginson, P); }, again, rho_column, 870.0);
  const ViscosityLaw viscosities[] = {Barus{20.0}, roelands, make_doolittle(squalane, p_h),
                                      make_yasutomi(turbine_oil, p_h), make_tabulated_viscosity(p, eta, p_h)};
  const DensityLaw densities[] = {higginson, make_tait(1.2e9, 11.0, p_h), make_murnaghan(1.2e9, 11.0, p_h),
                                  make_tabulated_density(p, rho_column, p_h)};
  // Second order: tables and tangents have jumps in the second derivative, so the error is h^2
  // f'''/6, or h f''/2 at a jump.
  constexpr double h = 1e-5;
  double worst = 0.0;
  const auto check = [&](auto f, auto df, const auto& law, double P) {
    const double difference = (value(f, law, P + h) - value(f, law, P - h)) / (2 * h);
    worst = std::max(worst, std::abs(difference / value(df, law, P) - 1.0));
  };
  for (int k = 0; k < 400; ++k) {
    const double P = 0.005 + 0.01 * k;  // between the points of the tables
    for (const ViscosityLaw& law : viscosities) check(log_viscosity, log_viscosity_slope, law, P);
    for (const DensityLaw& law : densities) check(density, density_slope, law, P);
  }
  BOOST_TEST_MESSAGE("slopes of nine laws, 0-4 GPa: relative gap to a difference " << worst << " (tolerance 1e-6)");
  BOOST_TEST(worst < 1e-6);
}

BOOST_AUTO_TEST_CASE(another_pressure_scale_is_the_same_liquid) {
  const std::vector<double> p{0.0, 1e9, 2e9, 3e9}, eta{0.1, 1e3, 1e6, 1e8}, rho_column{850.0, 1000.0, 1080.0, 1130.0};
  const ViscosityLaw viscosities[] = {make_doolittle(squalane, p_h), make_yasutomi(turbine_oil, p_h),
                                      make_tabulated_viscosity(p, eta, p_h)};
  const DensityLaw densities[] = {make_tait(1.2e9, 11.0, p_h), make_murnaghan(1.2e9, 11.0, p_h),
                                  make_tabulated_density(p, rho_column, p_h)};
  for (const double P : {0.1, 0.7, 2.0, 3.5}) {
    for (const ViscosityLaw& law : viscosities) {
      const double before = value(log_viscosity, law, P), after = value(log_viscosity, rescaled(law, 2.0), 0.5 * P);
      BOOST_TEST(std::abs(after / before - 1.0) < 1e-14);
      BOOST_TEST(std::abs(value(log_viscosity_slope, rescaled(law, 2.0), 0.5 * P) / value(log_viscosity_slope, law, P) -
                          2.0) < 1e-14);
    }
    for (const DensityLaw& law : densities)
      BOOST_TEST(std::abs(value(density, rescaled(law, 2.0), 0.5 * P) / value(density, law, P) - 1.0) < 1e-14);
  }
  for (const ViscosityLaw& law : viscosities) BOOST_TEST(value(fluidity, rescaled(law, 0.0), 2.0) == 1.0);
}

BOOST_AUTO_TEST_CASE(the_film_gets_both_laws_in_one_pass_and_in_any_length) {
  const ViscosityLaw law = make_doolittle(squalane, p_h);
  const DensityLaw tait = make_tait(1.192e9, 11.74, p_h);
  std::vector<double> P, phi(77), dense(77);
  for (int k = 0; k < 77; ++k) P.push_back(0.05 * k);
  film_properties(law, tait, P, phi, dense);
  for (std::size_t k = 0; k < P.size(); ++k) {
    BOOST_REQUIRE(phi[k] == value(fluidity, law, P[k]));
    BOOST_REQUIRE(dense[k] == value(density, tait, P[k]));
    if (k > 0) BOOST_REQUIRE(phi[k] < phi[k - 1]);
  }
  BOOST_TEST(phi[0] == 1.0);
}

BOOST_AUTO_TEST_CASE(what_leaves_its_range_is_named) {
  const Loading high{.P_max = 3.0, .p_h = p_h}, low{.P_max = 0.5, .p_h = p_h};
  const std::vector<double> p{0.0, 0.5e9, 1e9, 2e9}, eta{0.1, 1.0, 1e3, 1e5};
  for (const ViscosityLaw& law :
       {ViscosityLaw{make_doolittle(squalane, p_h)}, ViscosityLaw{make_yasutomi(turbine_oil, p_h)},
        ViscosityLaw{make_tabulated_viscosity(p, eta, p_h)}}) {
    BOOST_TEST(out_of_range(law, Incompressible{}, low).empty());
    const auto found = out_of_range(law, make_tait(1.2e9, 11.0, p_h), high);
    BOOST_REQUIRE(found.size() == 1);
    BOOST_TEST_MESSAGE(found[0].text);
    BOOST_TEST(found[0].text.find("3 GPa") != std::string::npos);
  }
}

// A grade may refer to the source of the first grade of its kind.
BOOST_AUTO_TEST_CASE(every_fluid_names_its_source) {
  const auto kind = [](std::string_view name) { return name.substr(0, name.find_first_of("0123456789")); };
  std::string_view told;
  for (const Fluid& fluid : fluids) {
    BOOST_TEST(fluid.source.empty() == fluid.about.empty(), fluid.name);
    if (!fluid.source.empty()) told = kind(fluid.name);
    BOOST_TEST(kind(fluid.name) == told, fluid.name);
    BOOST_TEST(find_fluid(fluid.name) == &fluid, fluid.name);
  }
  BOOST_TEST(find_fluid("water") == nullptr);
}

BOOST_AUTO_TEST_SUITE_END()
