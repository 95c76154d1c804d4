#include "golden/transcript.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "golden/normal.hpp"
#include "support/program.hpp"

namespace golden {
namespace {

std::string marked(const std::string& text, char mark) {
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line.erase(line.find_last_not_of(' ') + 1);
    out += mark + (line.empty() ? std::string() : " " + line) + "\n";
  }
  return out;
}

std::string with_program(const std::string& command) {
  return std::string("ehl() { '") + EHL_PROGRAM + "' \"$@\"; }\nexport LC_ALL=C\n" + command;
}

// The name of the processor, as the program prints it.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  return "a processor without a name";
}

}  // namespace

std::string performed(const std::string& transcript) {
  const support::TemporaryFolder folder;
  for (const auto& entry : std::filesystem::directory_iterator(GOLDEN_FILES))
    std::filesystem::copy(entry.path(), folder / entry.path().filename().string());
  const std::vector<Place> places{
      {folder.path(), "FOLDER"}, {EHL_PROGRAM, "EHL"}, {EHL_SOURCE, "SOURCE"}, {processor(), "MACHINE"}};
  std::string text;
  std::istringstream lines(transcript);
  for (std::string line; std::getline(lines, line);) {
    const char mark = line.empty() ? ' ' : line[0];
    if (mark == '|' || mark == '!' || mark == '=') continue;
    text += line + "\n";
    if (mark != '$' && mark != '~') continue;
    const support::Ended ended = support::shell(folder, with_program(line.substr(1)));
    const Numbers numbers = mark == '$' ? Numbers::kept : Numbers::replaced;
    text += marked(normal(ended.out, numbers, places), '|') + marked(normal(ended.err, numbers, places), '!');
    if (ended.status != 0) text += "= " + std::to_string(ended.status) + "\n";
  }
  return text;
}

}  // namespace golden
