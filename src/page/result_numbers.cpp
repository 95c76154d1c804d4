// The numbers of a result, each with its error bar; numbers that did not converge are marked.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "case/numbers/number.hpp"
#include "page/result_view.hpp"

namespace ehl::program {
namespace {

using numbers::path_of;
using numbers::Shown;

// The place of a number: "at (42.0, −112.1) µm".
std::string place_of(const ResultView& view, const std::string& name) {
  if (name.starts_with(path_of(id::Hc))) return name.ends_with("_moes") ? "" : "(0, 0)";
  std::string base = name.ends_with("_best") ? name.substr(0, name.size() - 5) + "_fitted" : name;
  if (!view.has(base + "_x")) base = name.ends_with("_best") ? name.substr(0, name.size() - 5) : name;
  if (!view.has(base + "_x")) return "";
  const results::Array x = view.number(base + "_x"), y = view.number(base + "_y"), z = view.number(base + "_z");
  if (!std::isfinite(x.values[0])) return "";
  const auto place = [&](double at) {
    return fmt::format("{:.{}f}", std::abs(at) < (view.source.si ? 0.05 : 0.0005) ? 0.0 : at, view.source.si ? 1 : 3);
  };
  const std::string depth = std::isfinite(z.values[0]) ? ", " + place(z.values[0]) : "";
  return "(" + place(x.values[0]) + ", " + place(y.values[0]) + depth + ") " + escaped(unit_words(x.unit));
}

bool grows_with_mesh(const ResultView& view, const Shown& one) {
  return one.number->name == id::P_max && view.value(path_of(id::P_max_converging)) == 0.0;
}

std::string cell_of(const ResultView& view, const Shown& one) {
  const results::Array found = view.number(one.path);
  const double error = one.error.empty() ? std::nan("") : view.value(one.error);
  if (!view.converged) {
    const std::string unit = with_indices(unit_words(found.unit));
    return not_converged_cell(digits(found.values[0], std::nan("")) + (unit.empty() ? "" : " " + unit));
  }
  return with_bar(found.values[0], error, found.unit);
}

std::string in_steps(const std::string& name) { return "/transient/" + name; }

std::vector<double> column_in_time(const ResultView& view, const std::string& name) {
  return view.has(in_steps(name)) ? view.source.numbers(in_steps(name)).values : std::vector<double>{};
}

// The program that computed a result: "version 0.1.0, commit 732df358, g++ 12.2.0".
std::string program_words(const ResultView& view) {
  const auto word = [&](const char* name) { return view.text(std::string("/provenance/") + name); };
  const std::string changed = word("dirty") == "true" ? ", with changes that no commit holds" : "";
  return word("program") + " " + word("version") + ", commit " + word("commit").substr(0, 12) + changed + ", " +
         word("compiler");
}

// Why a run in time ended early: "failed: the cycles did not converge."
std::string ended_words(const ResultView& view) {
  const std::string ended = view.text(path_of(id::ended));  // files of earlier versions lack it
  const std::string failed = "FAILED: ";
  return ended.starts_with(failed) ? "failed: " + ended.substr(failed.size()) + "."
         : view.has("/checkpoint") ? "was stopped before its end; `ehl resume` goes on with it."
                                   : "was stopped before its end.";
}

std::string paragraphs(const std::string& lines, const std::string& css_class, const std::string& before) {
  std::string text;
  std::istringstream all(lines);
  for (std::string line; std::getline(all, line);)
    if (!line.empty()) text += "<p class=\"" + css_class + "\">" + before + escaped(line) + "</p>\n";
  return text;
}

}  // namespace

std::string numbers_of_run(const ResultView& view) {
  HtmlTable table{view.in_time ? "At the start: the steady contact" : "What was computed",
                  {"", "value ± error bar", "at", ""},
                  {},
                  "main"};
  for (const Shown& one : numbers::shown_on_page()) {
    if (!std::isfinite(view.value(one.path))) continue;
    const numbers::OnPage& page = one.number->page;
    const std::string note =
        grows_with_mesh(view, one) ? "grows with the mesh, as at a spike: belongs to this mesh" : page.note;
    table.rows.push_back({with_indices(page.words.empty() ? one.number->label : page.words), cell_of(view, one),
                          place_of(view, one.path), with_indices(note)});
  }
  std::string text = table.text();
  const double domain = view.value(path_of(id::domain_error));
  if (domain > 0.0 && std::isfinite(domain) && view.converged)
    text += fmt::format(
        "<p class=\"small\">Error bars cover mesh and cycles, but not the size of the domain: on a domain without end "
        "the films would be about {:.2g} % different.</p>\n",
        100.0 * domain);
  return text;
}

std::string numbers_in_time(const ResultView& view) {
  const std::vector<double> times = column_in_time(view, id::time);
  if (times.empty()) return "";
  HtmlTable table{"In time", {"", "least", "at time", "highest", "at time", "at the end"}, {}, "numbers"};
  const std::string in_time = with_indices(unit_words(view.source.described(in_steps(id::time)).unit));
  for (const std::string name : {id::Hc, id::Hm, id::P_max, id::load, id::mu}) {
    const std::vector<double> values = column_in_time(view, name);
    if (values.size() != times.size() || std::ranges::any_of(values, [](double one) { return std::isnan(one); }))
      continue;
    if (name == id::load && std::ranges::adjacent_find(values, std::ranges::not_equal_to()) == values.end()) continue;
    const auto low = std::ranges::min_element(values), high = std::ranges::max_element(values);
    const std::string unit = with_indices(unit_words(view.source.described(in_steps(name)).unit));
    const auto number = [&](double value) { return fmt::format("{:.5g} ", value) + unit; };
    const auto time = [&](auto place) {
      return fmt::format("{:.4g} ", times[static_cast<std::size_t>(place - values.begin())]) + in_time;
    };
    table.rows.push_back({with_indices(numbers::label_in_time(name)), number(*low), time(low), number(*high),
                          time(high), number(values.back())});
  }
  return table.text() + fmt::format(
                            "<p class=\"small\">{} steps to {:.4g} {}. These numbers carry the error of the mesh, "
                            "as at the start, and that of the steps; it is not estimated in the run.</p>\n",
                            times.size() - 1, times.back(), in_time);
}

std::string warnings_of(const ResultView& view) {
  std::string text;
  if (!view.converged) {
    const std::string check = view.text(path_of(id::failed_check));
    text += "<p class=\"alarm\"><b>Not converged.</b> " + escaped(check) + (check.ends_with('.') ? "" : ".") +
            " No number of this run is a result.</p>\n";
  }
  if (view.value(path_of(id::completed)) == 0.0)
    text += "<p class=\"alarm\"><b>Not complete.</b> The run in time " + escaped(ended_words(view)) + "</p>\n";
  for (const std::string& name : view.source.file.names("/summary"))
    if (name.ends_with("warnings")) text += paragraphs(view.text("/summary/" + name), "warning", "<b>Warning:</b> ");
  return text.empty() ? "<p class=\"fine\">Converged: all checks passed. No warnings.</p>\n"
         : view.converged && view.value(path_of(id::completed)) != 0.0
             ? "<p class=\"fine\">Converged: all checks passed.</p>\n" + text
             : text;
}

namespace {

using Kind = results::ResultFile::Kind;

constexpr std::size_t most_rows = 200;

// "p_max" with all letters after the bar as the index.
std::string with_one_index(const std::string& symbol) {
  const std::size_t bar = symbol.find('_');
  if (bar == std::string::npos) return escaped(symbol);
  return with_indices(symbol.substr(0, bar + 1) + "{" + symbol.substr(bar + 1) + "}");
}

std::string table_of_file(const ResultView& view, const std::string& name) {
  HtmlTable table{with_indices(""), {}, {}, "numbers"};
  std::istringstream order(view.source.file.attribute(name, "columns"));
  std::vector<std::vector<double>> columns;
  for (std::string column; order >> column;) {
    const results::Array found = view.source.numbers(name + "/" + column);
    const std::string unit = with_indices(unit_words(found.unit));
    const std::string symbol = view.source.si ? numbers::symbol_in_si(column) : "";
    table.head.push_back((symbol.empty() ? escaped(column) : with_one_index(symbol)) +
                         (unit.empty() ? "" : " [" + unit + "]"));
    columns.push_back(found.values);
  }
  std::size_t rows = columns.empty() ? 0 : columns[0].size();
  for (const auto& column : columns) rows = std::min(rows, column.size());
  const std::size_t every = (rows + most_rows - 1) / most_rows;
  for (std::size_t row = 0; row < rows; row += every) {
    table.rows.emplace_back();
    for (const auto& column : columns)
      table.rows.back().push_back(std::isfinite(column[row]) ? fmt::format("{:.5g}", column[row]) : "–");
  }
  table.caption = escaped(view.source.file.attribute(name, "meaning"));
  if (every > 1) table.caption += fmt::format(" (each {}th of {} rows)", every, rows);
  return table.text();
}

std::string all_numbers(const ResultView& view, const std::string& group) {
  HtmlTable table{"", {"name", "value", "unit", "meaning"}, {}, "main"};
  for (const std::string& name : view.source.file.names(group)) {
    const std::string whole = group + "/" + name;
    const results::Array found = view.number(whole);
    const std::string words = view.text(whole);
    if (words.empty() && !std::isfinite(found.values[0])) continue;
    table.rows.push_back({escaped(name), words.empty() ? fmt::format("{:.7g}", found.values[0]) : escaped(words),
                          with_indices(unit_words(found.unit)), escaped(found.meaning)});
  }
  return (view.converged || group != "/summary" ? "" : "<p class=\"alarm\">Not converged.</p>\n") + table.text();
}

}  // namespace

std::string details_of(const ResultView& view) {
  std::string text;
  for (const std::string& name : view.source.file.names("/")) {
    const std::string whole = "/" + name;
    if (view.source.file.kind(whole) != Kind::group || view.source.file.attribute(whole, "columns").empty()) continue;
    const std::string table = table_of_file(view, whole);
    text += name == "levels" || name == "grids" ? table : folded("Table: " + escaped(name), table);
  }
  text += folded("All numbers of the result", all_numbers(view, "/summary"));
  text += folded("Contact and scales", all_numbers(view, "/scales"));
  text += folded("Deck", "<pre>" + escaped(view.text("/deck")) + "</pre>\n");
  text += folded("Provenance", all_numbers(view, "/provenance"));
  const auto word = [&](const char* name) { return escaped(view.text(std::string("/provenance/") + name)); };
  const double seconds = view.value(path_of(id::seconds));  // NaN of a file without a solution
  return text + "<p class=\"small\">" + escaped(program_words(view)) + "; " + word("host_cpu") + ", threads " +
         word("threads") + "; " +
         (std::isfinite(seconds) ? fmt::format("{:.3g} s for the solution; ", seconds) : std::string()) + word("date") +
         ".</p>\n";
}

}  // namespace ehl::program
