#include "tables/study_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "core/errors.hpp"
#include "deck/document.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

constexpr int fewest_cells = 64;
constexpr int most_cells = 1 << 20;

int cells_in(const std::string& text, const std::string& levels) {
  const deck::ReadNumber read = deck::read_number(text);
  const bool good = read.status == deck::ReadNumber::Status::number && read.value >= 16.0 && read.value <= most_cells &&
                    read.value == std::floor(read.value);
  if (!good)
    throw core::InputError("command line: --levels " + levels +
                           ": write a:b, cells of the coarsest and of the finest " + "grid studied, e.g. 64:512");
  return static_cast<int>(read.value);
}

}  // namespace

std::vector<int> levels_between(const std::string& text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const int first = cells_in(text.substr(0, colon), text);
  const int last = colon == text.size() ? first : cells_in(text.substr(colon + 1), text);
  std::vector<int> levels{first};
  while (2 * levels.back() <= last) levels.push_back(2 * levels.back());
  if (levels.back() != last)
    throw core::InputError("command line: --levels " + text + ": the second number must be the first times a power " +
                           "of two, e.g. " + std::to_string(first) + ":" + std::to_string(4 * first));
  return levels;
}

std::vector<int> levels_of_deck(int cells, const std::function<bool(int)>& legal) {
  std::vector<int> levels{cells};
  while (levels.back() % 2 == 0 && levels.back() / 2 >= fewest_cells && legal(levels.back() / 2))
    levels.push_back(levels.back() / 2);
  std::reverse(levels.begin(), levels.end());
  return levels;
}

std::vector<std::string> words_of_list(const std::string& option, const std::string& text,
                                       const std::function<bool(const std::string&)>& allowed,
                                       const std::string& told) {
  const std::string said = "command line: --" + option + " " + text + ": ";
  const std::vector<std::string> words = deck::split_words(text);
  if (words.empty()) throw core::InputError(said + "the list is empty: " + told);
  std::set<std::string> seen;
  for (const std::string& word : words) {
    if (!allowed(word)) throw core::InputError(said + deck::quoted(word) + " must be " + told);
    if (!seen.insert(word).second) throw core::InputError(said + word + " is given twice");
  }
  return words;
}

bool is_study_wedge(const std::string& word) { return std::regex_match(word, std::regex("upstream[123]")); }

bool is_study_evaluator(const std::string& word) { return std::regex_match(word, std::regex("mlmi[468]|fft|direct")); }

bool is_study_cycles(const std::string& word) { return std::regex_match(word, std::regex("run|[1-9][0-9]?[VWF]")); }

std::vector<StudyCase> cases_of(const StudyPlan& plan, const std::function<double(int)>& nodes) {
  std::vector<StudyCase> cases;
  for (const int cells : plan.cells)
    for (const std::string& wedge : plan.wedges)
      for (const std::string& evaluator : plan.evaluators)
        for (const std::string& cycles : plan.cycles)
          if (evaluator != "direct" || nodes(cells) <= most_nodes_of_direct)
            cases.push_back({.cells = cells, .wedge = wedge, .evaluator = evaluator, .cycles = cycles});
  return cases;
}

Case case_on_grid(const std::string& path, const std::vector<std::string>& overrides, int cells, int threads) {
  std::vector<std::string> all;
  for (const std::string& text : overrides) {
    const deck::Assignment given = deck::parse_override(text);
    if (given.section != "grid" || given.name != "cells") all.push_back(text);
  }
  all.push_back("grid.cells=" + std::to_string(cells));
  return read_lubricated_case(path, all, threads, "study");
}

void use_way(const StudyCase& variant, steady::Scene& scene) {
  scene.wedge = variant.wedge == "upstream1"   ? reynolds::Wedge::upstream1
                : variant.wedge == "upstream2" ? reynolds::Wedge::upstream2
                                               : reynolds::Wedge::upstream3;
  scene.face = reynolds::third_order(scene.wedge) ? reynolds::Face::logmean_bounded : reynolds::Face::mean;
  if (variant.evaluator == "fft" || variant.evaluator == "direct") {
    scene.deformation.method = variant.evaluator == "fft" ? mlmi::Method::fft : mlmi::Method::direct;
  } else {
    scene.deformation.method = mlmi::Method::mlmi;
    scene.deformation.order = variant.evaluator.back() - '0';
  }
  if (variant.cycles == "run") return;
  const char shape = variant.cycles.back();
  scene.solver.cycle = shape == 'V' ? multigrid::Cycle::V : shape == 'F' ? multigrid::Cycle::F : multigrid::Cycle::W;
  if (!scene.solver.post) scene.solver.post = 1;
  scene.solver.cycles = scene.solver.max_cycles = std::stoi(variant.cycles);
  scene.solver.extra_cycles = 0;
}

std::string name_of_variant(const StudyCase& variant) {
  if (variant.in_time()) return fmt::format("rtol {:g}, steps of at most {:.3g}", variant.rtol, variant.longest_step);
  return variant.wedge + ", " + variant.evaluator + ", " + variant.cycles;
}

}  // namespace ehl::program
