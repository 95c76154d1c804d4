// The variations of a sweep, the text of its rows, the heading of its table, and its child
// processes; nothing is solved.
#include <signal.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <new>
#include <numeric>

#include "case/catalogue.hpp"
#include "case/numbers/number.hpp"
#include "core/errors.hpp"
#include "deck/deck.hpp"
#include "report/outcome.hpp"
#include "support/temporary_folder.hpp"
#include "support/text.hpp"
#include "tables/children.hpp"
#include "tables/csv.hpp"
#include "tables/sweep_range.hpp"
#include "tables/sweep_row.hpp"
#include "tables/sweep_table.hpp"

using namespace ehl;
using Texts = std::vector<std::string>;

namespace {

using support::contains;
using support::refusal;

Texts values(const std::string& text) {
  Texts values;
  for (const Texts& one : program::parse_variation(text, program::catalogue()).values) values.push_back(one.at(0));
  return values;
}

std::vector<std::size_t> first(std::size_t count) {
  std::vector<std::size_t> cases(count);
  std::iota(cases.begin(), cases.end(), std::size_t{0});
  return cases;
}

program::SweepColumns plain() {
  const char* deck = "[contact]\nM = 20\nL = 10\n";
  return program::numbers::columns_of_sweep(deck::read_text(deck, "d.ini", {}, program::catalogue()), false);
}

program::SweepHeader header_of(const Texts& vary, const std::string& deck_text = "[contact]\n") {
  return {
      "ehl 1, commit x", "d.ini", deck_text, {}, program::parse_variations(vary, {}, program::catalogue()), plain()};
}

std::string row(const std::string& status) {
  return program::csv_row(program::row_without_solution(program::sweep_row(plain()), status, 0, ""));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_sweep)

BOOST_AUTO_TEST_CASE(lists) {
  BOOST_TEST(values("contact.M=2,5, 1e1") == (Texts{"2", "5", "1e1"}), boost::test_tools::per_element());
  BOOST_TEST(values("contact.M=2:10:5") == (Texts{"2", "4", "6", "8", "10"}), boost::test_tools::per_element());
  BOOST_TEST(values("contact.L=0:0.3:4") == (Texts{"0", "0.1", "0.2", "0.3"}), boost::test_tools::per_element());
  BOOST_TEST(values("contact.M=2:2000:4:log") == (Texts{"2", "20", "200", "2000"}), boost::test_tools::per_element());
  BOOST_TEST(values("contact.M=1000:10:3:log,5") == (Texts{"1000", "100", "10", "5"}),
             boost::test_tools::per_element());
  BOOST_TEST(values("grid.cells=64:1024:5:log") == (Texts{"64", "128", "256", "512", "1024"}),
             boost::test_tools::per_element());
  BOOST_TEST(values("discretization.wedge=upstream1,upstream2") == (Texts{"upstream1", "upstream2"}),
             boost::test_tools::per_element());
  // sqrt(2 x 5) in twelve digits.
  BOOST_TEST(std::abs(std::stod(values("contact.M=2:5:3:log")[1]) - std::sqrt(10.0)) < 1e-11);
}

BOOST_AUTO_TEST_CASE(wrong_lists) {
  struct Slip {
    std::string text;
    Texts parts;
  };
  for (const Slip& slip : std::vector<Slip>{
           {"contact.M", {"--vary contact.M"}},
           {"M=2", {"--vary M=2"}},
           {"contact.MM=2", {"[contact] MM"}},
           {"gird.cells=64", {"[gird]"}},
           {"contact.M=", {"[contact] M"}},
           {"contact.M=2,,5", {"[contact] M"}},
           {"contact.M=2,two", {"M = two"}},
           {"contact.M=20,-5", {"M = -5"}},
           {"contact.M=2:5", {"a:b:n"}},
           {"contact.M=2:5:1", {"n = 1"}},
           {"contact.M=2:5:2.5", {"n = 2.5"}},
           {"contact.M=2:5:3:lg", {"'lg'"}},
           {"contact.M=2:x:3", {"'x'"}},
           {"contact.M=2:2:3", {"--vary contact.M=2:2:3"}},
           {"contact.L=0:5:3:log", {"--vary contact.L=0:5:3:log"}},
           {"grid.cells=64:101:3:log", {"cells = 80.39"}},
           {"contact.M=5,5", {"contact.M=5,5"}},
           {"discretization.wedge=upstrem1", {"upstrem1", "upstream1, upstream2"}},
           {"case.title=a#b", {"case.title"}},
           {"output.file=a,b", {"[output]"}},
       }) {
    const std::string said = refusal([&] { values(slip.text); });
    for (const std::string& part : slip.parts) BOOST_TEST(contains(said, part), slip.text << " says\n" << said);
  }
  const auto all = [](const Texts& vary, const Texts& set) {
    return refusal([&] { program::parse_variations(vary, set, program::catalogue()); });
  };
  BOOST_TEST(contains(all({"contact.M=2", "contact.M=3"}, {}), "contact.M"));
  BOOST_TEST(contains(all({"contact.M=2"}, {"contact.M=3"}), "contact.M"));
  BOOST_TEST(contains(all({"contact.M=1:2:2000", "contact.L=1:2:2000"}, {}), "4000000"));
  const std::string two = all({"contact.MM=2", "contact.LL=3"}, {});
  BOOST_TEST((contains(two, "MM") && contains(two, "LL")), two);
}

BOOST_AUTO_TEST_CASE(the_first_varies_slowest) {
  const auto variations = program::parse_variations({"contact.M=5,20", "contact.L=1,2,3"}, {}, program::catalogue());
  BOOST_TEST(program::number_of_cases(variations) == 6u);
  Texts cases;
  for (std::size_t k = 0; k < 6; ++k) {
    const Texts one = program::overrides_of_case(variations, k);
    cases.push_back(one[0] + " " + one[1]);
  }
  BOOST_TEST(cases[0] == "contact.M=5 contact.L=1");
  BOOST_TEST(cases[1] == "contact.M=5 contact.L=2");
  BOOST_TEST(cases[3] == "contact.M=20 contact.L=1");
  BOOST_TEST(cases[5] == "contact.M=20 contact.L=3");
}

// A number that did not converge must not look as if it had.
BOOST_AUTO_TEST_CASE(rows) {
  program::Case input;
  input.physics.groups = contact::from_moes(20.0, 10.0);
  steady::Solution solution;
  solution.grid = {4, 2, -2.0, 2.0, -1.0, 1.0};
  solution.P = core::Field(solution.grid);
  solution.H = core::Field(solution.grid);
  solution.H.fill(0.25);
  steady::LevelRow finest;
  finest.nx = 4;
  finest.ny = 2;
  finest.Hc = 0.4;
  finest.Hm = 0.25;
  finest.residual = 3e-4;
  finest.load_error = 2e-6;
  finest.cycles = 7;
  finest.work_units = 11.2;
  solution.levels = {finest};
  solution.error_bars.Hc.discretization = 0.058;
  solution.error_bars.Hm.discretization = 0.062;
  solution.error_bars.Hc.algebraic = solution.error_bars.Hm.algebraic = 0.003;
  solution.attempts = {{"full multigrid", "stalled", 0.1}, {"full multigrid, start 2", "", 0.1}};
  solution.method = "full multigrid, start 2";
  solution.converged = true;
  const auto text_in = [](program::SweepRow row, const char* name) {
    return std::get<std::string>(program::in_row(row, name));
  };
  const auto in = [](program::SweepRow row, const char* name) { return results::number(program::in_row(row, name)); };
  const auto computed_of = [&] {
    return program::Computed{.solution = solution, .outcome = program::outcome_of(input, solution)};
  };
  program::Computed computed = computed_of();
  const program::SweepRow good = program::row_of_solution(plain(), input, computed);
  BOOST_TEST((text_in(good, "status") == "converged" && in(good, "exit_status") == 0 && in(good, "Hc") == 0.4 &&
              in(good, "Hm") == 0.25));
  BOOST_TEST(
      (text_in(good, "method") == "full multigrid, start 2" && in(good, "attempts") == 2 && in(good, "cycles") == 7));
  BOOST_TEST(
      (in(good, "nx") == 4 && in(good, "ny") == 2 && in(good, "error_Hm") == 0.065 && in(good, "work_units") == 11.2));
  solution.converged = false;
  solution.failed_check = "the \"residual\",\nlevel #2";
  computed = computed_of();
  const program::SweepRow bad = program::row_of_solution(plain(), input, computed);
  BOOST_TEST((text_in(bad, "status") == "not-converged" && in(bad, "exit_status") == 3 && in(bad, "residual") == 3e-4));
  for (const char* name : {"Hc", "Hm", "P_max", "error_Hc", "error_Hm", "Hc_best", "error_Hm_best"})
    BOOST_TEST(std::isnan(in(bad, name)));

  const std::string text = program::csv_row(bad);
  BOOST_TEST(
      text.starts_with(
          "not-converged,3,full multigrid; start 2,2,20,10,NaN,4,2,NaN,NaN,NaN,NaN,NaN,NaN,NaN,NaN,NaN,3e-04,2e-06,"),
      text);
  BOOST_TEST(text.ends_with(",\"the 'residual', level  2\""), text);
  const std::string columns = program::csv_names(program::sweep_row(plain()));
  const std::string clean = program::csv_row(good);
  BOOST_TEST(std::count(columns.begin(), columns.end(), ',') == std::count(clean.begin(), clean.end(), ','));
}

BOOST_AUTO_TEST_CASE(a_table_is_continued_or_refused) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "t.csv";
  const Texts vary{"contact.M=5,20", "contact.L=1,2,3"};
  const auto open = [&](const program::SweepHeader& header) {
    program::SweepTable table(path, header, first(6), false);
  };
  {
    program::SweepTable table(path, header_of(vary), first(6), false);
    BOOST_TEST(refusal([&] { open(header_of(vary)); }) != "(none)");
    table.append(4, row("converged"));
    table.append(0, row("failed"));
    table.append(2, row("not-converged"));
  }
  BOOST_TEST(folder.read("t.csv").starts_with(program::header_text(header_of(vary))));
  const std::string whole = folder.read("t.csv");
  folder.write("t.csv", whole + "5,2,conver");  // killed while writing
  {
    program::SweepTable table(path, header_of(vary), first(6), false);
    BOOST_TEST((table.missing() == std::vector<std::size_t>{0, 1, 3, 5}));  // a process that died is tried again
    BOOST_TEST(table.count("not-converged") == 1u);
    table.append(0, row("converged"));
    table.finish();
  }
  const std::string sorted = folder.read("t.csv");
  BOOST_TEST(sorted == program::header_text(header_of(vary)) + "5,1," + row("converged") + "\n5,3," +
                           row("not-converged") + "\n20,2," + row("converged") + "\n");

  const auto refused = [&](const program::SweepHeader& header, const std::string& part) {
    const std::string said = refusal([&] { open(header); });
    BOOST_TEST((contains(said, part) && contains(said, "--overwrite")), said);
    BOOST_TEST(folder.read("t.csv").size() > 4);
  };
  const auto narrower = [&] {
    program::SweepTable table(path, header_of({"contact.M=5,20", "contact.L=1,2"}), first(4), false);
  };
  BOOST_TEST(contains(refusal(narrower), "vary: contact.L = 1,2,3"));
  refused(header_of(vary, "[contact]\n# another text\n"), "t.csv");
  refused(header_of(vary, "[lubrict]\n"), "t.csv");  // of the same length as the other text
  program::SweepHeader with_set = header_of(vary);
  with_set.set = {"grid.cells=64"};
  refused(with_set, "set: grid.cells=64");
  folder.write("t.csv", sorted + "6,1," + row("converged") + "\n");
  refused(header_of(vary), "6,1");
  folder.write("t.csv", sorted + "5,2,converged,0\n");
  refused(header_of(vary), "5,2");
  folder.write("t.csv", "x,y\n1,2\n");
  refused(header_of(vary), "t.csv");
  program::SweepTable(path, header_of(vary), first(6), true);
  BOOST_TEST(folder.read("t.csv") == program::header_text(header_of(vary)));
}

// A child that throws, crashes, is killed or exits is one result; the other children are not affected.
BOOST_AUTO_TEST_CASE(children_end_alone) {
  std::map<std::size_t, program::ChildEnd> ends;
  program::ChildrenCalls calls;
  calls.stop = [] { return false; };
  calls.ended = [&](const program::ChildEnd& end) { ends[end.task] = end; };
  calls.task = [](std::size_t task, const program::Say&) -> std::string {
    if (task == 1) throw std::runtime_error("thrown");
    if (task == 2) ::raise(SIGKILL);
    if (task == 3) ::_exit(0);
    if (task == 4) throw std::bad_alloc();
    return task == 5 ? std::string(300000, 'x') : "task " + std::to_string(task);
  };
  BOOST_TEST(program::run_in_children({0, 1, 2, 3, 4, 5, 6}, 2, calls));
  BOOST_REQUIRE(ends.size() == 7u);
  BOOST_TEST((ends[0].complete && ends[0].text == "task 0" && ends[6].complete));
  BOOST_TEST((ends[5].complete && ends[5].text.size() == 300000u));  // more than a pipe holds
  BOOST_TEST((!ends[1].complete && ends[1].status == 1 && ends[1].reason == "thrown"));
  BOOST_TEST((!ends[2].complete && ends[2].status == 128 + SIGKILL && !ends[2].reason.empty()));
  BOOST_TEST((!ends[3].complete && !ends[3].reason.empty()));
  BOOST_TEST((!ends[4].complete && contains(ends[4].reason, "memory")));
}

// The report of a child reaches its parent while the child works.
BOOST_AUTO_TEST_CASE(children_say_how_far_they_are) {
  std::string heard;
  program::ChildrenCalls calls;
  calls.stop = [&] { return heard == "task 7 is at half"; };
  calls.ended = [](const program::ChildEnd&) {};
  calls.waits = [&](const program::ChildAtWork& child) { heard = child.says; };
  calls.task = [](std::size_t task, const program::Say& say) -> std::string {
    say("task " + std::to_string(task) + " is at half");
    ::pause();
    return "";
  };
  BOOST_TEST(!program::run_in_children({7}, 1, calls));  // stopped when the report was received
}

BOOST_AUTO_TEST_CASE(children_are_stopped) {
  int ended = 0;
  program::ChildrenCalls calls;
  calls.stop = [&] { return ended == 1; };
  calls.ended = [&](const program::ChildEnd&) { ++ended; };
  calls.task = [](std::size_t task, const program::Say&) {
    while (task > 0) ::pause();
    return std::string("done");
  };
  BOOST_TEST(!program::run_in_children({0, 1, 2, 3}, 2, calls));
  BOOST_TEST(ended == 1);
}

BOOST_AUTO_TEST_SUITE_END()
