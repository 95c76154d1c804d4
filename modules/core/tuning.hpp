#pragma once
// Tuned numbers: those that were chosen by experience, and that may change without making the equations wrong. A module
// keeps its own in a plain struct `Tuning`, beside a table that names them.
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace ehl::core {

/// The kinds of tuned numbers, which say what values make sense.
using Share = double;      ///< 0 < value <= 1
using Reduction = double;  ///< 0 < value < 1
using Growth = double;     ///< 1 < value
using Positive = double;   ///< 0 < value
using Count = int;         ///< 1 <= value
enum class Tunable { share, reduction, growth, positive, count };

/// Name, place and meaning of a tuned number of a module.
template <class Tuning>
struct TunedNumber {
  const char* name;
  Tunable kind;
  std::variant<double Tuning::*, int Tuning::*> place;
  const char* meaning;

  double value(const Tuning& tuning) const {
    return std::visit([&](auto member) { return static_cast<double>(tuning.*member); }, place);
  }
  /// in: a value of this kind.
  void set(Tuning& tuning, double value) const {
    std::visit(
        [&](auto member) { tuning.*member = static_cast<std::remove_reference_t<decltype(tuning.*member)>>(value); },
        place);
  }
};

/// A tuned number that differs from its default.
struct Retuned {
  std::string name;
  double value = 0.0;
  double default_value = 0.0;
};

/// Those of the module's numbers that differ from their defaults.
template <class Tuning>
std::vector<Retuned> retuned(const std::vector<TunedNumber<Tuning>>& table, const Tuning& tuning) {
  std::vector<Retuned> found;
  for (const TunedNumber<Tuning>& number : table)
    if (const double value = number.value(tuning), standard = number.value(Tuning{}); value != standard)
      found.push_back({number.name, value, standard});
  return found;
}

}  // namespace ehl::core
