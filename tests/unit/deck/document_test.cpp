#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "core/errors.hpp"
#include "small_catalogue.hpp"
#include "support/text.hpp"

using namespace ehl;
namespace files = std::filesystem;

namespace {

struct Folder {
  files::path path = files::temp_directory_path() / ("ehl_deck_test_" + std::to_string(::getpid()));
  Folder() { files::create_directories(path); }
  ~Folder() { files::remove_all(path); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
    return path / name;
  }
};

std::string refusal(const std::string& path) {
  return support::refusal<core::InputError>([&] { deck::load_text(path); });
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_deck_document)

// The lines in the text below are counted by hand.
BOOST_AUTO_TEST_CASE(every_assignment_knows_its_line) {
  const std::string text =
      "# a comment\n"
      "; another\n"
      "[body]   # heading\n"
      "\n"
      "  load =  15   # newton\r\n"
      "title = a = b\n"
      "[ mesh ]\n"
      "cells=32\n"
      "strange = 1\n"
      "empty =\n";
  const deck::Document document = deck::parse(text, "d.ini");
  BOOST_TEST(document.errors.empty());
  BOOST_REQUIRE(document.headings.size() == 2u);
  BOOST_TEST(document.headings[1].section == "mesh");
  BOOST_TEST(document.headings[1].place == "d.ini:7");
  const std::vector<deck::Assignment> expected{{"body", "load", "15", "d.ini:5"},
                                               {"body", "title", "a = b", "d.ini:6"},
                                               {"mesh", "cells", "32", "d.ini:8"},
                                               {"mesh", "strange", "1", "d.ini:9"},
                                               {"mesh", "empty", "", "d.ini:10"}};
  BOOST_REQUIRE(document.assignments.size() == expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    BOOST_TEST(document.assignments[k].section == expected[k].section);
    BOOST_TEST(document.assignments[k].name == expected[k].name);
    BOOST_TEST(document.assignments[k].value == expected[k].value);
    BOOST_TEST(document.assignments[k].place == expected[k].place);
  }
}

BOOST_AUTO_TEST_CASE(broken_lines_are_all_listed_and_the_rest_is_read) {
  const deck::Document document = deck::parse("[body\nload 15\n= 3\n[]\n[mesh] cells = 3\n[law]\nz = 0.5\n", "d.ini");
  BOOST_TEST(document.errors.size() == 5u);
  for (std::size_t k = 0; k < document.errors.size(); ++k)
    BOOST_TEST(document.errors[k].starts_with("d.ini:" + std::to_string(k + 1) + ": "));
  BOOST_REQUIRE(document.assignments.size() == 1u);
  BOOST_TEST(document.assignments[0].place == "d.ini:7");
}

BOOST_AUTO_TEST_CASE(of_many_broken_lines_some_are_listed_and_all_counted) {
  std::string text;
  for (int k = 0; k < 500; ++k) text += "some other file\x1b\n";
  const deck::Document document = deck::parse(text, "d.ini");
  BOOST_TEST(document.errors.size() == 21u);
  BOOST_TEST(document.errors.front().find("'some other file\\x1b'") != std::string::npos);
  BOOST_TEST(document.errors.back() == "d.ini: 480 more lines cannot be read: is this a deck?");
}

BOOST_AUTO_TEST_CASE(a_title_may_be_anything) {
  const deck::Document document = deck::parse("[body]\ntitle = [50, 10] \"quoted\" 100 % \xCE\xB1\n", "d");
  BOOST_REQUIRE(document.assignments.size() == 1u);
  BOOST_TEST(document.assignments[0].value == "[50, 10] \"quoted\" 100 % \xCE\xB1");
}

BOOST_AUTO_TEST_CASE(overrides) {
  const deck::Assignment given = deck::parse_override("body.load = 3");
  BOOST_TEST(given.section == "body");
  BOOST_TEST(given.name == "load");
  BOOST_TEST(given.value == "3");
  BOOST_TEST(given.place == "command line");
  for (const char* text : {"load=3", "body.load", "=3", ".load=3", "body.=3", ""})
    BOOST_CHECK_THROW(deck::parse_override(text), core::InputError);
}

BOOST_AUTO_TEST_CASE(files_that_are_no_decks) {
  const Folder folder;
  BOOST_TEST(refusal(folder.path / "missing.ini").find("no such file") != std::string::npos);
  BOOST_TEST(refusal(folder.path).find("directory") != std::string::npos);
  BOOST_TEST(refusal(folder.write("empty.ini", "")).find("empty") != std::string::npos);
  BOOST_TEST(refusal(folder.write("blank.ini", " \n\t\n")).find("empty") != std::string::npos);
  BOOST_TEST(refusal(folder.write("binary.ini", std::string("\x89HDF\0\0", 6))).find("not a text") !=
             std::string::npos);
  BOOST_TEST(refusal("/dev/zero").find("larger than a megabyte") != std::string::npos);
  const std::string locked = folder.write("locked.ini", "[body]\n");
  files::permissions(locked, files::perms::none);
  if (::geteuid() != 0) BOOST_TEST(refusal(locked).find("cannot be read") != std::string::npos);
  BOOST_TEST(deck::load_text(folder.write("mark.ini", "\xEF\xBB\xBF[body]\n")) == "[body]\n");
}

BOOST_AUTO_TEST_SUITE_END()
