// Sweeps in many jobs: keys varied together, cases from a file, shards, and the merged table.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <numeric>

#include "case/catalogue.hpp"
#include "case/numbers/number.hpp"
#include "deck/deck.hpp"
#include "support/temporary_folder.hpp"
#include "support/text.hpp"
#include "tables/csv.hpp"
#include "tables/shard.hpp"
#include "tables/sweep_data.hpp"
#include "tables/sweep_merge.hpp"
#include "tables/sweep_table.hpp"

using namespace ehl;
using Texts = std::vector<std::string>;

namespace {

using support::contains;
using support::refusal;

std::vector<std::size_t> first(std::size_t count) {
  std::vector<std::size_t> cases(count);
  std::iota(cases.begin(), cases.end(), std::size_t{0});
  return cases;
}

program::SweepColumns plain() {
  const char* deck = "[contact]\nM = 20\nL = 10\n";
  return program::numbers::columns_of_sweep(deck::read_text(deck, "d.ini", {}, program::catalogue()), false);
}

program::SweepHeader header_of(const Texts& vary) {
  return {"ehl 1, commit x",
          "d.ini",
          "[contact]\n",
          {},
          program::parse_variations(vary, {}, program::catalogue()),
          plain()};
}

std::string row(const std::string& status) {
  return program::csv_row(program::row_without_solution(program::sweep_row(plain()), status, 0, ""));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_campaign)

// Older tables, in which one name had three meanings, are read with the present names.
BOOST_AUTO_TEST_CASE(older_tables_are_read) {
  const support::TemporaryFolder folder;
  const auto columns = [&](const std::string& text) {
    const std::string path = folder.write("t.csv", text);
    return program::read_table(path, program::mark_of(path)).columns;
  };
  BOOST_TEST(
      columns("# ehl sweep, table 1\ncontact.M,status,error_Hc\n") == (Texts{"contact.M", "status", "mesh_error_Hc"}),
      boost::test_tools::per_element());
  BOOST_TEST(columns("# ehl sweep, table 2\ncontact.M,status,error_Hc\n") == (Texts{"contact.M", "status", "error_Hc"}),
             boost::test_tools::per_element());
  BOOST_TEST(columns("# ehl study, table 1\nstatus,error_Hc,estimate_Hc\n") ==
                 (Texts{"status", "deviation_Hc", "estimate_Hc"}),
             boost::test_tools::per_element());
  BOOST_TEST(columns("# ehl study in time, table 1\nstatus,error_P_1\n") == (Texts{"status", "deviation_P_1"}),
             boost::test_tools::per_element());
}

// In a large sweep not every case is estimated in every job, but the parts still take nearly the same time.
BOOST_AUTO_TEST_CASE(parts_of_many_cases) {
  const std::vector<std::size_t> values{20, 50, 40};
  const auto cost = [](std::size_t k) {
    const double cells = static_cast<double>(1 << (k / 2000 % 5)), load = static_cast<double>(k / 40 % 50);
    return 0.01 * cells * cells * (1.0 + 0.1 * load) * (k % 40 < 4 ? 3.0 : 1.0);
  };
  std::size_t estimates = 0;
  const std::vector<double> seconds = program::foreseen_seconds(values, [&](std::size_t k) {
    ++estimates;
    return cost(k);
  });
  BOOST_TEST_MESSAGE(estimates << " estimates for " << seconds.size() << " cases");
  BOOST_TEST((estimates <= 111 && seconds.size() == 40000));
  for (const std::size_t k : {0, 1999, 12345, 39999})
    BOOST_TEST(seconds[k] / seconds[20777] == cost(k) / cost(20777), boost::test_tools::tolerance(1e-12));
  // A table of cases is one variation with unknown costs, so its parts differ only by chance.
  std::size_t few = 0;
  const std::vector<double> equal = program::foreseen_seconds({40000}, [&](std::size_t) { return ++few, 1.0; });
  BOOST_TEST(few <= 1);
  constexpr int parts = 50;
  for (const auto& [planned, allowed] : {std::pair(seconds, 1.01), std::pair(equal, 1.3)}) {
    double whole = 0.0, most = 0.0;
    std::vector<int> found(planned.size(), 0);
    for (int index = 1; index <= parts; ++index) {
      double load = 0.0;
      for (const std::size_t k : program::cases_of_shard(planned, {index, parts})) {
        load += cost(k);
        ++found[k];
      }
      whole += load;
      most = std::max(most, load);
    }
    BOOST_TEST_MESSAGE("the longest part takes " << most * parts / whole << " of the mean");
    BOOST_TEST(most * parts / whole < allowed);
    BOOST_TEST(std::ranges::all_of(found, [](int count) { return count == 1; }));
  }
}

BOOST_AUTO_TEST_CASE(keys_change_together) {
  const auto together =
      program::parse_variations({"contact.M,contact.L=5:1,20:2", "grid.cells=64,128"}, {}, program::catalogue());
  BOOST_TEST(program::number_of_cases(together) == 4u);
  BOOST_TEST(program::overrides_of_case(together, 1) == (Texts{"contact.M=5", "contact.L=1", "grid.cells=128"}),
             boost::test_tools::per_element());
  BOOST_TEST(program::overrides_of_case(together, 2) == (Texts{"contact.M=20", "contact.L=2", "grid.cells=64"}),
             boost::test_tools::per_element());
  const support::TemporaryFolder folder;
  folder.write("c.csv", "# of a bearing\ncontact.M, contact.L\r\n5,1\r\n20,2\n\n");
  const auto read = program::parse_variations({"grid.cells=64,128"}, {}, program::catalogue(), folder / "c.csv");
  for (std::size_t k = 0; k < 4; ++k)
    BOOST_TEST(program::overrides_of_case(read, k) == program::overrides_of_case(together, k),
               boost::test_tools::per_element());
  const auto said = [&](const std::string& text) {
    folder.write("w.csv", text);
    return refusal([&] { program::read_cases(folder / "w.csv", program::catalogue()); });
  };
  // Formats of spreadsheets, R and Python.
  for (const char* text : {"\"contact.M\",\"contact.L\"\n5,1\n20,2\n", "contact.M;contact.L\n5,0;1,0\n20,0;2,0\n"}) {
    folder.write("q.csv", text);
    const auto quoted = program::parse_variations({}, {}, program::catalogue(), folder / "q.csv");
    BOOST_TEST(program::number_of_cases(quoted) == 2u, text);
    BOOST_TEST(program::varied_keys(quoted) == (Texts{"contact.M", "contact.L"}), boost::test_tools::per_element());
  }
  folder.write("q.csv", "contact.load [kN],motion.u_m [mm/s]\n0.02,100\n");
  BOOST_TEST(program::values_of_case(program::parse_variations({}, {}, program::catalogue(), folder / "q.csv"), 0) ==
                 (Texts{"20", "0.1"}),
             boost::test_tools::per_element());
  // A table with an unknown heading must be refused, and not be ignored.
  const auto refused = [&](const std::string& heading) {
    folder.write("w.csv", heading + "\n5,1\n");
    return refusal([&] { program::parse_variations({}, {}, program::catalogue(), folder / "w.csv"); });
  };
  BOOST_TEST(contains(refused("contct.M,contact.L"), "w.csv:1: [contct] M = ..."));
  BOOST_TEST(contains(refused("Contact.M,contact.L"), "w.csv:1: "));
  BOOST_TEST(contains(refused("contact.M,contact.L [m]"), "contact.L: the unit 'm'"));
  BOOST_TEST(contains(said("contact.M,contact.LL\n5,1\n"), "[contact] LL"));
  BOOST_TEST(contains(refused("contact.L,contact.L"), "w.csv:1: contact.L: "));
  BOOST_TEST(contains(refused("load,contact.L"), "w.csv:1: load: "));
  BOOST_TEST(contains(said("contact.M,contact.L\n5,1\n5\n"), "w.csv:3: 1 values"));
  BOOST_TEST(contains(said("contact.M,contact.L\n5,-1\n"), "L = -1"));
  BOOST_TEST(contains(said("contact.M,contact.L\n5,1\n5,1\n"), "5:1"));
  BOOST_TEST(contains(said("contact.M\n"), "w.csv"));
  BOOST_TEST(
      contains(refusal([] { program::parse_variation("contact.M,contact.L=5:1,20", program::catalogue()); }), "'20'"));
}

// Every case is in exactly one shard, and all shards have nearly the same work.
BOOST_AUTO_TEST_CASE(shards) {
  std::vector<double> seconds;
  for (int k = 0; k < 77; ++k) seconds.push_back(0.1 + (k * 37 % 77));
  std::vector<int> times(seconds.size(), 0);
  std::vector<double> loads;
  for (int index = 1; index <= 10; ++index) {
    const std::vector<std::size_t> own = program::cases_of_shard(seconds, {index, 10});
    BOOST_TEST(std::ranges::is_sorted(own));
    loads.push_back(0.0);
    for (const std::size_t one : own) {
      ++times[one];
      loads.back() += seconds[one];
    }
  }
  BOOST_TEST((std::ranges::count(times, 1) == 77));
  const auto [least, most] = std::ranges::minmax(loads);
  BOOST_TEST_MESSAGE("loads from " << least << " to " << most);
  BOOST_TEST(most < 1.02 * least);
  BOOST_TEST(program::name_of_shard("a/t.csv", {3, 10}) == "a/t.3of10.csv");
  BOOST_TEST(program::parse_shard("3/10").index == 3);
  for (const char* wrong : {"0/10", "11/10", "3", "3/", "x/10", "3/10 ", "-1/2"})
    BOOST_TEST(contains(refusal([&] { program::parse_shard(wrong); }), "--shard"), wrong);
}

// Shards computed in any order, one of them twice because a process died, give the same bytes as one run; a table can
// be extended by more values.
BOOST_AUTO_TEST_CASE(shards_become_one_table) {
  const support::TemporaryFolder folder;
  const Texts vary{"contact.M=5,20", "contact.L=1,2,3"};
  const auto fill = [&](program::SweepTable& table, const std::vector<std::size_t>& cases) {
    for (const std::size_t one : cases) table.append(one, row(one % 2 == 0 ? "converged" : "not-converged"));
  };
  {
    program::SweepTable whole(folder / "one.csv", header_of(vary), first(6), false);
    fill(whole, first(6));
    whole.finish();
  }
  Texts paths;
  for (int index = 1; index <= 2; ++index) {
    program::SweepHeader header = header_of(vary);
    header.shard = {index, 2};
    const auto own = program::cases_of_shard({1, 1, 1, 1, 1, 1}, header.shard);
    paths.push_back(program::name_of_shard(folder / "t.csv", header.shard));
    program::SweepTable table(paths.back(), header, own, false);
    BOOST_TEST(table.missing() == own, boost::test_tools::per_element());
    table.append(own[2], row("failed"));
    fill(table, {own[2], own[1]});
    if (index == 1) fill(table, {own[0]});
  }
  program::MergedSweep merged = program::merged_sweep({paths[1], paths[0]});
  BOOST_TEST((merged.missing == std::vector<std::size_t>{1}));
  folder.write("part.csv", merged.text);
  {
    program::SweepTable goes_on(folder / "part.csv", header_of(vary), first(6), false);
    BOOST_TEST((goes_on.missing() == std::vector<std::size_t>{1}));
  }
  {
    program::SweepHeader header = header_of(vary);
    header.shard = {2, 2};
    program::SweepTable table(paths[1], header, {1, 3, 5}, false);
    fill(table, {1});
  }
  merged = program::merged_sweep(paths);
  BOOST_TEST((merged.missing.empty() && merged.converged == 3u));
  BOOST_TEST(merged.text == folder.read("one.csv"));
  const auto refused = [&](const Texts& tables, const std::string& part) {
    const std::string said = refusal([&] { program::merged_sweep(tables); });
    BOOST_TEST(contains(said, part), said);
  };
  refused({paths[0], folder / "one.csv"}, "one.csv");
  folder.write("again.csv", folder.read("t.1of2.csv"));
  refused({paths[0], folder / "again.csv"}, "case 4 ");
  folder.write("other.csv", std::string(folder.read("t.2of2.csv"))
                                .replace(0, 0, "")
                                .insert(folder.read("t.2of2.csv").find("# vary"), "# set: grid.cells=64\n"));
  refused({paths[0], folder / "other.csv"}, "other.csv");
  folder.write("damaged.csv", folder.read("t.2of2.csv") + "3,5\n");
  refused({paths[0], folder / "damaged.csv"}, "3,5");

  program::SweepTable more(folder / "one.csv", header_of({"contact.M=5,20", "contact.L=1,2,3,4"}), first(8), false);
  BOOST_TEST((more.missing() == std::vector<std::size_t>{3, 7}));
}

BOOST_AUTO_TEST_SUITE_END()
