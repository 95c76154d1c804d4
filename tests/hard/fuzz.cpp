// Runs the program on random and on damaged decks. Each run must solve the case, refuse it with a place, or say why it
// failed. It must never crash, hang or leak, and never report a wrong number as converged.
//
//   test_fuzz -- [--cases N] [--seed S] [--jobs J] [--limit SECONDS] [--supplies SHARE] [--heat SHARE]
//                [--lines SHARE] [--inputs SHARE] [--program PATH] [--verbose]
//
// Case k has the seed S + k; `--seed S+k --cases 1 --verbose` repeats one case and prints its deck.
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <iomanip>
#include <map>
#include <numeric>
#include <sstream>
#include <thread>

#include "hard/judge.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace hard;

struct Options {
  std::uint64_t seed = 1;
  std::uint64_t cases = EHL_FUZZ_CASES;
  unsigned jobs = 2;
  double limit = EHL_FUZZ_SECONDS;
  Shares shares{};
  std::string program = EHL_PROGRAM;
  bool verbose = false;
};

Options read_options() {
  const auto& suite = boost::unit_test::framework::master_test_suite();
  const std::vector<std::string> words(suite.argv + 1, suite.argv + suite.argc);
  Options options;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const auto is = [&](const char* name) { return words[k] == name && k + 1 < words.size(); };
    if (words[k] == "--verbose")
      options.verbose = true;
    else if (is("--seed"))
      options.seed = std::stoull(words[++k]);
    else if (is("--cases"))
      options.cases = std::stoull(words[++k]);
    else if (is("--jobs"))
      options.jobs = static_cast<unsigned>(std::stoul(words[++k]));
    else if (is("--limit"))
      options.limit = std::stod(words[++k]);
    else if (is("--supplies"))
      options.shares.supplies = std::stod(words[++k]);
    else if (is("--heat"))
      options.shares.heat = std::stod(words[++k]);
    else if (is("--lines"))
      options.shares.lines = std::stod(words[++k]);
    else if (is("--inputs"))
      options.shares.inputs = std::stod(words[++k]);
    else if (is("--program"))
      options.program = words[++k];
    else
      BOOST_FAIL("unknown option " << words[k]);
  }
  return options;
}

Setting make_setting(const Options& options) {
  Setting setting;
  setting.program = options.program;
  setting.limit = options.limit;
  setting.shares = options.shares;
  setting.environment = {"OMP_WAIT_POLICY=passive"};
  const support::TemporaryFolder folder;
  const Finished listing = run_program({setting.program, "keys"}, folder.path(), setting.environment, options.limit);
  BOOST_REQUIRE_MESSAGE(listing.status == 0, listing.err);
  setting.keys = read_known_keys(listing.out);
  constexpr std::size_t at_least = 30;  // fewer keys mean that the listing was not read correctly
  BOOST_REQUIRE(setting.keys.size() >= at_least);
  return setting;
}

/// Judges all cases, a few at a time; the verdicts are in the order of the seeds.
std::vector<Verdict> judge_all(const Options& options, const Setting& setting) {
  constexpr std::uint64_t every_fifth = 5;
  std::vector<Verdict> verdicts(options.cases);
  std::atomic<std::uint64_t> next{0};
  const auto work = [&] {
    for (std::uint64_t k = next++; k < options.cases; k = next++)
      verdicts[k] = judge(options.seed + k, setting, (options.seed + k) % every_fifth == 0);
  };
  std::vector<std::jthread> workers;
  for (unsigned k = 0; k < options.jobs; ++k) workers.emplace_back(work);
  workers.clear();
  return verdicts;
}

/// A reason without its numbers, so that similar reasons are counted together.
std::string kind_of(const std::string& reason) {
  std::string kind;
  for (const char c : reason.substr(0, reason.find(';')))
    if (std::isdigit(static_cast<unsigned char>(c)) == 0)
      kind += c;
    else if (!kind.ends_with('#'))
      kind += '#';
  return kind;
}

std::string shown(const std::string& text) {
  std::string safe;
  constexpr std::size_t most = 4000;
  for (const char c : text.substr(0, most))
    safe += c == '\n' || c == '\t' || static_cast<unsigned char>(c) >= ' ' ? c : '?';
  return safe;
}

std::string described(const Verdict& verdict) {
  std::ostringstream text;
  text << "seed " << verdict.seed << ", " << std::setprecision(3) << verdict.seconds << " s, " << verdict.deck.threads
       << " threads";
  for (const std::string& damage : verdict.deck.damage) text << "; " << shown(damage);
  for (const std::string& set : verdict.deck.overrides) text << " --set " << shown(set);
  text << "\n" << shown(verdict.deck.text) << "\n";
  if (verdict.end == End::solved)
    text << "solved: Hc = " << verdict.Hc << ", over the formula " << verdict.formula_ratio << ", warnings "
         << verdict.warnings.at(0) << "\n";
  return text.str() + shown(verdict.reason);
}

void print_figures(const std::vector<Verdict>& verdicts) {
  std::map<End, int> ends;
  std::map<std::string, std::vector<const Verdict*>> reasons;
  int damaged = 0, refused_in_good_faith = 0;
  double seconds = 0.0, longest = 0.0;
  for (const Verdict& verdict : verdicts) {
    ++ends[verdict.end];
    const bool good_faith = verdict.deck.damage.empty();
    damaged += good_faith ? 0 : 1;
    refused_in_good_faith += good_faith && verdict.end == End::refused ? 1 : 0;
    seconds += verdict.seconds;
    longest = std::max(longest, verdict.seconds);
    if (verdict.end == End::not_converged) reasons[kind_of(verdict.reason)].push_back(&verdict);
  }
  BOOST_TEST_MESSAGE("cases " << verdicts.size() << " (" << damaged << " damaged): converged " << ends[End::solved]
                              << ", refused " << ends[End::refused] << " (" << refused_in_good_faith
                              << " of them not damaged), not converged " << ends[End::not_converged]
                              << ", too large to run " << ends[End::too_large] << ", crashed " << ends[End::crashed]
                              << ", hung " << ends[End::hung] << ", other " << ends[End::other]);
  BOOST_TEST_MESSAGE("seconds per run: mean " << seconds / static_cast<double>(verdicts.size()) << ", longest "
                                              << longest);
  for (const auto& [reason, found] : reasons) {
    std::ostringstream list;
    for (const Verdict* verdict : found) list << ' ' << verdict->seed << " (" << verdict->groups << ")";
    BOOST_TEST_MESSAGE("not converged " << found.size() << " x: " << reason << "\n   seeds and (M, L):" << list.str());
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_fuzz)

BOOST_AUTO_TEST_CASE(random_decks) {
  const Options options = read_options();
  const Setting setting = make_setting(options);
  const std::vector<Verdict> verdicts = judge_all(options, setting);
  int solved = 0;
  for (const Verdict& verdict : verdicts) {
    if (options.verbose) BOOST_TEST_MESSAGE(described(verdict));
    for (const std::string& fault : verdict.faults) BOOST_ERROR("seed " << verdict.seed << ": " << shown(fault));
    solved += verdict.end == End::solved ? 1 : 0;
  }
  print_figures(verdicts);
  // A program that refuses every deck would pass all other checks.
  constexpr std::size_t many = 100;
  if (verdicts.size() >= many) BOOST_TEST(4 * solved > static_cast<int>(verdicts.size()));
}

BOOST_AUTO_TEST_SUITE_END()
