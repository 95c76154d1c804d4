// Line contacts with heat from end to end: balances, symmetries, the middle of a wide ellipse, slow surfaces, files,
// tables, and what is refused.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <sstream>

#include "results/read.hpp"
#include "support/heated.hpp"
#include "support/json.hpp"
#include "support/program.hpp"
#include "support/refused.hpp"
#include "support/text.hpp"

using ehl::results::ResultFile;
using support::check_close;
using support::number_at;

namespace {

const std::string line = "[contact]\nkind = line\nload_per_length = 2e5\nradius_x = 0.010\nE_prime = 226.4e9\n";
const std::string motion = "[motion]\nu_m = 10\nsrr = 0.4\n";
const std::string oil = "[lubricant]\neta0 = 0.0165\nalpha = 1.8e-8\n";
const std::string shear = "[shear]\nlaw = eyring\ntau_0 = 5e6\n";
const std::string grid = "[grid]\ncells = 256\n";
const std::string heat = "[thermal]\nT_oil = 80\nbeta = 0.033\nsolid1 = steel\nsolid2 = steel\n";
const std::string teeth = line + motion + oil + shear + grid + heat;

struct Scene : support::HeatedScene {
  explicit Scene(const std::string& deck = teeth) : HeatedScene(deck) {}
};

}  // namespace

BOOST_AUTO_TEST_SUITE(test_heated_lines)

BOOST_AUTO_TEST_CASE(heat_goes_where_it_is_told) {
  const Scene scene;
  const auto found = scene.run("--set friction.cavitated=none");
  const auto at = [&](const char* name) { return number_at(found, std::string("/thermal/") + name); };
  // The power of the surfaces per length: sliding at 4 m/s, and both surfaces at 10 m/s against the rolling friction.
  // The heat produced upstream of the domain is not included.
  const double rolling = number_at(found, "/friction/mu_rolling") - number_at(found, "/friction/mu_upstream");
  const double sliding = number_at(found, "/friction/mu") - number_at(found, "/friction/mu_beyond");
  const double work = 2e5 * (sliding * 4 + rolling * 20);
  check_close("heat made over the work of the surfaces", at("heat_made"), work, 0.02);
  BOOST_TEST(std::abs(at("heat_imbalance")) < 1e-3);
  check_close("heat led away", at("heat_1") + at("heat_2") + at("heat_carried"), at("heat_made"), 1e-3);
  // The faster surface takes more heat and stays colder.
  BOOST_TEST(at("heat_1") > at("heat_2"));
  BOOST_TEST(at("T1_max") < at("T2_max"));
  BOOST_TEST(std::abs(at("mu") / number_at(found, "/friction/mu") - 1) < 1e-12);
  // Flash temperatures by the moving line source differ by less than 1 % at these high Peclet numbers.
  const auto by_lines = scene.run("--set thermal.solids=lines");
  for (const char* surface : {"/thermal/T1_max", "/thermal/T2_max"})
    check_close(surface, number_at(found, surface), number_at(by_lines, surface), 0.01);
  // The summary says so too.
  const support::Ended text = scene.ehl("run d.ini --quiet --overwrite --output d.h5");
  BOOST_TEST(support::contains(text.out, " W/m made"), text.out);
}

// The rolling friction of a hot inlet must not depend on the domain: the oil upstream of it is hot as well. The
// tolerances are a third of the error that an isothermal upstream part would cause.
BOOST_AUTO_TEST_CASE(rolling_friction_of_a_hot_inlet_does_not_depend_on_the_domain) {
  const Scene scene(line + "[motion]\nu_m = 20\n[lubricant]\neta0 = 0.05\nalpha = 1.8e-8\n" + heat +
                    "[friction]\ncavitated = none\n");
  const auto rolling = [&](const char* domain) {
    return number_at(scene.run(std::string("--set domain.x_outlet=1.5 ") + domain), "/friction/mu_rolling");
  };
  const double far = rolling("--set domain.x_inlet=-18 --set grid.cells=2048");
  check_close("from -2.5", rolling("--set domain.x_inlet=-2.5 --set grid.cells=512"), far, 0.04);
  check_close("from -4.5", rolling("--set domain.x_inlet=-4.5 --set grid.cells=512"), far, 0.015);
}

// The isothermal film of a run with heat equals that of the deck without [thermal] bit for bit.
BOOST_AUTO_TEST_CASE(the_isothermal_contact_is_the_same) {
  const Scene hot, cold(line + motion + oil + shear + grid + "[friction]\ncavitated = none\n");
  support::check_isothermal_beside(hot.run(""), cold.run(""));
}

BOOST_AUTO_TEST_CASE(swapped_bodies_mirror_the_film) {
  const Scene scene;
  const auto one = scene.run("--set thermal.solid2=glass --set thermal.T_body1=90");
  const auto other =
      scene.run("--set motion.srr=-0.4 --set thermal.solid1=glass --set thermal.solid2=steel --set thermal.T_body2=90");
  support::check_mirrored(one, other);
}

// With a small dependence on temperature and no expansion, the change is proportional to it.
BOOST_AUTO_TEST_CASE(little_change_is_in_proportion) {
  const Scene scene;
  support::check_little_change(scene);
}

// The middle of an ellipse with R_x/R_y = 0.01 is a line contact with the same load per length.
BOOST_AUTO_TEST_CASE(the_middle_of_a_wide_ellipse) {
  const std::string rest = "[motion]\nu_m = 5\nsrr = 0.4\n" + oil + shear + "[friction]\ncavitated = none\n" + heat;
  const Scene wide("[contact]\nload = 350\nradius_x = 0.010\nradius_ratio = 0.01\nE_prime = 226.4e9\n" + rest +
                   "[grid]\ncells = 128\n");
  const auto ellipse = wide.run("");
  const double a = number_at(ellipse, "/a_m"), p_h = number_at(ellipse, "/p_h_Pa");
  std::istringstream rows(wide.ehl("extract d.h5 P --along x").out);
  double sum = 0.0, first = NAN, last = NAN;
  int count = 0;
  for (std::string row; std::getline(rows, row);)
    if (double x = 0.0, P = 0.0; std::istringstream(row) >> x >> P) {
      if (count++ == 0) first = x;
      last = x;
      sum += P;
    }
  BOOST_TEST_REQUIRE(count > 100);
  std::ostringstream load;
  load.precision(12);
  load << sum * (last - first) / (count - 1) * a * p_h;
  const Scene narrow("[contact]\nkind = line\nload_per_length = " + load.str() +
                     "\nradius_x = 0.010\nE_prime = 226.4e9\n" + rest + grid);
  const auto found = narrow.run("");
  const double height = std::pow(number_at(found, "/a_m") / a, 2);
  check_close("Hc", height * number_at(found, "/Hc"), number_at(ellipse, "/Hc"), 0.01);
  for (const char* name : {"/thermal/T_film_max", "/thermal/T1_max", "/thermal/T2_max"})
    check_close(name, number_at(found, name), number_at(ellipse, name), 0.015);
}

// A recirculating inlet warms its oil, and slow bodies take up heat, upstream of the first node. The reference is a
// domain with four times the inlet. If this heat were neglected, Hc would be too large.
BOOST_AUTO_TEST_CASE(what_lies_before_the_domain) {
  const Scene scene;
  const auto in_domain = [&](const std::string& more, const char* inlet, int cells) {
    return scene.run(more + " --set domain.x_outlet=1.5 --set domain.x_inlet=" + inlet +
                     " --set grid.cells=" + std::to_string(cells));
  };
  for (const char* more : {"", "--set contact.load_per_length=1e5 --set motion.u_m=5"}) {
    const auto found = in_domain(more, "-4.5", 192), longer = in_domain(more, "-18.5", 640);
    const double bar = number_at(found, "/error_parts/domain");
    for (const char* film : {"/Hc", "/Hm"}) {
      const double off = std::abs(number_at(found, film) / number_at(longer, film) - 1);
      BOOST_TEST_MESSAGE(film << " " << more << ": off by " << off << " (tolerance 9e-4), bar " << bar);
      BOOST_TEST(off < 9e-4);
      BOOST_TEST(off < bar);
    }
  }
}

// Slow sliding: on 256 cells the oil is hottest in the inlet, on finer grids under the pressure spike, which 256 cells
// do not resolve. The film temperature therefore has no error bar but a warning. The spike hardly affects the surfaces,
// whose error bars stay narrow.
BOOST_AUTO_TEST_CASE(bars_of_a_spike_that_grows) {
  const Scene scene;
  const std::string deck =
      "--set contact.load_per_length=1.954e5 --set contact.radius_x=0.00827 --set motion.u_m=2.61 "
      "--set motion.srr=0.0708 --set lubricant.eta0=0.0715 --set lubricant.alpha=1.527e-8 "
      "--set thermal.T_oil=50 --set thermal.beta=0.0394 --set shear.tau_0=5.7e6 --set grid.cells=";
  const auto coarse = scene.run(deck + "256"), fine = scene.run(deck + "2048");
  const auto converged = scene.run(deck + "256 --set multigrid.tolerance=1e-8");
  BOOST_TEST(number_at(coarse, "/thermal/T_film_max_x") < 0.0);
  BOOST_TEST(number_at(fine, "/thermal/T_film_max_x") > 0.0);
  const auto holds = [&](const auto& found, const std::string& name, double widest) {
    const double bar = number_at(found, "/thermal/error_" + name);
    const double error = std::abs(number_at(found, "/thermal/" + name) / number_at(fine, "/thermal/" + name) - 1);
    BOOST_TEST_MESSAGE(name << " off by " << error << ", bar " << bar << " (" << widest << " at most)");
    BOOST_TEST(error < bar);
    BOOST_TEST(bar < widest);
  };
  for (const auto& found : {coarse, converged}) {
    BOOST_TEST(std::isnan(number_at(found, "/thermal/error_T_film_max")));
    BOOST_TEST(found["thermal"]["warning_names"].dump().find("\"spike\"") != std::string::npos);
  }
  for (const char* surface : {"T1_max", "T2_max"}) {
    holds(coarse, surface, 0.1);  // includes the algebraic error
    holds(converged, surface, 0.05);
  }
}

// The bodies are so slow (Pe of 0.05 and 2) that heat spreads upstream of the contact. The solution must converge
// and agree with finer grids.
BOOST_AUTO_TEST_CASE(slow_surfaces) {
  const Scene scene;
  const std::string slow = "--set motion.u_m=0.1 --set motion.srr=1.9 ";
  const auto found = scene.run(slow), fine = scene.run(slow + "--set grid.cells=512");
  BOOST_TEST(number_at(found, "/thermal/peclet_2") < 0.1);
  for (const char* name : {"/thermal/mu", "/thermal/T1_max", "/thermal/T2_max"})
    check_close(name, number_at(found, name), number_at(fine, name), 5e-3);
  BOOST_TEST(std::abs(number_at(found, "/thermal/heat_imbalance")) < 1e-3);
}

BOOST_AUTO_TEST_CASE(with_little_oil) {
  const Scene scene;
  // With a supply, the boundary has no pressure.
  const auto flooded = scene.run("--set domain.far_field=zero"), thick = scene.run("--set supply.layer_m=1e-3");
  for (const char* name : {"/Hc", "/thermal/mu", "/thermal/T_film_max"})
    check_close(name, number_at(thick, name), number_at(flooded, name), 1e-3);
  const auto found = scene.run("--set supply.layer_m=300e-9");
  BOOST_TEST(std::abs(number_at(found, "/mass_imbalance")) <= 1e-10);
  BOOST_TEST(std::abs(number_at(found, "/thermal/heat_imbalance")) < 1e-3);
  // A line contact has no side flow.
  check_close("factor", number_at(found, "/starvation_factor"), number_at(found, "/starvation/supply_ratio"), 2e-3);
  BOOST_TEST(number_at(found, "/thermal/mu") > number_at(flooded, "/thermal/mu"));
}

// The coarser grids provide a start on any fine grid; a direct start on 256 cells would not converge with heat.
BOOST_AUTO_TEST_CASE(with_little_oil_on_fine_grids) {
  const Scene scene;
  scene.folder.write(
      "fine.ini",
      "[contact]\nkind = line\nload_per_length = 1e5\nradius_x = 0.01\nE_prime = 226e9\n[motion]\nu1 = 5.5\n"
      "u2 = 4.5\n[lubricant]\neta0 = 0.0165\nalpha = 1.8e-8\n[thermal]\nT_oil = 80\nbeta = 0.04\n"
      "solid1 = steel\nsolid2 = steel\n[supply]\nlayer_m = 5e-7\n");
  const auto mu_on = [&](const char* cells) {
    const support::Ended run =
        scene.ehl(std::string("run fine.ini --json --quiet --overwrite --set grid.cells=") + cells);
    BOOST_TEST_REQUIRE(run.status == 0, run.err);
    return number_at(nlohmann::json::parse(run.out), "/thermal/mu");
  };
  check_close("mu on 1024 cells", mu_on("1024"), mu_on("512"), 5e-3);
}

BOOST_AUTO_TEST_CASE(results_and_tables_hold_it) {
  const Scene scene;
  const auto found = scene.run("--set thermal.fields=T_mid,T_max,T1,T2,section");
  const ResultFile file(scene.folder / "d.h5");
  const std::vector<double> T = file.numbers("/fields/T_max").values;
  BOOST_TEST(T.size() == 257u);
  BOOST_TEST(*std::ranges::max_element(T) == number_at(found, "/thermal/T_film_max"));
  BOOST_TEST(file.numbers("/thermal_section/T").values.size() == 17u * 257u);
  // u varies from u2 = 0.8 to u1 = 1.2 u_m.
  const std::vector<double> u = file.numbers("/thermal_section/u").values;
  BOOST_TEST(u.front() == 0.8, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(u.back() == 1.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(file.numbers("/summary/heat_1").values.at(0) == number_at(found, "/thermal/heat_1"));
  BOOST_TEST(found["thermal"]["levels"].size() == 3u);
  // A traction curve: friction decreases where heat dominates.
  const support::Ended sweep = scene.ehl("sweep d.ini --vary motion.srr=0,0.02,0.1,0.4,1,1.8 --output t.csv");
  BOOST_TEST(sweep.status == 0, sweep.err);
  const std::string table = scene.folder.read("t.csv");
  BOOST_TEST(support::contains(table, "heat_1 [W/m]"), table);
  const std::vector<support::NamedRow> rows = support::named_rows(table);
  BOOST_TEST_REQUIRE(rows.size() == 6u);
  const auto mu = [&](std::size_t k) { return std::stod(rows[k].at("mu")); };
  BOOST_TEST(mu(0) == 0.0);
  BOOST_TEST((mu(1) < mu(2) && mu(2) > mu(3) && mu(3) > mu(4) && mu(4) > mu(5)), table);
}

// The pressure flow thins the oil too, with heat and without.
BOOST_AUTO_TEST_CASE(with_flow_thinning) {
  const Scene scene;
  const auto plain = scene.run("--set shear.tau_0=3e6"),
             thinned = scene.run("--set shear.flow=on --set shear.tau_0=3e6");
  BOOST_TEST(number_at(thinned, "/Hc") < number_at(plain, "/Hc"));
  const Scene cold(line + motion + oil + shear + grid);
  const auto without = cold.run("--set shear.tau_0=3e6"), with = cold.run("--set shear.flow=on --set shear.tau_0=3e6");
  BOOST_TEST(number_at(with, "/Hc") < number_at(without, "/Hc"));
  check_close("little of it", number_at(with, "/Hc"), number_at(without, "/Hc"), 0.05);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_is_refused) {
  const auto moving = [](const std::string& motion) { return line + "[motion]\n" + motion + oil + shear + heat; };
  support::check_refused({
      {"surface 2 stands", moving("u_m = 10\nsrr = 2\n"), {"srr"}},
      {"surface 1 stands", moving("u_m = 10\nsrr = -2\n"), {"srr"}},
      {"u2 = 0", moving("u1 = 10\nu2 = 0\n"), {"u2"}},
      {"u1 = 0", moving("u1 = 0\nu2 = 10\n"), {"u1"}},
      {"no speeds", "[contact]\nkind = line\nM = 50\nL = 10\n[lubricant]\nalpha = 2e-8\n" + heat, {"T_oil"}},
      {"roller",
       "[contact]\nkind = roller\nload = 1000\nlength_m = 0.01\nradius_x = 0.010\nE_prime = 226.4e9\n" + motion + oil +
           heat,
       {"T_oil"}},
  });
}

BOOST_AUTO_TEST_SUITE_END()
