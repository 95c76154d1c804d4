// The front page is true: what a reader copies from README.md works and shows what the page says.
//
// The blocks of README.md, distinguished by the word after the fence, in one folder and in their order:
//   ini      whose first line is "# NAME": written to NAME
//   sh       every line is run with the built program as `ehl` and with the folder inputs/; exit status 0
//   output   every line occurs in the output of the preceding sh block, to the digits shown; times, the last column of
//            the level table, are excepted
//   others   are not run: text has commands that install or take longer, python what needs packages of its own
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/program.hpp"

BOOST_AUTO_TEST_SUITE(test_readme)

namespace {

struct Block {
  std::string kind;
  std::vector<std::string> lines;
};

std::vector<Block> blocks_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<Block> blocks;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) blocks.push_back({line.substr(3), {}});
    } else if (inside) {
      blocks.back().lines.push_back(line);
    }
  }
  return blocks;
}

void write_deck(const support::TemporaryFolder& folder, const Block& deck) {
  const std::string& first = deck.lines.front();
  BOOST_REQUIRE_MESSAGE(first.starts_with("# "), "an ini block does not name its file: " << first);
  std::string text;
  for (const std::string& line : deck.lines) text += line + "\n";
  folder.write(first.substr(2), text);
}

/// The output of the commands, up to the first one that failed.
std::string run(const support::TemporaryFolder& folder, const Block& commands) {
  const std::string program = std::filesystem::path(EHL_PROGRAM).parent_path().string();
  std::string printed;
  for (const std::string& command : commands.lines) {
    const support::Ended ended = support::shell(folder, "PATH='" + program + "':$PATH\n" + command);
    BOOST_TEST_MESSAGE(command);
    BOOST_TEST(ended.status == 0, command << "\nends with " << ended.status << "\n" << ended.err);
    printed += ended.out;
  }
  return printed;
}

/// The words of a line. For the level table, whose rows begin with a number, the seconds at the end are omitted.
std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  if (!words.empty() && std::isdigit(static_cast<unsigned char>(words.front()[0])) != 0) words.pop_back();
  return words;
}

void compare(const Block& shown, const std::string& printed) {
  std::istringstream stream(printed);
  std::vector<std::vector<std::string>> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(words_of(line));
  for (const std::string& line : shown.lines)
    BOOST_TEST((std::ranges::find(lines, words_of(line)) != lines.end()), "README.md shows what was not printed:\n"
                                                                              << line << "\nprinted:\n"
                                                                              << printed);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_readme_works_as_written) {
  const support::TemporaryFolder folder;
  std::filesystem::create_directory_symlink(EHL_INPUTS, folder / "inputs");
  int decks = 0, commands = 0, outputs = 0;
  std::string printed;
  for (const Block& block : blocks_of(EHL_README)) {
    if (block.kind == "ini") {
      write_deck(folder, block);
      ++decks;
    } else if (block.kind == "sh") {
      printed = run(folder, block);
      commands += static_cast<int>(block.lines.size());
    } else if (block.kind == "output") {
      compare(block, printed);
      ++outputs;
    }
  }
  BOOST_TEST_MESSAGE(decks << " decks, " << commands << " commands, " << outputs << " outputs");
  // A fence with another word would silently drop its block.
  BOOST_TEST(decks >= 1);
  BOOST_TEST(commands >= 10);
  BOOST_TEST(outputs >= 1);
}

BOOST_AUTO_TEST_SUITE_END()
