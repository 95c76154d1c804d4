#pragma once
// Runs a deck of inputs/hard with the program and reads its report.
#include <string>
#include <vector>

#include "support/json.hpp"
#include "support/program.hpp"

namespace hard {

struct Step {
  double M;
  bool converged;
};

struct Report {
  int status = -1;  ///< exit status
  std::string err{};
  nlohmann::json json{};  ///< null if nothing was reported

  /// The number at a path, "verification/Hm"; NaN if the report has null there.
  double number(const std::string& path) const { return support::number_at(json, "/" + path); }
  /// A text as it is, any other value as JSON; empty if there is none.
  std::string text(const std::string& name) const {
    const nlohmann::json value = json.is_object() ? json.value(name, nlohmann::json("")) : "";
    return value.is_string() ? value.get<std::string>() : value.dump();
  }
  double of_last_level(const std::string& name) const {
    return support::number_at(json.at("levels").back(), "/" + name);
  }
  int cells() const { return static_cast<int>(of_last_level("nx")); }
  /// The warning that contains this part; empty if there is none.
  std::string warning(const std::string& part) const {
    for (const std::string one : json.at("warnings"))
      if (one.find(part) != std::string::npos) return one;
    return "";
  }
  std::vector<Step> continuation() const {
    std::vector<Step> steps;
    for (const nlohmann::json& step : json.at("continuation")) steps.push_back({step.at("M"), step.at("converged")});
    return steps;
  }
};

/// Runs `ehl run inputs/hard/NAME.ini` with these overrides ("section.key=value").
inline Report run_deck(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const support::TemporaryFolder folder;
  std::string arguments = std::string("run '") + EHL_INPUTS + "/hard/" + name + ".ini' --json --quiet --output r.h5";
  for (const std::string& override : overrides) arguments += " --set '" + override + "'";
  const support::Ended ended = support::ehl(folder, arguments);
  return {ended.status, ended.err, ended.out.empty() ? nlohmann::json() : nlohmann::json::parse(ended.out)};
}

}  // namespace hard
