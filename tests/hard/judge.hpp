#pragma once
// Runs the program on one random deck and judges the outcome.
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
  double most_nodes = 129.0 * 129.0;  ///< larger grids, which damage may ask for, are checked but not run
};

enum class End { solved, refused, not_converged, too_large, crashed, hung, other };

struct Verdict {
  std::uint64_t seed = 0;
  RandomDeck deck{};
  End end = End::other;
  std::string reason{};               ///< the program's reason for a refusal or for a solution that did not converge
  std::vector<std::string> faults{};  ///< faults of the program; each begins with what was expected
  std::vector<std::string> warnings{};
  double seconds = 0.0;
  double Hc = 0.0;             ///< set if the case was solved
  double formula_ratio = 0.0;  ///< Hc divided by the published formula; set if the case was solved
  std::string groups{};        ///< "M, L"; set if the solution was started
};

/// Makes the deck of a seed, runs the program on it and judges the outcome. in: setting; sampled: also read the result
/// file and repeat the case with another number of threads.
Verdict judge(std::uint64_t seed, const Setting& setting, bool sampled);

/// The faults of the report of a dry contact that claims to be solved.
std::vector<std::string> faults_of_dry(const std::string& json);

/// The faults of the report of a run in time; empty if it has no "transient".
std::vector<std::string> faults_in_time(const std::string& json);

/// The faults of the friction in a report; empty if it has none.
std::vector<std::string> faults_of_friction(const std::string& json);

/// The faults of the starvation in a report; empty if it has none.
std::vector<std::string> faults_of_starvation(const std::string& json);

/// The faults of the heat in a report; empty if it has none.
std::vector<std::string> faults_of_heat(const std::string& json);

/// The faults of the columns that `ehl extract FILE transient` prints. in: the number of steps in the report.
std::vector<std::string> faults_of_rows(const std::string& columns, double steps);

/// The number in a text; NaN if there is none.
double number(const std::string& text);

/// The line of a text in which nan or inf stands as a word; empty if there is none. NaN is what a table writes for an
/// unknown number.
std::string no_number_in(const std::string& text);

/// The markup of a page without its embedded pictures, whose letters mean nothing.
std::string without_pictures(std::string markup);

/// The value of a member as JSON, a text without its quotes; empty if there is none. in: its path, "friction/mu".
std::string json_member(const std::string& json, const std::string& path);

}  // namespace hard
