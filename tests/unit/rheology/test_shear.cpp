// The shear laws compared with long double, their limits, and the fluidities of the film.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "rheology/shear.hpp"

BOOST_AUTO_TEST_SUITE(test_rheology_shear)

using namespace ehl::rheology;

namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();
const std::vector<ShearLaw> laws{Eyring{}, Carreau{0.46}, Carreau{0.8}};

double relative(double value, double exact) { return std::abs(value / exact - 1.0); }

struct Fluidities {
  double along, across;
};
using Function = void (*)(const ShearThinning&, std::span<const double>, std::span<const double>, std::span<double>,
                          std::span<double>);
Fluidities at(Function f, const ShearThinning& thinning, double H, double fluidity) {
  Fluidities out{};
  f(thinning, {&H, 1}, {&fluidity, 1}, {&out.along, 1}, {&out.across, 1});
  return out;
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_rate_no_thinning) {
  for (const ShearLaw& law : laws) {
    const Thinned at_rest = thinned(law, 0.0);
    BOOST_TEST((at_rest.along == 1.0 && at_rest.across == 1.0));
    // Both differ from 1 by a term in s^2; for Eyring transverse to sliding, this is s^2/6.
    double before = 1.0;
    for (const double s : {1e-1, 1e-2, 1e-3, 1e-5}) {
      const double away = 1.0 - thinned(law, s).across;
      BOOST_TEST_MESSAGE("law " << law.index() << ", s = " << s << ": 1 - eta_y/eta = " << away << " (<= s^2)");
      BOOST_TEST((away >= 0.0 && away <= s * s && away < before));
      before = away;
    }
  }
  BOOST_TEST(relative(1.0 - thinned(Eyring{}, 1e-3).across, 1e-6 / 6.0) < 1e-6);
}

// Also beyond the range of the series.
BOOST_AUTO_TEST_CASE(eyring_against_long_double) {
  double worst = 0.0;
  for (double s = 1e-9; s < 1e12; s *= 1.07) {
    const auto exact = static_cast<double>(std::asinh(static_cast<long double>(s)) / static_cast<long double>(s));
    worst = std::max(worst, relative(thinned(Eyring{}, s).across, exact));
  }
  BOOST_TEST_MESSAGE("largest relative error " << worst << " (tolerance " << 4.0 * ulp << ")");
  BOOST_TEST(worst < 4.0 * ulp);
}

// tau/tau_0 = s eta_y/eta -> ln(2 s), with a remainder of 1/(4 s^2).
BOOST_AUTO_TEST_CASE(eyring_grows_as_a_logarithm) {
  for (const double s : {1e2, 1e4, 1e8}) {
    const double stress = s * thinned(Eyring{}, s).across;
    BOOST_TEST_MESSAGE("s = " << s << ": tau/tau_0 = " << stress << ", ln(2 s) = " << std::log(2.0 * s));
    BOOST_TEST(std::abs(stress - std::log(2.0 * s)) < 0.26 / (s * s) + 8.0 * ulp * stress);
  }
}

// eta_x is d tau/d rate.
BOOST_AUTO_TEST_CASE(along_is_the_slope_of_the_stress) {
  double worst = 0.0;
  for (const ShearLaw& law : laws)
    for (const double s : {1e-3, 0.1, 1.0, 7.0, 1e3, 1e6}) {
      const double step = 1e-4 * s;
      const auto stress = [&](double x) { return x * thinned(law, x).across; };
      worst = std::max(worst, relative(thinned(law, s).along, (stress(s + step) - stress(s - step)) / (2.0 * step)));
    }
  BOOST_TEST_MESSAGE("largest difference " << worst << " (tolerance 1e-7, of the difference quotient)");
  BOOST_TEST(worst < 1e-7);
}

BOOST_AUTO_TEST_CASE(carreau_with_n_1_is_newtonian) {
  for (const double s : {0.0, 0.3, 1e6}) {
    BOOST_TEST(thinned(Carreau{1.0}, s).along == 1.0);
    BOOST_TEST(thinned(Carreau{1.0}, s).across == 1.0);
  }
}

BOOST_AUTO_TEST_CASE(the_film_follows_the_laws) {
  double worst = 0.0;
  for (const ShearLaw& law : laws)
    for (const double k : {1e-8, 1e-3, 0.4})
      for (const double H : {1e-3, 0.2, 30.0})
        for (const double fluidity : {1.0, 1e-4, 1e-13}) {
          const Thinned exact = thinned(law, k / (H * fluidity));
          const Fluidities film = at(film_fluidity, {law, k}, H, fluidity);
          worst = std::max(
              {worst, relative(film.along, fluidity / exact.along), relative(film.across, fluidity / exact.across)});
        }
  BOOST_TEST_MESSAGE("largest relative difference " << worst << " (tolerance 1e-13)");
  BOOST_TEST(worst < 1e-13);
}

// Each value is independent of the length of the array and of its position.
BOOST_AUTO_TEST_CASE(a_value_does_not_depend_on_its_neighbours) {
  for (const ShearLaw& law : laws)
    for (std::size_t length = 1; length < 20; ++length) {
      std::vector<double> H(length), fluidity(length), along(length), across(length);
      for (std::size_t k = 0; k < length; ++k) {
        H[k] = 0.1 + 0.3 * static_cast<double>(k);
        fluidity[k] = std::exp(-2.0 * static_cast<double>(k));
      }
      film_fluidity({law, 1e-2}, H, fluidity, along, across);
      for (std::size_t k = 0; k < length; ++k) {
        const Fluidities one = at(film_fluidity, {law, 1e-2}, H[k], fluidity[k]);
        BOOST_TEST((along[k] == one.along && across[k] == one.across));
      }
    }
}

BOOST_AUTO_TEST_CASE(little_sliding_is_newtonian) {
  for (const ShearLaw& law : laws)
    for (const double fluidity : {1.0, 0.3, 1e-12}) {
      const Fluidities none = at(film_fluidity, {law, 0.0}, 0.2, fluidity);
      BOOST_TEST((none.along == fluidity && none.across == fluidity));
      const Fluidities little = at(film_fluidity, {law, 1e-25}, 0.2, fluidity);
      BOOST_TEST(relative(little.along, fluidity) < 4.0 * ulp);
      BOOST_TEST(relative(little.across, fluidity) < 4.0 * ulp);
    }
}

// Glassy oil, no film, a negative film: the result is finite; a NaN stays a NaN.
BOOST_AUTO_TEST_CASE(the_ends_of_the_range) {
  for (const ShearLaw& law : laws) {
    for (const auto& [H, fluidity] : {std::pair{0.2, 0.0}, {0.2, 1e-300}, {0.0, 1.0}, {-0.5, 1e-5}, {0.0, 0.0}}) {
      const Fluidities film = at(film_fluidity, {law, 1e-3}, H, fluidity);
      BOOST_TEST((std::isfinite(film.along) && std::isfinite(film.across) && film.along >= 0.0 && film.across >= 0.0),
                 "H = " << H << ", fluidity " << fluidity << ": " << film.along << ", " << film.across);
    }
    BOOST_TEST(std::isnan(at(film_fluidity, {law, 1e-3}, std::nan(""), 1.0).along));
    BOOST_TEST(std::isnan(at(film_fluidity, {law, 1e-3}, 1.0, std::nan("")).across));
  }
}

BOOST_AUTO_TEST_CASE(slopes_against_differences) {
  double worst = 0.0;
  for (const ShearLaw& law : laws)
    for (const double fluidity : {1.0, 1e-2, 1e-4, 1e-9}) {
      const ShearThinning thinning{law, 1e-3};
      constexpr double H = 0.2, step = 1e-4;
      const Fluidities slope = at(film_fluidity_slopes, thinning, H, fluidity);
      const auto difference = [&](double by_H, double by_fluidity, double Fluidities::*which) {
        const auto ln = [&](double sign) {
          return std::log(
              at(film_fluidity, thinning, H * std::exp(sign * by_H), fluidity * std::exp(sign * by_fluidity)).*which);
        };
        return (ln(1.0) - ln(-1.0)) / (2.0 * step);
      };
      for (const auto& [exact, which] :
           {std::pair{slope.along, &Fluidities::along}, {slope.across, &Fluidities::across}}) {
        worst = std::max(worst, std::abs(difference(0.0, step, which) - exact));
        worst = std::max(worst, std::abs(difference(step, 0.0, which) - (exact - 1.0)));
      }
    }
  BOOST_TEST_MESSAGE("largest difference " << worst << " (tolerance 1e-7, of the difference quotient)");
  BOOST_TEST(worst < 1e-7);
}

// The change of a^2 changes the stress that sliding would cause: k = eta_0 du R/(a^2 tau_c).
BOOST_AUTO_TEST_CASE(rescaled_to_another_load) {
  BOOST_TEST(relative(rescaled({Eyring{}, 0.3}, 2.0).k, 0.075) < 2.0 * ulp);
}

BOOST_AUTO_TEST_CASE(a_limit_cuts_on_both_sides) {
  BOOST_TEST(limited(3.0, 2.0) == 2.0);
  BOOST_TEST(limited(-3.0, 2.0) == -2.0);
  BOOST_TEST(limited(1.0, 2.0) == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()
