// Exit status 3: whatever failed, a result is written and marked.
#include <boost/test/unit_test.hpp>
#include <string>

#include "support/json.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

using support::contains;

namespace {

const std::string deck = "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\n";

// A number or a text in the summary.
std::string in_summary(const support::TemporaryFolder& folder, const std::string& file, const std::string& name) {
  const support::Ended ended = support::ehl(folder, "extract " + file + " /summary/" + name);
  BOOST_TEST(ended.status == 0, ended.err);
  const std::string text = ended.out.substr(0, ended.out.find_last_not_of('\n') + 1);
  return text.starts_with('#') ? text.substr(text.find('\n') + 1) : text;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_not_converged)

// The grids for an accuracy may use at most half of the free memory, which is here the limit of the shell minus
// the memory of the program.
BOOST_AUTO_TEST_CASE(an_accuracy_stops_before_the_memory_ends) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck + "[grid]\naccuracy = 1e-5\n");
  const support::Ended ended = support::shell(
      folder, std::string("ulimit -v 400000; '") + EHL_PROGRAM + "' run d.ini --threads 1 --quiet --output r.h5");
  BOOST_TEST_MESSAGE(ended.err);
  BOOST_TEST(ended.status == 3, ended.err);
  BOOST_TEST(ended.says({" GB"}), ended.err);
  BOOST_TEST(in_summary(folder, "r.h5", "converged") == "0");
  BOOST_TEST(contains(in_summary(folder, "r.h5", "failed_check"), "memory"));
  // The film of the finest possible grid is in the file.
  BOOST_TEST(std::stod(in_summary(folder, "r.h5", "Hc")) == 0.43793, boost::test_tools::tolerance(1e-3));
}

// If there is no film at all, the file contains the deck and the reason.
BOOST_AUTO_TEST_CASE(without_a_film_the_reason_is_written) {
  const support::TemporaryFolder folder;
  folder.write(
      "d.ini",
      deck +
          "[grid]\ncells = 64\n[continuation]\npath = load\nmax_steps = 1\nM_start = 1\n[multigrid]\npolish = off\n");
  const support::Ended ended = support::ehl(folder, "run d.ini --quiet --output r.h5");
  BOOST_TEST_MESSAGE(ended.err);
  BOOST_TEST(ended.status == 3, ended.err);
  BOOST_TEST(ended.says({"r.h5"}), ended.err);
  BOOST_TEST(in_summary(folder, "r.h5", "converged") == "0");
  BOOST_TEST(contains(in_summary(folder, "r.h5", "failed_check"), "load continuation"));
  BOOST_TEST(contains(support::ehl(folder, "extract r.h5 deck").out, "max_steps = 1"));
  // Commands that read the result say that there is no film, and none crashes.
  BOOST_TEST(support::ehl(folder, "extract r.h5 P").status == 2);
  for (const char* command : {"plot r.h5", "report r.h5"}) {
    const support::Ended read = support::ehl(folder, command);
    BOOST_TEST((read.status == 0 || read.status == 2 || read.status == 4), command << ": " << read.status << read.err);
  }
  BOOST_TEST(support::ehl(folder, "run d.ini --quiet --output r.h5").status == 4);
  BOOST_TEST(support::ehl(folder, "run d.ini --quiet --output r.h5 --overwrite").status == 3);
}

BOOST_AUTO_TEST_SUITE_END()
