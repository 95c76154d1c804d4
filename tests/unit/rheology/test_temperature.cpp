// Oils at a temperature: ISO 3448, ASTM D341, D2270 and D1250 compared with their worked examples, and
// Roelands' law with a given alpha*.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "deck/text.hpp"
#include "rheology/fluids.hpp"
#include "rheology/pressure_coefficient.hpp"
#include "rheology/temperature.hpp"

BOOST_AUTO_TEST_SUITE(test_rheology_temperature)

using namespace ehl::rheology;

namespace {

double number_of(const Fluid& fluid, const char* key) {
  return ehl::deck::read_number(std::string(value_of(fluid, key))).value;
}

// ASTM D2270, procedure A and the polynomials of its annex for 4.4 to 40 mm^2/s: the kinematic viscosities at 40 C of
// oils with this kv100 and with viscosity indices of 0 and 100.
struct Polynomials {
  double above, a, b, c, d, e, f;
};
constexpr Polynomials astm_d2270[] = {
    {4.4, 2.5, -7.2143, 13.812, 0.82143, 1.5679, 0.119},        {5.0, 0.101, 16.635, -45.469, 0.04985, 9.1613, -18.557},
    {6.4, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656}, {7.0, 0.01191, 21.475, -72.87, 0.79762, -0.7321, 14.61},
    {7.7, 0.41858, 16.1558, -56.04, 0.05794, 10.5156, -28.24},  {9.0, 0.88779, 7.5527, -16.6, 0.26665, 6.7015, -10.81},
    {12, 0.7672, 10.7972, -38.18, 0.20073, 8.4658, -22.49},     {15, 0.97305, 5.3135, -2.2, 0.28889, 5.9741, -4.93},
    {18, 0.97256, 5.25, -0.98, 0.24504, 7.416, -16.73},         {22, 0.91413, 7.4759, -21.82, 0.20323, 9.1267, -34.23},
    {28, 0.87031, 9.7157, -50.77, 0.18411, 10.1015, -46.75}};

double viscosity_index(double kv40, double kv100) {
  const Polynomials* here = &astm_d2270[0];
  for (const Polynomials& row : astm_d2270)
    if (kv100 >= row.above) here = &row;
  const double Y = kv100;
  const double L = (here->a * Y + here->b) * Y + here->c, H = (here->d * Y + here->e) * Y + here->f;
  return 100.0 * (L - kv40) / (L - H);
}

}  // namespace

BOOST_AUTO_TEST_CASE(mineral_oils_are_the_grades_of_iso_3448) {
  // The worked example of ASTM D2270: 73.30 and 8.86 mm^2/s give 92.43.
  BOOST_TEST(std::abs(viscosity_index(73.30, 8.86) - 92.43) < 0.05);
  for (const int grade : {32, 46, 68, 100, 150, 220, 320, 460}) {
    const Fluid* fluid = find_fluid("mineral-vg" + std::to_string(grade));
    BOOST_REQUIRE(fluid);
    BOOST_TEST(number_of(*fluid, "kv40") == grade);
    const double index = viscosity_index(grade, number_of(*fluid, "kv100"));
    BOOST_TEST_MESSAGE("ISO VG " << grade << ": viscosity index " << index << " (95 +- 0.2, four digits of kv100)");
    BOOST_TEST(std::abs(index - 95.0) < 0.2);
  }
}

BOOST_AUTO_TEST_CASE(named_oils_have_golds_coefficient) {
  // Gold et al., Journal of Synthetic Lubrication 18, 2001: ln(eta/eta0)/p up to 0.2 GPa. Roelands 1966: z of
  // mineral oils is about 0.6.
  constexpr double p = 0.2e9;
  for (const Fluid& fluid : fluids) {
    if (value_of(fluid, "kv40").empty()) continue;
    const bool mineral = fluid.name.starts_with("mineral");
    const double kv40 = number_of(fluid, "kv40");
    const double gold = mineral ? 9.904e-9 * std::pow(kv40, 0.1390) : 7.382e-9 * std::pow(kv40, 0.1335);
    const double eta0 = 1e-6 * kv40 * oil_density(number_of(fluid, "density15"), 40.0);
    const double z = roelands_z_of(number_of(fluid, "alpha_star"), roelands_p0, eta0);
    const double A = roelands_log_ratio(eta0);
    const double secant = log_viscosity_at(make_roelands(z * A / roelands_p0, roelands_p0, z, p), 1.0) / p;
    BOOST_TEST_MESSAGE(fluid.name << ": z = " << z << ", secant " << secant / gold - 1.0
                                  << " off (tolerance 5e-4: four "
                                  << "digits of alpha*)");
    BOOST_TEST(std::abs(secant / gold - 1.0) < 5e-4, fluid.name);
    BOOST_TEST(std::abs(z - (mineral ? 0.60 : 0.47)) < 0.01, fluid.name);
  }
}

BOOST_AUTO_TEST_CASE(walther_through_two_points) {
  struct Example {
    double kv40, kv100, T, nu, digits;
    const char* source;
  };
  // Public calculators of the standard; the last one uses 273 instead of 273.15.
  for (const Example& e : {Example{404, 28, 60, 132.126, 5e-4, "olezol.com"},
                           {68, 8.8, 80, 14.85, 2e-3, "olezol.com"},
                           {32, 5.4, 80, 8.5, 6e-3, "scribd.com, 361017004"}}) {
    const double nu = kinematic_viscosity(make_walther(e.kv40, e.kv100), e.T);
    BOOST_TEST_MESSAGE(e.kv40 << ", " << e.kv100 << " mm^2/s: at " << e.T << " C " << nu << ", " << e.source << " "
                              << e.nu << " (tolerance " << e.digits << ", its digits)");
    BOOST_TEST(std::abs(nu / e.nu - 1.0) < e.digits);
  }
  // The law reproduces its two points, even where the term for thin liquids matters.
  for (const auto& [kv40, kv100] : {std::pair{460.0, 30.0}, {18.4, 4.1}, {1.5, 0.7}, {0.5, 0.21}}) {
    const Walther law = make_walther(kv40, kv100);
    BOOST_TEST(std::abs(kinematic_viscosity(law, 40) / kv40 - 1.0) < 1e-12);
    BOOST_TEST(std::abs(kinematic_viscosity(law, 100) / kv100 - 1.0) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(density_expands_as_measured) {
  BOOST_TEST(oil_density(880, 15) == 880);
  // Shell T9, measured (Habchi 2018): 872 kg/m^3 at 25 C, V/V_25 = 1 + 7.734e-4 dT.
  double at_15 = 872;
  for (int k = 0; k < 20; ++k) at_15 *= 872 / oil_density(at_15, 25);
  for (const double T : {40.0, 80.0, 120.0}) {
    const double measured = 872 / (1 + 7.734e-4 * (T - 25));
    BOOST_TEST_MESSAGE("T9 at " << T << " C: " << oil_density(at_15, T) << ", measured " << measured);
    BOOST_TEST(std::abs(oil_density(at_15, T) / measured - 1.0) < 2e-3);
  }
}

BOOST_AUTO_TEST_CASE(roelands_law_of_a_stated_alpha_star) {
  // At z = 1/2 in closed form, with A = alpha p0/z = ln(eta0) + 9.67: 1/alpha* = 2 p0 (1/A + 1/A^2).
  for (const double A : {5.0, 7.0, 9.5}) {
    const double alpha_star = 1.0 / (2.0 * roelands_p0 * (1.0 / A + 1.0 / (A * A))), eta0 = std::exp(A - 9.67);
    const double z = roelands_z_of(alpha_star, roelands_p0, eta0);
    const double slope = roelands_alpha_of(alpha_star, roelands_p0, 0.5);
    BOOST_TEST_MESSAGE("alpha* = " << alpha_star << ": z - 0.5 = " << z - 0.5 << ", slope "
                                   << slope * roelands_p0 / (0.5 * A) - 1.0 << " off (tolerance 1e-11)");
    BOOST_TEST(std::abs(z - 0.5) < 1e-11);
    BOOST_TEST(std::abs(slope * roelands_p0 / (0.5 * A) - 1.0) < 1e-11);
  }
  // z = 1 is Barus' law; small and large z; an alpha* that no z can give.
  BOOST_TEST(std::abs(roelands_alpha_of(20e-9, roelands_p0, 1.0) / 20e-9 - 1.0) < 1e-11);
  for (const double z : {0.05, 1.5})
    for (const double alpha_star : {1e-12, 1e-6}) {
      const ViscosityLaw law = make_roelands(roelands_alpha_of(alpha_star, roelands_p0, z), roelands_p0, z, 1.0);
      BOOST_TEST(std::abs(pressure_coefficients(law).alpha_star / alpha_star - 1.0) < 1e-10);
    }
  BOOST_TEST(std::isnan(roelands_z_of(1e-7, roelands_p0, 0.1)));
  BOOST_TEST(std::isnan(roelands_z_of(20e-9, roelands_p0, 5e-5)));
}

BOOST_AUTO_TEST_CASE(one_z_at_every_temperature) {
  // Viscosity [mPa s] and alpha [1/GPa] of mineral oils at 30, 60 and 100 C. source: Stachowiak and Batchelor,
  // Engineering Tribology, Table 2.3. For constant z, alpha is proportional to ln(eta0) + 9.67.
  struct Measured {
    double eta[3], alpha[3];
  };
  constexpr Measured oils[] = {{{153, 34, 9.1}, {23.7, 20.5, 15.8}},   {{250, 50.5, 12.6}, {25, 21.3, 17.6}},
                               {{810, 135, 26.8}, {34, 28, 22}},       {{18.6, 6.3, 2.4}, {20, 16, 13}},
                               {{45, 12, 3.9}, {28, 20, 16}},          {{107, 23.3, 6.4}, {29.6, 22.8, 17.8}},
                               {{122, 26.3, 7.3}, {27, 21.6, 17.5}},   {{171, 31, 7.5}, {28, 23, 18}},
                               {{30.7, 8.6, 3.1}, {25.7, 20.3, 15.4}}, {{165, 30, 6.8}, {33, 23.8, 16}},
                               {{310, 44.2, 9.4}, {34.6, 26.3, 19.5}}, {{2000, 180, 24}, {41.5, 29.4, 25}}};
  double sum = 0.0, largest = 0.0;
  for (const Measured& oil : oils)
    for (const int k : {1, 2}) {
      const double ratio = roelands_log_ratio(1e-3 * oil.eta[k]) / roelands_log_ratio(1e-3 * oil.eta[0]);
      const double off = std::abs(ratio * oil.alpha[0] / oil.alpha[k] - 1.0);
      sum += off;
      largest = std::max(largest, off);
    }
  BOOST_TEST_MESSAGE("alpha at 60 and 100 C from that at 30 C: "
                     << 100 * sum / 24 << " % off in the mean, at most " << 100 * largest
                     << " % (tolerance 7 and 25: measured alphas scatter by 5)");
  BOOST_TEST(sum / 24 < 0.07);
  BOOST_TEST(largest < 0.25);
}

BOOST_AUTO_TEST_SUITE_END()
