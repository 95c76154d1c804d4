// Sliding from end to end: traction curves, what is refused, what the result contains.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

#include "results/read.hpp"
#include "support/json.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

using ehl::results::ResultFile;

namespace {

const std::string ball =
    "[contact]\nload = 30\nradius_x = 0.0125\nE_prime = 230e9\n[motion]\nu_m = 1\nsrr = 0.1\n[lubricant]\n"
    "eta0 = 0.04\nalpha = 20e-9\n[domain]\nx_inlet = -4.5\nx_outlet = 1.5\ny_half = 3\n[grid]\ncells = 64\n";
const std::string eyring = "[shear]\nlaw = eyring\ntau_0 = 5e6\n";
const std::string friction = "[friction]\ncavitated = striated\n";
const std::string moes =
    "[contact]\nM = 50\nL = 10\na_over_R = 0.01\n[motion]\nsrr = 0.2\n[lubricant]\nalpha = 2e-8\n[grid]\ncells = 64\n"
    "[domain]\nx_inlet = -4.5\ny_half = 3\n";

using support::contains;

struct Scene {
  support::TemporaryFolder folder;
  support::Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }
};

struct Curve {
  std::vector<double> srr{}, mu{}, Hc{};
};

Curve curve_of(const std::string& table) {
  Curve curve;
  for (const support::NamedRow& row : support::named_rows(table)) {
    curve.srr.push_back(std::stod(row.at("motion.srr")));
    curve.mu.push_back(std::stod(row.at("mu")));
    curve.Hc.push_back(std::stod(row.at("Hc")));
  }
  return curve;
}

double slope(const Curve& curve, std::size_t k) {
  return std::log(curve.mu[k + 1] / curve.mu[k]) / std::log(curve.srr[k + 1] / curve.srr[k]);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_sliding)

// d ln mu/d ln srr is 1 at slow sliding. At the fast end tau = tau_0 asinh(s) grows by 1/ln(2 s) at each point, and not
// at all where the limiting stress is reached.
BOOST_AUTO_TEST_CASE(traction_curves) {
  const Scene scene;
  scene.folder.write("d.ini", ball + eyring + friction);
  const std::string sweep = "sweep d.ini --vary motion.srr=1e-8,1e-7,0.3,1 --threads 2 --overwrite ";
  const support::Ended ended = scene.ehl(sweep);
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  const Curve free = curve_of(scene.folder.read("d_sweep.csv"));
  BOOST_REQUIRE(free.mu.size() == 4u);
  BOOST_TEST_MESSAGE("Eyring: slopes " << slope(free, 0) << " (1 within 1e-3), " << slope(free, 2) << " (0.1 to 0.25)");
  BOOST_TEST(std::abs(slope(free, 0) - 1.0) < 1e-3);
  BOOST_TEST((slope(free, 2) > 0.1 && slope(free, 2) < 0.25));
  BOOST_TEST(free.Hc[3] < free.Hc[0]);
  // Without the cavitated region, whose stress the limit does not affect.
  BOOST_REQUIRE(scene.ehl(sweep + "--set friction.limit=0.02 --set friction.cavitated=none").status == 0);
  const Curve limited = curve_of(scene.folder.read("d_sweep.csv"));
  BOOST_TEST_MESSAGE("with a limit of 0.02: mu " << limited.mu[3] << ", slope " << slope(limited, 2));
  BOOST_TEST((limited.mu[3] < 0.02 && limited.mu[3] > 0.018));
  BOOST_TEST(slope(limited, 2) < 0.05);
  BOOST_TEST(limited.Hc[3] == free.Hc[3]);  // the limit affects the friction alone
  BOOST_REQUIRE(scene.ehl("plot d_sweep.csv --format svg").status == 0);
  BOOST_TEST(contains(scene.folder.read("d_sweep_traction_curve.svg"), "friction coefficient"));
}

BOOST_AUTO_TEST_CASE(the_result_holds_friction_where_asked) {
  const Scene scene;
  scene.folder.write("f.ini", ball + eyring + friction + "fields = tau1, tau2\n");
  scene.folder.write("n.ini", ball);
  const support::Ended ended = scene.ehl("run f.ini --json --quiet");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  BOOST_TEST(support::is_json(ended.out), ended.out);
  for (const char* part : {"\"friction\":{\"mu\":0.02", "{\"name\":\"shear\",\"seconds\":null"})
    BOOST_TEST(contains(ended.out, part), part << " is missing in\n" << ended.out);
  const ResultFile file(scene.folder / "f.h5");
  const double mu = file.numbers("/summary/mu").values[0], rolling = file.numbers("/summary/mu_rolling").values[0];
  BOOST_TEST(file.numbers("/summary/mu_1").values[0] == -(mu + rolling));
  BOOST_TEST((file.kind("/fields/tau1") != ResultFile::Kind::missing));
  BOOST_TEST((file.kind("/fields/tau2") != ResultFile::Kind::missing));
  // The deck in the result gives the same result.
  scene.folder.write("again.ini", file.text("/deck"));
  const support::Ended again = scene.ehl("run again.ini --quiet --overwrite --output again.h5");
  BOOST_REQUIRE_MESSAGE(again.status == 0, again.err);
  BOOST_TEST(ResultFile(scene.folder / "again.h5").numbers("/summary/mu").values[0] == mu);
  BOOST_REQUIRE(scene.ehl("run n.ini --quiet").status == 0);
  const ResultFile none(scene.folder / "n.h5");
  for (const char* name : {"/summary/mu", "/fields/tau1", "/effects"})
    BOOST_TEST((none.kind(name) == ResultFile::Kind::missing), name);
  // A Newtonian oil at this pressure: the number comes with a warning.
  const std::string newtonian = scene.ehl("run n.ini --overwrite --set friction.cavitated=full").out;
  BOOST_TEST(contains(newtonian, "[shear-stress]"), newtonian);
}

// With M and L, which leave the ratio a/R open, so that it is given.
BOOST_AUTO_TEST_CASE(contacts_in_M_and_L) {
  const Scene scene;
  scene.folder.write("m.ini", moes + eyring + friction);
  const support::Ended ended = scene.ehl("run m.ini --quiet");
  BOOST_TEST(ended.status == 0, ended.err);
  BOOST_TEST(contains(ended.out, "mu = 0.0"), ended.out);
  BOOST_REQUIRE(scene.ehl("extract m.h5 /deck").status == 0);
  scene.folder.write("again.ini", ResultFile(scene.folder / "m.h5").text("/deck"));
  BOOST_TEST(scene.ehl("check again.ini").status == 0);
}

BOOST_AUTO_TEST_CASE(what_is_refused) {
  const Scene scene;
  scene.folder.write("si.ini", ball + eyring + friction);
  scene.folder.write("plain.ini", ball);
  scene.folder.write("moes.ini", moes + eyring);
  scene.folder.write("dry.ini", "[case]\nkind = dry\n" + friction);
  scene.folder.write("thin.ini",
                     "[contact]\nM = 50\nL = 0\na_over_R = 0.01\n[motion]\nsrr = 0.2\n[lubricant]\n"
                     "viscosity = isoviscous\ndensity = incompressible\n" +
                         eyring);
  struct Line {
    const char* arguments;
    const char* key;
  };
  const int files = scene.folder.entries();
  for (const Line& line : std::initializer_list<Line>{
           {"si.ini --set shear.tau_0=0", "[shear] tau_0 = 0"},
           {"si.ini --set shear.tau_0=-5e6", "[shear] tau_0 = -5e6"},
           {"si.ini --set shear.n=0.5", "[shear] n"},
           {"plain.ini --set shear.law=carreau --set shear.G=7e6 --set shear.n=0", "[shear] n = 0"},
           {"plain.ini --set shear.law=carreau --set shear.G=7e6 --set shear.n=1.1", "[shear] n = 1.1"},
           {"plain.ini --set shear.law=carreau --set shear.n=0.5", "[shear] G"},
           {"plain.ini --set shear.law=carreau --set shear.G=7e6 --set shear.n=1", "[shear] law = carreau"},
           {"plain.ini --set shear.law=eyring", "[shear] tau_0"},
           {"plain.ini --set shear.law=eyringg --set shear.tau_0=5e6", "law = eyringg"},
           {"plain.ini --set shear.tau_0=5e6", "[shear] tau_0"},
           {"si.ini --unset friction.cavitated --set motion.srr=0", "law = eyring"},
           {"si.ini --set friction.limit=0", "[friction] limit = 0"},
           {"si.ini --set friction.limit=-0.1", "[friction] limit = -0.1"},
           {"plain.ini --set friction.limit=0.1", "[friction] limit"},
           {"si.ini --set transient.end_time=1 --set shear.flow=on --set output.checkpoint=60",
            "[output] checkpoint = 60"},
           {"dry.ini", "[friction] cavitated = striated"},
           {"moes.ini --set motion.u1=1", "[motion] u1 = 1"},
           {"plain.ini --set contact.a_over_R=0.01", "a_over_R = 0.01"},
           {"thin.ini", "law = eyring"},
       }) {
    const support::Ended ended = scene.ehl(std::string("run --quiet ") + line.arguments);
    BOOST_TEST(ended.status == 2, line.arguments << " ends with " << ended.status);
    BOOST_TEST(ended.says({line.key}), line.arguments << " says\n" << ended.err);
  }
  BOOST_TEST(scene.folder.entries() == files);
}

BOOST_AUTO_TEST_SUITE_END()
