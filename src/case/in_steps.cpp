// What the effects of a case add to a run in time.
#include <algorithm>
#include <utility>

#include "case/effects.hpp"
#include "core/timer.hpp"

namespace ehl::program {
namespace {

// Appends the results of an effect to those of the effects before it. in: seconds: counts its time; may be null.
template <class Measure>
void append(const Measure& own, double* seconds, Measure& all) {
  if (!own) return;
  all = [before = all, own, seconds](const transient::Snapshot& state) {
    auto list = before ? before(state) : decltype(own(state)){};
    const double began = core::now();
    for (auto& one : own(state)) list.push_back(std::move(one));
    if (seconds != nullptr) *seconds += core::now() - began;
    return list;
  };
}

// The coupling of an effect, with the time of its functions counted. in: seconds; may be null.
transient::Coupling timed(const transient::Coupling& own, double* seconds) {
  const auto count = [seconds](auto function) {
    return [function, seconds](const auto&... arguments) {
      const double began = core::now();
      auto made = function(arguments...);
      if (seconds != nullptr) *seconds += core::now() - began;
      return made;
    };
  };
  return {count(own.settle), count(own.predict), count(own.respond), own.accept, own.restart, own.in_cycles, own.limit};
}

}  // namespace

InSteps in_steps_of(const Case& input, std::map<std::string, double>* seconds) {
  InSteps all;
  for (const Effect& effect : effects_of(input)) {
    if (!effect.stages.in_steps) continue;
    const InSteps own = effect.stages.in_steps(input);
    if (own.empty()) continue;
    double* of_effect = seconds == nullptr ? nullptr : &(*seconds)[effect.name];
    all.numbers.insert(all.numbers.end(), own.numbers.begin(), own.numbers.end());
    all.fields.insert(all.fields.end(), own.fields.begin(), own.fields.end());
    if (own.coupling) all.coupling = timed(*own.coupling, of_effect);
    append(own.measure, of_effect, all.measure);
    append(own.measure_fields, of_effect, all.measure_fields);
  }
  return all;
}

std::vector<double> column_of(const TransientResult& result, const std::string& number) {
  const auto found = std::ranges::find(result.measured, number);
  std::vector<double> values;
  if (found == result.measured.end()) return values;
  for (const transient::StepRow& row : result.rows)
    values.push_back(row.measured.at(static_cast<std::size_t>(found - result.measured.begin())));
  return values;
}

}  // namespace ehl::program
