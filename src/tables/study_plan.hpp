#pragma once
// The plan of a study: one case with several grids, wedge schemes, film evaluators and numbers of cycles.
#include <functional>
#include <string>
#include <vector>

#include "case/scene.hpp"

namespace ehl::program {

/// One method of solving the case. wedge: upstream1, upstream2, upstream3 (the last with the face value
/// logmean_bounded). evaluator: mlmi4, mlmi6, mlmi8 (transfer order), fft, direct. cycles: "2W": exactly two W cycles
/// on every level; "run": as in `ehl run`, until all checks pass. A run in time has another parameter, the control of
/// its integration.
struct StudyCase {
  int cells = 0;  ///< cells of the finest grid along x
  std::string wedge{};
  std::string evaluator{};
  std::string cycles{};
  double rtol = 0.0;          ///< zero: a steady solution
  double longest_step = 0.0;  ///< [a/u_m]
  bool in_time() const { return rtol > 0.0; }
  bool operator==(const StudyCase&) const = default;
};

/// The lists whose combinations are computed.
struct StudyPlan {
  std::vector<int> cells{};  ///< coarse to fine
  std::vector<std::string> wedges{};
  std::vector<std::string> evaluators{};
  std::vector<std::string> cycles{};
};

/// Cells from a to b, each twice the one before. in: "a:b". errors: core::InputError for another form, or if b is
/// not a times a power of two.
std::vector<int> levels_between(const std::string& text);

/// The levels of a deck: its own cells, halved while at least 64 remain and the coarser grid is legal.
std::vector<int> levels_of_deck(int cells, const std::function<bool(int)>& legal);

/// The words of a comma-separated list. in: name of the option; the list; whether a word is allowed; the allowed words
/// as the error message lists them. errors: core::InputError for a word that is not allowed, a word given twice, or an
/// empty list.
std::vector<std::string> words_of_list(const std::string& option, const std::string& text,
                                       const std::function<bool(const std::string&)>& allowed, const std::string& told);

/// True for the wedges and the evaluators listed at StudyCase.
bool is_study_wedge(const std::string& word);
bool is_study_evaluator(const std::string& word);
/// 1 to 99 cycles and their shape, V, W or F; or "run".
bool is_study_cycles(const std::string& word);

/// Largest number of nodes for the direct sum, whose cost rises by a factor of sixteen per level.
constexpr double most_nodes_of_direct = 2e4;

/// All combinations, coarse to fine; the direct sum only on grids where it is affordable. in: the plan; nodes: the
/// number of nodes of a grid with a given number of cells.
std::vector<StudyCase> cases_of(const StudyPlan& plan, const std::function<double(int)>& nodes);

/// The case of the deck on a grid of `cells`, otherwise unchanged. in: path; overrides, of which grid.cells is
/// replaced; threads. errors: core::InputError.
Case case_on_grid(const std::string& path, const std::vector<std::string>& overrides, int cells, int threads);

/// Sets the method in the scene. For a fixed number of cycles, this number becomes the limit of cycles, so that the
/// solution ends unconverged if the checks need more. All other settings are those of the deck.
void use_way(const StudyCase& variant, steady::Scene& scene);

/// The name of a method, "upstream2, mlmi8, 2W"; of a run in time, "rtol 0.001, steps of at most 0.05".
std::string name_of_variant(const StudyCase& variant);

}  // namespace ehl::program
