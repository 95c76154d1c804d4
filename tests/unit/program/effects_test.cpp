// The list of effects and the deck: nothing belongs to two effects, and no effect is on unless the deck asks for it.
#include "case/effects.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>

#include "case/catalogue.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "support/json.hpp"
#include "support/temporary_folder.hpp"
#include "support/text.hpp"

using namespace ehl;
using boost::test_tools::tolerance;

namespace {

const std::string plain =
    "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\n[domain]\nx_inlet = -4.5\ny_half = 3\n[grid]\ncells = "
    "64\n";

program::Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const support::TemporaryFolder folder;
  return program::read_case(folder.write("case.ini", text), overrides, 1);
}

std::string complaints(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read(text, overrides);
  } catch (const core::InputError& error) {
    return deck::joined(error.messages(), "\n");
  }
  return "";
}

using support::contains;

std::vector<std::string> names_of(const std::vector<program::Effect>& effects) {
  std::vector<std::string> names;
  for (const program::Effect& effect : effects) names.push_back(effect.name);
  return names;
}

const program::Effect& find(const std::vector<program::Effect>& all, const std::string& name) {
  return *std::ranges::find(all, name, &program::Effect::name);
}

// The overrides of an effect's example, including those of the effect that it requires.
std::vector<std::string> example_of(const std::vector<program::Effect>& all, const program::Effect& effect) {
  std::vector<std::string> overrides;
  if (!effect.upon.empty()) overrides = example_of(all, find(all, effect.upon));
  overrides.insert(overrides.end(), effect.example.begin(), effect.example.end());
  return overrides;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_effects)

BOOST_AUTO_TEST_CASE(a_section_belongs_to_every_deck_or_to_one_effect) {
  const std::set<std::string> of_every_deck{
      "case",         "contact", "motion", "lubricant", "domain", "grid", "discretization", "deformation", "multigrid",
      "continuation", "dry",     "output", "bearing",   "gear",   "cam",  "stroke",         "impact",      "tuning"};
  const std::vector<program::Effect> all = program::effects();
  for (const deck::Section& section : program::catalogue().sections) {
    std::vector<std::string> owners;
    for (const program::Effect& effect : all)
      for (const deck::Section& own : effect.sections)
        if (own.name == section.name) owners.push_back(effect.name);
    BOOST_TEST(owners.size() + of_every_deck.count(section.name) == 1u, section.name);
    BOOST_TEST(section.effect == (owners.empty() ? "" : owners[0]), section.name);
    BOOST_TEST(section.called_by.empty() == owners.empty(), section.name);
  }
}

BOOST_AUTO_TEST_CASE(every_entry_is_complete) {
  const deck::Catalogue catalogue = program::catalogue();
  const std::vector<program::Effect> all = program::effects();
  for (const program::Effect& effect : all) {
    BOOST_TEST(std::ranges::count(all, effect.name, &program::Effect::name) == 1, effect.name);
    BOOST_TEST((!effect.meaning.empty() && effect.on && effect.what && !effect.example.empty()), effect.name);
    BOOST_TEST(!effect.callers.empty(), effect.name);
    for (const program::KeyName& key : effect.callers)
      BOOST_TEST((deck::find_key(catalogue, key.section, key.name) != nullptr), key.section << "." << key.name);
    // What is computed at a stage of its own reports its time.
    const program::Stages& stages = effect.stages;
    BOOST_TEST((!(stages.film || stages.in_time || stages.after_solution) || effect.seconds), effect.name);
    BOOST_TEST((stages.from == program::Extent::whole || stages.after_solution), effect.name);
    if (!effect.costly.name.empty())
      BOOST_TEST((deck::find_key(catalogue, effect.costly.section, effect.costly.name) != nullptr), effect.name);
    for (const deck::Section& section : effect.sections)
      for (const std::string& name : section.called_by) {
        const bool listed = std::ranges::any_of(effect.callers, [&](const program::KeyName& key) {
          return key.section == section.name && key.name == name;
        });
        BOOST_TEST(listed, section.name << "." << name);
      }
    if (!effect.upon.empty()) BOOST_TEST(std::ranges::count(all, effect.upon, &program::Effect::name) == 1);
  }
}

BOOST_AUTO_TEST_CASE(a_plain_deck_calls_for_none) {
  const program::Case input = read(plain);
  BOOST_TEST(names_of(program::effects_of(input)).empty());
  BOOST_TEST(program::asymmetries(input).empty());
  BOOST_TEST(program::expected_needs(input).bytes == program::basic_needs(input.scene).bytes);
  const program::Computed nothing;
  BOOST_TEST(program::effect_times(input, nothing).empty());
  BOOST_TEST(program::effect_rows(input, nothing).empty());
  nlohmann::ordered_json report;
  program::add_effects(input, nothing, report);
  BOOST_TEST(report.dump() == "{\"effects\":[]}");
}

// Each example enables its effect, and its keys are in the deck.
BOOST_AUTO_TEST_CASE(an_example_turns_its_effect_on) {
  const std::vector<program::Effect> all = program::effects();
  for (const program::Effect& effect : all) {
    const program::Case input = read(plain, example_of(all, effect));
    std::vector<std::string> expected{effect.name};
    if (!effect.upon.empty()) expected.insert(expected.begin(), effect.upon);
    BOOST_TEST(names_of(program::effects_of(input)) == expected, boost::test_tools::per_element());
    const std::vector<std::string> why = program::called_by(input, effect, true);
    BOOST_TEST(!why.empty(), effect.name);
    for (const std::string& reason : why) BOOST_TEST(contains(reason, "(command line)"), reason);
    for (const program::KeyName& key : effect.callers) {
      const deck::Value& value = deck::value(input.deck, key.section, key.name);
      const std::string text = "[" + key.section + "] " + key.name + " = " + value.text;
      const bool named = std::ranges::count(program::called_by(input, effect, false), text) == 1;
      BOOST_TEST(named == (value.origin == deck::Origin::given), text);
    }
    const std::string lines = program::effect_lines(input);
    for (const std::string& part : {effect.name + ": " + effect.what(input), why[0]}) BOOST_TEST(contains(lines, part));
    if (!effect.without.empty()) BOOST_TEST(!contains(lines.substr(lines.find("model apart")), effect.without), lines);
  }
}

// The total cost is the sum of the costs of the effects.
BOOST_AUTO_TEST_CASE(expenses_add_up) {
  const std::vector<program::Effect> all = program::effects();
  for (const program::Effect& effect : all) {
    const program::Case input = read(plain, example_of(all, effect));
    program::Needs sum = program::basic_needs(input.scene);
    for (const program::Effect& on : program::effects_of(input)) {
      const program::Needs more = on.expense ? on.expense(input) : program::Needs{};
      BOOST_TEST((more.bytes >= 0.0 && more.seconds >= 0.0), on.name);
      sum.bytes += more.bytes;
      sum.seconds += more.seconds;
    }
    const program::Needs expected = program::expected_needs(input);
    BOOST_TEST(expected.bytes == sum.bytes, tolerance(1e-14));
    BOOST_TEST(expected.seconds == sum.seconds, tolerance(1e-14));
  }
}

// A section of an effect without a key that enables it: with each of its other keys, and with none.
BOOST_AUTO_TEST_CASE(a_section_without_influence_is_refused) {
  const deck::Catalogue catalogue = program::catalogue();
  for (const program::Effect& effect : program::effects())
    for (const deck::Section& section : effect.sections) {
      const std::string empty = complaints(plain + "[" + section.name + "]\n");
      BOOST_TEST(contains(empty, section.called_by[0]), empty);
      for (const deck::Key& key : catalogue.keys) {
        if (key.section != section.name || std::ranges::count(section.called_by, key.name) > 0) continue;
        const std::string legal = key.example.empty() && !key.words.empty() ? key.words[0] : key.example;
        const std::string value = key.default_text.empty() ? legal : key.default_text;
        const std::string said = complaints(plain, {section.name + "." + key.name + "=" + value});
        BOOST_TEST(contains(said, deck::joined(section.called_by, " or ")), said);
      }
    }
  const std::string guest = complaints(plain, {"output.checkpoint=1"});
  BOOST_TEST(contains(guest, "[transient] end_time"), guest);
}

BOOST_AUTO_TEST_CASE(what_breaks_the_symmetry_is_named) {
  const std::vector<std::string> ridge{"transient.end_time=1", "surface2.shape=ridge", "surface2.height=0.01",
                                       "surface2.width=0.5"};
  const auto with = [&](const std::string& more) {
    std::vector<std::string> overrides = ridge;
    overrides.push_back(more);
    return read(plain, overrides);
  };
  BOOST_TEST(program::asymmetries(with("surface2.angle=0")).empty());
  const std::vector<std::string> expected{"surfaces: ridge of surface2 at 30 degrees"};
  BOOST_TEST(program::asymmetries(with("surface2.angle=30")) == expected, boost::test_tools::per_element());
  BOOST_TEST(contains(program::effect_lines(with("surface2.angle=30")), expected[0]));
}

// 10 s in total; the run in time took 6 of them, and the surfaces 1 of those 6.
BOOST_AUTO_TEST_CASE(times_and_shares) {
  const std::vector<program::Effect> all = program::effects();
  const program::Case input = read(plain, example_of(all, find(all, "surfaces")));
  program::Computed computed;
  computed.seconds = 10.0;
  computed.in_time = program::TransientResult{};
  computed.in_time->rows.resize(2);
  computed.in_time->report.seconds = 6.0;
  computed.in_time->report.seconds_of_surfaces = 1.0;
  const std::string table = program::effect_times(input, computed);
  for (const char* row :
       {"basic model                    4.0000   40 %", "transient                      5.0000   50 %",
        "surfaces                       1.0000   10 %"})
    BOOST_TEST(contains(table, row), table);
  nlohmann::ordered_json report;
  program::add_effects(input, computed, report);
  BOOST_TEST(report["effects"][0]["name"] == "transient");
  BOOST_TEST(report["effects"][0]["seconds"] == 5.0);
  BOOST_TEST(report.contains("transient"));
  const std::vector<results::EffectRow> rows = program::effect_rows(input, computed);
  BOOST_REQUIRE(rows.size() == 2u);
  BOOST_TEST(rows[1].seconds == 1.0);
  BOOST_TEST(rows[1].why == "[surface1] shape = dimple");
}

BOOST_AUTO_TEST_SUITE_END()
