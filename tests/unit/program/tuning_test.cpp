// The section [tuning]: every number can be set, reaches the solver, and is checked; results say so.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "case/catalogue.hpp"
#include "case/scene.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "deck/write.hpp"
#include "steady/starts.hpp"
#include "support/temporary_folder.hpp"

using namespace ehl;

namespace {

const std::string moes = "[contact]\nM = 50\nL = 10\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n[grid]\ncells = 128\n";
const std::string thinned =
    "[motion]\nsrr = 0.5\n[contact]\na_over_R = 0.01\n[shear]\nlaw = eyring\ntau_0 = 5e6\nflow = on\n";  // solved with
                                                                                                         // the
                                                                                                         // iteration of
                                                                                                         // heat
const std::string in_time = "[transient]\nend_time = 1\nload = 0:1 1:2\n";

program::Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const support::TemporaryFolder folder;
  return program::read_case(folder.write("case.ini", text), overrides, 1);
}

std::string refusal(const std::string& given) {
  try {
    read(moes, {"tuning." + given});
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_tuning)

BOOST_AUTO_TEST_CASE(defaults) {
  const program::Case input = read(moes + in_time);
  BOOST_TEST(program::retuned(input.tuning).empty());
  BOOST_TEST(!program::tuning_warning(input.tuning));
  BOOST_TEST(program::tuning_lines(input.tuning) == "Tuned numbers: all at their defaults\n");
}

// Every number of the modules chosen at once, each with a value of its own.
program::Case read_all(const std::string& contact, bool (*chosen)(const std::string& name)) {
  std::string deck = contact + "[tuning]\n";
  std::vector<std::pair<std::string, double>> wanted;
  for (const deck::Key& key : program::tuning_keys()) {
    if (!chosen(key.name)) continue;
    const double standard = std::stod(key.default_note);
    const bool integer = key.type == deck::Type::integer;
    const double less = 0.75 * standard;
    const double value = integer ? standard + 1.0 : key.range.contains(less) ? less : 1.25 * standard;
    BOOST_TEST_REQUIRE(key.range.contains(value));
    wanted.emplace_back(key.name, value);
    deck += key.name + " = " + deck::shortest(value) + "\n";
  }
  program::Case input = read(deck);
  const std::vector<core::Retuned> found = program::retuned(input.tuning);
  BOOST_TEST_MESSAGE(found.size() << " numbers set");
  BOOST_TEST_REQUIRE(found.size() == wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    BOOST_TEST(found[k].name == wanted[k].first);
    BOOST_TEST(std::abs(found[k].value / wanted[k].second - 1.0) < 1e-12, found[k].name);
  }
  return input;
}

BOOST_AUTO_TEST_CASE(every_number_can_be_set) {
  const auto of_heat = [](const std::string& name) { return name.starts_with("heat."); };
  const program::Case input =
      read_all(moes + in_time, [](const std::string& name) { return !name.starts_with("heat."); });
  // They travel with the scene and with the run in time.
  BOOST_TEST(input.scene.solver.tuning.patience == multigrid::Tuning{}.patience + 1);
  BOOST_TEST(input.scene.solver.judgement.settled_change == 0.75 * judgement::Tuning{}.settled_change);
  BOOST_TEST(input.scene.newton.patience == newton::Tuning{}.patience + 1);
  BOOST_TEST(input.scene.tuning.settling_sweeps == steady::Tuning{}.settling_sweeps + 1);
  BOOST_TEST(input.transient->conditions.tuning.edge_reach == transient::Tuning{}.edge_reach + 1);
  BOOST_TEST(read_all(thinned + moes, of_heat).tuning.heat.most_cycles == heat::Tuning{}.most_cycles + 1);
}

// ln eta_bar near the edge of this contact lies between the two thresholds: one relaxation after the correction where
// it counts as steep, none where it does not.
BOOST_AUTO_TEST_CASE(a_number_changes_the_method) {
  const double edge = steady::log_viscosity_at_edge(read(moes).scene);
  BOOST_TEST_MESSAGE("ln eta_bar near the edge: " << edge);
  const auto post = [&](double threshold) {
    const program::Case input = read(moes, {"tuning.steady.steep_log_viscosity=" + deck::shortest(threshold)});
    return steady::parameters_of(input.scene, steady::usual_start()).post.value();
  };
  BOOST_TEST(post(0.9 * edge) == 1);
  BOOST_TEST(post(1.1 * edge) == 0);
}

BOOST_AUTO_TEST_CASE(wrong_numbers_are_refused) {
  BOOST_TEST(contains(refusal("steady.widest_step=0"), "a number >= 0.0025 and <= 2500"));
  BOOST_TEST(contains(refusal("multigrid.y_sweep_damping=1.5"), "a number > 0 and <= 1"));
  BOOST_TEST(contains(refusal("multigrid.next_supply=1"), "a number > 0 and < 1"));
  BOOST_TEST(contains(refusal("steady.next_first=1"), "a number > 1 and"));
  BOOST_TEST(contains(refusal("multigrid.patience=2.5"), "a whole number >= 1"));
  BOOST_TEST(contains(refusal("multigrid.patience=0"), "a whole number >= 1"));
  const std::string unknown = refusal("steady.widest_stp=2");
  BOOST_TEST(contains(unknown, "did you mean steady.widest_step?"), unknown);
  BOOST_TEST(contains(unknown, "`ehl keys tuning` lists the keys"), unknown);
  BOOST_TEST(contains(refusal("transient.first_step=1e-4"), "transient.first_step"));  // a steady contact
  const std::string cold = refusal("heat.most_cycles=9");
  BOOST_TEST(contains(cold, "heat.most_cycles"), cold);
  BOOST_TEST(refusal("steady.widest_step=2").empty());
}

// `ehl keys` lists the section only if it is asked for; a result keeps the numbers that were given, and no others.
BOOST_AUTO_TEST_CASE(shown_on_request) {
  BOOST_TEST(!contains(deck::list_keys(program::catalogue(), ""), "steady.widest_step"));
  BOOST_TEST(!contains(deck::commented_deck(program::catalogue()), "widest_step"));
  BOOST_TEST(contains(deck::list_keys(program::catalogue(), "tuning"), "default: 2.5"));
  const std::string kept = deck::effective_deck(read(moes, {"tuning.steady.widest_step=2"}).deck);
  BOOST_TEST(contains(kept, "[tuning]\nsteady.widest_step = 2\n"));
  BOOST_TEST(!contains(kept, "settling_sweeps"));
}

BOOST_AUTO_TEST_SUITE_END()
