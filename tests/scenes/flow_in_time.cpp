// Thinning by the pressure flow and limiting stress in time, compared with steady contacts.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "results/read.hpp"
#include "support/program.hpp"

using namespace ehl;

namespace {

// Lengths in half widths of the contact, whose load is `load` times that of 1 GPa.
std::string contact(double load) {
  const double size = std::sqrt(load);
  return "[contact]\nkind = line\nload_per_length = " + std::to_string(9.976e5 * load) +
         "\nradius_x = 0.0362\nE_prime = 228e9\n[motion]\nu1 = 0.948\nu2 = 2.845\n[lubricant]\nviscosity = "
         "roelands\neta0 = 0.02\nalpha = 2e-8\n[shear]\nlaw = eyring\ntau_0 = 4e6\nflow = on\n"
         "[friction]\ncavitated = none\nlimit = 0.05\n[domain]\nfar_field = zero\nx_inlet = " +
         std::to_string(-2.5 / size) + "\nx_outlet = " + std::to_string(1.5 / size) +
         "\n[grid]\ncells = 512\n[multigrid]\ntolerance = 1e-8\n";
}

results::ResultFile solved(const support::TemporaryFolder& folder, const std::string& name, const std::string& deck) {
  folder.write(name + ".ini", deck);
  const support::Ended run = support::ehl(folder, "run " + name + ".ini --quiet --overwrite");
  BOOST_TEST_REQUIRE(run.status == 0, run.err);
  return results::ResultFile(folder / (name + ".h5"));
}

std::vector<double> column(const results::ResultFile& file, const std::string& name) {
  return file.numbers("/transient/" + name).values;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_flow_in_time)

BOOST_AUTO_TEST_CASE(a_steady_contact_stays_steady) {
  const support::TemporaryFolder folder;
  const results::ResultFile run = solved(folder, "steady", contact(1.0) + "[transient]\nend_time = 3\n");
  for (const std::string name : {"Hc", "Hm", "P_max", "mu"}) {
    const std::vector<double> values = column(run, name);
    const auto [least, largest] = std::ranges::minmax_element(values);
    const double drift = (*largest - *least) / std::abs(values.front());
    BOOST_TEST_MESSAGE(name << " drifts by " << drift << " (1e-6)");
    BOOST_TEST(drift < 1e-6);
  }
}

// After a ramp the contact is the steady one under the new load, on the same nodes.
BOOST_AUTO_TEST_CASE(a_slow_ramp_ends_at_the_steady_contact) {
  const support::TemporaryFolder folder;
  const results::ResultFile run =
      solved(folder, "ramp", contact(1.0) + "[transient]\nend_time = 20\nload = 0:1 8:1.2\n");
  const results::ResultFile film = solved(folder, "end", contact(1.2));
  for (const auto& [name, own, factor, allowed] :
       {std::tuple{"Hc", "/summary/Hc", 1.0 / 1.2, 1e-3}, std::tuple{"Hm", "/summary/Hm", 1.0 / 1.2, 2e-3},
        std::tuple{"mu", "/summary/mu", 1.0, 1e-4}}) {
    const double ended = factor * column(run, name).back(), steady = film.numbers(own).values.front();
    BOOST_TEST_MESSAGE(name << " at the end " << ended << ", steady " << steady << " (" << allowed << ")");
    BOOST_TEST(std::abs(ended / steady - 1.0) < allowed);
  }
}

BOOST_AUTO_TEST_SUITE_END()
