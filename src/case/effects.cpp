#include "case/effects.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/json.hpp"
#include "base/text_format.hpp"
#include "case/numbers/number.hpp"
#include "core/constants.hpp"
#include "deck/text.hpp"
#include "steady/multigrid_solve.hpp"

namespace ehl::program {
namespace {

using core::unknown;

std::vector<Effect> completed() {
  std::vector<Effect> all = listed_effects();
  for (Effect& effect : all)
    for (deck::Section& section : effect.sections) {
      section.effect = effect.name;
      if (section.meaning.empty()) section.meaning = effect.meaning;
      for (const std::string& key : section.called_by) effect.callers.push_back({section.name, key});
    }
  return all;
}

double own_seconds(const Effect& effect, const Computed& computed) {
  return effect.seconds ? effect.seconds(computed) : unknown;
}

core::Warnings warnings_of(const Effect& effect, const Case& input, const Computed& computed) {
  return effect.warnings ? effect.warnings(input, computed) : core::Warnings{};
}

// The JSON member of an effect; null if there is nothing in it.
Json json_of(const Effect& effect, const Case& input, const Computed& computed) {
  Json own;
  if (effect.numbers) {
    const std::vector<results::Quantity> list = numbers::quantities(effect.numbers().name, {input, computed});
    add(list, own);
    add_in_SI(list, si_scales(input.physics), own);
  }
  if (effect.json) effect.json(input, computed, own);
  if (effect.seconds && !own.is_null()) own[id::seconds] = effect.seconds(computed);
  return own;
}

// The additional cost of an effect: "2 MB and 0.1 s more".
std::string cost(const Needs& more) {
  constexpr double shown_bytes = 5e5;
  if (more.bytes < shown_bytes && more.seconds == 0.0) return "less than 1 MB more";
  std::string text = more.bytes < shown_bytes ? "less than 1 MB" : "about " + memory(more.bytes);
  if (more.seconds > 0.0) text += " and " + about_seconds(more.seconds);
  return text + " more";
}

// The stages at which the pipeline calls the effect.
std::string stages_text(const Case& input, const Effect& effect) {
  std::vector<std::string> texts;
  if (effect.stages.scene) texts.push_back("in the scene that is solved");
  if (effect.stages.film && effect.stages.film(input)) texts.push_back("by equations that are solved with the film");
  if (effect.stages.in_time) texts.push_back("by a run in time from the steady contact");
  if (effect.stages.in_steps && input.transient && !effect.stages.in_steps(input).empty())
    texts.push_back("at every step in time");
  if (effect.stages.after_solution) texts.push_back("after the solution");
  return texts.empty() ? "" : "acts " + deck::joined(texts, " and ") + ", ";
}

// Which part of the domain is computed; if it is the whole domain, the reason.
std::string symmetry(const Case& input) {
  if (input.scene.grid.line) return "line contact: one line is computed";
  const std::vector<std::string> reasons = asymmetries(input);
  if (!reasons.empty()) return "none in Y, the whole domain is computed: " + deck::joined(reasons, "; ");
  return steady::on_one_half(input.scene)
             ? "in Y: one half of the domain is computed"
             : "in Y, but half of the coarsest grid would be too small: the whole domain is computed";
}

std::string assignment(const Case& input, const KeyName& key, bool with_place) {
  const deck::Value& value = deck::value(input.deck, key.section, key.name);
  std::string text = "[" + key.section + "] " + key.name + " = " + value.text;
  if (with_place) text += " (" + (value.origin == deck::Origin::given ? value.place : "chosen: " + value.why) + ")";
  return text;
}

}  // namespace

const std::vector<Effect>& effects() {
  static const std::vector<Effect> all = completed();
  return all;
}

void read_effects(Case& input) {
  for (const Effect& effect : effects()) {
    if (effect.read) effect.read(input);
    if (effect.stages.scene) effect.stages.scene(input);
  }
}

std::vector<Effect> effects_of(const Case& input) {
  std::vector<Effect> on = effects();
  std::erase_if(on, [&](const Effect& effect) { return !effect.on(input); });
  for (Effect& effect : on)
    if (effect.name_here) effect.name = effect.name_here(input);
  return on;
}

std::vector<std::string> basic_model(const Case& input) {
  std::vector<std::string> words;
  for (const Effect& effect : effects())
    if (!effect.without.empty() && !effect.on(input)) words.push_back(effect.without);
  if (input.roller) std::erase(words, "circular");  // nor is it elliptic; its own effect describes it
  return words;
}

std::vector<std::string> called_by(const Case& input, const Effect& effect, bool with_place) {
  std::vector<std::string> keys;
  for (const KeyName& key : effect.callers) {
    const deck::Origin origin = deck::value(input.deck, key.section, key.name).origin;
    if (origin == deck::Origin::given || origin == deck::Origin::chosen)
      keys.push_back(assignment(input, key, with_place));
  }
  return keys;
}

std::vector<std::string> asymmetries(const Case& input) {
  std::vector<std::string> reasons;
  for (const Effect& effect : effects_of(input)) {
    const std::string reason = effect.asymmetry ? effect.asymmetry(input) : "";
    if (!reason.empty()) reasons.push_back(effect.name + ": " + reason);
  }
  return reasons;
}

void refuse_idle(Case& input) {
  for (const Effect& effect : effects_of(input)) {
    const std::string reason = effect.idle ? effect.idle(input) : "";
    if (!reason.empty())
      complain(input.deck, effect.callers.front().section, effect.callers.front().name,
               "the effect " + effect.name + " has no influence: " + reason, deck::Cause::idle);
  }
}

std::string effect_lines(const Case& input) {
  const std::vector<Effect> on = effects_of(input);
  const std::string model = deck::joined(basic_model(input), ", ");
  std::string text;
  for (const Effect& effect : on) {
    text += (text.empty() ? "effects      " : "             ") + effect.name + ": " + effect.what(input) + "\n";
    text += "               enabled by " + deck::joined(called_by(input, effect, true), ", ") + "\n";
    text += "               " + stages_text(input, effect) + "costs " +
            (effect.expense ? cost(effect.expense(input)) : "no noticeable time") + "\n";
  }
  if (input.dry) return text;
  text +=
      on.empty() ? "effects      none; model: " + model + "\n" : "             model apart from these: " + model + "\n";
  return text + "symmetry     " + symmetry(input) + "\n";
}

std::string effect_times(const Case& input, const Computed& computed) {
  const std::vector<Effect> on = effects_of(input);
  if (on.empty()) return {};
  std::string text = fmt::format("{:<29}  {:>8}  {:>5}\n", "effects", "seconds", "share");
  std::string rows;
  double basic = computed.seconds;
  for (const Effect& effect : on) {
    const double seconds = own_seconds(effect, computed);
    rows += fmt::format("  {:<27}  {:>8}  {:>5}\n", effect.name, known("{:.4f}", seconds),
                        std::isfinite(seconds) ? fmt::format("{:3.0f} %", 100.0 * seconds / computed.seconds) : "-");
    if (std::isfinite(seconds)) basic -= seconds;
  }
  return text + fmt::format("  {:<27}  {:8.4f}  {:3.0f} %\n", "basic model", basic, 100.0 * basic / computed.seconds) +
         rows;
}

core::Warnings all_warnings(const Case& input, const Computed& computed) {
  core::Warnings all = computed.outcome.warnings;
  for (const Effect& effect : effects_of(input))
    for (core::Warning& warning : warnings_of(effect, input, computed)) all.push_back(std::move(warning));
  return all;
}

void add_effects(const Case& input, const Computed& computed, Json& report) {
  Json& rows = report["effects"] = Json::array();
  for (const results::EffectRow& row : effect_rows(input, computed))
    rows.push_back({{"name", row.name}, {"seconds", row.seconds}, {"what", row.what}, {"why", row.why}});
  for (const Effect& effect : effects_of(input)) {
    const core::Warnings warnings = warnings_of(effect, input, computed);
    add_warnings(warnings, report);
    Json own = json_of(effect, input, computed);
    if (own.is_null()) continue;
    if (effect.warnings) add_warnings(warnings, own);
    report[effect.name] = std::move(own);
  }
}

std::vector<results::EffectRow> effect_rows(const Case& input, const Computed& computed) {
  std::vector<results::EffectRow> rows;
  for (const Effect& effect : effects_of(input))
    rows.push_back({effect.name, own_seconds(effect, computed), effect.what(input),
                    deck::joined(called_by(input, effect, false), ", ")});
  return rows;
}

void add_effects(const Case& input, const Computed& computed, results::Content& content) {
  for (const Effect& effect : effects_of(input)) {
    if (effect.add_content) effect.add_content(input, computed, content);
    if (effect.warnings)
      content.summary.push_back({effect.name + "_warnings",
                                 deck::joined(with_names(effect.warnings(input, computed)), "\n"), "", "one per line"});
  }
  // A number refers to an error bar only if the file has it.
  for (results::Quantity& one : content.summary)
    if (std::ranges::find(content.summary, one.error, &results::Quantity::name) == content.summary.end())
      one.error.clear();
  content.effects = effect_rows(input, computed);
}

}  // namespace ehl::program
