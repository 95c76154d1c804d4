// The friction of the whole contact, including the oil outside the domain: exact solutions,
// and contacts on two domains.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "support/heated.hpp"
#include "support/text.hpp"

using support::check_close;
using support::contains;
using support::number_at;

namespace {

const std::string rigid =
    "a_over_R = 0.01\n[motion]\nsrr = 0.1\n[lubricant]\nviscosity = isoviscous\ndensity = incompressible\n"
    "[friction]\ncavitated = full\n";
const std::string rigid_line = "[contact]\nkind = line\nM = 0.1\nL = 0\n" + rigid;
const std::string oily =
    "L = 2\na_over_R = 0.01\n[motion]\nsrr = 0.1\n[lubricant]\nalpha = 2e-8\n[friction]\ncavitated = striated\n";

struct Scene : support::HeatedScene {
  using HeatedScene::HeatedScene;
  double rolling(const std::string& changes) const { return number_at(run(changes), "/friction/mu_rolling"); }
};

// Both coefficients of one contact, computed on two domains.
void check_equal(const std::string& name, const nlohmann::json& one, const nlohmann::json& other, double tolerance) {
  for (const char* mu : {"mu", "mu_rolling"})
    check_close(name + ", " + mu, number_at(one, std::string("/friction/") + mu),
                number_at(other, std::string("/friction/") + mu), tolerance);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_friction_outside)

// T M = 1.4466, where T = (1/2) integral of H dP/dX over the undeformed parabola, in units in which the load is pi/2.
// mu_rolling is T divided by the load, times a/R.
BOOST_AUTO_TEST_CASE(a_rigid_line_wherever_the_inlet_begins) {
  const Scene scene(rigid_line);
  constexpr double exact = 1.4466, M = 0.1, a_over_R = 0.01;
  for (const char* domain :
       {"--set domain.x_inlet=-38 --set grid.cells=1024", "--set domain.x_inlet=-100 --set grid.cells=2048"})
    check_close(domain, scene.rolling(domain) / a_over_R * 0.5 * std::numbers::pi * M, exact, 2e-3);
}

// A meniscus inside the domain, and one outside.
BOOST_AUTO_TEST_CASE(a_rigid_line_up_to_a_meniscus) {
  const Scene scene(rigid_line + "meniscus = 40\n");
  check_equal("meniscus at -40", scene.run("--set domain.x_inlet=-30 --set grid.cells=1024"),
              scene.run("--set domain.x_inlet=-90 --set domain.x_outlet=50 --set grid.cells=4096"), 3e-3);
}

// On a domain with a closed far field, and on one four times as long.
BOOST_AUTO_TEST_CASE(points_on_two_domains) {
  for (const auto& [M, inlet] : {std::pair{1.0, 70.0}, {5.0, 8.0}, {20.0, 8.0}}) {
    const Scene scene("[contact]\nM = " + std::to_string(M) + "\n" + oily);
    const nlohmann::json one = scene.run("");
    const std::string cells = M > 1.0 ? "512" : "1024";
    const nlohmann::json other =
        scene.run("--set domain.x_inlet=" + std::to_string(-4.0 * inlet) + " --set grid.cells=" + cells);
    check_equal("M = " + std::to_string(M), one, other, 0.01);
    BOOST_TEST(number_at(one, "/friction/mu_rolling_beyond") > 0.1 * number_at(one, "/friction/mu_rolling"));
  }
}

// An ellipse at an angle has two rupture lines of different directions.
BOOST_AUTO_TEST_CASE(ellipses_on_two_domains) {
  const Scene scene("[contact]\nM = 10\nradius_ratio = 0.3\n" + oily);
  for (const char* angle : {"0", "30", "90"}) {
    const std::string at = std::string("--set motion.angle=") + angle + " --set friction.meniscus=40 ";
    check_equal(std::string(angle) + " degrees", scene.run(at + "--set grid.cells=256 --set domain.x_inlet=-8"),
                scene.run(at + "--set grid.cells=512 --set domain.x_inlet=-20"), 0.01);
  }
}

// Far from the contact the bodies are rigid: H = r^2/2 and P = r^-3 f(phi). Between two menisci S1 and S2, rolling
// friction increases by (lambda/2) ln(S2/S1) times the integral of f cos(phi)/lambda, where f = 0.8 cos(phi) +
// 0.00173 cosh(3 phi) up to the rupture line. Sliding friction in a full gap increases by the integral of tau_0
// (2/r^2), which is 4 pi tau_0 ln(S2/S1).
BOOST_AUTO_TEST_CASE(between_two_menisci_of_a_rigid_ball) {
  const Scene scene("[contact]\nM = 1\nL = 0\n" + rigid);
  const nlohmann::json near = scene.run("--set friction.meniscus=1e3"), far = scene.run("--set friction.meniscus=1e5");
  const double lambda = std::cbrt(128.0 * std::pow(std::numbers::pi, 3) / 3.0), a_over_R = 0.01, srr = 0.1;
  const double load = 2.0 * std::numbers::pi / 3.0, longer = std::log(100.0);
  constexpr int parts = 2000;
  const double rupture = 108.44 * std::numbers::pi / 180.0;
  double integral = 0.0;
  for (int k = 0; k < parts; ++k) {
    const double phi = (k + 0.5) * rupture / parts;
    integral += 2.0 * rupture / parts * (0.8 * std::cos(phi) + 0.00173 * std::cosh(3.0 * phi)) * std::cos(phi);
  }
  const auto grows = [&](const char* mu) { return number_at(far, mu) - number_at(near, mu); };
  check_close("rolling", grows("/friction/mu_rolling"), 0.5 * a_over_R * lambda * integral * longer / load, 3e-3);
  check_close("sliding", grows("/friction/mu"), 4.0 * std::numbers::pi * lambda * a_over_R * srr / 12.0 * longer / load,
              3e-3);
}

// The meniscus of a contact in SI, in metres and in Hertz radii, and what is refused.
BOOST_AUTO_TEST_CASE(keys_of_the_meniscus) {
  const Scene scene(
      "[contact]\nload = 1\nradius_x = 0.01\nE_prime = 2e11\n[motion]\nu_m = 1\nsrr = 0.1\n[lubricant]\neta0 = 0.05\n"
      "alpha = 2e-8\n[grid]\ncells = 64\n[friction]\ncavitated = striated\n");
  const nlohmann::json by_default = scene.run(""), in_metres = scene.run("--set friction.meniscus_m=0.01");
  check_equal("one radius", by_default, in_metres, 1e-12);
  check_close("its place", number_at(in_metres, "/friction/meniscus"), number_at(by_default, "/friction/meniscus"),
              1e-12);
  for (const std::string changes :
       {"meniscus=20 --set friction.meniscus_m=0.01", "meniscus=20 --set supply.H_oil=0.2 --set grid.cells=1024",
        "meniscus=20 --set domain.far_field=zero --set domain.x_inlet=-4.5", "meniscus=0.5", "meniscus_m=1e-6"}) {
    const support::Ended ended = scene.ehl("check d.ini --set friction." + changes);
    BOOST_TEST(ended.status == 2, changes);
    BOOST_TEST(contains(ended.err, "[friction] meniscus"), ended.err);
  }
}

BOOST_AUTO_TEST_SUITE_END()
