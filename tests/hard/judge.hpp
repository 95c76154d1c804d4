#pragma once
// One random deck, the real program, and what can be held against it.
#include <cstdint>
#include <string>
#include <vector>

#include "hard/random_deck.hpp"
#include "hard/subprocess.hpp"

namespace hard {

struct Setting {
  std::string program{};
  std::vector<KnownKey> keys{};
  std::vector<std::string> environment{};
  Shares shares{};
  double limit = 60.0;                ///< seconds of one run
  double most_nodes = 129.0 * 129.0;  ///< larger grids (damage can ask for one) are checked, not run
};

enum class End { solved, refused, not_converged, too_large, crashed, hung, other };

struct Verdict {
  std::uint64_t seed = 0;
  RandomDeck deck{};
  End end = End::other;
  std::string reason{};               ///< what the program said when it refused or did not converge
  std::vector<std::string> faults{};  ///< of the program; each begins with what was expected
  std::vector<std::string> warnings{};
  double seconds = 0.0;
  double Hc = 0.0;             ///< where solved
  double formula_ratio = 0.0;  ///< Hc over the published formula; where solved
  std::string groups{};        ///< "M, L"; where the case was begun
};

/// Makes the deck of a seed, runs the program on it and judges. in: setting; sampled: also reads the result file back
/// and runs the case again on the other number of threads.
Verdict judge(std::uint64_t seed, const Setting& setting, bool sampled);

/// What is wrong with the report of a contact without lubricant that calls itself solved; an entry for each fault.
std::vector<std::string> faults_of_dry(const std::string& json);

/// The same of one in time; nothing where the report has no "transient".
std::vector<std::string> faults_in_time(const std::string& json);

/// What a run with friction must say of it; none where the result has none.
std::vector<std::string> faults_of_friction(const std::string& json);

/// The same of one with a supply.
std::vector<std::string> faults_of_starvation(const std::string& json);

/// The same of heat.
std::vector<std::string> faults_of_heat(const std::string& json);

/// What is wrong with the columns that `ehl extract FILE transient` has printed. in: the steps that the report counts.
std::vector<std::string> faults_of_rows(const std::string& columns, double steps);

/// A number in a text, NaN where there is none.
double number(const std::string& text);

/// The value of a member as JSON, a text without its quotes; empty when there is none. in: its path, "friction/mu".
std::string json_member(const std::string& json, const std::string& path);

}  // namespace hard
