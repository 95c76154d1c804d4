#pragma once
// Runs a deck of inputs/hard with the program and reads its report.
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace hard {

using Tree = boost::property_tree::ptree;

struct Step {
  double M;
  bool converged;
};

struct Report {
  int status = -1;  ///< exit status
  std::string err{};
  Tree json{};  ///< empty where nothing was reported

  /// NaN where the report has null.
  double number(const std::string& path) const { return number_of(json, path); }
  std::string text(const std::string& path) const { return json.get<std::string>(path, ""); }
  const Tree& last_level() const { return json.get_child("levels").back().second; }
  double of_last_level(const std::string& name) const { return number_of(last_level(), name); }
  int cells() const { return last_level().get<int>("nx"); }
  std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    for (const auto& [name, warning] : json.get_child("warnings")) all.push_back(warning.data());
    return all;
  }
  /// The warning with this in it; empty when there is none.
  std::string warning(const std::string& part) const {
    for (const std::string& one : warnings())
      if (one.find(part) != std::string::npos) return one;
    return "";
  }
  std::vector<Step> continuation() const {
    std::vector<Step> steps;
    for (const auto& [name, step] : json.get_child("continuation"))
      steps.push_back({step.get<double>("M"), step.get<bool>("converged")});
    return steps;
  }

 private:
  static double number_of(const Tree& tree, const std::string& path) {
    return tree.get<double>(path, std::numeric_limits<double>::quiet_NaN());
  }
};

/// ehl run inputs/hard/NAME.ini with these overrides ("section.key=value").
inline Report run_deck(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const support::TemporaryFolder folder;
  std::string arguments = std::string("run '") + EHL_INPUTS + "/hard/" + name + ".ini' --json --quiet --output r.h5";
  for (const std::string& override : overrides) arguments += " --set '" + override + "'";
  const support::Ended ended = support::ehl(folder, arguments);
  Report report{.status = ended.status, .err = ended.err};
  std::istringstream out(ended.out);
  if (!ended.out.empty()) boost::property_tree::read_json(out, report.json);
  return report;
}

}  // namespace hard
