// ehl extract: prints datasets as columns that gnuplot reads.
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "base/exit_status.hpp"
#include "commands/commands.hpp"
#include "commands/field_sample.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

using Kind = results::ResultFile::Kind;

std::string column_number(double value) { return std::isnan(value) ? "nan" : deck::shortest(value); }

// The path of a dataset: "P" -> /fields/P, "levels" -> /levels, "Hc" -> /summary/Hc; a full path is unchanged.
std::string full_name(const ResultSource& source, const std::string& name) {
  if (name.starts_with("/") && source.file.kind(name) != Kind::missing) return name;
  const std::vector<std::string> homes{"/",      "/fields/",    "/summary/",          "/scales/",    "/provenance/",
                                       "/grid/", "/transient/", "/transient/frames/", "/subsurface/"};
  std::vector<std::string> known;
  for (const std::string& home : homes) {
    if (source.file.kind(home + name) != Kind::missing) return home + name;
    if (source.file.kind(home) == Kind::group)
      for (const std::string& found : source.file.names(home)) known.push_back(found);
  }
  refuse(source.file.path() + " has no dataset " + name + suggestion(name, known) + " It has " +
         deck::joined(known, ", "));
}

std::string header(const ResultSource& source, const std::string& name, const FieldOnGrid& f) {
  return "# " + source.file.path() + ": " + source.file.attribute("/", "title") + "\n# " + name + " [" + f.field.unit +
         "]: " + f.field.meaning + "; x, " + f.rows + " in " + f.places() + "\n";
}

std::string grid_columns(const FieldOnGrid& f, const std::string& column) {
  std::string text = "# x " + f.rows + " " + column + "\n";
  for (std::size_t j = 0; j < f.y.values.size(); ++j) {
    if (j > 0) text += "\n";  // gnuplot ends a scan at a blank line
    const std::string y = deck::shortest(f.y.values[j]);
    for (std::size_t i = 0; i < f.x.values.size(); ++i)
      text += deck::shortest(f.x.values[i]) + " " + y + " " + column_number(f.at(i, j)) + "\n";
  }
  return text;
}

std::string matrix(const FieldOnGrid& f) {
  std::string text =
      "# first row: number of columns and x; then " + f.rows + " and the values: plot '...' matrix nonuniform\n";
  text += std::to_string(f.x.values.size());
  for (const double x : f.x.values) text.append(" ").append(deck::shortest(x));
  text += "\n";
  for (std::size_t j = 0; j < f.y.values.size(); ++j) {
    text += deck::shortest(f.y.values[j]);
    for (std::size_t i = 0; i < f.x.values.size(); ++i) text.append(" ").append(column_number(f.at(i, j)));
    text += "\n";
  }
  return text;
}

std::size_t nearest_line(const std::vector<double>& lines, double at) {
  const auto nearest = std::ranges::min_element(lines, {}, [at](double line) { return std::abs(line - at); });
  return static_cast<std::size_t>(nearest - lines.begin());
}

std::string section(const FieldOnGrid& f, const std::string& column, const Arguments& arguments) {
  const Section wanted = wanted_section(f, arguments);
  const std::string axis = wanted.along_x ? "x" : f.rows;
  const std::string other = wanted.along_x ? f.rows : "x";
  const std::vector<double>& positions = wanted.along_x ? f.x.values : f.y.values;
  const std::vector<double>& lines = wanted.along_x ? f.y.values : f.x.values;
  const std::size_t line = nearest_line(lines, wanted.at);
  std::string text = "# along " + axis + " at " + other + " = " + deck::shortest(lines[line]) +
                     (f.x.unit == "a" ? "" : " " + f.x.unit) + "\n# " + axis + " " + column + "\n";
  for (std::size_t k = 0; k < positions.size(); ++k)
    text += deck::shortest(positions[k]) + " " + column_number(wanted.along_x ? f.at(k, line) : f.at(line, k)) + "\n";
  return text;
}

// The fields of a dataset with `count` of them that --step asks for.
std::vector<std::size_t> chosen_steps(const Arguments& arguments, std::size_t count) {
  const std::string given = arguments.value("step", "");
  if (given == "last") return {count - 1};
  std::vector<std::string> words = deck::split_words(given);
  if (words.empty()) words = {given};
  std::vector<std::size_t> steps;
  for (const std::string& one : words) {
    const deck::ReadNumber read = deck::read_number(one);
    const bool whole = read.status == deck::ReadNumber::Status::number && read.value == std::floor(read.value);
    if (!whole || read.value < 0.0 || read.value >= static_cast<double>(count))
      refuse("--step " + given + ": must be last or a whole number from 0 to " + std::to_string(count - 1) +
             ", or several of them with commas");
    steps.push_back(static_cast<std::size_t>(read.value));
  }
  return steps;
}

// A section at every time or depth: blocks of lines "time position value", separated by blank lines.
std::string sections_in_time(const ResultSource& source, const std::string& name, const Arguments& arguments,
                             std::size_t count) {
  if (!arguments.has("along") && !arguments.has("at"))
    refuse(name + " contains " + std::to_string(count) + " fields: choose one with --step 0 to " +
           std::to_string(count - 1) + ", or a section of all with --along x");
  const std::string layer = source.file.axis(name, "time").empty() ? "z" : "time";
  const results::Array times = source.numbers(source.file.axis(name, layer));
  if (times.values.size() != count) throw core::FileError(source.file.path() + ": the file is damaged: " + name);
  std::string text;
  for (std::size_t k = 0; k < count; ++k) {
    const FieldOnGrid field = sampled(read_field(source, name, k), arguments);
    std::istringstream lines(section(field, name.substr(name.rfind('/') + 1), arguments));
    if (k > 0) text += "\n";
    const std::string units =
        source.si ? "# units: " + times.unit + " " + field.x.unit + " " + field.field.unit + "\n" : "";
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("#"))
        text += deck::shortest(times.values[k]) + " " + line + "\n";
      else if (k == 0)
        text += line.starts_with("# along") ? units + line + "\n" : "# " + layer + " " + line.substr(2) + "\n";
    }
  }
  return text;
}

// A group of columns (levels, history); the last line of the heading names the columns.
std::string table(const ResultSource& source, const std::string& name) {
  std::istringstream order(source.file.attribute(name, "columns"));
  std::vector<results::Array> columns;
  std::string names = "#";
  std::string units = "# units:";
  for (std::string column; order >> column;) {
    columns.push_back(source.numbers(name + "/" + column));
    names += " " + column;
    units += " " + columns.back().unit;
  }
  std::string text = "# " + source.file.attribute(name, "meaning") + "\n" + units + "\n" + names + "\n";
  const std::size_t rows = columns.empty() ? 0 : columns[0].values.size();
  for (const results::Array& column : columns)
    if (column.values.size() != rows) throw core::FileError(source.file.path() + ": the file is damaged: " + name);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t k = 0; k < columns.size(); ++k)
      text.append(k == 0 ? "" : " ").append(column_number(columns[k].values[row]));
    text += "\n";
  }
  return text;
}

// A dataset with a single value, or the size of another one.
std::string value_line(const ResultSource& source, const std::string& path, const std::string& said) {
  if (source.file.kind(path) == Kind::text) {
    const std::string text = source.file.text(path);
    return said + (text.find('\n') == std::string::npos ? " \"" + text + "\"\n" : " (text)\n");
  }
  const std::vector<std::size_t> dims = source.file.dims(path);
  const results::Array found = dims.empty() ? source.numbers(path) : source.described(path);
  std::string value = dims.empty() ? column_number(found.values[0]) : "";
  for (const std::size_t size : dims) value += (value.empty() ? "[" : "x") + std::to_string(size);
  return said + " " + value + (dims.empty() ? "" : "]") + " \"" + found.unit + "\" \"" + found.meaning + "\"\n";
}

// The entries of a group, one per line.
std::string list(const ResultSource& source, const std::string& name) {
  std::string text = "# name value unit meaning\n";
  for (const std::string& entry : source.file.names(name)) {
    const std::string whole = (name == "/" ? "" : name) + "/" + entry;
    const Kind kind = source.file.kind(whole);
    text += kind == Kind::group ? entry + " (group)\n" : kind == Kind::missing ? "" : value_line(source, whole, entry);
  }
  return text;
}

// All datasets of a group and of the groups in it. A damaged file may contain a group in itself.
std::string contents(const ResultSource& source, const std::string& group) {
  constexpr int deepest = 6;
  std::string text;
  for (const std::string& entry : source.file.names(group)) {
    const std::string whole = (group == "/" ? "" : group) + "/" + entry;
    const Kind kind = source.file.kind(whole);
    if (kind == Kind::numbers || kind == Kind::text) text += value_line(source, whole, whole);
    if (kind == Kind::group && std::ranges::count(whole, '/') < deepest) text += contents(source, whole);
  }
  return text;
}

std::string columns(const ResultSource& source, const std::string& name) {
  const results::Array array = source.numbers(name);
  std::string text = "# " + name + " [" + array.unit + "]: " + array.meaning + "\n";
  for (const double value : array.values) text += column_number(value) + "\n";
  return text;
}

// The number of the case in the results of a sweep; empty: the file is one result.
std::optional<std::size_t> wanted_case(const Arguments& arguments) {
  if (!arguments.has("case")) return std::nullopt;
  constexpr int most = 999'999'999;
  return static_cast<std::size_t>(whole_number(arguments, "case", 0, most, 0));
}

// The number of dimensions of a dataset: 2 for a field, 3 for fields of several times or depths.
std::size_t rank(const ResultSource& source, const std::string& name) {
  return source.file.kind(name) == Kind::numbers ? source.file.dims(name).size() : 0;
}

void check_options(const ResultSource& source, const std::vector<std::string>& names, const Arguments& arguments) {
  const auto any = [&](std::size_t least) {
    return std::ranges::any_of(names, [&](const std::string& name) { return rank(source, name) >= least; });
  };
  const std::string none = names.size() == 1 ? ", and " + names[0] + " is not a field"
                                             : ", and there is none among " + deck::joined(names, ", ");
  for (const char* option : {"along", "at", "matrix", "sample", "window"})
    if (arguments.has(option) && !any(2)) refuse(std::string("--") + option + " applies to fields" + none);
  if (arguments.has("matrix") && is_section(arguments)) refuse("either --matrix or --along and --at");
  if (arguments.has("step") && !any(3)) refuse("--step applies to fields of several times or depths" + none);
}

std::string field_text(const ResultSource& source, const std::string& name, std::size_t step,
                       const Arguments& arguments) {
  const FieldOnGrid field = sampled(read_field(source, name, step), arguments);
  const std::string column = name.substr(name.rfind('/') + 1);
  return header(source, name, field) + (is_section(arguments)     ? section(field, column, arguments)
                                        : arguments.has("matrix") ? matrix(field)
                                                                  : grid_columns(field, column));
}

// A dataset as text, or a field of a dataset with several.
struct Piece {
  std::string name{};
  std::string text{};
};

std::vector<Piece> pieces_of(const ResultSource& source, const std::string& path, const Arguments& arguments) {
  const std::string name = path.substr(path.rfind('/') + 1);
  const Kind kind = source.file.kind(path);
  const std::size_t dimensions = rank(source, path);
  if (kind == Kind::text) return {{name, source.file.text(path) + "\n"}};
  if (kind == Kind::group)
    return {{name, source.file.attribute(path, "columns").empty() ? list(source, path) : table(source, path)}};
  if (dimensions < 2) return {{name, columns(source, path)}};
  if (dimensions == 2) return {{name, field_text(source, path, 0, arguments)}};
  const std::size_t count = source.file.dims(path)[0];
  if (!arguments.has("step")) return {{name, sections_in_time(source, path, arguments, count)}};
  std::vector<Piece> pieces;
  const std::vector<std::size_t> steps = chosen_steps(arguments, count);
  for (const std::size_t step : steps)
    pieces.push_back(
        {name + (steps.size() == 1 ? "" : "_" + std::to_string(step)), field_text(source, path, step, arguments)});
  return pieces;
}

// A data block of gnuplot, without comments. A table begins with the names of its columns.
std::string data_block(const Piece& piece, bool is_table, const Arguments& arguments) {
  std::istringstream lines(piece.text);
  std::string heading, rows;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#"))
      heading = line.substr(std::min<std::size_t>(2, line.size())) + "\n";
    else
      rows += line + "\n";
  }
  return "$" + arguments.value("gnuplot", "") + "_" + piece.name + " << EOD\n" + (is_table ? heading : "") + rows +
         "EOD\n";
}

std::string data_blocks(const ResultSource& source, const std::string& path, const Arguments& arguments) {
  const bool group = source.file.kind(path) == Kind::group;
  if (source.file.kind(path) == Kind::text || (group && source.file.attribute(path, "columns").empty()))
    refuse("--gnuplot applies to numbers, and " + path + " contains text");
  std::string text;
  for (const Piece& piece : pieces_of(source, path, arguments)) text += data_block(piece, group, arguments);
  return text;
}

}  // namespace

int extract(const Arguments& arguments) {
  ResultSource source = open_result(arguments.operands[0], wanted_case(arguments));
  if (arguments.has("si")) source.si = scales_of(source.file);
  if (arguments.has("si") && !source.si) refuse("--si: the contact of " + source.file.path() + " is not given in SI");
  std::vector<std::string> names;
  for (std::size_t k = 1; k < arguments.operands.size(); ++k) names.push_back(full_name(source, arguments.operands[k]));
  check_options(source, names, arguments);
  std::string text = names.empty() ? "# path value unit meaning\n" + contents(source, "/") : "";
  for (const std::string& name : names) {
    if (arguments.has("gnuplot"))
      text += data_blocks(source, name, arguments);
    else
      for (const Piece& piece : pieces_of(source, name, arguments)) text += (text.empty() ? "" : "\n\n") + piece.text;
  }
  print(text);
  return solved;
}

}  // namespace ehl::program
