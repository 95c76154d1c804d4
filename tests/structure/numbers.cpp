// Every number is declared once, in the registry: its name and its label stand nowhere else in the program.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "case/catalogue.hpp"
#include "case/numbers/number.hpp"
#include "structure/house.hpp"

namespace fs = std::filesystem;
using namespace ehl::program;

namespace {

const fs::path root = EHL_SOURCE_DIR;
const std::string home = "src/case/numbers/";

struct Literal {
  int line = 0;
  std::string text;
};

// The string literals of a source text, without those of comments and #include lines.
std::vector<Literal> literals_of(const std::string& source) {
  std::vector<Literal> found;
  int line = 1;
  for (std::size_t k = 0; k < source.size(); ++k) {
    const char c = source[k];
    if (c == '\n') ++line;
    if (source.compare(k, 2, "//") == 0 || source.compare(k, 8, "#include") == 0) {
      k = std::min(source.find('\n', k), source.size()) - 1;
    } else if (c == '\'' && k + 2 < source.size() && (source[k + 2] == '\'' || source[k + 1] == '\\')) {
      k = source.find('\'', k + 2);
    } else if (c == '"') {
      std::string text;
      for (++k; k < source.size() && source[k] != '"'; ++k) {
        if (source[k] == '\\') text += source[k++];
        text += source[k];
      }
      found.push_back({line, text});
    }
  }
  return found;
}

// Names of numbers that are also words of decks: sections, keys, values, and names of effects.
std::set<std::string> words_of_decks() {
  std::set<std::string> words;
  const ehl::deck::Catalogue all = catalogue();
  for (const ehl::deck::Section& section : all.sections) words.insert(section.name);
  for (const ehl::deck::Key& key : all.keys) {
    words.insert(key.name);
    for (const std::string& word : key.words) words.insert(word);
  }
  return words;
}

// Names of numbers that are also names of other things.
const std::map<std::string, std::string>& other_things() {
  static const std::map<std::string, std::string> all{
      {"a", "a unit"},
      {"h", "a symbol"},
      {"p_h", "a unit"},
      {"rho0", "a unit"},
      {"Sq", "a number of each height map in the JSON report"},
      {"lambda", "a word of a warning"},
      {"mu", "a column of measured traction curves"},
      {"converged", "a status"},
      {"warnings", "a list in the JSON report, one for each effect"},
      {"time", "the axis of fields in time"},
      {"attempts", "the table of strategies in the JSON report"},
      {"steps", "a column of the tables of passes and of studies in time"},
      {"rejected", "a column of the tables of steps and of studies in time"},
      {"not_solved", "a column of the tables of steps and of studies in time"},
      {"newton_steps", "a column of the table of steps"},
      {"oil_lost", "a column of the table of steps"},
      {"jumps", "a number of the checkpoint, and a column of studies in time"}};
  return all;
}

struct Names {
  std::set<std::string> names;
  std::set<std::string> labels;
  std::set<std::string> symbols;  ///< of numbers with a label: "h_c"
  std::set<std::string> homes;    ///< groups of the result file
};

Names registered() {
  Names all;
  for (const numbers::Group& group : numbers::registry()) {
    if (!group.home.empty()) all.homes.insert(group.home);
    for (const numbers::Number& one : group.numbers) {
      all.names.insert(one.name);
      all.names.insert(group.prefix + one.name);
      if (one.in_si.place > 0) all.names.insert(numbers::column_in_si(one.name));
      if (!one.label.empty()) all.labels.insert(one.label);
      if (!one.label.empty() && one.in_si.place > 0) all.symbols.insert(one.in_si.symbol);
      if (!one.page.words.empty()) all.labels.insert(one.page.words);
    }
  }
  return all;
}

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool has_word(const std::string& text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_of_word(text[at - 1])) && (end == text.size() || !is_of_word(text[end]))) return true;
  }
  return false;
}

// The text of a file without the records of an effect's numbers, which stand in namespace numbers; lines are kept.
std::string without_records(std::string text) {
  const std::size_t from = text.find("\nnamespace numbers {\n"), to = text.find("\n}  // namespace numbers\n");
  if (from == std::string::npos || to == std::string::npos) return text;
  for (std::size_t k = from; k < to; ++k)
    if (text[k] != '\n') text[k] = ' ';
  return text;
}

// Literals that are a number's name, a path that ends with it, or its label, or that contain its symbol.
std::vector<std::string> offences(const std::vector<house::SourceFile>& files, const Names& known) {
  const std::set<std::string> words = words_of_decks();
  std::vector<std::string> found;
  for (const house::SourceFile& file : files) {
    if (file.path.generic_string().starts_with(home)) continue;
    const bool is_effect = file.path.generic_string().starts_with("src/case/effect_");
    for (const Literal& literal : literals_of(is_effect ? without_records(file.text) : file.text)) {
      const bool is_path =
          std::ranges::any_of(known.homes, [&](const std::string& of) { return literal.text.starts_with(of + "/"); });
      const std::string name = is_path ? literal.text.substr(literal.text.rfind('/') + 1) : literal.text;
      const bool is_name = known.names.contains(name) && !words.contains(name) && !other_things().contains(name);
      const bool has_symbol =
          std::ranges::any_of(known.symbols, [&](const std::string& symbol) { return has_word(literal.text, symbol); });
      if (is_name || has_symbol || known.labels.contains(literal.text))
        found.push_back(file.path.generic_string() + ":" + std::to_string(literal.line) + ": \"" + literal.text + "\"");
    }
  }
  return found;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_numbers)

BOOST_AUTO_TEST_CASE(the_reader_finds_literals) {
  const std::vector<Literal> found =
      literals_of("#include \"a.hpp\"\n// \"no\"\nf('\"', \"Hc\", \"/summary/Hm\");\ng(\"a\\\"b\");\n");
  BOOST_REQUIRE(found.size() == 3);
  BOOST_TEST(found[0].text == "Hc");
  BOOST_TEST(found[0].line == 3);
  BOOST_TEST(found[1].text == "/summary/Hm");
  BOOST_TEST(found[2].text == "a\\\"b");
  const house::SourceFile bad{"src/page/a.cpp", "src",
                              "f(\"Hc\", \"/summary/Hm\", \"central film h_c\", \"h_c = \", \"other\");"};
  BOOST_TEST(offences({bad}, registered()).size() == 4);
  const house::SourceFile good{home + "a.cpp", "src", "f(\"Hc\");"};
  BOOST_TEST(offences({good}, registered()).empty());
  const house::SourceFile effect{"src/case/effect_a.cpp", "src",
                                 "\nnamespace numbers {\nf(\"Hc\");\n}  // namespace numbers\nf(\"Hm\");"};
  BOOST_TEST(offences({effect}, registered()).size() == 1);
}

BOOST_AUTO_TEST_CASE(a_number_is_declared_once) {
  const Names known = registered();
  BOOST_TEST_MESSAGE(known.names.size() << " names and " << known.labels.size() << " labels in the registry");
  BOOST_TEST(known.names.size() > 100);
  for (const std::string& offence : offences(house::read_sources(root, "src"), known)) BOOST_ERROR(offence);
}

// A new number is one record: its name is written once in all of src, in the record or, where other parts ask for it,
// in names.hpp, and once in each record whose error bar or symbol it is. All that shows numbers takes them from there.
BOOST_AUTO_TEST_CASE(a_name_is_written_once) {
  std::map<std::string, int> written, records;
  for (const house::SourceFile& file : house::read_sources(root, "src"))
    for (const Literal& literal : literals_of(file.text)) ++written[literal.text];
  for (const numbers::Group& group : numbers::registry())
    for (const numbers::Number& one : group.numbers)
      for (const std::string& name : {one.error, one.in_si.symbol}) ++records[name];
  const std::set<std::string> words = words_of_decks();
  int names = 0;
  for (const std::string& name : registered().names) {
    if (words.contains(name) || other_things().contains(name)) continue;
    BOOST_TEST(written[name] <= 1 + records[name], "\"" << name << "\" is written " << written[name] << " times");
    ++names;
  }
  BOOST_TEST_MESSAGE(names << " names are written once");
}

// A word that no number has, or that decks have anyhow, needs no exception.
BOOST_AUTO_TEST_CASE(every_exception_is_needed) {
  const std::set<std::string> names = registered().names, words = words_of_decks();
  for (const auto& [word, why] : other_things())
    BOOST_TEST((names.contains(word) && !words.contains(word)), word << ": " << why);
}

// In a group a name stands once; the conditions of a name that stands twice exclude each other.
BOOST_AUTO_TEST_CASE(names_are_unambiguous) {
  for (const numbers::Group& group : numbers::registry()) {
    std::map<std::string, int> count;
    for (const numbers::Number& one : group.numbers) {
      ++count[one.name];
      BOOST_TEST(!one.name.empty());
      BOOST_TEST(!one.meaning.empty(), one.name);
      BOOST_TEST((one.page.place == 0 || !one.label.empty()), one.name << " is on the page without a label");
      if (!one.error.empty()) BOOST_TEST(!numbers::error_path_of(one.name).empty(), one.name);
      BOOST_TEST((count[one.name] == 1 || one.only_if), group.name << ": " << one.name);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
