#pragma once
// The registry of numbers. Every number of a case is declared once, by a record: name, unit, meaning, error bar, label,
// the places where it is shown, and how it follows from a solved case. The result file, the JSON report, the C and
// Python interfaces, the table of a sweep, the page and the plots take it from there. A new number is a new record.
#include <functional>
#include <string>
#include <vector>

#include "base/column.hpp"
#include "case/computed.hpp"
#include "case/numbers/names.hpp"
#include "case/scene.hpp"

namespace ehl::program::numbers {

using results::Quantity;

/// A case and what was computed of it.
struct Solved {
  const Case& input;
  const Computed& computed;
};
using Of = const Solved&;

/// The unit of a number, and the unit where a line contact is reported per length.
struct Unit {
  std::string name{};
  std::string per_length{};      ///< empty: the same
  bool also_of_rollers = false;  ///< also where a roller of finite length is reported per length

  Unit(const char* name_, const char* per_length_ = "", bool also_of_rollers_ = false)
      : name(name_), per_length(per_length_), also_of_rollers(also_of_rollers_) {}
  const std::string& of(bool line) const { return line && !per_length.empty() ? per_length : name; }
};

/// A place among the columns of a sweep's table; the hundreds are the parts of the table, 0 is no column.
struct InSweep {
  int place = 0;
  Value blank = core::unknown;  ///< stands there before anything is known
  bool only_si = false;         ///< only in the table of contacts in SI
};

/// A second column in the table of contacts in SI, in the unit that people read: "h_c" in "nm" is the column h_c_nm.
struct InSi {
  int place = 0;
  std::string symbol{};
  std::string unit{};
};

/// A place in the main table of a result's page, from 1 on; 0: only in its list of all numbers.
struct OnPage {
  int place = 0;
  std::string words{};  ///< the label there, where it is not that of the number
  std::string note{};
};

/// How the page of a sweep shows a column.
enum class OfSweep { hidden, in_table, as_curve };

struct Number {
  std::string name{};
  Unit unit{""};
  std::string meaning{};
  std::function<Value(Of)> value{};               ///< not set: stands in a row or in a file, and not in a case
  std::function<bool(Of)> only_if{};              ///< the cases that have the number; not set: all
  std::function<std::string(Of)> meaning_here{};  ///< set: the meaning depends on the case
  std::string json{};                             ///< path in the report as JSON, where it is not the name
  std::string error{};                            ///< name of the number that is its relative error
  std::string label{};                            ///< with symbol; _ and ^ begin an index
  bool in_file = true;
  InSweep column{};
  InSi in_si{};
  OnPage page{};
  OfSweep of_sweep = OfSweep::hidden;
};

/// When the numbers of a group are known: before the solution, with any solution, with a converged one.
enum class Known { before, solved, converged };

/// Numbers that belong together.
struct Group {
  std::string name{};
  std::vector<Number> numbers{};
  std::string home = "/summary";  ///< in the result file
  std::string prefix{};           ///< of the names in the result file: "roller_"
  Known known = Known::converged;
  bool (*on)(Of) = nullptr;                         ///< the cases that have the group; not set: all
  bool (*asked)(const deck::Deck& deck) = nullptr;  ///< the decks whose sweeps have its columns; not set: all
};

const std::vector<Group>& registry();

/// The numbers of a group of a case. errors: std::logic_error: there is no such group.
std::vector<Quantity> quantities(const std::string& group, Of solved);
/// One number of a case, by its name or its path in the result file.
Quantity quantity(const std::string& name, Of solved);
/// The number with a value from elsewhere.
Quantity given(const std::string& name, const Value& value);
/// What is known before the solution: the groups of the contact, its machine, and its scales.
std::vector<Quantity> scale_quantities(const Case& input);
/// Adds the numbers of a group to a list, except those whose names it already has.
void append(const std::string& group, Of solved, std::vector<Quantity>& list);

/// The record with this name, the first one in the order of the groups, or with this path in the result file,
/// "/transient/load". errors: std::logic_error: there is none.
const Number& number_of(const std::string& name);
/// True where a case reports forces, heat and oil per length of the contact.
bool per_length(const Case& input);
/// The unit of a number in this case.
const std::string& unit_of(const std::string& name, const Case& input);
/// Path in the result file: "/summary/Hc". errors: std::logic_error: there is no such number.
std::string path_of(const std::string& name);
/// Path of its relative error; empty: none is estimated.
std::string error_path_of(const std::string& name);

/// What the page of a result shows, in this order.
struct Shown {
  const Number* number = nullptr;
  std::string path{};   ///< in the result file
  std::string error{};  ///< path of its relative error; empty: none is estimated
};
std::vector<Shown> shown_on_page();

/// The symbol of a number, the last word of its label: "h_c" of "central film h_c".
std::string symbol_of(const std::string& name);
/// The symbol in SI of a dimensionless column: "h_c" of Hc. Empty: it has none.
std::string symbol_in_si(const std::string& name);
/// The heading of a printed column of contacts in SI: "h_c [nm]".
std::string heading_in_si(const std::string& name);
/// The label of a column of /transient: Hc and Hm with the symbols of films in SI.
std::string label_in_time(const std::string& name);

/// A column of another table that holds this number.
template <class Row, class At>
Column<Row> column(const char* name, At at) {
  const Number& number = number_of(name);
  return Column<Row>(number.name, number.unit.name, number.meaning, at);
}

/// A column of the table of a sweep.
struct SweepColumn {
  std::string name{};
  std::string unit{};
  std::string meaning{};
  int place = 0;
  Value blank = core::unknown;
  Known known = Known::before;
  std::function<Value(Of)> value{};  ///< `blank` where the case has no such number
};

/// The columns that a deck asks for: known before any of its cases is solved. in: timing: with seconds and memory.
/// errors: core::InputError of a bearing or of gears.
std::vector<SweepColumn> columns_of_sweep(deck::Deck deck, bool timing);

/// The record of a column of a sweep's table, by the name of the column; nullptr: none has it.
const Number* number_of_column(const std::string& column);
/// The columns that hold the error bar of a column: in its own unit, "h_c_error_nm" of "h_c_nm", and relative,
/// "error_Hc". Empty: there is none.
struct BarColumns {
  std::string in_unit{};
  std::string relative{};
};
BarColumns bar_columns(const std::string& column);
/// The column of a number in the table of contacts in SI: "h_c_nm" of "hc". errors: std::logic_error: it has none.
std::string column_in_si(const std::string& name);

}  // namespace ehl::program::numbers
