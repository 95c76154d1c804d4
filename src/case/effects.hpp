#pragma once
// What a scene can call for beyond the basic model: one list, from which all that the program says and does about an
// effect follows: the sections of the deck and their help, `ehl check`, the run, the table of times, the JSON, the
// result. An effect that a case does not call for is asked whether it is on, and nothing else.
//
// A new one: a file effect_<name>.cpp with its record, a line in effects(), its declaration below. What its section of
// the deck says goes into the case by `read`: into the scene, or into an optional of its own in Case (scene.hpp).
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "case/computed.hpp"
#include "case/needs.hpp"
#include "case/scene.hpp"
#include "deck/key.hpp"
#include "results/content.hpp"

namespace ehl::program {

/// How a run was asked for.
struct RunSettings {
  Progress& progress;
  TransientResult before{};  ///< what was kept of a transient before: with a checkpoint it goes on from there
  /// Writes the result so far: that of the contact, with what `add` adds to it.
  std::function<void(const std::function<void(results::Content& content)>& add)> save{};
};

struct KeyName {
  std::string section{};
  std::string name{};
};

/// Where an effect acts.
enum class Stage {
  coefficients,      ///< of the film: gap, viscosity, density
  after_relaxation,  ///< on what follows the pressure from sweep to sweep
  unknowns,          ///< it has unknowns of its own, or steps in time
  after_solution     ///< on nothing: it follows from P and H
};

/// One effect. A function that is not set has nothing to say or to do; all but `read` and `on` are called where it is
/// on.
struct Effect {
  std::string name{};
  std::string meaning{};
  std::string (*name_here)(const Case& input) = nullptr;  ///< its name in this case, where that may be another
  Stage stage = Stage::after_solution;
  std::string without{};                                  ///< what the basic model has in its place: "steady"
  std::vector<deck::Section> sections{};                  ///< of the deck, that belong to nothing else
  std::vector<KeyName> callers{};                         ///< keys that call for it; effects() adds those of sections
  KeyName costly{};                                       ///< key that governs its memory; none: a caller
  std::vector<deck::Key> (*keys)() = nullptr;             ///< not set: they stand among those of another module
  void (*read)(Case& input) = nullptr;                    ///< from the deck; complains there; the scene is made before
  bool (*on)(const Case& input) = nullptr;                ///< must be set
  std::string (*what)(const Case& input) = nullptr;       ///< what there is of it in this case, must be set
  std::string (*idle)(const Case& input) = nullptr;       ///< why it has no influence in this case; empty where it has
  Needs (*expense)(const Case& input) = nullptr;          ///< beyond the case without it
  std::string (*asymmetry)(const Case& input) = nullptr;  ///< why the case is not symmetric in Y; empty where it is
  void (*compute)(const Case& input, RunSettings& settings,
                  Computed& computed) = nullptr;  ///< after the steady contact
  std::string (*summary)(const Case& input, const Computed& computed) = nullptr;
  nlohmann::ordered_json (*json)(const Case& input, const Computed& computed) = nullptr;  ///< the member of its name
  void (*add_content)(const Case& input, const Computed& computed, results::Content& content) = nullptr;
  double (*seconds)(const Computed& computed) = nullptr;  ///< its own, that no other effect counts
  std::vector<std::string> example{};                     ///< overrides that turn it on in a deck in M and L
  std::string upon{};                                     ///< the effect that the example needs besides
};

/// The list, in the order in which they are computed and spoken of. A section without a meaning has its effect's.
const std::vector<Effect>& effects();

/// Those that the case calls for.
std::vector<Effect> effects_of(const Case& input);

/// What the deck says of each effect, into the case. Complains in its deck.
void read_effects(Case& input);

/// The entries of the list.
Effect elliptic_effect();
Effect roller_effect();
Effect transient_effect();
Effect body_effect();
Effect surfaces_effect();
Effect shear_effect();
Effect starvation_effect();
Effect subsurface_effect();
Effect friction_effect();
Effect thermal_effect();

/// The friction of a solution, as the case asks for it or without the cavitated region. in: what heat and the flow's
/// thinning make of the film, or nullptr.
friction::Friction friction_of(const Case& input, const steady::Solution& solution, const heat::Fields* film);
/// Its numbers, for the report as JSON, the result file and the tables.
std::vector<results::Quantity> friction_quantities(const friction::Friction& found);

/// "steady, smooth, ..., fully flooded": what the case leaves to the basic model.
std::vector<std::string> basic_model(const Case& input);

/// The keys of the deck that call for the effect, "[transient] end_time = 8"; with_place: and where they stand.
std::vector<std::string> called_by(const Case& input, const Effect& effect, bool with_place);

/// Why the case is not symmetric in Y, an entry for each reason; none: one half of it can be computed.
std::vector<std::string> asymmetries(const Case& input);

/// Complains in the case's deck about every effect that was called for and has no influence.
void refuse_idle(Case& input);

/// Lines of `ehl check`: what is on, what it is in this case, why, and what it will cost; the symmetry in Y.
std::string effect_lines(const Case& input);

/// Seconds and share of the basic model and of each effect; empty where there is none.
std::string effect_times(const Case& input, const Computed& computed);

/// Adds to a report "effects": [{name, seconds, why, what}], and a member for each effect that has more to say.
void add_effects(const Case& input, const Computed& computed, nlohmann::ordered_json& report);

/// /effects in the result file: name, seconds and why; none where there is no effect.
std::vector<results::EffectRow> effect_rows(const Case& input, const Computed& computed);

/// Adds to a result what the effects keep there, and /effects.
void add_effects(const Case& input, const Computed& computed, results::Content& content);

}  // namespace ehl::program
