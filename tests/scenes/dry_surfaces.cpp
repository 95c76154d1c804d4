// Dry contacts with surfaces that are not smooth, through the program.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <sstream>

#include "support/columns.hpp"
#include "support/json.hpp"
#include "support/refused.hpp"
#include "support/text.hpp"

namespace {

using support::rows_of;

const std::string dry = "[case]\nkind = dry\n[grid]\ncells = 128\n";
const std::string dimple = "[surface1]\nshape = dimple\nheight = 0.02\nwidth = 0.4\n";
// a = 136.7 um, a^2/R = 1.496 um.
const std::string steel = "[contact]\nload = 15\nradius_x = 0.0125\nE_prime = 110e9\n";

using support::contains;

std::vector<std::vector<double>> field(const support::TemporaryFolder& folder, const std::string& file,
                                       const std::string& words) {
  const support::Ended ended = support::ehl(folder, "extract " + file + " " + words);
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  return rows_of(ended.out);
}

void run(const support::TemporaryFolder& folder, const std::string& name, const std::string& deck) {
  folder.write(name + ".ini", deck);
  const support::Ended ended = support::ehl(folder, "run " + name + ".ini --quiet");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
}

double largest_difference(const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b) {
  BOOST_REQUIRE(a.size() == b.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k].back() - b[k].back()));
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_dry_surfaces)

// A wave A cos(2 pi x/w) that is pressed flat: Westergaard's pressure pi^2 A/(2 w), in units of p_h and a^2/R, is
// added to the Hertz pressure.
BOOST_AUTO_TEST_CASE(waves_pressed_flat) {
  constexpr double w = 0.375, p = 0.2;
  const double A = 2.0 * w * p / (std::numbers::pi * std::numbers::pi);
  std::ostringstream waves;
  waves << "[surface1]\nshape = waviness\nwidth = " << w << "\nheight = " << A << "\n";
  const support::TemporaryFolder folder;
  run(folder, "wavy", dry + waves.str());
  run(folder, "smooth", dry);
  const auto wavy = field(folder, "wavy.h5", "P --along x"), smooth = field(folder, "smooth.h5", "P --along x");
  const auto gap = field(folder, "wavy.h5", "gap --along x"), S = field(folder, "wavy.h5", "S --along x");
  const std::size_t middle = 64, half_a_wave = 8;
  const auto more = [&](std::size_t k) { return wavy[k][1] - smooth[k][1]; };
  const double amplitude = 0.25 * (more(middle - half_a_wave) + more(middle + half_a_wave) - 2.0 * more(middle));
  BOOST_TEST_MESSAGE("amplitude of the pressure over Westergaard's " << amplitude / p << " (1 within 0.02)");
  BOOST_TEST(std::abs(amplitude / p - 1.0) < 0.02);
  BOOST_TEST(std::abs(gap[middle][1]) < 1e-7);
  // The mean of the wave over a cell is smaller by the factor sin(pi h/w)/(pi h/w), 0.9936 for 16 cells per wave.
  BOOST_TEST_MESSAGE("S in the middle over A " << S[middle][1] / A << " (0.9936)");
  BOOST_TEST(std::abs(S[middle][1] / A - 0.9936) < 1e-3);
  BOOST_TEST(support::ehl(folder, "extract smooth.h5 S").status == 2);
}

BOOST_AUTO_TEST_CASE(both_sides_of_y) {
  const support::TemporaryFolder folder;
  const std::string ridge = "[surface2]\nshape = ridge\nheight = 0.05\nwidth = 0.3\nx = 0.3\nangle = ";
  run(folder, "left", dry + ridge + "30\n");
  run(folder, "right", dry + ridge + "-30\n");
  const auto left = field(folder, "left.h5", "P --along y --at x=0");
  auto right = field(folder, "right.h5", "P --along y --at x=0");
  const double own = largest_difference(left, {right.rbegin(), right.rend()});
  const double other = largest_difference(left, right);
  BOOST_TEST_MESSAGE("mirrored " << own << " (1e-6), not mirrored " << other << " (more than 0.1)");
  BOOST_TEST(own < 1e-6);
  BOOST_TEST(other > 0.1);
}

BOOST_AUTO_TEST_CASE(the_same_in_metres_and_from_its_own_deck) {
  const support::TemporaryFolder folder;
  run(folder, "plain", dry + dimple);
  const double a = 136.725e-6, height = a * a / 0.0125;
  std::ostringstream metres;
  metres << "[surface1]\nshape = dimple\nheight_m = " << 0.02 * height << "\nwidth_m = " << 0.4 * a << "\n";
  run(folder, "metres", dry + steel + metres.str() + "[subsurface]\ndepth = 1\nplanes = 5\n");
  const double scales = largest_difference(field(folder, "plain.h5", "P"), field(folder, "metres.h5", "P"));
  BOOST_TEST_MESSAGE("in metres and in units of Hertz " << scales << " (1e-4)");
  BOOST_TEST(scales < 1e-4);
  folder.write("again.ini", support::ehl(folder, "extract metres.h5 deck").out);
  BOOST_REQUIRE(support::ehl(folder, "run again.ini --threads 1").status == 0);
  for (const char* name : {"P", "gap", "S", "/subsurface/section/sigma_mises"})
    BOOST_TEST(largest_difference(field(folder, "metres.h5", name), field(folder, "again.h5", name)) == 0.0, name);
  // A dimple of 0.02 that is pressed flat reduces the pressure in the centre, and thus the stresses.
  const support::Ended checked = support::ehl(folder, "check metres.ini");
  for (const char* part : {"surface1", "29.9 nm (0.02)", "subsurface"})
    BOOST_TEST(contains(checked.out, part), checked.out);
  const support::Ended json = support::ehl(folder, "run metres.ini --json --overwrite");
  BOOST_TEST(support::is_json(json.out));
  BOOST_TEST(contains(json.out, "\"name\":\"surfaces\""), json.out);
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_refused) {
  const std::vector<support::Slip> slips{
      {"at rest", dry + dimple + "at_rest = yes\n", {"d.ini:9", "at_rest = yes", "kind = dry"}},
      {"in metres", dry + "[surface1]\nshape = dimple\nheight_m = 1e-8\nwidth = 0.4\n", {"d.ini:7"}},
      {"elsewhere", dry + dimple + "x = 50\n", {"d.ini:6", "shape = dimple"}},
      {"too small", dry + "[surface1]\nshape = dimple\nheight = 0.1\nwidth = 0.01\n", {"d.ini:8"}},
      {"no height", dry + "[surface2]\nshape = ridge\nwidth = 1\n", {"[surface2] height"}},
      {"no map", dry + "[surface2]\nshape = map\nunit = 1\ndx = 0.1\n", {"[surface2] file"}},
      {"in time", dry + dimple + "[transient]\nend_time = 1\n", {"end_time = 1"}}};
  const support::TemporaryFolder folder;
  for (const support::Slip& slip : slips) support::check_refused(folder, slip);
  // An error in the contact causes no further errors about lengths in metres.
  folder.write("d.ini", dry + steel + "radius_y = 0.02\n[surface1]\nshape = dimple\nheight_m = 1e-8\nwidth_m = 5e-5\n");
  const support::Ended one = support::ehl(folder, "check d.ini");
  BOOST_TEST(one.status == 2);
  BOOST_TEST(one.says({"d.ini:9: [contact] radius_y"}), one.err);
  BOOST_TEST(!contains(one.err, "height_m"), one.err);
}

BOOST_AUTO_TEST_SUITE_END()
