// Friction of an elliptic contact along its axes and at an angle, from end to end: in newtons, by sums that do not
// use the program's scales.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "results/read.hpp"
#include "support/program.hpp"

using ehl::results::ResultFile;

namespace {

constexpr double R_x = 0.01, R_y = 0.025, E_prime = 2e11, eta0 = 0.05, u_m = 1.0, srr = 0.3;
constexpr double alpha = 2e-8, z = 0.6, p0 = 1.96e8;

std::string deck(double load, double radius_x, double radius_y, double angle, const std::string& oil) {
  return "[contact]\nload = " + std::to_string(load) + "\nradius_x = " + std::to_string(radius_x) +
         "\nradius_y = " + std::to_string(radius_y) +
         "\nE_prime = 2e11\n[motion]\nu_m = 1\nsrr = 0.3\nangle = " + std::to_string(angle) +
         "\n[lubricant]\neta0 = 0.05\n" + oil;
}
const std::string isoviscous = "viscosity = isoviscous\ndensity = incompressible\n[friction]\ncavitated = full\n";
const std::string roelands =
    "viscosity = roelands\nalpha = 2e-8\nz = 0.6\ndensity = dowson-higginson\n[multigrid]\ntolerance = 1e-9\n"
    "[friction]\ncavitated = none\n";

/// Hertz theory: a along R_x, and p_h, from complete elliptic integrals and bisection for kappa = b/a > 1.
struct Hertz {
  double a, p_h;
};
Hertz hertz(double load) {
  const auto radius_ratio = [](double kappa) {
    const double modulus = std::sqrt(1.0 - 1.0 / (kappa * kappa));
    const double K = std::comp_ellint_1(modulus), E = std::comp_ellint_2(modulus);
    return (kappa * kappa * E - K) / (K - E);
  };
  double low = 1.001, high = 100.0;
  for (int n = 0; n < 200; ++n) (radius_ratio(0.5 * (low + high)) < R_y / R_x ? low : high) = 0.5 * (low + high);
  const double E = std::comp_ellint_2(std::sqrt(1.0 - 1.0 / (low * low)));
  const double R = 1.0 / (1.0 / R_x + 1.0 / R_y);
  const double b = std::cbrt(6.0 * low * low * E * load * R / (std::numbers::pi * E_prime));
  return {b / low, 1.5 * load / (std::numbers::pi * (b / low) * b)};
}

/// A result converted to metres and pascals.
class InSi {
 public:
  InSi(const std::string& path, double load)
      : file_(path),
        dry_(hertz(load)),
        x_(file_.numbers("/grid/x").values),
        y_(file_.numbers("/grid/y").values),
        P_(file_.numbers("/fields/P").values),
        H_(file_.numbers("/fields/H").values) {}

  double summary(const std::string& name) const { return file_.numbers("/summary/" + name).values[0]; }
  std::size_t nx() const { return x_.size(); }
  std::size_t ny() const { return y_.size(); }
  double x(std::size_t i) const { return x_[i] * dry_.a; }
  double y(std::size_t j) const { return y_[j] * dry_.a; }
  double p(std::size_t i, std::size_t j) const { return P_[j * x_.size() + i] * dry_.p_h; }
  double h(std::size_t i, std::size_t j) const { return film(H_[j * x_.size() + i]); }
  double film(double H) const { return H * dry_.a * dry_.a / R_x; }
  double cell() const { return (x(1) - x(0)) * (y(1) - y(0)); }

 private:
  ResultFile file_;
  Hertz dry_;
  std::vector<double> x_, y_, P_, H_;
};

void check(const char* what, double value, double expected, double tolerance) {
  BOOST_TEST_MESSAGE(what << " " << value << ", expected " << expected << ", off by " << value / expected - 1.0
                          << " (tolerance " << tolerance << ")");
  BOOST_TEST(std::abs(value / expected - 1.0) < tolerance);
}

struct Scene {
  support::TemporaryFolder folder;
  InSi run(const std::string& text, double load) const {
    folder.write("d.ini", text);
    const support::Ended ended = support::ehl(folder, "run d.ini --quiet --overwrite");
    BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
    return {folder / "d.h5", load};
  }
};

constexpr double angles[] = {0.0, 45.0, 90.0};

}  // namespace

BOOST_AUTO_TEST_SUITE(test_elliptic_friction)

// At M = 0.5 the bodies are practically rigid: h = h_0 + xi^2/(2 R_x) + eta^2/(2 R_y), with xi and eta along the axes
// of the bodies. The sliding friction is eta_0 (u1 - u2) times the integral of 1/h over the domain.
BOOST_AUTO_TEST_CASE(rigid_isoviscous_ellipse) {
  const Scene scene;
  const double load = 0.188;
  for (const double angle : angles) {
    const std::string domain =
        "[domain]\nfar_field = zero\nx_inlet = -32\nx_outlet = 16\ny_half = 24\n[grid]\ncells = 128\n";
    const InSi found = scene.run(deck(load, R_x, R_y, angle, isoviscous) + domain, load);
    const double c = std::cos(angle * std::numbers::pi / 180.0), s = std::sin(angle * std::numbers::pi / 180.0);
    const double h0 = found.film(found.summary("Hc"));
    const double x_a = found.x(0), x_b = found.x(found.nx() - 1), y_a = found.y(0), y_b = found.y(found.ny() - 1);
    constexpr int n = 1000;
    double sum = 0.0;
    for (int k = 0; k < n; ++k)
      for (int l = 0; l < n; ++l) {
        const double x = x_a + (k + 0.5) * (x_b - x_a) / n, y = y_a + (l + 0.5) * (y_b - y_a) / n;
        const double xi = x * c - y * s, eta = x * s + y * c;
        sum += 1.0 / (h0 + xi * xi / (2.0 * R_x) + eta * eta / (2.0 * R_y));
      }
    const double exact = eta0 * srr * u_m * sum * (x_b - x_a) * (y_b - y_a) / (n * n) / load;
    BOOST_TEST_MESSAGE(angle << " degrees:");
    check("mu", found.summary("mu"), exact, 2e-4);
  }
}

// A loaded contact: the sum of eta(p) (u1 - u2)/h over the nodes with pressure, and the sum of -(p/2) dh/dx, which is
// the integral of (h/2) dp/dx by parts, divided by the load of the deck.
BOOST_AUTO_TEST_CASE(loaded_ellipse) {
  const Scene scene;
  const double load = 20.0;
  const std::string whole = "[domain]\nfar_field = zero\n";  // else the integral has a boundary term
  for (const double angle : angles) {
    const InSi found = scene.run(deck(load, R_x, R_y, angle, roelands) + whole + "[grid]\ncells = 256\n", load);
    double sliding = 0.0, rolling = 0.0, side = 0.0;
    for (std::size_t i = 1; i + 1 < found.nx(); ++i)
      for (std::size_t j = 1; j + 1 < found.ny(); ++j) {
        const double p = found.p(i, j);
        if (p <= 0.0) continue;
        const double eta = eta0 * std::exp(alpha * p0 / z * (std::pow(1.0 + p / p0, z) - 1.0));
        sliding += eta * srr * u_m / found.h(i, j);
        rolling -= 0.5 * p * (found.h(i + 1, j) - found.h(i - 1, j)) / (found.x(i + 1) - found.x(i - 1));
      }
    for (std::size_t i = 1; i + 1 < found.nx(); ++i)
      for (std::size_t j = 1; j + 1 < found.ny(); ++j)
        side += 0.5 * found.p(i, j) * (found.h(i, j + 1) - found.h(i, j - 1)) / (found.y(j + 1) - found.y(j - 1));
    BOOST_TEST_MESSAGE(angle << " degrees:");
    // An ellipse along its axes has no side force.
    if (angle == 45.0) check("mu_side", found.summary("mu_side"), side * found.cell() / load, 1e-7);
    check("mu", found.summary("mu"), sliding * found.cell() / load, 1e-7);
    check("mu_rolling", found.summary("mu_rolling"), rolling * found.cell() / load, 1e-7);
  }
}

// Two decks describe the same bodies: the second exchanges R_x and R_y and turns them by 90 degrees.
BOOST_AUTO_TEST_CASE(one_contact_under_two_names) {
  const Scene scene;
  for (const double angle : {90.0, 45.0}) {
    const InSi one = scene.run(deck(20.0, R_x, R_y, angle, roelands), 20.0);
    const double mu = one.summary("mu"), rolling = one.summary("mu_rolling");
    const InSi other = scene.run(deck(20.0, R_y, R_x, angle - 90.0, roelands), 20.0);
    BOOST_TEST_MESSAGE(angle << " degrees:");
    check("mu", other.summary("mu"), mu, 1e-7);
    check("mu_rolling", other.summary("mu_rolling"), rolling, 1e-7);
  }
}

// In a point contact H dP/dX falls as 1/r^2. Without a far field, doubling the length of the inlet adds as much as
// its outer half contributed.
BOOST_AUTO_TEST_CASE(rolling_friction_grows_with_the_inlet) {
  const Scene scene;
  const auto from = [&](const char* domain) {
    return scene.run(deck(20.0, R_x, R_y, 0.0, roelands) + "[domain]\nfar_field = zero\n" + domain, 20.0);
  };
  const InSi one = from("x_inlet = -6\nx_outlet = 2\ny_half = 7.5\n[grid]\ncells = 128\n");
  const double rolling = one.summary("mu_rolling"), outer = one.summary("mu_rolling_outer");
  const InSi twice = from("x_inlet = -12\nx_outlet = 4\ny_half = 15\n[grid]\ncells = 256\n");
  const double more = twice.summary("mu_rolling") - rolling;
  BOOST_TEST_MESSAGE("an inlet of twice the length adds " << more << ", reported " << outer << " of " << rolling);
  BOOST_TEST(outer > 0.1 * rolling);
  BOOST_TEST(std::abs(more / outer - 1.0) < 0.3);
}

BOOST_AUTO_TEST_SUITE_END()
