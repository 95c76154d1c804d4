// Measured maps in the formats of instruments and spreadsheets: every format describes the same surface.
#include <bit>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <sstream>

#include "support/refused.hpp"
#include "support/text.hpp"

namespace {

constexpr int n = 32;

// A wave that is even about the centre and has no mean: levelling does not change it, and Sq = 40/sqrt(2) nm.
double height(int k, int l) {
  const double wave = 40.0 * std::cos(2.0 * std::numbers::pi * 4.0 * (k - 0.5 * (n - 1)) / n);
  return wave + 0.3 * k - 0.7 * l + 12.0;
}

const std::string deck =
    "[contact]\nload = 20\nradius_x = 0.0127\nE_prime = 230e9\n[motion]\nu1 = 2\nu2 = 0\n[lubricant]\n"
    "fluid = mineral-vg68\ntemperature = 40\n[domain]\nx_inlet = -3\nx_outlet = 1.5\ny_half = 2.25\n"
    "[surface2]\nshape = map\n";
const std::string keys = "unit_m = 1e-9\ndx_m = 2e-6\n";

std::string number(double z) {
  std::ostringstream text;
  text.precision(10);
  text << z;
  return text.str();
}

std::string comma(std::string text) {
  for (char& c : text)
    if (c == '.') c = ',';
  return text;
}

// Rows with a given separator, a given end of line, and a factor on the heights.
std::string rows(const std::string& between, const std::string& end, double factor = 1.0, bool from_top = false) {
  std::string text;
  for (int row = 0; row < n; ++row)
    for (int k = 0; k < n; ++k)
      text += number(factor * height(k, from_top ? n - 1 - row : row)) + (k + 1 < n ? between : end);
  return text;
}

// A list of the points in an order other than that of rows.
std::string list(const std::string& between, double unit_of_xy, double unit_of_z) {
  std::string text;
  for (int m = 0; m < n * n; ++m) {
    const int at = (m * 37) % (n * n), k = at / n, l = at % n;
    text += number(2e-6 * k / unit_of_xy) + between + number(2e-6 * l / unit_of_xy) + between +
            number(1e-9 * height(k, l) / unit_of_z) + "\n";
  }
  return text;
}

struct Form {
  std::string name, file, text, keys;
  const char* slopes = "slopes 0.3 and -0.7 per point";
};

// A file of Digital Surf's format, built from the fields that its documentation names: 16 bits in steps of 2 nm / 1000,
// or 32 bits in steps of 2 nm / 1e6. A comment and a private zone stand between header and heights.
std::string sur(int bits, bool missing = false, const std::string& signature = "DIGITAL SURF") {
  std::string file(512, '\0');
  const auto put = [&](std::size_t at, std::uint32_t value, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) file[at + k] = static_cast<char>(value >> (8 * k) & 0xFF);
  };
  const auto real = [&](std::size_t at, float value) { put(at, std::bit_cast<std::uint32_t>(value), 4); };
  const auto word = [&](std::size_t at, const std::string& text) { file.replace(at, text.size(), text); };
  const double step = bits == 16 ? 2e-3 : 2e-6;  // nm
  const auto least = static_cast<std::int32_t>(std::lround(-60.0 / step));
  word(0, signature), word(20, "a map"), word(180, "mm"), word(196, "\xC2\xB5m"), word(212, "nm");
  put(14, 1, 2), put(16, 1, 2), put(18, 2, 2), put(86, missing ? 1 : 0, 2);
  put(98, static_cast<std::uint32_t>(bits), 2), put(100, static_cast<std::uint32_t>(least), 4);
  put(108, n, 4), put(112, n, 4), put(116, n * n, 4);
  real(120, 2e-3F), real(124, 2.0F), real(128, static_cast<float>(step));
  put(334, 7, 2), put(336, 5, 2);
  file += "commentzone.";
  for (int l = 0; l < n; ++l)
    for (int k = 0; k < n; ++k) {
      const bool none = missing && l == 3 && k >= 5 && k < 13;
      const std::int32_t z = none ? least - 2 : static_cast<std::int32_t>(std::lround(height(k, l) / step));
      for (int byte = 0; byte < bits / 8; ++byte) file += static_cast<char>(z >> (8 * byte) & 0xFF);
    }
  return file;
}

std::string with_missing(std::string text, const std::string& word) {
  // The heights of points 5 to 12 in the third row.
  std::size_t at = 0;
  for (int line = 0; line < 2; ++line) at = text.find('\n', at) + 1;
  for (int k = 0; k < 5; ++k) at = text.find(',', at) + 1;
  for (int k = 0; k < 8; ++k) {
    const std::size_t end = text.find(',', at);
    text.replace(at, end - at, word);
    at = text.find(',', at) + 1;
  }
  return text;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_map_files)

BOOST_AUTO_TEST_CASE(every_form_is_the_same_surface) {
  const std::string gwyddion = "# Channel: Z\n# Width: 64 \xC2\xB5m\n# Height: 64 \xC2\xB5m\n# Value units: nm\n";
  const std::string sdf =
      "aISO-1.0\nManufacID = x\nNumPoints = 32\nNumProfiles = 32\nXscale = 2e-6\nYscale = 2e-6\n"
      "Zscale = 1e-9\nZresolution = -1\nCompression = 0\nDataType = 7\nCheckType = 0\n*\n";
  const std::string esri = "ncols 32\nnrows 32\nxllcorner 0\nyllcorner 0\ncellsize 2e-6\nNODATA_value -9999\n";
  const Form forms[] = {
      {"commas", "m.csv", rows(",", "\n"), keys},
      {"blanks", "m.txt", rows(" ", "\n"), keys},
      {"tabs and a byte order mark", "m.dat", "\xEF\xBB\xBF" + rows("\t", "\r\n"), keys},
      {"capital letters", "M.TXT", rows(" ", "\n"), keys},
      {"decimal commas and semicolons", "m.csv", comma(rows(";", "\n")), keys},
      {"decimal commas and tabs", "m.txt", comma(rows("\t", "\n")), keys},
      {"decimal commas and blanks", "m.txt", comma(rows("  ", "\n")), keys},
      {"a comma at every end", "m.csv", rows(",", ",\n"), keys},
      {"a tab at every end", "m.txt", rows("\t", "\t\n"), keys},
      {"line ends of old instruments", "m.csv", rows(",", "\r"), keys},
      {"a list", "m.xyz", list("\t", 1e-6, 1e-9), keys},
      {"a list in metres", "m.xyz", list(" ", 1.0, 1e-9), keys},
      {"a list with units", "m.csv", "x [um],y [um],z [nm]\n" + list(",", 1e-6, 1e-9), ""},
      {"a list in mm with decimal commas", "m.csv", "x (mm);y (mm);z (um)\n" + comma(list(";", 1e-3, 1e-6)), "",
       "slopes 0.0003 and -0.0007 per point"},
      {"Gwyddion", "m.txt", gwyddion + rows("\t", "\n"), ""},
      {"Gwyddion and the same keys", "m.txt", gwyddion + rows("\t", "\n"), keys},
      {"SDF", "m.sdf", sdf + rows(" ", "\n") + "*\n", ""},
      {"Digital Surf, 16 bits", "m.sur", sur(16), ""},
      {"Digital Surf, 32 bits, and the same keys", "m.SUR", sur(32), keys},
      {"ESRI, rows from the top", "m.asc", esri + rows(" ", "\n", 1.0, true), "unit_m = 1e-9\n"},
      {"ESRI in um", "m.asc", "ncols 32\nnrows 32\ncellsize 2\n" + rows(" ", "\n", 1.0, true), keys},
  };
  for (const Form& form : forms) {
    const support::TemporaryFolder folder;
    folder.write(form.file, form.text);
    folder.write("d.ini", deck + "file = " + form.file + "\n" + form.keys);
    const support::Ended ended = support::ehl(folder, "check d.ini");
    BOOST_TEST(ended.status == 0, form.name << ": " << ended.err);
    // The plane that is removed shows the order of rows and points; 62 um are 0.5239 a.
    for (const char* part : {"32 x 32 points on 0.524 x 0.524 a", "Sq 28.3 nm", form.slopes})
      BOOST_TEST(support::contains(ended.out, part), form.name << ": " << part << " is missing in\n" << ended.out);
    BOOST_TEST(!support::contains(ended.out, "missing points"), form.name);
  }
}

BOOST_AUTO_TEST_CASE(missing_points_are_filled_counted_and_told) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck + "file = m.csv\n" + keys);
  for (const char* word : {"", "NaN", "nan", "BAD", "***"}) {
    folder.write("m.csv", with_missing(rows(",", "\n"), word));
    const support::Ended ended = support::ehl(folder, "check d.ini");
    BOOST_TEST(ended.status == 0, word << ": " << ended.err);
    BOOST_TEST(support::contains(ended.out, "8 missing points"), word << ":\n" << ended.out);
    BOOST_TEST(support::contains(ended.out, "Sq 28."), word << ":\n" << ended.out);
  }
  for (const int bits : {16, 32}) {
    folder.write("m.sur", sur(bits, true));
    const support::Ended ended = support::ehl(folder, "check d.ini --set surface2.file=m.sur");
    BOOST_TEST(ended.status == 0, bits << ": " << ended.err);
    BOOST_TEST(support::contains(ended.out, "8 missing points"), bits << ":\n" << ended.out);
    BOOST_TEST(support::contains(ended.out, "Sq 28."), bits << ":\n" << ended.out);
  }
  const support::Ended ran = support::ehl(folder, "run d.ini --quiet --json --set grid.cells=128");
  BOOST_TEST(ran.status == 0, ran.err);
  BOOST_TEST(support::contains(ran.out, "\"missing_points\":8"), ran.out);
  // Half of the points of a list.
  std::string half;
  for (int l = 0; l < n; ++l)
    for (int k = l % 2; k < n; k += 2)
      half += number(2.0 * k) + " " + number(2.0 * l) + " " + number(height(k, l)) + "\n";
  folder.write("m.csv", half);
  const support::Ended refused = support::ehl(folder, "check d.ini");
  BOOST_TEST(refused.status == 2);
  BOOST_TEST(refused.says({"512 of 1024"}), refused.err);
}

BOOST_AUTO_TEST_CASE(what_contradicts_itself_is_refused) {
  const std::string heading = "# Width: 64 um\n# Height: 64 um\n# Value units: nm\n";
  const support::Slip slips[] = {
      {"another unit", "file = m.txt\nunit_m = 1e-6\n", {"unit_m"}},
      {"another spacing", "file = m.txt\ndx_m = 3e-6\n", {"dx_m"}},
      {"a list of other points", "file = l.xyz\nunit_m = 1e-9\ndx_m = 3e-6\n", {"l.xyz"}},
      {"no unit anywhere", "file = m.csv\ndx_m = 2e-6\n", {"unit"}},
      {"an instrument's own", "file = m.opd\n" + keys, {"m.opd"}},
      {"half of a header", "file = half.sur\n" + keys, {"half.sur"}},
      {"compressed", "file = zip.sur\n" + keys, {"zip.sur"}},
      {"cut off", "file = cut.sur\n" + keys, {"cut.sur"}},
      {"not a length", "file = volt.sur\n" + keys, {"volt.sur"}},
      {"another unit than the header's", "file = m.sur\nunit_m = 1e-6\n", {"unit_m"}},
      {"commas of two meanings", "file = either.txt\n" + keys, {"either.txt:1"}},
      {"a zipped one", "file = m.x3p\n" + keys, {"m.x3p"}},
      {"filters in the wrong order",
       "file = m.csv\n" + keys + "longest_wave_m = 1e-5\nshortest_wave_m = 2e-5\n",
       {"longest_wave_m"}},
      {"a filter of nothing", "file = m.csv\n" + keys + "shortest_wave_m = 1e-7\n", {"shortest_wave_m"}},
  };
  const support::TemporaryFolder folder;
  folder.write("m.txt", heading + rows(" ", "\n"));
  folder.write("m.csv", rows(",", "\n"));
  folder.write("l.xyz", list(" ", 1e-6, 1e-9));
  folder.write("m.sur", sur(16));
  folder.write("m.opd", "x");
  folder.write("half.sur", sur(16).substr(0, 300));
  folder.write("cut.sur", sur(16).substr(0, sur(16).size() - 1));
  folder.write("zip.sur", sur(16, false, "DSCOMPRESSED"));
  folder.write("volt.sur", sur(16).replace(212, 2, std::string("V\0", 2)));
  folder.write("m.x3p", "PK");
  std::string either;
  for (int row = 0; row < 8; ++row) either += "1,234;2,345;3,456;4,567;5,678;6,789;7,891;8,912\n";
  folder.write("either.txt", either);
  for (const support::Slip& slip : slips) support::check_refused(folder, {slip.name, deck + slip.deck, slip.parts});
}

// The wave is 16 um long: a filter with this cut-off leaves half of it, whether it removes short or long waves.
BOOST_AUTO_TEST_CASE(filters_leave_half_of_the_wave_at_their_cut_off) {
  const support::TemporaryFolder folder;
  folder.write("m.csv", rows(",", "\n"));
  folder.write("d.ini", deck + "file = m.csv\n" + keys);
  for (const char* key : {"shortest_wave_m", "longest_wave_m"}) {
    const support::Ended ended = support::ehl(folder, std::string("check d.ini --set surface2.") + key + "=16e-6");
    BOOST_TEST(ended.status == 0, ended.err);
    BOOST_TEST(support::contains(ended.out, "Sq 28.3 nm"), ended.out);
    const double left = 1e0 * std::stod(ended.out.substr(ended.out.find("unit), Sq ") + 10));
    BOOST_TEST_MESSAGE(key << ": Sq " << left << " nm, wanted 14.1");
    BOOST_TEST(std::abs(left - 14.14) < 0.6);  // the filter is truncated at the edges
  }
  // Without levelling the tilt remains: 0.3 and 0.7 nm per point.
  const support::Ended mean = support::ehl(folder, "check d.ini --set surface2.levelling=mean");
  const double tilt = std::sqrt((0.09 + 0.49) * (n * n - 1) / 12.0);
  const double left = std::stod(mean.out.substr(mean.out.find("unit), Sq ") + 10));
  BOOST_TEST(std::abs(left - std::hypot(40.0 / std::sqrt(2.0), tilt)) < 0.06, mean.out);
}

BOOST_AUTO_TEST_SUITE_END()
