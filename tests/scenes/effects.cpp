// The effects of a deck as a user sees them: `ehl check`, the summary, the JSON, the result file.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "results/read.hpp"
#include "support/json.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

using ehl::results::ResultFile;

namespace {

const std::string plain =
    "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\nz = 0.68\n[domain]\nx_inlet = -4.5\ny_half = 3\n[grid]\n"
    "cells = 64\n";
const std::string in_time =
    "[transient]\nend_time = 0.1\nload = 0.02:1 0.08:1.05\n[surface1]\nshape = ridge\nheight = 0.01\nwidth = 0.5\n"
    "angle = 30\nx = -0.5\n";

using support::contains;

struct Scene {
  support::TemporaryFolder folder;
  Scene() {
    folder.write("plain.ini", plain);
    folder.write("timed.ini", plain + in_time);
  }
  support::Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(test_effects)

BOOST_AUTO_TEST_CASE(check_says_what_is_on_and_why) {
  const Scene scene;
  const std::string two = scene.ehl("check timed.ini").out;
  for (const char* part : {"[transient] end_time = 0.1 (timed.ini:13)", "[surface1] shape = ridge (timed.ini:16)"})
    BOOST_TEST(contains(two, part), part << " is missing in\n" << two);
}

// A line contact is not called an ellipse in `ehl check`, the summary and the JSON.
BOOST_AUTO_TEST_CASE(a_line_is_called_a_line) {
  const Scene scene;
  scene.folder.write("line.ini",
                     "[contact]\nkind = line\nM = 10\nL = 5\n[lubricant]\nalpha = 2.2e-8\n[grid]\ncells = 64\n");
  const std::string told = scene.ehl("check line.ini").out;
  const support::Ended text = scene.ehl("run line.ini --quiet --output line.h5");
  const support::Ended json = scene.ehl("run line.ini --quiet --json --overwrite --output line.h5");
  BOOST_REQUIRE_MESSAGE(text.status == 0 && json.status == 0, text.err + json.err);
  BOOST_TEST(contains(json.out, "\"effects\":[{\"name\":\"line\""), json.out);
  for (const std::string& said : {told, text.out, json.out}) BOOST_TEST(!contains(said, "elliptic"), said);
}

// An effect that is off leaves no trace; one that is on is listed with name, seconds and reason.
BOOST_AUTO_TEST_CASE(results_name_the_effects_that_were_on) {
  const Scene scene;
  const support::Ended none = scene.ehl("run plain.ini --json --quiet");
  BOOST_REQUIRE_MESSAGE(none.status == 0, none.err);
  BOOST_TEST(contains(none.out, "\"effects\":[]"));
  const ResultFile without(scene.folder / "plain.h5");
  BOOST_TEST((without.kind("/effects") == ResultFile::Kind::missing));
  BOOST_TEST((without.kind("/transient") == ResultFile::Kind::missing));

  const support::Ended two = scene.ehl("run timed.ini --json --quiet");
  BOOST_REQUIRE_MESSAGE(two.status == 0, two.err);
  BOOST_TEST(support::is_json(two.out), two.out);
  for (const char* part : {"\"effects\":[{\"name\":\"transient\",\"seconds\":", "{\"name\":\"surfaces\",",
                           "\"why\":\"[surface1] shape = ridge\"", "\"transient\":{\"completed\":true"})
    BOOST_TEST(contains(two.out, part), part << " is missing in\n" << two.out);
  const ResultFile with(scene.folder / "timed.h5");
  BOOST_TEST(with.names("/effects") == (std::vector<std::string>{"surfaces", "transient"}),
             boost::test_tools::per_element());
  for (const char* name : {"/effects/surfaces", "/effects/transient"}) {
    const ehl::results::Array seconds = with.numbers(name);
    BOOST_TEST((seconds.values.size() == 1 && seconds.values[0] > 0.0), name);
    BOOST_TEST(seconds.unit == "s");
  }
  BOOST_TEST(with.attribute("/effects/transient", "why") == "[transient] end_time = 0.1");
  BOOST_TEST(with.attribute("/effects/surfaces", "meaning") ==
             "ridge on surface1 (x = -0.5 to -0.4 a), height 0.023 of the smooth film");
}

BOOST_AUTO_TEST_CASE(the_summary_shares_out_the_time) {
  const Scene scene;
  const std::string none = scene.ehl("run plain.ini").out;
  BOOST_TEST(!contains(none, "effects"), none);
  BOOST_TEST(!contains(none, "share"), none);
  const std::string two = scene.ehl("run timed.ini").out;
  double shares = 0.0;
  for (const char* row : {"\n  basic model ", "\n  transient ", "\n  surfaces "}) {
    const std::size_t at = two.find(row);
    BOOST_REQUIRE_MESSAGE(at != std::string::npos, row << " is missing in\n" << two);
    const std::string line = two.substr(at + 1, two.find('\n', at + 1) - at - 1);
    shares += std::stod(line.substr(line.find('%') - 5));
  }
  BOOST_TEST_MESSAGE("shares add up to " << shares << " % (100 but for rounding)");
  BOOST_TEST(std::abs(shares - 100.0) <= 1.5);
}

BOOST_AUTO_TEST_SUITE_END()
