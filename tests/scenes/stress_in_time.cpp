// Stresses at the stored times of a run in time, and what the material of the bodies meets.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

#include "support/program.hpp"
#include "support/refused.hpp"
#include "support/solved.hpp"
#include "support/stopped.hpp"

using namespace ehl;
using support::distance;
using support::solved;

namespace {

const std::string oil = "a_over_R = 0.01\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n[multigrid]\ntolerance = 1e-9\n";
const std::string point =
    "[contact]\nM = 50\nL = 10\n" + oil +
    "[domain]\nfar_field = zero\nx_inlet = -2.5\nx_outlet = 1.5\ny_half = 2\n[grid]\ncells = 64\n";
const std::string line = "[contact]\nkind = line\nM = 20\nL = 5\n" + oil + "[grid]\ncells = 128\n";
const std::string rubs = "[friction]\ncavitated = striated\nlimit = 0.08\n";
const std::string stresses = "[subsurface]\ndepth = 1.5\nplanes = 13\ncells = 32\n";

double number(const results::ResultFile& file, const std::string& name) { return file.numbers(name).values.at(0); }

}  // namespace

BOOST_AUTO_TEST_SUITE(test_stress_in_time)

BOOST_AUTO_TEST_CASE(a_steady_run_keeps_the_steady_stresses) {
  const support::TemporaryFolder folder;
  const std::string time = "[motion]\nsrr = 0.4\n[transient]\nend_time = 3\noutput_interval = 0.1\n";
  for (const std::string& contact : {point, line}) {
    const results::ResultFile file = solved(folder, "steady", contact + rubs + stresses + time);
    for (const std::string name : {"largest_sigma_mises", "largest_sigma_mises_x", "largest_sigma_mises_z",
                                   "largest_tau_max", "largest_tau_max_z"}) {
      const double steady = number(file, "/subsurface/" + name);
      double worst = 0.0;
      for (const double one : file.numbers("/stresses_in_time/" + name).values)
        worst = std::max(worst, std::abs(one - steady));
      BOOST_TEST_MESSAGE(name << " = " << steady << ", largest difference in time " << worst << " (1e-6)");
      BOOST_TEST(worst < 1e-6);
    }
    // The file has them in single precision.
    for (const std::string name : {"sigma_mises", "tau_xz", "sigma_x"})
      BOOST_TEST(distance(file.numbers("/subsurface/section/" + name).values,
                          file.frame("/stresses_in_time/" + name, 5).values) < 1e-6);
    // No point of the material meets more than the largest stress of all, and the range of tau_xz is about that below
    // a Hertzian contact: 0.5 p_h of a line contact, 0.43 p_h of a circular one (Johnson 1985).
    const double met = number(file, "/history_1/most_sigma_mises");
    const double range = number(file, "/history_1/range_tau_xz"), hertzian = contact == line ? 0.5 : 0.43;
    BOOST_TEST(met <= 1.001 * number(file, "/subsurface/largest_sigma_mises"));
    BOOST_TEST(met >= 0.97 * number(file, "/subsurface/largest_sigma_mises"));
    BOOST_TEST_MESSAGE("range of tau_xz " << range << ", Hertz " << hertzian);
    BOOST_TEST(std::abs(range / hertzian - 1.0) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(exchanged_bodies_exchange_their_histories) {
  const support::TemporaryFolder folder;
  const auto deck = [](const char* u1, const char* u2, const char* surface) {
    return line + rubs + stresses + "[transient]\nend_time = 2\noutput_interval = 0.1\nu1 = " + u1 + "\nu2 = " + u2 +
           "\n[" + surface + "]\nshape = ridge\nheight = 0.02\nwidth = 0.8\nx = -1.5\n";
  };
  const results::ResultFile one = solved(folder, "one", deck("0:1.3 1:1.2", "0:0.7 1:0.9", "surface1"));
  const results::ResultFile other = solved(folder, "other", deck("0:0.7 1:0.9", "0:1.3 1:1.2", "surface2"));
  const support::Ended drawn = support::ehl(folder, "plot one.h5 --format svg --figure material_history");
  BOOST_TEST(drawn.status == 0, drawn.err);
  for (const std::string name : {"most_sigma_mises", "most_tau_max", "range_tau_xz"}) {
    const std::vector<double> first = one.numbers("/history_1/section_" + name).values;
    const double difference = distance(first, other.numbers("/history_2/section_" + name).values);
    const double apart = std::abs(number(one, "/history_1/" + name) - number(one, "/history_2/" + name));
    BOOST_TEST_MESSAGE(name << ": exchanged " << difference << " (1e-9), the two bodies " << apart);
    BOOST_TEST(difference < 1e-9);
    BOOST_TEST(apart > 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(threads_and_resume_keep_the_stresses) {
  const support::TemporaryFolder folder;
  const std::string deck =
      point + rubs + stresses +
      "[motion]\nsrr = 0.4\n[transient]\nend_time = 1\noutput_interval = 0.1\nload_wave = 0.2 0.7\n";
  const results::ResultFile one = solved(folder, "one", deck, "--threads 1");
  const results::ResultFile two = solved(folder, "two", deck, "--threads 2");
  for (const std::string name : {"/stresses_in_time/largest_tau_max", "/history_1/section_most_tau_max",
                                 "/history_2/section_range_tau_xz", "/history_2/most_sigma_mises_x"})
    BOOST_TEST((one.numbers(name).values == two.numbers(name).values));
  BOOST_TEST_REQUIRE(
      support::stopped_where(folder, "run one.ini --output half.h5 --quiet", support::between_two_steps).status == 130);
  const support::Ended resumed = support::ehl(folder, "resume half.h5 --quiet");
  BOOST_TEST_REQUIRE(resumed.status == 0, resumed.err);
  const results::ResultFile half(folder / "half.h5");
  for (const std::string name : {"/stresses_in_time/largest_tau_max", "/history_1/section_most_tau_max"})
    BOOST_TEST(distance(one.numbers(name).values, half.numbers(name).values) < 1e-4);  // another choice of steps
}

BOOST_AUTO_TEST_CASE(coarse_samples_warn_and_missing_ones_are_refused) {
  const support::TemporaryFolder folder;
  folder.write("coarse.ini", line + rubs + stresses + "[transient]\nend_time = 1\noutput_interval = 0.5\n");
  const support::Ended ended = support::ehl(folder, "run coarse.ini --quiet");
  BOOST_TEST(ended.status == 0);
  // The domain of 32 cells; a body moves by 0.5 a between two stored times.
  const std::vector<double> x = results::ResultFile(folder / "coarse.h5").numbers("/stresses_in_time/x").values;
  std::ostringstream cells;
  cells.precision(2);
  cells << 0.5 / (x[1] - x[0]) << " cells";
  BOOST_TEST((ended.out + ended.err).find("[coarse-history]") != std::string::npos);
  BOOST_TEST((ended.out + ended.err).find(cells.str()) != std::string::npos, cells.str() + ended.out);
  support::check_refused(folder, {"no stored times",
                                  line + rubs + stresses + "[transient]\nend_time = 1\n",
                                  {"[subsurface] depth", "output_interval"}});
  support::check_refused(folder, {"no stored pressures",
                                  line + stresses +
                                      "[output]\nfields = H\n[transient]\nend_time = 1\n"
                                      "output_interval = 0.1\n",
                                  {"[output] fields", "P"}});
}

BOOST_AUTO_TEST_SUITE_END()
