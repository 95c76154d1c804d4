// Judges runs that contain more than a steady film.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "hard/judge.hpp"

namespace hard {
namespace {

// If the bodies are separated, the load is a small difference of forces and is relative to the load of the contact.
constexpr double loose_load_in_time = 1e-3;

void expect(std::vector<std::string>& faults, bool holds, const std::string& what) {
  if (!holds) faults.push_back(what);
}

void expect_number(std::vector<std::string>& faults, const std::string& json, const std::string& name) {
  expect(faults, std::isfinite(number(json_member(json, name))),
         "solved: " + name + " is a number: " + json_member(json, name));
}

}  // namespace

double number(const std::string& text) {
  std::istringstream stream(text);
  double value = std::nan("");
  stream >> value;
  return value;
}

std::vector<std::string> faults_of_dry(const std::string& json) {
  std::vector<std::string> faults;
  for (const char* name : {"P_max", "H00", "area", "gap_error", "load_error"}) expect_number(faults, json, name);
  expect(faults, number(json_member(json, "P_max")) > 0.0, "solved: P_max > 0");
  constexpr double rounding = 1e-9;
  expect(faults, number(json_member(json, "load_error")) < rounding,
         "solved: the load holds: " + json_member(json, "load_error"));
  return faults;
}

std::vector<std::string> faults_of_friction(const std::string& json) {
  std::vector<std::string> faults;
  const std::string own = json_member(json, "friction");
  if (own.empty()) return faults;
  for (const char* name : {"mu", "mu_rolling", "mu_1", "mu_2", "mu_cavitated", "largest_stress"})
    expect_number(faults, own, name);
  // Sliding acts on both surfaces with opposite signs; the pressure on the slopes of the gap is the remainder.
  const double mu = number(json_member(own, "mu"));
  const double halves = 0.5 * (number(json_member(own, "mu_2")) - number(json_member(own, "mu_1")));
  constexpr double rounding = 1e-9;
  expect(faults, std::abs(halves - mu) <= rounding * std::max(1.0, std::abs(mu)),
         "solved: mu is half of what both surfaces feel: " + std::to_string(mu) + ", " + std::to_string(halves));
  return faults;
}

std::vector<std::string> faults_of_starvation(const std::string& json) {
  std::vector<std::string> faults;
  const std::string own = json_member(json, "starvation");
  if (own.empty()) return faults;
  expect_number(faults, own, "oil_in");
  if (json.find("there is no starvation factor") != std::string::npos) {
    expect(faults, json_member(own, "starvation_factor") == "null", "no flooded contact, no factor");
  } else {
    for (const char* name : {"starvation_factor", "supply_ratio"}) expect_number(faults, own, name);
    const double factor = number(json_member(own, "starvation_factor"));
    constexpr double thicker = 1.01;  // the film may exceed the flooded film by the algebraic errors of both
    const bool told = json.find("the starvation factor is") != std::string::npos;
    expect(faults, factor > 0.0 && (factor <= thicker || told),
           "solved: less oil, less film: factor " + std::to_string(factor));
  }
  constexpr double balanced = 1.0000001e-10;  // the limit for a solution, allowing for the digits of the report
  expect(faults, std::abs(number(json_member(own, "mass_imbalance"))) < balanced,
         "solved: oil is conserved: " + json_member(own, "mass_imbalance"));
  return faults;
}

std::vector<std::string> faults_of_heat(const std::string& json) {
  std::vector<std::string> faults;
  const std::string own = json_member(json, "thermal");
  if (own.empty() || own == "null") return faults;
  for (const char* name : {"mu", "mu_isothermal", "T_film_max", "T1_max", "T2_max", "heat_1", "heat_2", "heat_made"})
    expect_number(faults, own, name);
  constexpr double allowed = 1e-3;  // the program's own limit
  expect(faults, std::abs(number(json_member(own, "heat_imbalance"))) <= allowed,
         "solved: heat balances: " + json_member(own, "heat_imbalance"));
  // No surface is hotter than the adjacent film.
  const double film = number(json_member(own, "T_film_max"));
  for (const char* name : {"T1_max", "T2_max"})
    expect(faults, number(json_member(own, name)) <= film,
           std::string("solved: ") + name + " is a temperature of the film");
  return faults;
}

std::vector<std::string> faults_in_time(const std::string& json) {
  std::vector<std::string> faults;
  const std::string own = json_member(json, "transient");
  if (own.empty()) return faults;
  expect(faults, json_member(own, "completed") == "true",
         "solved: the run in time is complete: " + json_member(own, "ended"));
  for (const char* name : {"end_time", "Hc", "Hm", "least_Hm", "largest_P_max", "worst_load_error"})
    expect_number(faults, own, name);
  expect(faults, number(json_member(own, "least_Hm")) > 0.0, "solved: a film at all times");
  const bool at_once = json_member(own, "ended").find("stop_film") != std::string::npos;
  expect(faults, number(json_member(own, "steps")) > 0.0 || at_once, "solved: steps of time");
  expect(faults, number(json_member(own, "worst_load_error")) < loose_load_in_time,
         "solved: the load holds at all times: " + json_member(own, "worst_load_error"));
  constexpr double balanced = 1.0000001e-10;
  // After a jump the first steps are about 1e-7 long; rates over such a step amplify the rounding
  // of the oil content by 1e7.
  constexpr double rounding_of_rates = 1e-8;
  if (const std::string oil = json_member(own, "worst_oil_error"); !oil.empty())
    expect(faults, number(oil) <= balanced && std::abs(number(json_member(own, "oil_lost"))) <= rounding_of_rates,
           "solved: oil is conserved at all times: " + oil + ", " + json_member(own, "oil_lost"));
  return faults;
}

std::vector<std::string> faults_of_rows(const std::string& columns, double steps) {
  std::vector<std::string> faults;
  std::istringstream lines(columns);
  double count = 0.0;
  double before = -1.0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream row(line);
    double time = std::nan("");
    row >> time;
    expect(faults, time > before, "the times grow: " + line);
    before = time;
    for (std::string word; row >> word;) expect(faults, std::isfinite(number(word)), "a row of numbers: " + line);
    ++count;
  }
  expect(faults, count == steps + 1.0, "a row for every step: " + std::to_string(count));
  return faults;
}

}  // namespace hard
