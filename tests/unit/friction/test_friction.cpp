// Friction of films with known integrals: a rigid paraboloid with an isoviscous oil, and films of constant height.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>

#include "core/norms.hpp"
#include "effects/friction/friction.hpp"

BOOST_AUTO_TEST_SUITE(test_friction)

using namespace ehl;
using friction::Cavitated;

namespace {

struct Fields {
  core::Grid grid;
  core::Field P{grid}, H{grid};
  rheology::ViscosityLaw viscosity{rheology::Isoviscous{}};
  std::optional<rheology::ShearThinning> thinning{};

  using Shape = std::function<double(double X, double Y)>;
  Fields(const core::Grid& on, const Shape& pressure, const Shape& gap) : grid(on) {
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) {
        P(i, j) = pressure(grid.X(i), grid.Y(j));
        H(i, j) = gap(grid.X(i), grid.Y(j));
      }
  }
  friction::Friction friction(const friction::Parameters& parameters) const {
    return friction::friction_of({grid, P, H, viscosity, thinning}, parameters);
  }
};

const friction::Parameters plain{.stress = 0.03, .slope = 0.02, .cavitated = Cavitated::full};

// The rectangle |X| <= A, |Y| <= B; neither it nor its cells are square.
constexpr double A = 2.0, B = 1.5, H0 = 0.3, c = -0.05;
double paraboloid(double X, double Y) { return H0 + 0.5 * (X * X + Y * Y); }
core::Grid rectangle(int n) { return {n, n / 2, -A, A, -B, B}; }

// Integrates a closed form along X over Y by Simpson's rule, exact to rounding.
double along_y(const std::function<double(double q)>& integral_along_x) {
  constexpr int n = 4000;
  double sum = 0.0;
  for (int k = 0; k <= n; ++k) {
    const double Y = -B + 2.0 * B * k / n;
    sum += (k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) * integral_along_x(std::sqrt(2.0 * H0 + Y * Y));
  }
  return sum * 2.0 * B / n / 3.0;
}

}  // namespace

// Pure rolling on a rigid paraboloid: p = c X/H^2 (full Sommerfeld), plus a constant that keeps it positive. The load
// is that constant times the area. With q^2 = 2 H0 + Y^2:
//   integral of 1/H dX = (4/q) atan(A/q),
//   integral of H dP/dX dX = [H P] - integral of X P dX = 4 c A/(A^2 + q^2) - 4 c [atan(A/q)/q - A/(A^2 + q^2)].
BOOST_AUTO_TEST_CASE(rigid_isoviscous_paraboloid) {
  const double load = 4.0 * A * B;
  const double sliding = plain.stress / load * along_y([](double q) { return 4.0 / q * std::atan(A / q); });
  const double rolling = 0.5 * plain.slope / load * along_y([](double q) {
                           return 8.0 * c * A / (A * A + q * q) - 4.0 * c / q * std::atan(A / q);
                         });
  double before_s = 0.0, before_r = 0.0;
  for (const int n : {32, 64, 128, 256}) {
    const Fields fields(
        rectangle(n), [](double X, double Y) { return 1.0 + c * X / std::pow(paraboloid(X, Y), 2); }, paraboloid);
    const friction::Friction found = fields.friction(plain);
    const double error_s = std::abs(found.sliding / sliding - 1.0), error_r = std::abs(found.rolling / rolling - 1.0);
    BOOST_TEST_MESSAGE(n << " cells: sliding " << found.sliding << " (" << sliding << "), error " << error_s
                         << ", ratio " << before_s / error_s << "; rolling " << found.rolling << " (" << rolling
                         << "), error " << error_r << ", ratio " << before_r / error_r);
    if (n > 64) {
      BOOST_TEST((before_s / error_s > 3.8 && before_s / error_s < 4.2));
      BOOST_TEST((before_r / error_r > 3.8 && before_r / error_r < 4.2));
    }
    before_s = error_s;
    before_r = error_r;
  }
  BOOST_TEST(before_s < 1e-4);
  BOOST_TEST(before_r < 1e-3);
}

BOOST_AUTO_TEST_CASE(forces_and_fields_agree) {
  const Fields fields(
      rectangle(64), [](double X, double Y) { return std::max(0.0, 1.0 - X * X - Y * Y); }, paraboloid);
  friction::Parameters parameters = plain;
  parameters.keep_tau1 = parameters.keep_tau2 = true;
  const friction::Friction f = fields.friction(parameters);
  BOOST_TEST(f.on_1 == -(f.sliding + f.rolling));
  BOOST_TEST(f.on_2 == f.sliding - f.rolling);
  BOOST_TEST(f.sliding > 0.0);
  double tau1 = 0.0, tau2 = 0.0, load = 0.0;
  for (int i = 0; i <= fields.grid.nx; ++i)
    for (int j = 0; j <= fields.grid.ny; ++j) {
      const double w = (i == 0 || i == fields.grid.nx ? 0.5 : 1.0) * (j == 0 || j == fields.grid.ny ? 0.5 : 1.0);
      tau1 += w * f.tau1(i, j);
      tau2 += w * f.tau2(i, j);
      load += w * fields.P(i, j);
    }
  BOOST_TEST_MESSAGE("forces by the fields " << tau1 / load << ", " << tau2 / load << "; " << f.on_1 << ", " << f.on_2);
  BOOST_TEST(std::abs(tau1 / load - f.on_1) < 1e-12);
  BOOST_TEST(std::abs(tau2 / load - f.on_2) < 1e-12);
  // Sliding in the opposite direction gives the opposite friction.
  parameters.stress = -parameters.stress;
  BOOST_TEST(fields.friction(parameters).sliding == -f.sliding);
  BOOST_TEST(fields.friction(parameters).rolling == f.rolling);
  BOOST_TEST(fields.friction({.stress = 0.1, .slope = 0.02}).tau1.nodes_x() == 0);
}

// If the limiting stress is reached everywhere, mu equals the limit.
BOOST_AUTO_TEST_CASE(the_limiting_stress) {
  const Fields fields(
      rectangle(32), [](double X, double) { return 2.0 + X / A; }, paraboloid);
  friction::Parameters parameters = plain;
  parameters.stress = 1e3;
  parameters.limit = 0.07;
  const friction::Friction f = fields.friction(parameters);
  BOOST_TEST(std::abs(f.sliding - 0.07) < 1e-15);
  BOOST_TEST(f.limited_share == 1.0);
  BOOST_TEST(std::abs(f.largest_stress - 0.07 * 3.0) < 1e-15);
  BOOST_TEST(friction::warnings(f).empty());
  parameters.limit = std::numeric_limits<double>::infinity();
  const friction::Friction free = fields.friction(parameters);
  BOOST_TEST(free.unlikely_share == 1.0);
  BOOST_TEST(friction::warnings(free).size() == 1u);
}

// Eyring between parallel plates: tau = tau_0 asinh(eta rate/tau_0), with stress = k tau_0.
BOOST_AUTO_TEST_CASE(parallel_plates_with_eyring) {
  Fields fields(
      rectangle(16), [](double, double) { return 1.5; }, [](double, double) { return 0.25; });
  fields.viscosity = rheology::Barus{4.0};
  fields.thinning = rheology::ShearThinning{rheology::Eyring{}, 0.02};
  constexpr double tau_0 = 0.006;
  const friction::Friction f = fields.friction({.stress = -0.02 * tau_0, .slope = 0.01});
  const double exact = -tau_0 * std::asinh(0.02 / 0.25 * std::exp(6.0)) / 1.5;
  BOOST_TEST_MESSAGE("mu " << f.sliding << ", exact " << exact);
  BOOST_TEST(std::abs(f.sliding / exact - 1.0) < 1e-13);
  BOOST_TEST(f.rolling == 0.0);
}

// P = 1 up to X = 0, then H = 1 + X: the integral is log(1 + A) for a full film, and H_r (1 - 1/(1 + A)) for streamers.
BOOST_AUTO_TEST_CASE(the_cavitated_region) {
  const auto with = [](Cavitated kind, int n) {
    const Fields fields(
        {n, 8, -A, A, -B, B}, [](double X, double) { return X <= 0.0 ? 1.0 : 0.0; },
        [](double X, double) { return X <= 0.0 ? 1.0 : 1.0 + X; });
    return fields.friction({.stress = 0.1, .slope = 0.02, .cavitated = kind});
  };
  BOOST_TEST(with(Cavitated::none, 64).cavitated == 0.0);
  for (const auto& [kind, exact] :
       {std::pair{Cavitated::full, std::log(1.0 + A)}, {Cavitated::striated, 1.0 - 1.0 / (1.0 + A)}}) {
    double before = 0.0;
    for (const int n : {64, 128, 256}) {
      const friction::Friction f = with(kind, n);
      // The load acts on the nodes X <= 0; the cell of the edge belongs to both sides.
      const double load = A + 0.5 * 2.0 * A / n;
      const double wet = A;
      const double error = std::abs(f.sliding * load / 0.1 - wet - exact);
      BOOST_TEST_MESSAGE(n << " cells: " << f.cavitated * load / 0.1 << ", error of all " << error);
      if (before > 0.0) BOOST_TEST(before / error > 3.8);
      before = error;
    }
  }
}

// A load that is partly outside the domain, oil that ends inside the domain, and layers upstream of a starved film.
BOOST_AUTO_TEST_CASE(the_load_of_the_contact_and_where_the_oil_ends) {
  const Fields fields(
      rectangle(128), [](double X, double) { return X > 0.0 ? 1.0 : 0.0; }, [](double, double) { return 0.5; });
  const friction::Film film{fields.grid, fields.P, fields.H, fields.viscosity, fields.thinning};
  const auto with = [&](const friction::Parameters& parameters, auto change) {
    friction::Film other = film;
    change(other);
    return friction::friction_of(other, parameters).sliding;
  };
  const double inside = 2.0 * A * B, whole = with(plain, [](friction::Film&) {});
  const double of_more = with(plain, [&](friction::Film& one) { one.load = 3.0 * inside; });
  const double cell = fields.grid.hx() / A;  // the cell of the edge belongs to neither side
  BOOST_TEST(std::abs(of_more / whole * 3.0 - 1.0) < cell);
  friction::Parameters parameters = plain;
  parameters.meniscus = 1.0;
  const double round = with(parameters, [&](friction::Film& one) { one.load = inside; });
  const double area = std::acos(-1.0), exact = plain.stress / 0.5 * area / inside;
  BOOST_TEST_MESSAGE("a round meniscus: " << round << ", exact " << exact);
  BOOST_TEST(std::abs(round / exact - 1.0) < 1e-3);
  parameters = plain;
  parameters.cavitated = Cavitated::striated;
  const double starved = with(parameters, [](friction::Film& one) { one.starved = true; });
  const double flooded = with(parameters, [](friction::Film&) {});
  BOOST_TEST(std::abs(2.0 * starved / flooded - 1.0) < cell);
}

BOOST_AUTO_TEST_SUITE_END()
