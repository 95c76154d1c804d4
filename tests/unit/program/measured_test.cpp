// Measured traction curves as spreadsheets and rigs write them.
#include "tables/measured.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "core/errors.hpp"
#include "support/temporary_folder.hpp"
#include "support/text.hpp"

using namespace ehl;

namespace {

std::string wrong(const std::string& text) {
  const support::TemporaryFolder folder;
  const std::string path = folder.write("m.csv", text);
  return support::refusal<core::FileError>([&] { program::read_measured(path); });
}

bool says(const std::string& text, const std::string& part) {
  const std::string found = wrong(text);
  BOOST_TEST_MESSAGE(found);
  return support::contains(found, part);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_measured)

// Every text holds the same ratios and the same friction.
BOOST_AUTO_TEST_CASE(per_cent_and_ratios_are_the_same_curve) {
  for (const char* text :
       {"0.1,0.055\n0.2,0.0625\n", "srr,mu\n0.2,0.0625\n0.1,0.055\n", "SRR (%),mu [%]\n10,5.5\n20,6.25\n",
        "SRR (%);mu [%]\n10;5,5\n20;6,25\n", "mu\tSRR [%]\n0,055\t10\n0,0625\t20\n",
        "\"Slide-roll ratio [%]\",\"Traction coefficient [-]\"\n10,0.055\n20,0.0625\n",
        "SRR;COF\n%;-\n10;0,055\n20;0,0625\n", "Slide roll ratio / %, friction coefficient\n10, 0.055\n20, 0.0625\n"}) {
    const support::TemporaryFolder folder;
    const std::vector<program::MeasuredPoint> points = program::read_measured(folder.write("m.csv", text));
    BOOST_TEST_REQUIRE(points.size() == 2u, text);
    BOOST_TEST_MESSAGE(points[0].srr << " " << points[0].mu << " " << points[1].srr << " " << points[1].mu);
    const auto rounding = boost::test_tools::tolerance(1e-14);
    BOOST_TEST(points[0].srr == 0.1, rounding);
    BOOST_TEST(points[0].mu == 0.055, rounding);
    BOOST_TEST(points[1].srr == 0.2, rounding);
    BOOST_TEST(points[1].mu == 0.0625, rounding);
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_traction_curve_is_refused_with_its_cure) {
  BOOST_TEST(says("srr,mu\n10,0.05\n20,0.06\n", "m.csv:2: 10: "));
  BOOST_TEST(says("srr,mu\n0.1,5\n", "m.csv:2: 5: "));
  BOOST_TEST(says("SRR,SRR,mu\n0.1,0.1,0.05\n", "m.csv:1: 'srr'"));
  BOOST_TEST(says("SRR [m/s],mu\n0.1,0.05\n", "m.csv:1: "));
  BOOST_TEST(says("SRR;mu\n1,234;1,234\n", "1234"));
  for (const char* films : {"u [m/s],h_c [nm]\n0.02,24.4\n", "speed;film [nm]\n0,02;24,4\n", "u,h_c\n0.02,2.4e-8\n"}) {
    BOOST_TEST(says(films, "h_c_nm"), films);  // the column of a sweep that films are compared with
  }
}

BOOST_AUTO_TEST_SUITE_END()
