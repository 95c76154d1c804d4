#include "page/table_words.hpp"

#include "page/markup.hpp"

namespace ehl::program {

std::string comment(const SweepData& table, const std::string& name) {
  for (const std::string& line : table.comments)
    if (line.starts_with(name + ": ")) return line.substr(name.size() + 2);
  return "";
}

std::string origin_of(const SweepData& table) {
  HtmlTable made{"", {}, {}, "main"};
  for (const std::string& line : table.comments)
    for (const char* name : {"deck", "set", "vary", "cases", "machine", "date", "times", "program", "file"})
      if (line.starts_with(std::string(name) + ": "))
        made.rows.push_back({name, escaped(line.substr(line.find(": ") + 2))});
  return made.text();
}

std::string comments_of(const SweepData& table) {
  std::string lines;
  for (const std::string& line : table.comments) lines += escaped(line) + "\n";
  return folded("Remarks above the table", "<pre>" + lines + "</pre>\n");
}

}  // namespace ehl::program
