#include "tables/sweep_merge.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "core/errors.hpp"
#include "deck/file.hpp"
#include "deck/text.hpp"
#include "tables/sweep_table.hpp"

namespace ehl::program {
namespace {

struct Part {
  std::vector<std::string> programs{};
  std::vector<std::string> head{};  ///< the lines that all parts have in common, and the names of the columns
  std::string shard{};              ///< "3/10 of 77 cases"
  std::vector<std::string> rows{};  ///< rows, each with the number of its case
};

Part read_part(const std::string& path) {
  constexpr std::uintmax_t largest = 1'000'000'000;  // bytes
  std::ifstream file = deck::opened(path, largest);
  const std::string content{std::istreambuf_iterator<char>(file), {}};
  deck::check_read(file, path);
  std::istringstream lines(content.substr(0, content.rfind('\n') + 1));
  Part part;
  std::string line;
  if (!std::getline(lines, line) || line != sweep_mark)
    throw core::FileError(path + ": this is not a table of `ehl sweep` of this version");
  while (std::getline(lines, line)) {
    if (line.starts_with(program_mark)) {
      part.programs.push_back(line);
    } else if (line.starts_with(shard_mark)) {
      part.shard = line.substr(std::string(shard_mark).size());
    } else if (line.starts_with('#')) {
      part.head.push_back(line);
    } else if (line.starts_with(case_column)) {
      part.head.push_back(line.substr(std::string(case_column).size()));
    } else {
      part.rows.push_back(line);
    }
  }
  if (part.shard.empty())
    throw core::FileError(path + ": is not part of a sweep: only tables of --shard can be merged");
  return part;
}

std::size_t whole_number(const std::string& text, const std::string& said) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) throw core::FileError(said);
  return number;
}

void check_same(const std::string& path, const Part& part, const std::string& first_path, const Part& first) {
  const auto differ = [&](const std::string& own, const std::string& other) {
    throw core::FileError(fmt::format("{}: belongs to another sweep than {}: '{}', not '{}'", path, first_path,
                                      own.substr(0, 160), other.substr(0, 160)));
  };
  for (std::size_t k = 0; k < std::max(part.head.size(), first.head.size()); ++k) {
    const std::string own = k < part.head.size() ? part.head[k] : "nothing";
    const std::string other = k < first.head.size() ? first.head[k] : "nothing";
    if (own != other) differ(own, other);
  }
  const auto of = [](const std::string& shard) { return shard.substr(shard.find('/')); };
  if (of(part.shard) != of(first.shard)) differ("shard " + part.shard, "shard " + first.shard);
}

}  // namespace

MergedSweep merged_sweep(const std::vector<std::string>& paths) {
  std::vector<Part> parts;
  std::vector<std::string> programs;
  std::map<std::size_t, std::pair<std::string, std::string>> rows;  // per case: its row and its file
  for (const std::string& path : paths) {
    parts.push_back(read_part(path));
    check_same(path, parts.back(), paths[0], parts[0]);
    for (const std::string& program : parts.back().programs)
      if (std::ranges::find(programs, program) == programs.end()) programs.push_back(program);
    for (const std::string& line : parts.back().rows) {
      const std::string damaged = path + ": the table is damaged: " + line.substr(0, 120);
      const std::size_t comma = line.find(',');
      if (comma == std::string::npos || !line.ends_with('"')) throw core::FileError(damaged);
      const std::size_t number = whole_number(line.substr(0, comma), damaged);
      // The last row of a case counts: a case that failed is computed again.
      const auto [found, is_new] = rows.try_emplace(number, line.substr(comma + 1), path);
      if (!is_new && found->second.second != path)
        throw core::FileError(fmt::format("{}: case {} is also in {}", path, number, found->second.second));
      found->second.first = line.substr(comma + 1);
    }
  }
  const std::string of = " of ";
  const std::string& shard = parts[0].shard;
  MergedSweep merged{.text = std::string(sweep_mark) + "\n" + deck::joined(programs, "\n") + "\n" +
                             deck::joined(parts[0].head, "\n") + "\n"};
  const std::string count = shard.substr(std::min(shard.size(), shard.find(of) + of.size()));
  merged.cases = whole_number(count.substr(0, count.find(' ')), paths[0] + ": the table is damaged: " + shard);
  for (std::size_t k = 0; k < merged.cases; ++k) {
    const auto row = rows.find(k);
    if (row == rows.end()) {
      merged.missing.push_back(k);
      continue;
    }
    const std::string& text = row->second.first;
    merged.text += text + "\n";
    merged.converged += text.find(",converged,") != std::string::npos || text.starts_with("converged,") ? 1 : 0;
  }
  return merged;
}

}  // namespace ehl::program
