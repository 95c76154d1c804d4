#pragma once
// What a study computes: the same case over levels, wedge schemes, film evaluators and cycles.
#include <functional>
#include <string>
#include <vector>

#include "case/scene.hpp"

namespace ehl::program {

/// One way to solve the case. wedge: upstream1, upstream2, and upstream3 with face logmean_bounded. evaluator: mlmi4,
/// mlmi6, mlmi8 (transfer order), fft, direct. cycles: "2W": two W cycles on every level and no more; "run": as `ehl
/// run` does it, until its checks are content.
struct StudyCase {
  int cells = 0;  ///< of the finest grid, along x
  std::string wedge{};
  std::string evaluator{};
  std::string cycles{};
  bool operator==(const StudyCase&) const = default;
};

/// The lists that are combined.
struct StudyPlan {
  std::vector<int> cells{};  ///< coarse to fine
  std::vector<std::string> wedges{};
  std::vector<std::string> evaluators{};
  std::vector<std::string> cycles{};
};

/// Cells from a to b, each twice the one before. in: "a:b". errors: core::InputError: another form, or b is not a times
/// a power of two.
std::vector<int> levels_between(const std::string& text);

/// The levels of a deck: its own cells, halved while 64 or more are left and the coarser grid is legal.
std::vector<int> levels_of_deck(int cells, const std::function<bool(int)>& legal);

/// The words of a list between commas. in: name of the option, the list, whether a word is allowed and how the allowed
/// ones are told. errors: core::InputError: a word that is not allowed, twice the same, none.
std::vector<std::string> words_of_list(const std::string& option, const std::string& text,
                                       const std::function<bool(const std::string&)>& allowed, const std::string& told);

bool is_study_wedge(const std::string& word);
bool is_study_evaluator(const std::string& word);
/// 1 to 99 cycles and their shape, V, W or F; or "run".
bool is_study_cycles(const std::string& word);

/// Nodes up to which the direct sum is affordable: a solution costs seconds there, and sixteen times as much per level.
constexpr double most_nodes_of_direct = 2e4;

/// All combinations, coarse to fine; the direct sum only where it is affordable. in: the plan; nodes of a grid by its
/// cells.
std::vector<StudyCase> cases_of(const StudyPlan& plan, const std::function<double(int)>& nodes);

/// The deck's case on a grid of `cells`, with its other settings. in: path, overrides (grid.cells among them is
/// replaced), threads. errors: core::InputError.
Case case_on_grid(const std::string& path, const std::vector<std::string>& overrides, int cells, int threads);

/// The same case by another way. For a fixed number of cycles the limit of cycles is that number, so that the solution
/// ends unconverged where the checks would ask for more; everything else is the deck's.
void use_way(const StudyCase& way, steady::Scene& scene);

/// The tasks, the whole list as often as each is repeated: the repetitions of one are far apart, so that a disturbance
/// does not meet all of them.
template <class Way>
std::vector<Way> repeated(const std::vector<Way>& ways, int times) {
  std::vector<Way> all;
  for (; times > 0; --times) all.insert(all.end(), ways.begin(), ways.end());
  return all;
}

/// "upstream2, mlmi8, 2W".
std::string name_of_way(const StudyCase& way);

}  // namespace ehl::program
