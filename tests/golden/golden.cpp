// What the program prints is what the transcripts in commands/ say. After rewording, renew.sh writes the new ones, and
// `git diff` shows the words before and after.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include "golden/normal.hpp"
#include "golden/transcript.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

namespace {

namespace files = std::filesystem;

std::vector<std::string> transcripts() {
  std::vector<std::string> names;
  for (const auto& entry : files::directory_iterator(GOLDEN_COMMANDS)) names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Lines that were removed and added, with their neighbours.
std::string difference(const std::string& before, const std::string& after) {
  const support::TemporaryFolder folder;
  folder.write("before", before);
  folder.write("after", after);
  return support::shell(folder, "diff -U 2 before after | tail -n +3").out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_golden)

BOOST_AUTO_TEST_CASE(the_normal_form_of_a_text) {
  using golden::Numbers;
  const std::vector<golden::Place> places{{"/tmp/ehl_test_x", "FOLDER"}};
  const auto replaced = [&](const std::string& text) { return golden::normal(text, Numbers::replaced, places); };
  BOOST_TEST(replaced("H   -3.5e-07  1 %, 12.5 nm at (-0.25, 1)") == "H # # %, # nm at (#, #)");
  BOOST_TEST(replaced("level 65 x 129 on [-4.5, 1.5] x [-3, 3]") == "level 65 x 129 on [#, #] x [#, #]");
  BOOST_TEST(replaced("d.ini:17: Sq1 = 3 of 2U in 1/Pa, H^2, p.h5") == "d.ini:17: Sq1 = # of 2U in 1/Pa, H^2, p.h5");
  BOOST_TEST(replaced("0.43 +- 2 %, nan, -inf, 10-20") == "# +- # %, nan, -inf, #-#");
  BOOST_TEST(replaced("Hc 0.1234567890123456 \\054") == "Hc # \\054");
  BOOST_TEST(golden::normal("/tmp/ehl_test_x/a: 3 s, 2026-11-29T08:47:14Z", Numbers::kept, places) ==
             "FOLDER/a: 3 s, DATE");
  BOOST_TEST(golden::normal("ehl:  45 %  level 3\n2 computed in 0.5 s\n", Numbers::kept, places) ==
             "2 computed in # s\n");
}

BOOST_AUTO_TEST_CASE(the_program_prints_what_the_transcripts_say) {
  const char* const renewed = std::getenv("EHL_RENEW_GOLDEN");  // their names between spaces
  const std::vector<std::string> names = transcripts();
  BOOST_TEST(!names.empty());
  for (const std::string& name : names) {
    const std::string path = GOLDEN_COMMANDS "/" + name + ".txt";
    if (renewed != nullptr && !support::contains(std::string(" ") + renewed + " ", " " + name + " ")) continue;
    const std::string expected = read_text(path);
    const std::string printed = golden::performed(expected);
    if (renewed != nullptr) std::ofstream(path, std::ios::binary) << printed;
    if (renewed == nullptr && printed != expected)
      BOOST_ERROR("tests/golden/commands/" << name << ".txt (-) is not what the program prints (+):\n"
                                           << difference(expected, printed)
                                           << "If the new words are right, tests/golden/renew.sh writes them there.");
  }
}

BOOST_AUTO_TEST_SUITE_END()
