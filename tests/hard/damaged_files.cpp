// Every kind of file that a deck names or a command reads, damaged: the program reads it all the same or says what is
// wrong with it; it never crashes, hangs, or touches memory that is not its own.
//
//   test_damaged_files -- [--cases N] [--seed S]
//
// Damage k of a kind has the seed S + k.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <sstream>

#include "hard/random_deck.hpp"
#include "hard/subprocess.hpp"
#include "support/temporary_folder.hpp"
#include "support/text.hpp"

namespace {

using namespace hard;
using Words = std::vector<std::string>;

const std::string contact =
    "[contact]\nload = 20\nradius_x = 0.01\nE_prime = 2e11\n[motion]\nu_m = 1\nsrr = 2\n[grid]\ncells = 32\n";
const std::string oil = "[lubricant]\neta0 = 0.05\nalpha = 2e-8\n";
const std::string map = "[surface2]\nshape = map\nunit_m = 1e-9\ndx_m = 5e-5\nfile = ";

/// A kind of file: what makes a sound one, and what reads it.
struct Kind {
  std::string file{};
  std::string deck{};            ///< d.ini
  std::string text{};            ///< of the file; empty: the commands make it
  std::vector<Words> made_by{};  ///< each ends with 0
  std::vector<Words> read_by{};  ///< of a sound file each ends with 0
};

std::string rows(const std::string& heading, int count, const std::function<std::string(int)>& row) {
  std::string text = heading + "\n";
  for (int k = 0; k < count; ++k) text += row(k) + "\n";
  return text;
}

std::string joined(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ",") + std::to_string(number);
  return text;
}

std::vector<Kind> text_tables() {
  const Words check{"check", "d.ini"}, run{"run", "d.ini", "--quiet", "--overwrite"};
  const std::string in_time = "[transient]\nend_time = 0.01\n";
  return {
      {"oil.csv",
       contact + "[lubricant]\nviscosity = table\ndensity = table\ntable = oil.csv\n",
       rows("p [Pa], eta [Pa s], rho [kg/m^3]", 12,
            [](int k) {
              return joined({4e8 * k, 0.05 * std::exp(1.5 * k), 850.0 + 20.0 * k});
            }),
       {},
       {check, run}},
      {"load.csv",
       contact + oil + in_time + "load = load.csv\n",
       rows("time,load", 10,
            [](int k) {
              return joined({0.1 * k, 1.0 + 0.02 * k});
            }),
       {},
       {check, run}},
      {"speed.csv",
       contact + oil + in_time + "u1 = speed.csv\n",
       rows("time,u1", 10,
            [](int k) {
              return joined({0.1 * k, 1.0 - 0.02 * k});
            }),
       {},
       {check}},
      {"layer.csv",
       contact + oil + "[supply]\nprofile = layer.csv\n",
       rows("y [mm],h [nm]", 21,
            [](int k) {
              return joined({0.1 * (k - 10), 200.0 + k});
            }),
       {},
       {check, run}},
      {"profile.csv",
       "[contact]\nkind = roller\nload = 1000\nlength_m = 0.01\nradius_x = 3.5e-3\nE_prime = 2e11\n[roller]\nprofile = "
       "table\nfile = profile.csv\n[motion]\nu_m = 2\n" +
           oil,
       rows("y,z", 41,
            [](int k) {
              return joined({2.5e-4 * (k - 20), 1e-9 * (k - 20) * (k - 20) * (k - 20) * (k - 20)});
            }),
       {},
       {check}},
      {"map.csv",
       contact + oil + map + "map.csv\n",
       rows("height in nm", 16,
            [](int k) {
              return joined({1. * k, 2. - k, 3., 4., 5., 2., 1. * k, 7., 1., 2., 0., 1., 3.});
            }),
       {},
       {check, run}},
      {"cases.csv",
       contact + oil,
       "contact.load,motion.u_m\n20,1\n30,1\n20,2\n",
       {},
       {{"sweep", "d.ini", "--quiet", "--overwrite", "--cases", "cases.csv", "--output", "t.csv"}}},
      {"measured.csv",
       contact + oil + "[shear]\nlaw = eyring\ntau_0 = 5e6\n[friction]\ncavitated = full\n",
       "srr,mu,sigma\n0.1,0.02,0.001\n0.3,0.03,0.001\n",
       {},
       {{"fit", "d.ini", "--quiet", "--measured", "measured.csv", "--free", "shear.tau_0"}}},
  };
}

std::vector<Kind> own_files() {
  const Words sweep{"sweep", "d.ini", "--quiet", "--keep", "--vary", "motion.u_m=1,2,4", "--output", "t.csv"};
  const Words page{"--output", "p.html", "--overwrite"};
  const auto paged = [&](Words words) {
    words.insert(words.end(), page.begin(), page.end());
    return words;
  };
  const Words run{"run", "d.ini", "--quiet", "--output", "r.h5"};
  const std::string in_time =
      "[transient]\nend_time = 0.02\noutput_interval = 0.01\nload = 0:1 0.02:1.1\n[output]\nprobe = 0 0\n";
  return {
      {"r.h5",
       contact + oil + "[friction]\ncavitated = striated\n[subsurface]\ndepth = 1\nplanes = 3\n",
       "",
       {run},
       {{"extract", "r.h5", "P"},
        {"extract", "r.h5", "deck"},
        {"extract", "r.h5", "levels"},
        paged({"report", "r.h5"})}},
      {"r.h5",
       contact + oil + in_time +
           "[friction]\ncavitated = striated\nfields = tau1\n[subsurface]\ndepth = 1\nplanes = 3\n",
       "",
       {run},
       {{"extract", "r.h5", "history"},
        {"extract", "r.h5", "/stresses_in_time/sigma_mises", "--step", "1"},
        {"extract", "r.h5", "/history_1/section_range_tau_xz"},
        paged({"report", "r.h5"})}},
      {"r.h5",
       contact + oil + map + "r.h5\ndataset = fields/P\n",
       "",
       {{"run", "d.ini", "--quiet", "--output", "r.h5", "--unset", "surface2.shape", "--unset", "surface2.unit_m",
         "--unset", "surface2.dx_m", "--unset", "surface2.file", "--unset", "surface2.dataset"}},
       {{"check", "d.ini"}}},
      {"t.csv",
       contact + oil,
       "",
       {sweep},
       {sweep, paged({"report", "t.csv"}), {"plot", "t.csv", "--figure", "curves"}}},
      {"t.h5", contact + oil, "", {sweep}, {{"extract", "t.h5", "P", "--case", "1"}, sweep}},
      {"s.csv",
       contact + oil,
       "",
       {{"study", "d.ini", "--quiet", "--levels", "32:64", "--wedges", "upstream2", "--evaluators", "mlmi6", "--cycles",
         "1W", "--repeat", "1", "--output", "s.csv"}},
       {paged({"report", "s.csv"})}},
  };
}

class Scene {
 public:
  explicit Scene(const Kind& kind) : kind_(kind) { folder_.write("d.ini", kind.deck); }
  void make() {
    if (kind_.text.empty())
      for (const Words& words : kind_.made_by) take(words);
    else
      folder_.write(kind_.file, kind_.text);
    sound_ = folder_.read(kind_.file);
    BOOST_REQUIRE(!sound_.empty());
    for (const Words& words : kind_.read_by) take(words);
  }
  /// Damages the file and reads it in one of the ways. out: exit status.
  int damage(std::uint64_t seed) {
    Random random(seed * 0x9E3779B97F4A7C15ULL + 15);
    std::string text = sound_;
    std::vector<std::string> done;
    if (kind_.file.ends_with(".h5"))
      damage_bytes(text, random, done);
    else if (random.chance(0.5))
      damage_cells(text, random, done);
    else
      damage_text(text, random, done);
    folder_.write(kind_.file, text);
    const Words words = pick(random, kind_.read_by);
    const Finished ended = ehl(words);
    if (std::getenv("EHL_SHOW"))
      BOOST_TEST_MESSAGE("  " << done.at(0).substr(0, 100) << " | " << ended.err.substr(0, 200));
    judge(ended, kind_.file + ", seed " + std::to_string(seed) + " (" + done.at(0) + "), " + words[0]);
    return ended.status;
  }

 private:
  Finished ehl(Words words) {
    words.insert(words.begin(), EHL_PROGRAM);
    return run_program(words, folder_.path(), {"OMP_WAIT_POLICY=passive"}, EHL_FUZZ_SECONDS);
  }
  void take(const Words& words) {
    const Finished ended = ehl(words);
    BOOST_REQUIRE_MESSAGE(ended.status == 0,
                          kind_.file << ", sound, " << words[0] << " ends with " << ended.status << ": " << ended.err);
  }
  static void judge(const Finished& ended, const std::string& what) {
    BOOST_TEST(!ended.hung, what << ": hangs");
    BOOST_TEST(ended.signal == 0, what << ": ends by signal " << ended.signal << ": " << ended.err);
    for (const char* sign : {"Sanitizer", "runtime error:", "terminate called", "infinite loop closing library"})
      BOOST_TEST(!support::contains(ended.err, sign), what << ": " << ended.err);
    const bool allowed = ended.status == 0 || (ended.status >= 2 && ended.status <= 4);
    BOOST_TEST((allowed || ended.hung || ended.signal != 0),
               what << ": ends with " << ended.status << ": " << ended.err);
    if (ended.status == 2 || ended.status == 4) BOOST_TEST(ended.err.starts_with("ehl: "), what << ": " << ended.err);
    constexpr std::size_t longest_line = 1000;
    std::istringstream lines(ended.err);
    for (std::string line; std::getline(lines, line);) {
      BOOST_TEST(line.size() <= longest_line, what << ": a message of " << line.size() << " bytes");
      const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
      BOOST_TEST(std::none_of(line.begin(), line.end(), is_control), what << ": control characters: " << line);
    }
  }

  Kind kind_;
  support::TemporaryFolder folder_;
  std::string sound_{};
};

std::uint64_t option(const char* name, std::uint64_t otherwise) {
  const auto& suite = boost::unit_test::framework::master_test_suite();
  for (int k = 1; k + 1 < suite.argc; ++k)
    if (std::string(suite.argv[k]) == name) return std::strtoull(suite.argv[k + 1], nullptr, 10);
  return otherwise;
}

void damage_all(const std::vector<Kind>& kinds) {
  const std::uint64_t seed = option("--seed", 1), cases = option("--cases", EHL_DAMAGED_FILES);
  for (const Kind& kind : kinds) {
    Scene scene(kind);
    scene.make();
    std::map<int, int> ends;
    for (std::uint64_t k = 0; k < cases; ++k) ++ends[scene.damage(seed + k)];
    std::ostringstream told;
    for (const auto& [status, count] : ends) told << ", " << count << " x " << status;
    BOOST_TEST_MESSAGE(kind.file << ", " << kind.read_by.back()[0] << ": exit status" << told.str().substr(1));
    // Damage that is never noticed is none.
    BOOST_TEST(ends[0] < static_cast<int>(cases));
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_damaged_files)

BOOST_AUTO_TEST_CASE(tables_of_users) { damage_all(text_tables()); }
BOOST_AUTO_TEST_CASE(files_of_the_program) { damage_all(own_files()); }

BOOST_AUTO_TEST_SUITE_END()
