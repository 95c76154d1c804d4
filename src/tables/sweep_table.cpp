#include "tables/sweep_table.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "case/catalogue.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "tables/csv.hpp"
#include "tables/warning_names.hpp"

namespace ehl::program {
namespace {

const std::string vary_mark = "# vary: ";
const std::string cases_mark = "# cases: ";

// The lines that identify a sweep.
std::vector<std::string> identity(const SweepHeader& header) {
  std::vector<std::string> lines{deck_text_line(header.deck_text)};
  for (const deck::NamedFile& file : header.files) lines.push_back(file_line(file));
  for (const std::string& set : header.set) lines.push_back("# set: " + set);
  return lines;
}

// The lines that define the cases of a sweep.
std::vector<std::string> cases_of(const SweepHeader& header) {
  std::vector<std::string> lines;
  for (const Variation& variation : header.variations) {
    const std::string keys = deck::joined(varied_keys({variation}), ",");
    std::vector<std::string> values;
    for (const std::vector<std::string>& one : variation.values) values.push_back(deck::joined(one, ":"));
    lines.push_back(variation.file.empty() ? vary_mark + keys + " = " + deck::joined(values, ",")
                                           : cases_mark + variation.file);
  }
  if (!header.shard.whole())
    lines.push_back(fmt::format("{}{}/{} of {} cases", shard_mark, header.shard.index, header.shard.count,
                                number_of_cases(header.variations)));
  return lines;
}

std::string names_of_columns(const SweepHeader& header) {
  std::string line = header.shard.whole() ? "" : case_column;
  for (const std::string& key : varied_keys(header.variations)) line += key + ",";
  return line + csv_names(sweep_row(header.columns));
}

// One line for each part of the table.
std::string meaning_of_columns(const SweepColumns& columns) {
  std::string text;
  int part = -1;
  for (const numbers::SweepColumn& one : columns) {
    if (one.name == id::warnings) continue;
    const bool begins = one.place / 100 != part;
    part = one.place / 100;
    text += (begins ? (text.empty() ? "# " : "\n# ") : "; ") + one.name + ": " + one.meaning;
  }
  return text + "\n";
}

std::string whole_header(const SweepHeader& header, const std::vector<std::string>& programs) {
  std::string text = std::string(sweep_mark) + "\n";
  for (const std::string& program : programs) text += std::string(program_mark) + program + "\n";
  text += "# deck: " + header.deck + "\n" + deck::joined(identity(header), "\n") + "\n";
  if (const std::vector<std::string> cases = cases_of(header); !cases.empty()) text += deck::joined(cases, "\n") + "\n";
  text += "# H = h R/a^2, P = p/p_h, errors and residual relative\n";
  text += meaning_of_columns(header.columns) + "# " + meaning_of_warnings() + "\n";
  for (const std::string& line : header.left_out) text += "# " + line + "\n";
  return text + csv_units(sweep_row(header.columns)) + "\n" + names_of_columns(header) + "\n";
}

const std::string remedy = ": give --overwrite to start again, or another --output";

// Shortens the list of cases for a message; it may be very long.
std::string shortened(const std::string& text) {
  constexpr std::size_t most = 160;
  return text.size() > most ? text.substr(0, most) + "..." : text;
}

}  // namespace

std::vector<deck::NamedFile> files_of_cases(const std::string& path, const std::vector<std::string>& set,
                                            const std::vector<Variation>& variations) {
  std::map<std::string, deck::NamedFile> by_name;
  const auto add = [&](std::vector<std::string> overrides) {
    overrides.insert(overrides.begin(), set.begin(), set.end());
    for (deck::NamedFile& file : deck::named_files(deck::read(path, overrides, catalogue())))
      by_name.insert({file.name, std::move(file)});
  };
  add(overrides_of_case(variations, 0));
  for (const Variation& varied : variations)
    for (std::size_t k = 0; k < varied.keys.size(); ++k) {
      const Variation::Key& key = varied.keys[k];
      if (deck::find_key(catalogue(), key.section, key.name)->names == deck::Names::nothing) continue;
      std::set<std::string> names;
      for (const std::vector<std::string>& values : varied.values) names.insert(values[k]);
      for (const std::string& name : names) add({name_of(key) + "=" + name});
    }
  std::vector<deck::NamedFile> files;
  for (auto& [name, file] : by_name) files.push_back(std::move(file));
  return files;
}

std::string header_text(const SweepHeader& header) { return whole_header(header, {header.program}); }

SweepTable::SweepTable(const std::string& path, const SweepHeader& header, const std::vector<std::size_t>& own,
                       bool overwrite)
    : path_(path),
      header_(header),
      own_(own),
      rows_(number_of_cases(header.variations)),
      columns_(sweep_row(header.columns)) {
  open();
  try {
    std::ifstream file(path);
    const std::string content = overwrite ? "" : std::string(std::istreambuf_iterator<char>(file), {});
    if (!file) throw core::FileError(path + ": cannot be read: " + std::strerror(errno));
    if (content.empty()) {
      if (::ftruncate(descriptor_, 0) != 0)
        throw core::FileError(path + ": cannot be written: " + std::strerror(errno));
      programs_ = {header.program};
      write(header_text(header));
    } else {
      read(content);
    }
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

void SweepTable::open() {
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw core::FileError(path_ + ": cannot be written: " + std::strerror(errno));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(descriptor_);
  throw core::FileError(path_ + ": another sweep is writing this table");
}

SweepTable::~SweepTable() { ::close(descriptor_); }

void SweepTable::read(const std::string& content) {
  std::istringstream lines(content.substr(0, content.rfind('\n') + 1));
  std::vector<std::string> found, found_cases;
  std::map<std::string, std::size_t> cases;
  for (const std::size_t index : own_) cases[start_of_row(index)] = index;
  const std::string columns = names_of_columns(header_);
  bool has_columns = false;
  std::string line;
  std::getline(lines, line);
  if (line != sweep_mark)
    throw core::FileError(path_ + ": already exists and is not a table of a sweep of this version ('" +
                          shortened(line) + "')" + remedy);
  while (std::getline(lines, line)) {
    if (line.starts_with(program_mark)) programs_.push_back(line.substr(std::strlen(program_mark)));
    for (const std::string mark : {"# deck text: ", "# file: ", "# set: "})
      if (line.starts_with(mark)) found.push_back(line);
    for (const std::string& mark : {vary_mark, cases_mark, std::string(shard_mark)})
      if (line.starts_with(mark)) found_cases.push_back(line);
    if (line.starts_with('#')) continue;
    if (has_columns) {
      take_row(line, columns, cases);
      continue;
    }
    has_columns = true;
    check_same(found, identity(header_));
    // Other varied columns mean other cases; more values of the same columns mean more cases.
    if (line != columns) {
      check_same(found_cases, cases_of(header_));
      throw core::FileError(path_ + ": has other columns than this version writes" + remedy);
    }
  }
  if (!has_columns) throw core::FileError(path_ + ": already exists and is only the head of a table" + remedy);
  const bool new_program = std::ranges::find(programs_, header_.program) == programs_.end();
  if (new_program) programs_.push_back(header_.program);
  if (found_cases != cases_of(header_)) {
    if (lost_) check_same(found_cases, cases_of(header_));
    finish();
    ::close(descriptor_);
    open();
    return;
  }
  if (lost_)
    throw core::FileError(path_ + ": this line is not a row of the sweep: " + *lost_ +
                          ": remove it, give --overwrite to start again, or another --output");
  // Removes an incomplete last line, which a killed sweep may leave.
  if (::ftruncate(descriptor_, static_cast<off_t>(content.rfind('\n') + 1)) != 0)
    throw core::FileError(path_ + ": cannot be written: " + std::strerror(errno));
  if (new_program) write(std::string(program_mark) + header_.program + "\n");
}

void SweepTable::check_same(const std::vector<std::string>& found, const std::vector<std::string>& own) const {
  for (std::size_t k = 0; k < std::max(own.size(), found.size()); ++k) {
    const std::string here = k < found.size() ? shortened(found[k].substr(2)) : "nothing";
    const std::string asked = k < own.size() ? shortened(own[k].substr(2)) : "nothing";
    if (k >= found.size() || k >= own.size() || found[k] != own[k])
      throw core::FileError(path_ + ": belongs to another sweep (it has '" + here + "', this sweep has '" + asked +
                            "')" + remedy);
  }
}

void SweepTable::take_row(const std::string& line, const std::string& columns,
                          const std::map<std::string, std::size_t>& cases) {
  const std::size_t before = varied_keys(header_.variations).size() + (header_.shard.whole() ? 0 : 1);
  std::vector<std::string> cells = csv_cells(line, before + 1);
  const std::string row = cells.back();
  cells.pop_back();
  const auto found = cases.find(cells.empty() ? "" : deck::joined(cells, ",") + ",");
  // The reason is the last column, and the only one that may contain commas.
  const auto commas = [](const std::string& text) { return std::count(text.begin(), text.end(), ','); };
  if (found == cases.end() || !row.ends_with('"') || commas(line) < commas(columns)) {
    if (!lost_) lost_ = line.substr(0, 120);
    return;
  }
  rows_[found->second] = row;
}

void SweepTable::write(const std::string& text) const {
  // One call per row: other readers then see only whole rows, and a full disk shows as a short count.
  const ssize_t written = ::write(descriptor_, text.data(), text.size());
  if (written == static_cast<ssize_t>(text.size())) return;
  throw core::FileError(path_ + ": cannot be written: " + (written < 0 ? std::strerror(errno) : "the disk is full"));
}

std::string SweepTable::start_of_row(std::size_t index) const {
  const std::vector<std::string> values = values_of_case(header_.variations, index);
  return (header_.shard.whole() ? "" : std::to_string(index) + ",") + deck::joined(values, ",") +
         (values.empty() ? "" : ",");
}

std::string SweepTable::line_of(std::size_t index) const { return start_of_row(index) + rows_[index] + "\n"; }

void SweepTable::append(std::size_t index, const std::string& text) {
  rows_[index] = text;
  write(line_of(index));
}

void SweepTable::finish() const {
  std::string text = whole_header(header_, programs_);
  for (std::size_t index = 0; index < rows_.size(); ++index)
    if (!rows_[index].empty()) text += line_of(index);
  write_table(path_, text, true);
}

std::vector<std::size_t> SweepTable::missing() const {
  std::vector<std::size_t> cases;
  for (const std::size_t index : own_)
    if (rows_[index].empty() || rows_[index].starts_with("failed,")) cases.push_back(index);
  return cases;
}

std::string SweepTable::cell(std::size_t index, const std::string& column) const {
  const auto found = std::ranges::find(columns_, column, &results::Quantity::name);
  const std::vector<std::string> cells = csv_cells(rows_[index], columns_.size());
  const auto at = static_cast<std::size_t>(found - columns_.begin());
  return at < cells.size() ? cells[at] : "";
}

std::size_t SweepTable::count(const std::string& status) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(rows_, [&](const std::string& row) { return row.starts_with(status + ","); }));
}

}  // namespace ehl::program
