// Cycles and reversing motion through the program: what is refused, and what the result contains.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "support/refused.hpp"
#include "support/solved.hpp"

using namespace ehl;

namespace {

const std::string dimensionless =
    "[contact]\nkind = line\nM = 10\nL = 5\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n[domain]\nx_inlet = -4\nx_outlet = "
    "4\n[grid]\ncells = 128\n[transient]\nend_time = 8\n";
const std::string steel =
    "[contact]\nkind = line\nload_per_length = 20000\nradius_x = 0.01\nE_prime = 2.26e11\n[motion]\nu1 = 1\nu2 = 1\n"
    "[lubricant]\neta0 = 0.02\nalpha = 2e-8\n[domain]\nx_inlet = -4\nx_outlet = 4\n[grid]\ncells = 128\n[transient]\n"
    "time_unit = seconds\nend_time = 1e-3\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(test_cycles)

BOOST_AUTO_TEST_CASE(what_is_wrong_with_a_table_is_refused) {
  const support::TemporaryFolder folder;
  const struct {
    const char* name;
    std::string table, deck;
    std::vector<std::string> parts;
  } slips[] = {
      {"no columns", "t\n0\n8\n", "", {"cycle", "radius_x, load, u1, u2"}},
      {"an unknown column", "t,lod\n0,1\n8,1\n", "", {"c.csv:1", "lod"}},
      {"a length without SI", "t,radius_x [m]\n0,1\n8,1\n", "", {"c.csv:1", "radius_x"}},
      {"one row", "t,load\n0,1\n", "", {"fewer than two rows"}},
      {"a late start", "t,load\n1,1\n8,1\n", "", {"t = 0"}},
      {"times that fall", "t,load\n0,1\n4,1\n3,1\n8,1\n", "", {"c.csv:4", "t falls"}},
      {"an open cycle", "t,load\n0,1\n8,1.5\n", "", {"cycle_repeats = off", "load"}},
      {"no radius", "t,radius_x\n0,1\n4,0\n8,1\n", "", {"c.csv:3", "radius_x", "0.001 to 1000"}},
      {"a huge radius", "t,radius_x\n0,1\n4,1e30\n8,1\n", "", {"c.csv:3", "radius_x", "0.001 to 1000"}},
      {"states at a jump", "t,load\n0,1\n4,1\n4,2\n8,1\n", "mode = both\n", {"mode", "jumps"}},
      {"states without oil content",
       "t,load\n0,1\n8,1\n",
       "mode = quasi_steady\ncavitation = content\n",
       {"mode", "cavitation = pressure"}},
      {"a tolerance of no use", "t,load\n0,1\n8,1\n", "mode = quasi_steady\nrtol = 1e-3\n", {"rtol", "no influence"}},
      {"no load", "t,load\n0,1\n4,0\n8,1\n", "", {"[transient] cycle", "the load must stay positive"}},
      {"states of two periods", "t,load\n0,1\n4,1\n", "mode = quasi_steady\n", {"end_time", "one period", "4"}},
      {"no period",
       "t,load\n0,1\n8,1\n",
       "cycle_repeats = off\nstop_periodic = 1e-3\n",
       {"stop_periodic", "cycle_repeats"}},
      {"two loads", "t,load\n0,1\n8,1\n", "load = 1:1 2:2\n", {"load", "remove one"}},
      {"many periods", "t,load\n0,1\n1e-4,1\n", "", {"cycle", "periods"}},
      {"a start at rest", "t,u1,u2\n0,0,0\n4,1,1\n8,0,0\n", "", {"cycle", "positive at time 0"}},
      {"states of a body",
       "t,load\n0,1\n8,1\n",
       "mode = quasi_steady\n[surface1]\nshape = ridge\nheight = 0.1\nwidth = 1\n",
       {"mode"}},
  };
  for (const auto& slip : slips) {
    folder.write("c.csv", slip.table);
    support::check_refused(folder, {slip.name, dimensionless + "cycle = c.csv\n" + slip.deck, slip.parts});
  }
  folder.write("c.csv", "t,u1,u2\n0,1,1\n4,-1,-1\n8,1,1\n");
  support::check_refused(folder,
                         {"a short outlet", dimensionless + "cycle = c.csv\n[domain]\nx_outlet = 2\n", {"x_outlet"}});
  for (const char* key : {"cycle_repeats = off\n", "stop_periodic = 1e-3\n", "mode = both\n"})
    support::check_refused(folder, {key, dimensionless + key, {"cycle"}});
}

// Between two rows with opposite directions the film vanishes, and no number is drawn through that time.
BOOST_AUTO_TEST_CASE(no_state_is_interpolated_through_rest) {
  const support::TemporaryFolder folder;
  folder.write("c.csv", "t,u1,u2\n0,1,1\n4,-1,-1\n8,1,1\n");
  const results::ResultFile file = support::solved(folder, "d", dimensionless + "cycle = c.csv\nmode = both\n");
  const auto column = [&](const char* name) { return file.numbers(std::string("/transient/") + name).values; };
  const std::vector<double> films = column("Hc_quasi_steady"), times = column("time");
  int between = 0;
  for (std::size_t k = 0; k < films.size(); ++k) between += times[k] > 0.0 && times[k] < 4.0 && std::isfinite(films[k]);
  BOOST_TEST_MESSAGE(between << " quasi-steady films between the states at 0 and 4 (0)");
  BOOST_TEST((times.size() > 10 && between == 0));
}

// The columns of a table in SI become values relative to the contact; quasi-steady films stand next to those in time.
BOOST_AUTO_TEST_CASE(a_table_in_si_is_converted) {
  const support::TemporaryFolder folder;
  folder.write("c.csv",
               "t [ms],radius_x [mm],load [N/mm],u1 [mm/s],u2 [mm/s]\n0,10,20,1000,1000\n0.5,8,25,-500,-500\n"
               "1,10,20,1000,1000\n");
  const results::ResultFile file =
      support::solved(folder, "d", steel + "cycle = c.csv\nmode = both\n[multigrid]\ntolerance = 1e-9\n");
  const auto column = [&](const char* name) { return file.numbers(std::string("/transient/") + name).values; };
  const double film = column("Hc_quasi_steady").front() / column("Hc").front() - 1.0;
  BOOST_TEST_MESSAGE("the quasi-steady film at the start differs by " << film << " from the run's (1e-6)");
  BOOST_TEST(std::abs(film) <= 1e-6);
  for (const char* name : {"radius_x", "load", "speed"})
    for (const double value : {column(name).front(), column(name).back()}) BOOST_TEST(std::abs(value - 1.0) <= 1e-9);
  const auto least = [&](const char* name) { return std::ranges::min(column(name)); };
  BOOST_TEST(std::abs(least("radius_x") - 0.8) < 0.02);
  BOOST_TEST(std::abs(least("speed") + 0.5) < 0.05);
}

BOOST_AUTO_TEST_SUITE_END()
