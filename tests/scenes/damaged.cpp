// HDF5 files that were changed deliberately: maps in other files, checkpoints that no run wrote.
#include <hdf5.h>

#include <boost/test/unit_test.hpp>
#include <functional>
#include <limits>

#include "support/program.hpp"
#include "support/text.hpp"

namespace {

const std::string small =
    "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\nz = 0.68\n[domain]\nx_inlet = -4.5\ny_half = 3\n[grid]\n"
    "cells = 64\n";

hid_t open_file(const std::string& path) { return H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT); }

// Replaces one number of a dataset.
void set(const std::string& path, const char* dataset, std::size_t at, double value) {
  const hid_t file = open_file(path), set = H5Dopen2(file, dataset, H5P_DEFAULT), space = H5Dget_space(set);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  values[at < values.size() ? at : values.size() - 1] = value;
  H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Sclose(space), H5Dclose(set), H5Fclose(file);
}

// Replaces a dataset by a single number.
void replace(const std::string& path, const char* dataset, double value) {
  const hid_t file = open_file(path), space = H5Screate(H5S_SCALAR);
  H5Ldelete(file, dataset, H5P_DEFAULT);
  const hid_t set = H5Dcreate2(file, dataset, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value);
  H5Dclose(set), H5Sclose(space), H5Fclose(file);
}

void replace_text(const std::string& path, const char* dataset, const std::string& text) {
  const hid_t file = open_file(path), space = H5Screate(H5S_SCALAR), type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, text.size() + 1);
  H5Ldelete(file, dataset, H5P_DEFAULT);
  const hid_t set = H5Dcreate2(file, dataset, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str());
  H5Dclose(set), H5Tclose(type), H5Sclose(space), H5Fclose(file);
}

constexpr hsize_t heights[] = {16, 16};

void height_file(const std::string& path, const std::function<void(hid_t file, hid_t space)>& make) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(2, heights, nullptr);
  make(file, space);
  H5Sclose(space), H5Fclose(file);
}

void make_heights(hid_t file, hid_t space, hid_t properties) {
  std::vector<double> z(heights[0] * heights[1]);
  for (std::size_t k = 0; k < z.size(); ++k) z[k] = static_cast<double>(k % 7);
  const hid_t set = H5Dcreate2(file, "height", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
  H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, z.data());
  H5Dclose(set);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_damaged)

// A map that refers to another file must not make the program read that file.
BOOST_AUTO_TEST_CASE(maps_lie_in_their_own_file) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", small + "[surface1]\nshape = map\nfile = map.h5\nunit = 0.001\ndx = 0.1\nat_rest = yes\n");
  const std::string other = folder / "other.h5", map = folder / "map.h5",
                    raw = folder.write("raw", std::string(2048, 'x'));
  height_file(other, [](hid_t file, hid_t space) { make_heights(file, space, H5P_DEFAULT); });
  const auto refused = [&](const std::string& what) {
    const support::Ended ended = support::ehl(folder, "check d.ini");
    BOOST_TEST(ended.status == 4, what << ": " << ended.status << "\n" << ended.out);
    BOOST_TEST(ended.says({"map.h5", "height"}), what << ": " << ended.err);
  };
  height_file(map, [&](hid_t file, hid_t space) { make_heights(file, space, H5P_DEFAULT); });
  BOOST_TEST(support::ehl(folder, "check d.ini").status == 0);
  height_file(map, [&](hid_t file, hid_t) {
    H5Lcreate_external(other.c_str(), "height", file, "height", H5P_DEFAULT, H5P_DEFAULT);
  });
  refused("link");
  height_file(map, [&](hid_t file, hid_t space) {
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_virtual(properties, space, other.c_str(), "height", space);
    H5Dclose(H5Dcreate2(file, "height", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    H5Pclose(properties);
  });
  refused("a view of another file");
  height_file(map, [&](hid_t file, hid_t space) {
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(properties, raw.c_str(), 0, 2048);
    make_heights(file, space, properties);
    H5Pclose(properties);
  });
  refused("values in another file");
}

// A view of a dataset in the same file is read; the program's own files contain one for each field in time.
BOOST_AUTO_TEST_CASE(views_of_their_own_file_are_read) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", small + "[surface1]\nshape = map\nfile = map.h5\nunit = 0.001\ndx = 0.1\nat_rest = yes\n");
  height_file(folder / "map.h5", [&](hid_t file, hid_t space) {
    make_heights(file, space, H5P_DEFAULT);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_virtual(properties, space, ".", "height", space);
    H5Dclose(H5Dcreate2(file, "view", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    H5Pclose(properties);
  });
  const support::Ended own = support::ehl(folder, "check d.ini"),
                       view = support::ehl(folder, "check d.ini --set surface1.dataset=view");
  BOOST_TEST(own.status == 0, own.err);
  BOOST_TEST(view.status == 0, view.err);
  const auto heights = [](const std::string& text) { return text.substr(text.find("levelled"), 100); };
  BOOST_TEST(heights(own.out) == heights(view.out));
  folder.write("t.ini", small + "[transient]\nend_time = 0.1\noutput_interval = 0.05\nload = 0:1 0.1:1.1\n");
  BOOST_REQUIRE(support::ehl(folder, "run t.ini --quiet").status == 0);
  const auto numbers = [&](const std::string& what) {
    const support::Ended ended = support::ehl(folder, "extract t.h5 /transient/frames/" + what);
    BOOST_TEST(ended.status == 0, ended.err);
    return ended.out.substr(ended.out.find("\n", ended.out.rfind("#")) + 1);
  };
  const std::string view_1 = numbers("planes/P_1");
  BOOST_TEST((view_1 == numbers("P --step 1")));
  BOOST_TEST((view_1 != numbers("P --step 2")));
}

// The program does not continue from a checkpoint that it did not write, and leaves the file unchanged.
BOOST_AUTO_TEST_CASE(checkpoints_are_looked_at) {
  const support::TemporaryFolder folder;
  const std::string in_time = "[transient]\nend_time = 2\noutput_interval = 0.1\nload = swing.csv\n";
  folder.write("d.ini", small + in_time + "[output]\ncheckpoint = 1e-3\n");
  folder.write("swing.csv", "0, 1\n2, 1.2\n4, 1\n");
  support::shell(folder,
                 std::string("'") + EHL_PROGRAM +
                     "' run d.ini --quiet --output c.h5 & p=$!; while ! test -s c.h5; do sleep 0.05; done; sleep "
                     "0.2; kill -INT $p; wait $p");
  const std::string file = folder / "d.h5";
  const auto reset = [&] { support::shell(folder, "cp c.h5 d.h5"); };
  const auto refused = [&](const std::string& part) {
    const std::string before = folder.read("d.h5");
    const support::Ended ended = support::ehl(folder, "resume d.h5 --quiet");
    BOOST_TEST(ended.status == 4, part << ": ends with " << ended.status << "\n" << ended.err);
    BOOST_TEST(ended.says({part}), ended.err);
    BOOST_TEST((folder.read("d.h5") == before), part << ": the file was changed");
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const char* dataset : {"/transient/Hc", "/transient/frames/time", "/checkpoint/y", "/checkpoint/yp",
                              "/checkpoint/time", "/transient/frames/P", "/checkpoint/frames", "/transient/cycles"})
    for (const double value : {nan, 1e300, std::numeric_limits<double>::infinity()}) {
      if (value != value && (dataset[12] == 'f' || dataset[11] == 'c')) continue;  // integers have no NaN
      reset();
      set(file, dataset, 1, value);
      refused("the file is damaged");
    }
  for (const char* dataset : {"/checkpoint/frames", "/checkpoint/time"}) {
    reset();
    replace(file, dataset, 1e300);
    refused("the file is damaged");
  }
  reset();
  set(file, "/transient/time", 2, 0.0);
  refused("its times are not rising");
  reset();
  replace_text(file, "/deck", small);
  refused("its deck is not that of a run in time");
  reset();
  replace(file, "/grid/x", 3.0);
  refused("does not match its grid");
  reset();
  folder.write("swing.csv", "0, 1\n2, 1.3\n4, 1\n");
  refused("swing.csv: has changed since the run began");
  folder.write("swing.csv", "0, 1\n2, 1.2\n4, 1\n");
  reset();
  set(file, "/checkpoint/weight", 0, 1.5);
  refused("the times of its checkpoint");
  // Files of earlier versions have no weight, because their cycles had none.
  reset();
  const hid_t old = open_file(file);
  H5Ldelete(old, "/checkpoint/weight", H5P_DEFAULT), H5Fclose(old);
  BOOST_TEST(support::ehl(folder, "resume d.h5 --quiet").status == 0);
  reset();
  BOOST_TEST(support::ehl(folder, "resume d.h5 --quiet").status == 0);
}

BOOST_AUTO_TEST_SUITE_END()
