// [mixed] in use: touching points, ellipses and lines, their friction, and what is refused.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"
#include "support/solved.hpp"

BOOST_AUTO_TEST_SUITE(test_mixed)

using namespace support;

namespace {

const char* const point = R"([contact]
M = 50
L = 10
[lubricant]
alpha = 2.2e-8
[domain]
x_inlet = -2.5
x_outlet = 1.5
y_half = 2
far_field = zero
[discretization]
wedge = upstream2
[grid]
cells = 64
)";

double share_of(const nlohmann::json& report) { return report["mixed"]["load_share"].get<double>(); }

}  // namespace

BOOST_AUTO_TEST_CASE(the_deck_has_the_share_of_an_independent_program) {
  const TemporaryFolder folder;
  const Ended run = support::ehl(
      folder, std::string("run '") + EHL_INPUTS + "/mixed/smooth_M50_L10.ini' --json --quiet --output case.h5");
  BOOST_TEST_REQUIRE(run.status == 0, run.err);
  const nlohmann::json report = nlohmann::json::parse(run.out);
  std::printf("share %.8f, expected 0.05096225 (1e-7)\n", share_of(report));
  BOOST_TEST(std::abs(share_of(report) - 0.05096225) < 1e-7);
}

BOOST_AUTO_TEST_CASE(a_film_that_is_thicker_stays_as_it_is) {
  const TemporaryFolder folder;
  const nlohmann::json without = solved_json(folder, point);
  const nlohmann::json with = solved_json(folder, point, "--set mixed.H_b=0.05");
  BOOST_TEST(share_of(with) == 0.0);
  for (const char* name : {"Hc", "Hm", "P_max", "H00"})
    BOOST_TEST(with[name].get<double>() == without[name].get<double>());
}

// The slower, the more the friction is that of the boundary film.
BOOST_AUTO_TEST_CASE(friction_is_that_of_both) {
  const TemporaryFolder folder;
  for (const double H_b : {0.15, 0.6}) {
    const nlohmann::json report = solved_json(folder, point,
                                              "--set contact.a_over_R=0.01 --set motion.srr=0.2 --set "
                                              "friction.cavitated=none --set mixed.mu_b=0.12 --set mixed.H_b=" +
                                                  std::to_string(H_b));
    const nlohmann::json& friction = report["friction"];
    const double boundary = friction["mu_boundary"].get<double>(), expected = 0.12 * share_of(report);
    std::printf("H_b %.2f: share %.4f, mu %.5f, of the boundary film %.8f, expected %.8f (1e-9)\n", H_b,
                share_of(report), friction["mu"].get<double>(), boundary, expected);
    BOOST_TEST(std::abs(boundary - expected) < 1e-9);
    BOOST_TEST(friction["mu"].get<double>() > boundary);
  }
}

// At a low speed the oil carries little: the share tends to 1, and the pressure to that of the dry contact.
BOOST_AUTO_TEST_CASE(slow_lines_and_ellipses_are_dry) {
  const TemporaryFolder folder;
  const char* const rest = R"(
[lubricant]
alpha = 2.2e-8
[domain]
far_field = zero
[grid]
cells = 64
[mixed]
H_b = 0.1
)";
  for (const char* contact : {"kind = line\nM = 20\nL = 5\n", "radius_ratio = 0.3\nM = 50\nL = 10\n"}) {
    const nlohmann::json report = solved_json(folder, std::string("[contact]\n") + contact + rest, "--set mixed.H_b=2");
    std::printf("%s: share %.4f, P_max %.4f, contact area %.4f of the Hertz area\n", contact, share_of(report),
                report["P_max"].get<double>(), report["mixed"]["contact_area"].get<double>());
    BOOST_TEST(share_of(report) > 0.9);
    BOOST_TEST(std::abs(report["P_max"].get<double>() - 1.0) < 0.02);
    BOOST_TEST(std::abs(report["mixed"]["contact_area"].get<double>() - 1.0) < 0.1);
    BOOST_TEST(report["load_error"].get<double>() < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(what_is_not_available_is_refused) {
  const TemporaryFolder folder;
  folder.write("case.ini", point);
  const auto refused = [&](const std::string& sets, const char* key) {
    const Ended run = support::ehl(folder, "check case.ini " + sets);
    BOOST_TEST(run.status == 2, sets);
    BOOST_TEST(run.says({"[mixed]", key}), sets << ": " << run.err);
  };
  refused("--set mixed.h_b=2e-9", "h_b");
  refused("--set mixed.H_b=0", "H_b");
  refused("--set mixed.H_b=0.1 --set mixed.h_b=1e-9", "h_b");
  refused("--set mixed.mu_b=0.1", "mu_b");
  refused("--set mixed.H_b=0.1 --set mixed.mu_b=0.1", "mu_b");
  refused("--set mixed.H_b=0.1 --set mixed.mu_b=3 --set contact.a_over_R=0.01 --set friction.cavitated=none", "mu_b");
  refused("--set mixed.H_b=0.1 --set contact.a_over_R=0.01 --set friction.cavitated=none", "mu_b");
  refused("--set mixed.H_b=0.1 --set mixed.hardness=-1", "hardness");
  refused("--set mixed.H_b=0.1 --set supply.H_oil=0.2", "H_b");
  refused("--set mixed.H_b=0.1 --set transient.end_time=1", "H_b");
  refused("--set mixed.H_b=0.1 --set grid.accuracy=0.01 --unset grid.cells", "H_b");
  refused("--set mixed.H_b=0.1 --set multigrid.polish=off", "H_b");
}

BOOST_AUTO_TEST_SUITE_END()
