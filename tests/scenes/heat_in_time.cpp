// Heat in a run in time: the steady contact, the heat balance, the order of the steps, a dent, what is refused.
#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/program.hpp"
#include "support/refused.hpp"
#include "support/solved.hpp"

using namespace ehl;
using support::column;
using support::largest;
using support::solved;
using support::summary;

namespace {

const std::string oil =
    "[lubricant]\nviscosity = roelands\neta0 = 0.04\nalpha = 2e-8\ndensity = dowson-higginson\n"
    "[shear]\nlaw = eyring\ntau_0 = 5e6\n"
    "[thermal]\nT_oil = 40\nbeta = 0.042\nsolid1 = steel\nsolid2 = steel\n";
const std::string sides = "[domain]\nx_inlet = -3\nx_outlet = 1.5\ny_half = 2\n";
const std::string ball =
    "[contact]\nload = 30\nradius_x = 9.525e-3\nE_prime = 226e9\n" + sides + "[grid]\ncells = 64\n";
const std::string ellipse =
    "[contact]\nload = 60\nradius_x = 9.525e-3\nradius_y = 30e-3\nE_prime = 226e9\n[grid]\ncells = 64\n";
std::string line_with(const std::string& load) {
  return "[contact]\nkind = line\nload_per_length = " + load +
         "\nradius_x = 0.010\nE_prime = 226e9\n[grid]\ncells = 256\n";
}
const std::string line = line_with("5e4");
const std::string slides = "[motion]\nu_m = 2\nsrr = 0.6\n";

double unsolved(const results::ResultFile& file) {
  double sum = 0.0;
  for (const double count : column(file, "not_solved")) sum += count;
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_heat_in_time)

// Film, friction and temperatures stay, and are those of the steady solver to the tolerance of its iteration.
BOOST_AUTO_TEST_CASE(a_steady_contact_stays_where_it_is) {
  const support::TemporaryFolder folder;
  for (const std::string& contact : {ball, ellipse, line}) {
    const results::ResultFile file =
        solved(folder, "steady", contact + slides + oil + "[transient]\nend_time = 10\noutput_interval = 5\n");
    for (const char* const name : {"T_film_max", "T1_max", "T2_max", "mu", "Hc"}) {
      const std::vector<double> values = column(file, name);
      double moves = 0.0;
      for (const double value : values) moves = std::max(moves, std::abs(value / values.front() - 1.0));
      const double steady = summary(file, name), apart = std::abs(values.front() / steady - 1.0);
      BOOST_TEST_MESSAGE(name << " = " << values.front() << ": moves by " << moves
                              << " (allowed 1e-6), apart from the steady solver by " << apart << " (allowed 2e-3)");
      BOOST_TEST(moves <= 1e-6);
      BOOST_TEST(apart <= 2e-3);
    }
    const double balance = largest(column(file, "heat_imbalance"));
    BOOST_TEST_MESSAGE("heat balance " << balance << " (allowed 1e-3)");
    BOOST_TEST(balance <= 1e-3);
  }
}

// A load that rises and stays ends at the steady contact of that load, with which the other run starts. With solids =
// lines both have one model of the bodies; the moving source differs from it below the pressure spike.
BOOST_AUTO_TEST_CASE(after_a_change_of_load_the_steady_contact_is_reached) {
  const support::TemporaryFolder folder;
  for (const auto& [solids, allowed] : {std::pair("lines", 5e-3), {"full", 3e-2}}) {
    const std::string deck = line + slides + oil + "solids = " + solids + "\n[transient]\n";
    const results::ResultFile risen = solved(folder, "risen", deck + "end_time = 7\nload = 0.5:1 1.5:1.2\n");
    const results::ResultFile high = solved(folder, "high", deck + "end_time = 0.01\nload = 0:1.2\n");
    for (const char* const name : {"T_film_max", "T1_max", "T2_max", "mu"}) {
      const double is = column(risen, name).back(), wanted = column(high, name).front();
      BOOST_TEST_MESSAGE(solids << ": " << name << " " << column(risen, name).front() << " to " << is << ", steady "
                                << wanted << " (allowed " << allowed << ")");
      BOOST_TEST(std::abs(is / wanted - 1.0) < allowed);
    }
  }
}

// The thin film ahead of the dent heats up, the dent cools the film; both are flashes of the order of the steady rise.
BOOST_AUTO_TEST_CASE(a_dent_crosses_a_hot_contact) {
  const support::TemporaryFolder folder;
  const std::string dent = "[surface1]\nshape = dimple\nheight_m = 150e-9\nwidth_m = 60e-6\nx = -2\n";
  const std::string deck = ball + "[motion]\nu_m = 2\nsrr = -0.6\n" + oil + dent;
  const std::string time = "[transient]\nend_time = 4.5\noutput_interval = 0.25\n";
  const results::ResultFile file = solved(folder, "dent", deck + time, "--threads 1");
  const results::ResultFile other = solved(folder, "other", deck + time, "--threads 2");
  const std::vector<double> film = column(file, "T_film_max"), T2 = column(file, "T2_max");
  const double most = largest(film) / film.front(), balance = largest(column(file, "heat_imbalance"));
  BOOST_TEST_MESSAGE("film " << film.front() << " K, at most " << largest(film) << " K, at the end " << film.back()
                             << " K; heat balance " << balance << " (allowed 1e-3)");
  BOOST_TEST(most > 1.01);
  BOOST_TEST(most < 2.0);
  BOOST_TEST(std::abs(film.back() / film.front() - 1.0) < 0.1);
  BOOST_TEST(balance <= 1e-3);
  BOOST_TEST((film == column(other, "T_film_max")));  // the same bits for any number of threads
  const std::vector<double> field = file.frame("/transient/frames/T1", 0).values;
  BOOST_TEST(std::abs(largest(field) / column(file, "T1_max").front() - 1.0) < 1e-12);
  const support::Ended drawn = support::ehl(folder, "plot dent.h5 --format svg --figure transient_heat");
  BOOST_TEST((drawn.status == 0 && drawn.err.empty()), drawn.err);
}

// A small tolerance makes the first steps short; the closed far field must follow them.
BOOST_AUTO_TEST_CASE(small_tolerances_are_followed) {
  const support::TemporaryFolder folder;
  const std::string dent = "[surface1]\nshape = dimple\nheight_m = 150e-9\nwidth_m = 60e-6\nx = -2\n";
  for (const char* rtol : {"1e-5", "1e-6"}) {
    const results::ResultFile file = solved(
        folder, "dent",
        ball + "[motion]\nu_m = 2\nsrr = -0.6\n" + oil + dent + "[transient]\nend_time = 1\nrtol = " + rtol + "\n");
    BOOST_TEST_MESSAGE("rtol = " << rtol << ": " << column(file, "time").size() << " rows, " << unsolved(file)
                                 << " attempts not solved (0)");
    BOOST_TEST(unsolved(file) == 0.0);
  }
}

// Some of these contacts need stronger damping in long steps.
BOOST_AUTO_TEST_CASE(ellipses_near_a_circle_are_followed) {
  const support::TemporaryFolder folder;
  for (const double ratio : {0.5, 0.65, 0.8})
    for (const int cells : {64, 96}) {
      const std::string contact =
          fmt::format("[contact]\nload = 60\nradius_x = 9.525e-3\nradius_y = {}\nE_prime = 226e9\n[grid]\ncells = {}\n",
                      9.525e-3 * ratio, cells);
      const results::ResultFile file =
          solved(folder, "ellipse", contact + slides + oil + "[transient]\nend_time = 1.5\nmax_step = 0.1\n");
      BOOST_TEST_MESSAGE("radius ratio " << ratio << ", " << cells << " cells: " << column(file, "time").size()
                                         << " rows, " << unsolved(file) << " attempts not solved (0)");
      BOOST_TEST(unsolved(file) == 0.0);
    }
}

BOOST_AUTO_TEST_CASE(what_no_run_in_time_can_do_is_refused) {
  const std::string time = "[transient]\nend_time = 1\n";
  support::check_refused(
      {{"slow",
        ball + "[motion]\nu_m = 2\nsrr = -1.9\n" + oil + time,
        {"thermal", "of surface 1 falls to", "5 are needed", "remove [transient]"}},
       {"stops", ball + slides + oil + time + "u1 = 0:1.3 1:0.01\n", {"of surface 1 falls to"}},
       {"content", ball + slides + oil + time + "cavitation = content\n", {"thermal", "cavitation = pressure"}},
       {"checkpoint", ball + slides + oil + time + "[output]\ncheckpoint = 10\n", {"checkpoint", "[thermal]"}},
       {"gap", ball + slides + oil + time + "[body]\nmass_kg = 0.03\ngap_m = 1e-6\n", {"thermal", "remove gap"}}});
}

BOOST_AUTO_TEST_SUITE_END()
