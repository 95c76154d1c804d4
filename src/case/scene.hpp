#pragma once
// From a deck to a case that can be solved.
#include <string>
#include <vector>

#include "case/dry_case.hpp"
#include "case/physical_input.hpp"
#include "case/thermal_input.hpp"
#include "case/transient_input.hpp"
#include "deck/file.hpp"
#include "effects/friction/friction.hpp"
#include "effects/roller/profile.hpp"
#include "effects/subsurface/stress.hpp"
#include "machines/number.hpp"
#include "steady/scene.hpp"

namespace ehl::program {

struct Case {
  std::string title{};
  deck::Deck deck{};  ///< with everything that was chosen
  Physics physics{};
  steady::Scene scene{};
  SurfaceInput surfaces{};                      ///< what they carry, in time or at rest
  std::optional<transient::Input> transient{};  ///< nothing: steady
  std::optional<DryInput> dry{};                ///< without lubricant: then the scene is but a grid
  std::optional<machines::Contact> machine{};   ///< of a bearing or of gears, from which [contact] follows
  std::optional<subsurface::Parameters> subsurface{};
  std::optional<friction::Parameters> friction{};
  std::optional<HeatInput> heat{};
  std::optional<roller::Profile> roller{};
  std::optional<rheology::FlowThinning> flow_thinning{};  ///< [shear] flow = on
  std::vector<std::string> fields{};                      ///< to keep in the result
  std::string output{};                                   ///< result file that the deck names
  std::vector<deck::NamedFile> files{};                   ///< that the deck names, and what they held
};

/// The deck's keys of [case] title and [output], which are the program's own.
std::vector<deck::Key> case_keys();

/// Reads, validates and converts. in: path of the deck, overrides, number of threads.
/// errors: core::InputError with every complaint about keys and about what they mean together.
Case read_case(const std::string& path, const std::vector<std::string>& overrides, int threads);

/// The same for commands that compare films: a dry contact is refused. command: "study", "sweep".
Case read_lubricated_case(const std::string& path, const std::vector<std::string>& overrides, int threads,
                          const std::string& command);

/// The same of a deck that is read already; path: what names case and result where the deck does not.
Case case_of(deck::Deck understood, const std::string& path, int threads);

}  // namespace ehl::program
