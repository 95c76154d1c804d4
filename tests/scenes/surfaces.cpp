// Surfaces at rest and measured maps through the program: what is refused, what comes out, what the result contains.
#include <hdf5.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

#include "support/columns.hpp"
#include "support/refused.hpp"
#include "support/text.hpp"

namespace {

using support::rows_of;

const std::string grid = "[domain]\nx_inlet = -4.5\nx_outlet = 1.5\ny_half = 3\n[grid]\ncells = 64\n";
const std::string contact = "[contact]\nM = 50\nL = 10\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n" + grid;
std::string steel(const std::string& motion) {
  return "[contact]\nload = 15\nradius_x = 0.0125\nE_prime = 110e9\n[lubricant]\neta0 = 0.25\nalpha = 22e-9\n" + grid +
         "[motion]\n" + motion;
}
const std::string standing = "u_m = 0.09\nsrr = 2\n";  // surface 2 is at rest
const std::string dimple = "shape = dimple\nheight = 0.05\nwidth = 0.5\n";
const std::string map = "[surface2]\nshape = map\nfile = m.csv\nunit_m = 1e-9\ndx_m = 5e-6\n";

double height(int k, int l) { return 40.0 * std::sin(0.4 * k) * std::cos(0.3 * l) + 2.0 * k - l + 300.0; }

/// Lines of nx heights, with one line and one cell replaced.
std::string csv(int nx, int ny, int bad_line = -1, const std::string& instead = "", int bad_cell = -1) {
  std::ostringstream text;
  text.precision(17);
  for (int l = 0; l < ny; ++l) {
    if (l == bad_line && bad_cell < 0) {
      text << instead << "\n";
      continue;
    }
    for (int k = 0; k < nx; ++k) {
      if (k > 0) text << ",";
      if (l == bad_line && k == bad_cell)
        text << instead;
      else
        text << height(k, l);
    }
    text << "\n";
  }
  return text.str();
}

void write_hdf5(const std::string& path, int nx, int ny, double bad = 0.0) {
  std::vector<double> values;
  for (int l = 0; l < ny; ++l)
    for (int k = 0; k < nx; ++k) values.push_back(height(k, l));
  if (bad != 0.0) values[3 * static_cast<std::size_t>(nx) + 4] = bad;
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t dims[] = {static_cast<hsize_t>(ny), static_cast<hsize_t>(nx)};
  const hid_t space = H5Screate_simple(2, dims, nullptr);
  const hid_t set = H5Dcreate2(file, "height", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(set);
  H5Sclose(space);
  H5Fclose(file);
}

using support::contains;

}  // namespace

BOOST_AUTO_TEST_SUITE(test_surfaces)

BOOST_AUTO_TEST_CASE(what_is_wrong_is_refused) {
  const std::string at_rest = contact + "[surface2]\nat_rest = yes\n";
  const support::Slip slips[] = {
      {"moving or not", contact + "[surface1]\n" + dimple, {"[surface1] shape", "[transient] end_time", "at_rest"}},
      {"a moving surface", steel("u1 = 0.05\nu2 = 0.13\n") + "[surface2]\n" + dimple, {"d.ini:18", "u2 = 0"}},
      {"the wrong surface", steel(standing) + "[surface1]\n" + dimple, {"[surface1] shape"}},
      {"said twice", steel(standing) + "[surface2]\nat_rest = yes\n" + dimple, {"at_rest"}},
      {"at rest in time", at_rest + dimple + "[transient]\nend_time = 1\n", {"[surface2] at_rest"}},
      {"both at rest", at_rest + dimple + "[surface1]\nat_rest = yes\n" + dimple, {"[surface2] at_rest"}},
      {"elsewhere", at_rest + dimple + "x = 40\n", {"shape = dimple"}},
      {"too small to see", at_rest + "shape = ridge\nheight = 0.1\nwidth = 0.1\n", {"width = 0.1"}},
      {"one surface too few", contact + "[surface]\nshape = dimple\n", {"[surface]"}},
      {"a height of a map", steel(standing) + map + "height_m = 1e-7\n", {"height_m"}},
      {"a file of a dimple", at_rest + dimple + "file = m.csv\n", {"file = m.csv"}},
      {"no spacing", steel(standing) + "[surface2]\nshape = map\nfile = m.csv\nunit_m = 1\n", {"[surface2] dx"}},
      {"no unit", steel(standing) + "[surface2]\nshape = map\nfile = m.csv\ndx = 1\n", {"[surface2] unit"}},
      {"no file", steel(standing) + "[surface2]\nshape = map\nunit_m = 1\ndx = 1\n", {"[surface2] file"}},
      {"spacing of nothing", steel(standing) + map + "dy_m = 0\n", {"dy_m = 0", "d.ini:22"}},
      {"spacing twice", steel(standing) + map + "dx = 0.1\n", {"[surface2] dx"}},
      {"metres without SI", at_rest + "shape = map\nfile = m.csv\nunit_m = 1\ndx = 1\n", {"unit_m"}},
      {"another file", steel(standing) + map + "taper = 0.6\n", {"taper = 0.6"}},
  };
  const support::TemporaryFolder folder;
  folder.write("m.csv", csv(30, 20));
  for (const support::Slip& slip : slips) support::check_refused(folder, slip);
}

BOOST_AUTO_TEST_CASE(a_map_that_is_none_is_refused) {
  const support::Slip maps[] = {
      {"no number", csv(30, 20, 4, "x", 7), {"m.csv:5"}},
      {"infinite", csv(30, 20, 4, "inf", 7), {"m.csv:5"}},
      {"a short line", csv(30, 20, 6, "1,2,3"), {"m.csv:7", "30"}},
      {"a blank line", csv(30, 20, 6, ""), {"m.csv:7"}},
      {"too few lines", csv(30, 7), {"m.csv"}},
      {"too short", csv(5, 20), {"m.csv"}},
      {"two headings", "x, y\nz, h\n" + csv(30, 20), {"m.csv:2"}},
      {"nothing at all", "", {}},
  };
  const support::TemporaryFolder folder;
  folder.write("d.ini", steel(standing) + map);
  for (const support::Slip& one : maps) {
    folder.write("m.csv", one.deck);
    const support::Ended ended = support::ehl(folder, "check d.ini");
    BOOST_TEST(ended.status == 2, one.name << ": ends with " << ended.status << "\n" << ended.err);
    BOOST_TEST(ended.says({"[surface2] file = m.csv"}), one.name << " says\n" << ended.err);
    BOOST_TEST(ended.says(one.parts), one.name << " says\n" << ended.err);
  }
  std::ostringstream plane;
  for (int l = 0; l < 12; ++l)
    for (int k = 0; k < 12; ++k) plane << 3 * k - 2 * l << (k < 11 ? " " : "\n");
  folder.write("m.csv", plane.str());
  BOOST_TEST(support::ehl(folder, "check d.ini").says({"m.csv"}));
  write_hdf5(folder / "m.h5", 30, 20, INFINITY);
  const support::Ended hole = support::ehl(folder, "check d.ini --set surface2.file=m.h5");
  BOOST_TEST(hole.status == 2);
  BOOST_TEST(hole.says({"m.h5: height", "row 4", "column 5"}), hole.err);
  for (const char* file : {"none.csv", "none.h5", "d.ini.h5"})
    BOOST_TEST(support::ehl(folder, std::string("check d.ini --set surface2.file=") + file).status == 4);
  BOOST_TEST(support::ehl(folder, "check d.ini --set surface2.file=m.h5 --set surface2.dataset=depth").status == 4);
  BOOST_TEST(support::ehl(folder, "check d.ini --set surface2.file=d.ini").status == 2);
}

// A map from text and from HDF5, in metres and in Hertz radii, and from another folder; the deck in the
// result gives the same film.
BOOST_AUTO_TEST_CASE(a_map_stands_in_the_contact) {
  const support::TemporaryFolder folder;
  folder.write("m.csv", "# heights\nx, y\n" + csv(60, 50) + "\n\n");
  write_hdf5(folder / "m.h5", 60, 50);
  folder.write("d.ini", steel(standing) + map);
  const support::Ended checked = support::ehl(folder, "check d.ini");
  for (const char* part : {"60 x 50", "slopes 1.99"})
    BOOST_TEST(contains(checked.out, part), part << " is missing in\n" << checked.out);
  const support::Ended ended = support::ehl(folder, "run d.ini --quiet");
  BOOST_TEST_REQUIRE(ended.status == 0, ended.err);
  const auto extract = [&](const std::string& what) { return support::ehl(folder, "extract " + what); };
  const auto number = [&](const std::string& what) { return rows_of(extract(what).out).at(0).at(0); };
  const double lost = number("d.h5 /summary/surface2_variance_lost");
  BOOST_TEST((lost > 0.0 && lost < 1.0));
  BOOST_TEST(std::abs(number("d.h5 /summary/surface2_shortest_wave_x") - 2.0 * 6.0 / 64) < 1e-12);
  // The gap changes by the negative heights without their plane; the waves are 40 nm high.
  const double steps = number("d.h5 /scales/a") / 5e-6;  // points of the map per Hertz radius
  double most = 0.0, mean = 0.0, with_wave = 0.0, squares = 0.0, of_wave = 0.0;
  const auto S = rows_of(extract("d.h5 /fields/S").out);
  for (const auto& row : S) {
    most = std::max(most, std::abs(row.at(2)));
    mean += row.at(2) / static_cast<double>(S.size());
    if (std::max(std::abs(row.at(0)), std::abs(row.at(1))) > 0.6) continue;  // where the taper ends
    const double wave = std::sin(0.4 * (row.at(0) * steps + 29.5)) * std::cos(0.3 * (row.at(1) * steps + 24.5));
    with_wave += wave * row.at(2);
    squares += row.at(2) * row.at(2);
    of_wave += wave * wave;
  }
  const double in_file = 40e-9 / number("d.h5 /scales/h");
  BOOST_TEST_MESSAGE("largest gap " << most << ", 40 nm are " << in_file << "; mean " << mean);
  BOOST_TEST((most > 0.5 * in_file && most < 1.3 * in_file));
  BOOST_TEST(std::abs(mean) < 0.05 * in_file);
  const double correlation = with_wave / std::sqrt(squares * of_wave);
  BOOST_TEST_MESSAGE("correlation with the waves of the file " << correlation);
  BOOST_TEST(correlation < -0.98);

  const double Hc = number("d.h5 /summary/Hc");
  const auto same = [&](const std::string& arguments, double tolerance) {
    const support::Ended again = support::ehl(folder, "run " + arguments + " --quiet --output again.h5 --overwrite");
    BOOST_TEST(again.status == 0, arguments << ": " << again.err);
    const double other = number("again.h5 /summary/Hc");
    BOOST_TEST(std::abs(other / Hc - 1.0) <= tolerance, arguments << ": " << other << " and " << Hc);
  };
  same("d.ini --set surface2.file=m.h5", 0.0);
  folder.write("effective.ini", extract("d.h5 deck").out);
  same("effective.ini", 0.0);
  const double a = number("d.h5 /scales/a"), h = number("d.h5 /scales/h");
  std::ostringstream plain;
  plain.precision(17);
  plain << steel(standing) << "[surface2]\nshape = map\nfile = m.csv\nunit = " << 1e-9 / h << "\ndx = " << 5e-6 / a
        << "\n";
  folder.write("plain.ini", plain.str());
  same("plain.ini", 1e-9);
  const support::Ended outside =
      support::shell(folder, std::string("mkdir sub && cd sub && '") + EHL_PROGRAM + "' check ../d.ini");
  BOOST_TEST(outside.status == 0, outside.err);
  // A grid that is too coarse for the map causes a warning.
  const std::string coarse = support::ehl(folder, "run d.ini --quiet --output c.h5 --set surface2.dx_m=2.5e-6").out;
  BOOST_TEST(contains(coarse, "[map-lost]"), coarse);
}

BOOST_AUTO_TEST_CASE(a_dent_at_rest) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", contact + "[surface1]\nat_rest = yes\n" + dimple);
  const support::Ended ended = support::ehl(folder, "run d.ini --quiet");
  BOOST_TEST_REQUIRE(ended.status == 0, ended.err);
  BOOST_TEST(contains(ended.out, "dimple, height 0.05"));
  BOOST_TEST(contains(support::ehl(folder, "extract d.h5 /summary").out, "dimple, height 0.05"));
  // Without a map there is no text and no field about it.
  folder.write("s.ini", contact);
  const support::Ended smooth = support::ehl(folder, "run s.ini --quiet");
  BOOST_TEST(!contains(smooth.out, "surface"));
  BOOST_TEST(support::ehl(folder, "extract s.h5 /fields/S").status != 0);
}

// In time the map enters with its surface, and leaves.
BOOST_AUTO_TEST_CASE(a_map_moves_through) {
  const support::TemporaryFolder folder;
  folder.write("m.csv", csv(60, 50));
  folder.write("d.ini", steel("u1 = 0.09\nu2 = 0.09\n") + map + "[transient]\nend_time = 1.5\nrtol = 1e-3\n" +
                            "output_interval = 0.5\n[continuation]\npath = off\n");
  const support::Ended ended = support::ehl(folder, "run d.ini --quiet --set surface2.x=-1.5");
  BOOST_TEST_REQUIRE(ended.status == 0, ended.err);
  const auto rows = rows_of(support::ehl(folder, "extract d.h5 /transient").out);
  double least = 1e9, most = 0.0;
  for (const auto& row : rows) {
    least = std::min(least, row.at(1));
    most = std::max(most, row.at(1));
  }
  BOOST_TEST_MESSAGE(rows.size() << " steps, Hc from " << least << " to " << most);
  BOOST_TEST(most / least > 1.02);
  const support::Ended before = support::ehl(folder, "run d.ini --quiet --set surface2.x=-30 --output f.h5");
  BOOST_TEST(before.status == 0);
  const auto quiet = rows_of(support::ehl(folder, "extract f.h5 /transient").out);
  BOOST_TEST(std::abs(quiet.back().at(1) / quiet.front().at(1) - 1.0) < 1e-6);
}

BOOST_AUTO_TEST_SUITE_END()
