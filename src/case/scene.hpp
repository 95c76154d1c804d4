#pragma once
// Converts a deck to a case that can be solved.
#include <string>
#include <vector>

#include "case/dry_case.hpp"
#include "case/physical_input.hpp"
#include "case/thermal_input.hpp"
#include "case/transient_input.hpp"
#include "case/tuning_input.hpp"
#include "deck/file.hpp"
#include "effects/friction/friction.hpp"
#include "effects/roller/profile.hpp"
#include "effects/subsurface/stress.hpp"
#include "machines/number.hpp"
#include "steady/scene.hpp"

namespace ehl::program {

struct Case {
  std::string title{};
  deck::Deck deck{};  ///< including all values that were chosen
  Physics physics{};
  TunedNumbers tuning{};
  steady::Scene scene{};
  SurfaceInput surfaces{};                      ///< the surfaces, moving or at rest
  std::optional<transient::Input> transient{};  ///< nothing: the case is steady
  std::optional<DryInput> dry{};                ///< without lubricant; the scene is then only a grid
  std::optional<machines::Contact> machine{};   ///< the bearing or gears from which [contact] follows
  std::optional<subsurface::Parameters> subsurface{};
  std::optional<friction::Parameters> friction{};
  std::optional<HeatInput> heat{};
  std::optional<roller::Profile> roller{};
  std::optional<rheology::FlowThinning> flow_thinning{};  ///< [shear] flow = on
  std::vector<std::string> fields{};                      ///< fields to keep in the result
  std::string output{};                                   ///< the result file that the deck names
  std::vector<deck::NamedFile> files{};                   ///< the files that the deck names, and their contents
};

/// The keys [case] title and [output], which belong to the program and to no module.
std::vector<deck::Key> case_keys();

/// Reads, validates and converts a deck. in: path of the deck, overrides, number of threads. errors: core::InputError
/// with all errors of the deck.
Case read_case(const std::string& path, const std::vector<std::string>& overrides, int threads);

/// As read_case(), for commands that compare films: a dry contact is refused. in: command: "study" or "sweep".
Case read_lubricated_case(const std::string& path, const std::vector<std::string>& overrides, int threads,
                          const std::string& command);

/// Converts a deck that was already read. in: path: used for the names of case and result if the deck gives none.
Case case_of(deck::Deck understood, const std::string& path, int threads);

}  // namespace ehl::program
