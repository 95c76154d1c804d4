#include "commands/arguments.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "commands/commands.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "support/text.hpp"

using namespace ehl;
using program::Arguments;

namespace {

Arguments parse(const std::vector<std::string>& words) { return program::parse_arguments(words, program::commands()); }

std::string refusal(const std::vector<std::string>& words) {
  return support::refusal<core::InputError>([&] { parse(words); });
}

using support::contains;

bool refused(const std::vector<std::string>& words) { return refusal(words) != "(none)"; }

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_arguments)

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
  BOOST_TEST(refused({}));
  BOOST_TEST(refused({"plto", "r.h5"}));
  BOOST_TEST(refused({"run", "d", "--sett", "x"}));
  BOOST_TEST(refused({"run", "d", "-x"}));
  BOOST_TEST(refused({"run", "d", "--json", "--json"}));
  BOOST_TEST(refused({"run", "d", "--threads"}));
  BOOST_TEST(refused({"extract"}));
}

// The help lists only commands that work.
BOOST_AUTO_TEST_CASE(the_help_names_what_works) {
  const std::string help = program::help_text(program::commands(), "");
  for (const char* command : {"run", "check", "resume", "sweep", "study", "extract", "plot", "keys"})
    BOOST_TEST(contains(help, std::string("ehl ") + command), command);
}

BOOST_AUTO_TEST_CASE(more_slips) {
  BOOST_TEST(refused({"run", "d", "--out", "x"}));  // no abbreviations
  BOOST_TEST(refused({"run", "d", "-sett=x"}));
  BOOST_TEST(refused({"run", "d", "--quiet=3"}));
  BOOST_TEST(refused({"run", "d", "--output="}));
  BOOST_TEST(refused({"run", "--json", "d", "e"}));
  for (const char* odd : {"-=x", "--=x", "---", "-=", "--="}) BOOST_TEST(refusal({"run", "d", odd}) != "(none)", odd);
}

BOOST_AUTO_TEST_CASE(values_are_taken_as_they_are) {
  const Arguments given = parse({"run", "my deck.ini", "--set", "case.title=a = b, c", "--set", "", "--output", "-x"});
  BOOST_TEST((given.operands == std::vector<std::string>{"my deck.ini"}));
  BOOST_TEST((given.values("set") == std::vector<std::string>{"case.title=a = b, c", ""}));
  BOOST_TEST(given.value("output", "") == "-x");
}

BOOST_AUTO_TEST_CASE(help_is_asked_for_anywhere) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"help", "run"}, {"run", "--help"}, {"run", "d", "--set", "x", "-h"}}) {
    const Arguments given = parse(words);
    BOOST_TEST(given.command == "help");
    BOOST_TEST((given.operands == std::vector<std::string>{"run"}));
  }
  for (const char* word : {"help", "--help", "-h"}) BOOST_TEST(parse({word}).command == "help");
  BOOST_TEST(parse({"--version"}).command == "version");
}

// Every command in the list can be called, has its own function, and appears in the help with all its options.
BOOST_AUTO_TEST_CASE(every_command_is_dispatched) {
  std::set<int (*)(const Arguments&)> functions;
  std::set<std::string> names;
  const std::string overview = program::help_text(program::commands(), "");
  for (const program::Command& command : program::commands()) {
    BOOST_TEST((command.function != nullptr), command.name);
    BOOST_TEST(functions.insert(command.function).second, command.name);
    BOOST_TEST(names.insert(command.name).second, command.name);
    std::vector<std::string> words = deck::split_words(command.operands);
    words.insert(words.begin(), command.name);
    BOOST_TEST(parse(words).command == command.name);
    BOOST_TEST((&program::find_command(program::commands(), command.name) == &command));
    BOOST_TEST(contains(overview, "\n  ehl " + command.name), command.name);
    const std::string own = program::help_text(program::commands(), command.name);
    for (const program::Option& option : command.options) BOOST_TEST(contains(own, "--" + option.name), own);
  }
}

BOOST_AUTO_TEST_SUITE_END()
