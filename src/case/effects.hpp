#pragma once
// The effects: what a scene can contain beyond the basic model. Everything that the program prints and does about an
// effect comes from this list: its sections of the deck and their help, `ehl check`, the run, the table of times, the
// JSON, the result. For an effect that is off, only `on` is called (and `read`, which reads the deck).
//
// To add an effect, write a file effect_<name>.cpp with its record, and name it in effect_list.cpp. Its settings stand
// in the deck, in the scene, or in an optional of its own in Case (scene.hpp); its result in one in Computed
// (computed.hpp).
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "case/computed.hpp"
#include "case/needs.hpp"
#include "case/scene.hpp"
#include "core/warning.hpp"
#include "deck/key.hpp"
#include "results/content.hpp"

namespace ehl::program {

namespace numbers {
struct Group;
}

/// How much is computed of a case; each extent includes those before it.
enum class Extent {
  film,   ///< the steady contact alone, for a point of a study
  row,    ///< numbers for a row of a table, if the contact converged; with those of the run in time
  whole,  ///< also what only a result file holds
};

/// What the caller of the pipeline (run/pipeline.hpp) asks for, and how it follows the computation.
struct RunSettings {
  Progress& progress;
  Extent extent = Extent::whole;
  TransientResult before{};  ///< an earlier run in time; if it has a checkpoint, the run continues from there
  /// Takes the fields of a run in time instead of the result. Empty: the result keeps them.
  std::function<void(transient::Frame&& frame)> frame{};
  /// Writes the result so far: the content of the contact, and what `add` adds to it. Empty: nothing is written.
  std::function<void(const std::function<void(results::Content& content)>& add)> save{};
};

struct KeyName {
  std::string section{};
  std::string name{};
};

/// What an effect adds to a run in time. The rows and frames hold it in the order of the effects.
struct InSteps {
  std::vector<std::string> numbers{};  ///< columns of /transient, by their names in the registry
  std::function<std::vector<double>(const transient::Snapshot& state)> measure{};  ///< NaN: not known at this time
  std::optional<transient::Coupling> coupling{};  ///< of one effect that changes the coefficients
  std::vector<results::NamedField> fields{};      ///< of the frames; without values
  std::function<std::vector<core::Field>(const transient::Snapshot& state)> measure_fields{};
  bool empty() const { return !coupling && numbers.empty() && fields.empty(); }
};

/// Solves the film of a case into computed.solution.
using FilmSolver = void (*)(const Case& input, const steady::ProgressCallback& progress, Computed& computed);

/// The stages at which the pipeline calls an effect, in the order of the calls. What is not set is not called.
struct Stages {
  /// When the deck is read: makes the effect a part of the scene that is solved. Also if the effect is off.
  void (*scene)(Case& input) = nullptr;
  /// The solver that takes the place of steady::solve(), for an effect with equations that are solved together with the
  /// film; nullptr if it has none in this case.
  FilmSolver (*film)(const Case& input) = nullptr;
  /// Continues the steady solution in time.
  void (*in_time)(const Case& input, RunSettings& settings, Computed& computed) = nullptr;
  /// Computes at every accepted step of the run in time, and for every frame.
  InSteps (*in_steps)(const Case& input) = nullptr;
  /// Computes what follows from the solution.
  void (*after_solution)(const Case& input, RunSettings& settings, Computed& computed) = nullptr;
  Extent from = Extent::whole;  ///< the smallest extent with after_solution
};

/// One effect. A function that is not set does nothing. All functions except `read`, `on` and the stage `scene` are
/// called only if the effect is on.
struct Effect {
  std::string name{};
  std::string meaning{};
  std::string (*name_here)(const Case& input) = nullptr;    ///< its name in this case, if that differs from `name`
  std::string without{};                                    ///< the basic model without this effect: "steady"
  std::vector<deck::Section> sections{};                    ///< sections of the deck that belong to this effect alone
  std::vector<KeyName> callers{};                           ///< keys that enable it; effects() adds those of sections
  KeyName costly{};                                         ///< key that determines its memory; empty: first caller
  std::vector<deck::Key> (*keys)() = nullptr;               ///< not set: the keys are declared by another module
  numbers::Group (*numbers)() = nullptr;                    ///< its numbers, added to the registry
  std::vector<numbers::Group> (*more_numbers)() = nullptr;  ///< those of a run in time
  void (*read)(Case& input) = nullptr;                      ///< reads the deck and reports its errors; scene exists
  Stages stages{};                                          ///< when the pipeline calls it
  bool (*on)(const Case& input) = nullptr;                  ///< must be set
  std::string (*what)(const Case& input) = nullptr;         ///< describes the effect in this case; must be set
  std::string (*idle)(const Case& input) = nullptr;         ///< why it has no influence here; empty if it has one
  Needs (*expense)(const Case& input) = nullptr;            ///< the cost in addition to the case without the effect
  std::string (*asymmetry)(const Case& input) = nullptr;    ///< why it breaks the symmetry in Y; empty if not
  std::string (*summary)(const Case& input, const Computed& computed) = nullptr;
  /// Adds to the JSON member of its name, which has its numbers, also in SI, and its seconds.
  void (*json)(const Case& input, const Computed& computed, nlohmann::ordered_json& report) = nullptr;
  /// What a user must know about its numbers. Report, JSON, result file and C interface take it from here.
  core::Warnings (*warnings)(const Case& input, const Computed& computed) = nullptr;
  void (*add_content)(const Case& input, const Computed& computed, results::Content& content) = nullptr;
  double (*seconds)(const Computed& computed) = nullptr;  ///< its computing time, counted by no other effect
  std::vector<std::string> example{};                     ///< overrides that enable it in a deck with M and L
  std::string upon{};                                     ///< another effect that the example requires
};

/// The records of all effects (effect_list.cpp).
std::vector<Effect> listed_effects();

/// All effects, in the order of computation and of printing. A section without a meaning of its
/// own gets that of its effect.
const std::vector<Effect>& effects();

/// The effects that the case enables.
std::vector<Effect> effects_of(const Case& input);

/// Reads the settings of every effect into the case. Errors are added to its deck.
void read_effects(Case& input);

/// What all effects of the case add to a run in time. in: seconds: counts their time, by the name of the effect. The
/// case must outlive the result.
InSteps in_steps_of(const Case& input, std::map<std::string, double>* seconds = nullptr);
/// The values of a column that an effect adds, one for each row; empty: the run has no such column.
std::vector<double> column_of(const TransientResult& result, const std::string& number);

/// The cost of a run in time, of which moving surfaces are a share.
Needs expense_in_time(const Case& input);
/// The number of time steps that is expected.
double expected_steps(const Case& input);
/// The friction of a solution, as the case asks for it, else without the cavitated region. in: film: the temperature
/// and viscosity fields of heat or flow thinning, or nullptr.
friction::Friction friction_of(const Case& input, const steady::Solution& solution, const heat::Fields* film);
/// Makes the solver compute mu and mu_rolling on every level if the case reports friction, so that they get error bars.
void observe_friction(Case& input);

/// The words for the parts of the basic model that no effect replaces: "steady, smooth, ..., fully flooded".
std::vector<std::string> basic_model(const Case& input);

/// The keys of the deck that enable the effect, "[transient] end_time = 8"; with_place: also where they stand.
std::vector<std::string> called_by(const Case& input, const Effect& effect, bool with_place);

/// The reasons why the case is not symmetric in Y. Empty: only one half of the domain is computed.
std::vector<std::string> asymmetries(const Case& input);

/// Adds an error to the deck for each effect that was enabled and has no influence.
void refuse_idle(Case& input);

/// The lines of `ehl check` about the effects: which are on, their description, reason and cost; the symmetry in Y.
std::string effect_lines(const Case& input);

/// Seconds and share of the basic model and of each effect; empty without effects.
std::string effect_times(const Case& input, const Computed& computed);

/// All warnings of a run: those of the contact, then those of its effects.
core::Warnings all_warnings(const Case& input, const Computed& computed);

/// Adds to a report "effects": [{name, seconds, why, what}], and one member for each effect
/// that has numbers of its own; the warnings of the effects join those of the report.
void add_effects(const Case& input, const Computed& computed, nlohmann::ordered_json& report);

/// The group /effects of the result file: name, seconds and reason; empty without effects.
std::vector<results::EffectRow> effect_rows(const Case& input, const Computed& computed);

/// Adds the content of the effects and /effects to a result.
void add_effects(const Case& input, const Computed& computed, results::Content& content);

}  // namespace ehl::program
