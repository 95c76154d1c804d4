#pragma once
// The tuned numbers of the modules in the deck: [tuning], which `ehl keys` does not list unless asked for.
#include <optional>
#include <string>
#include <vector>

#include "core/tuning.hpp"
#include "core/warning.hpp"
#include "deck/deck.hpp"
#include "effects/heat/tuning.hpp"
#include "judgement/tuning.hpp"
#include "multigrid/tuning.hpp"
#include "newton/tuning.hpp"
#include "steady/tuning.hpp"
#include "transient/tuning.hpp"

namespace ehl::program {

struct TunedNumbers {
  multigrid::Tuning multigrid{};
  judgement::Tuning judgement{};
  steady::Tuning steady{};
  newton::Tuning newton{};
  transient::Tuning transient{};
  heat::Tuning heat{};
};

/// The section [tuning] with a key for each number, "steady.widest_step".
deck::Section tuning_section();
std::vector<deck::Key> tuning_keys();

/// The defaults, and the numbers that the deck gives instead.
TunedNumbers read_tuning(const deck::Deck& deck);

/// The numbers that differ from their defaults, with the name of their module.
std::vector<core::Retuned> retuned(const TunedNumbers& numbers);

/// The warning that numbers differ from those that were tested; nothing if none does.
std::optional<core::Warning> tuning_warning(const TunedNumbers& numbers);

/// Lines for the report: the numbers that differ from their defaults, or that none does.
std::string tuning_lines(const TunedNumbers& numbers);

}  // namespace ehl::program
