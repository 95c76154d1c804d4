#include "commands/arguments.hpp"

#include <boost/test/unit_test.hpp>

#include "core/errors.hpp"

using namespace ehl;
using program::Arguments;

namespace {

Arguments parse(const std::vector<std::string>& words) {
  return program::parse_arguments(words, program::command_records());
}

std::string refusal(const std::vector<std::string>& words) {
  try {
    parse(words);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "(none)";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_SUITE(arguments)

BOOST_AUTO_TEST_CASE(options_and_operands) {
  const Arguments given = parse({"run", "--set", "a.b=1", "d.ini", "--set=c.d=-2", "--threads", "2", "--json"});
  BOOST_TEST(given.command == "run");
  BOOST_TEST((given.operands == std::vector<std::string>{"d.ini"}));
  BOOST_TEST((given.values("set") == std::vector<std::string>{"a.b=1", "c.d=-2"}));
  BOOST_TEST(given.value("threads", "") == "2");
  BOOST_TEST(given.has("json"));
  BOOST_TEST(!given.has("quiet"));
  BOOST_TEST(given.value("output", "none") == "none");
}

BOOST_AUTO_TEST_CASE(values_may_look_like_options) {
  const Arguments given = parse({"extract", "r.h5", "P", "--at", "-0.5"});
  BOOST_TEST(given.value("at", "") == "-0.5");
  BOOST_TEST((parse({"check", "--", "--odd.ini"}).operands == std::vector<std::string>{"--odd.ini"}));
}

BOOST_AUTO_TEST_CASE(slips) {
  BOOST_TEST(contains(refusal({}), "a command is missing"));
  BOOST_TEST(contains(refusal({"plto", "r.h5"}), "did you mean plot?"));
  BOOST_TEST(contains(refusal({"run", "d", "--sett", "x"}), "did you mean --set?"));
  BOOST_TEST(contains(refusal({"run", "d", "-x"}), "no option --x"));
  BOOST_TEST(contains(refusal({"run", "d", "--json", "--json"}), "given twice"));
  BOOST_TEST(contains(refusal({"run", "d", "--threads"}), "value is missing"));
  BOOST_TEST(contains(refusal({"extract", "r.h5"}), "DATASET is missing"));
}

// Commands that do not work yet are not in the help; those that work are.
BOOST_AUTO_TEST_CASE(the_help_names_what_works) {
  const std::string help = program::help(program::command_records(), "");
  for (const char* command : {"run", "check", "resume", "sweep", "study", "extract", "plot", "keys"})
    BOOST_TEST(contains(help, std::string("ehl ") + command), command);
}

BOOST_AUTO_TEST_SUITE_END()
