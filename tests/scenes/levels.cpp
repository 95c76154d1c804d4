// The program with the numerics of every x86-64 level that this processor supports: the best level is chosen by
// default, and the films of all levels agree to rounding.
#include <gnu/libc-version.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <vector>

#include "support/json.hpp"
#include "support/program.hpp"

namespace {

namespace files = std::filesystem;

struct Level {
  std::string name;
  bool runs;
  std::string folder;  ///< folder of the library, below lib/
};

std::vector<Level> levels() {
  const std::string hwcaps = "glibc-hwcaps/";
  return {{"x86-64", true, ""},
          {"x86-64-v3", __builtin_cpu_supports("x86-64-v3") != 0, hwcaps + "x86-64-v3"},
          {"x86-64-v4", __builtin_cpu_supports("x86-64-v4") != 0, hwcaps + "x86-64-v4"}};
}

/// Copies the program and its libraries to another folder, without the libraries above `highest`.
void move_program(const files::path& to, std::size_t highest) {
  const files::path from = files::path(EHL_PROGRAM).parent_path();
  files::create_directories(to);
  files::copy(EHL_PROGRAM, to / "ehl");
  for (std::size_t k = 0; k <= highest; ++k) {
    const files::path library = files::path("lib") / levels()[k].folder / "libehl_solver.so";
    files::create_directories((to / library).parent_path());
    files::copy(from / library, to / library);
  }
}

double member(const std::string& json, const std::string& name) {
  const double value = support::number_at(support::parsed(json), "/" + name);
  BOOST_REQUIRE_MESSAGE(std::isfinite(value), name << " is missing in\n" << json);
  return value;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_levels)

// The levels differ in fused multiply-add and in the order of sums. The bound is that of rounding errors, 1e-16,
// multiplied by the condition of the problem. Before glibc 2.33 the loader did not know levels.
BOOST_AUTO_TEST_CASE(the_best_is_taken_and_all_agree) {
  BOOST_TEST_MESSAGE("loader of glibc " << gnu_get_libc_version());
  constexpr double tolerance = 1e-12;
  const support::TemporaryFolder folder;
  folder.write("d.ini",
               "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\nz = 0.68\n[domain]\nx_inlet = -4.5\ny_half = "
               "3\n[grid]\ncells = 64\n[multigrid]\ntolerance = 1e-10\n");
  std::string first;
  int seen = 0;
  for (std::size_t k = 0; k < levels().size(); ++k) {
    const Level level = levels()[k];
    if (!level.runs) {
      BOOST_TEST_MESSAGE(level.name << ": not on this processor");
      continue;
    }
    move_program(folder / level.name, k);
    files::create_symlink(level.name + "/ehl", folder / ("ehl_" + level.name));
    const support::Ended ended =
        support::shell(folder, "./ehl_" + level.name + " run d.ini --json --output " + level.name + ".h5");
    BOOST_REQUIRE_MESSAGE(ended.status == 0, level.name << ": " << ended.err);
    BOOST_TEST((ended.out.find("\"cpu_level\":\"" + level.name + "\"") != std::string::npos),
               level.name << " is not what was loaded:\n"
                          << ended.out);
    if (first.empty()) first = ended.out;
    for (const char* name : {"Hc", "Hm", "H00", "P_max"}) {
      const double value = member(ended.out, name);
      const double difference = std::abs(value / member(first, name) - 1.0);
      BOOST_TEST_MESSAGE(level.name << ": " << name << " " << value << ", off the lowest level by " << difference
                                    << " (" << tolerance << ")");
      BOOST_TEST(difference < tolerance);
    }
    ++seen;
  }
  BOOST_TEST(seen >= 1);
}

// Decks of every kind converge on every level and differ only by amplified rounding. A dry contact may differ by the
// tolerance of its conjugate gradients.
BOOST_AUTO_TEST_CASE(every_kind_of_deck_on_every_level) {
  struct Deck {
    std::string name, options;
    double tolerance;
  };
  constexpr double rounding = 1e-10, stopped = 1e-7;
  const Deck decks[] = {{"venner1992_M50_L10", "--set grid.cells=128", rounding},
                        {"line/M20_L5", "", rounding},
                        {"thermal/line", "--set grid.cells=128", rounding},
                        {"thermal/traction_curve", "--set grid.cells=64", rounding},
                        {"thermal/starved", "--set grid.cells=64", rounding},
                        {"starved/M50_L10", "--set grid.cells=64", rounding},
                        {"line/starved", "", rounding},
                        {"transient/load_step", "--set grid.cells=32 --set transient.end_time=0.5", rounding},
                        {"friction/traction_eyring", "--set grid.cells=64", rounding},
                        {"elliptic/oblique_M100_L10", "--set grid.cells=64", rounding},
                        {"subsurface/dry_friction", "--set grid.cells=64", stopped}};
  const support::TemporaryFolder folder;
  for (std::size_t k = 0; k < levels().size(); ++k)
    if (levels()[k].runs) move_program(folder / levels()[k].name, k);
  for (const Deck& deck : decks) {
    std::string first;
    for (const Level& level : levels()) {
      if (!level.runs) continue;
      const support::Ended ended =
          support::shell(folder, level.name + "/ehl run '" + EHL_INPUTS + "/" + deck.name + ".ini' " + deck.options +
                                     " --json --quiet --threads 1 --overwrite --output r.h5");
      BOOST_TEST(ended.status == 0,
                 deck.name << " for " << level.name << " ends with " << ended.status << ": " << ended.err);
      if (ended.status != 0) continue;
      if (first.empty()) first = ended.out;
      const char* const name = first.find("\"Hc\"") != std::string::npos ? "Hc" : "P_max";
      const double difference = std::abs(member(ended.out, name) / member(first, name) - 1.0);
      BOOST_TEST_MESSAGE(deck.name << " for " << level.name << ": " << name << " off the lowest level by " << difference
                                   << " (" << deck.tolerance << ")");
      BOOST_TEST(difference < deck.tolerance);
    }
  }
}

// The program in the build folder takes the level of its tests.
BOOST_AUTO_TEST_CASE(the_built_program_takes_the_best) {
  const support::TemporaryFolder folder;
  std::string best;
  for (const Level& level : levels())
    if (level.runs) best = level.name;
  const support::Ended ended = support::ehl(folder, "version");
  BOOST_TEST(ended.out.ends_with(", for " + best + "\n"), ended.out << " should end with " << best);
}

BOOST_AUTO_TEST_SUITE_END()
