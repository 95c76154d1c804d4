// Traced rollers: roughness and film, what is reported of them, and that a contact whose surfaces touch ends soon.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <sstream>

#include "support/columns.hpp"
#include "support/refused.hpp"
#include "support/text.hpp"

namespace {

// (20, 10), 30 half widths long; the minimum film of smooth surfaces is 0.07 a^2/R.
const std::string deck =
    "[contact]\nkind = roller\nM = 20\nL = 10\nlength = 30\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n"
    "[grid]\ncells = 128\n[roller]\nprofile = table\nfile = p.csv\n";

// A trace with a crown, waves 0.6 and 0.9 a long with their root mean square, and a tilt.
std::string trace(double Rq, double tilt = 0.0) {
  std::ostringstream text;
  text << "y,drop\n";
  text.precision(12);
  for (int k = -300; k <= 300; ++k) {
    const double y = 0.05 * k, pi = std::numbers::pi;
    text << y << "," << y * y / 60.0 + Rq * (std::sin(2.0 * pi * y / 0.6) + std::cos(2.0 * pi * y / 0.9)) + tilt * y
         << "\n";
  }
  return text.str();
}

double after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + words.size()));
}

int count(const std::string& text, const std::string& words) {
  int found = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++found;
  return found;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_rough_rollers)

BOOST_AUTO_TEST_CASE(check_tells_the_roughness_beside_the_film) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  for (const double Rq : {0.005, 0.04, 0.15}) {
    folder.write("p.csv", trace(Rq));
    const support::Ended ended = support::ehl(folder, "check d.ini");
    BOOST_TEST_REQUIRE(ended.status == 0, ended.err);
    const double told = after(ended.out, "S_q = "), lambda = after(ended.out, "h_m/S_q = ");
    BOOST_TEST_MESSAGE("Rq " << Rq << ": reported " << told << ", lambda ratio " << lambda);
    BOOST_TEST(std::abs(told / Rq - 1.0) < 0.05);
    BOOST_TEST(support::contains(ended.out, "[lambda]") == (lambda < 3.0), ended.out);
    const std::string needs = ended.out.substr(ended.out.find("\nneeds "));
    BOOST_TEST(support::contains(needs, "smooth surfaces") == (lambda > 1.5 && lambda < 5.0), needs);
    BOOST_TEST(support::contains(needs, "one start") == (lambda < 1.0), needs);
  }
  folder.write("p.csv", trace(0.0));
  const std::string smooth = support::ehl(folder, "check d.ini").out;
  BOOST_TEST(!support::contains(smooth, "[lambda]"));
  BOOST_TEST(!support::contains(smooth.substr(smooth.find("\nneeds ")), "smooth surfaces"), smooth);
}

BOOST_AUTO_TEST_CASE(surfaces_that_touch_are_given_up_after_one_start) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  folder.write("p.csv", trace(0.25));
  const support::Ended ended = support::ehl(folder, "run d.ini --quiet");
  BOOST_TEST(ended.status == 3, ended.out + ended.err);
  BOOST_TEST(ended.says({"[roller] shortest_wave"}), ended.err);
  BOOST_TEST(count(ended.out, "tried before") == 1, ended.out);
  BOOST_TEST(support::contains(ended.out, ", dry -; "), ended.out);  // no dry contact is solved beside it
  // With the filter the surfaces are separated.
  const support::Ended smooth = support::ehl(folder, "run d.ini --quiet --output s.h5 --set roller.shortest_wave=3");
  BOOST_TEST(smooth.status == 0, smooth.err);
  folder.write("p.csv", trace(0.02));
  BOOST_TEST(support::ehl(folder, "run d.ini --quiet --output r.h5").status == 0);
}

// A filter halves a wave with the length of its cut-off; the least-squares line removes a tilt.
BOOST_AUTO_TEST_CASE(traces_are_filtered_and_levelled) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  folder.write("p.csv", trace(0.02, 0.01));
  const std::string out =
      support::ehl(folder, "check d.ini --set roller.levelling=line --set roller.shortest_wave=0.9").out;
  BOOST_TEST(std::abs(after(out, "levelled by dH/dY = ") - 0.01) < 2e-4, out);
  const auto passed = [](double ratio) {
    const double b = std::numbers::pi * std::pow(0.7309 * ratio, 2);
    return (1.0 + b) * std::exp(-b);
  };
  const double wanted = 0.02 * std::hypot(passed(1.5), passed(1.0)) / std::sqrt(2.0);
  BOOST_TEST_MESSAGE("Rq " << after(out, ", Rq ") << ", wanted " << wanted);
  BOOST_TEST(std::abs(after(out, ", Rq ") / wanted - 1.0) < 0.05, out);
}

BOOST_AUTO_TEST_SUITE_END()
