#include <hdf5.h>
#include <sys/resource.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <limits>

#include "core/errors.hpp"
#include "results/collection.hpp"
#include "results/read.hpp"
#include "results/write.hpp"
#include "support/temporary_folder.hpp"
#include "support/text.hpp"

using namespace ehl;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The value at a node identifies it: 1000 i + j. nx != ny, so that a transposed field is noticed.
struct Example {
  core::Grid grid{4, 2, -4.5, 1.5, -3.0, 3.0};
  core::Field field{grid};
  results::Content content;

  Example() {
    for (int i = 0; i < grid.nodes_x(); ++i)
      for (int j = 0; j < grid.nodes_y(); ++j) field(i, j) = 1000.0 * i + j;
    content.title = "an <example> & more";
    content.deck = "[contact]\nM = 50\n";
    content.provenance = {{"version", "0.1", "", "version of the program"}};
    content.scales = {{"a", 136.5e-6, "m", "Hertz radius"}, {"unknown", nan, "m", "not known"}};
    content.grid = grid;
    content.fields = {{"P", "p_h", "pressure", &field}};
    content.summary = {{"converged", true, "-", "1: converged"},
                       {"Hc", 0.2205, "a^2/R", "central film"},
                       {"warnings", "", "", "none"}};
    content.tables = {{"levels",
                       "the ladder",
                       {{"level", "-", "level", true, {1, 2, 3}}, {"Hc", "-", "film", false, {0.1, nan, 0.3}}}}};
  }
};

std::string refusal(const std::string& path) {
  return support::refusal<core::FileError>([&] { results::ResultFile file(path); });
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_results_file)

BOOST_AUTO_TEST_CASE(what_is_written_is_read_back) {
  const support::TemporaryFolder folder;
  const Example example;
  results::write(folder / "r.h5", example.content, false);
  const results::ResultFile file(folder / "r.h5");

  const results::Array P = file.numbers("/fields/P");
  BOOST_REQUIRE(P.dims.size() == 2u);
  BOOST_TEST(P.dims[0] == 3u);  // row = y
  BOOST_TEST(P.dims[1] == 5u);  // column = x
  BOOST_TEST(P.values[2 * 5 + 4] == 4002.0);
  BOOST_TEST(P.values[1 * 5 + 3] == 3001.0);
  BOOST_TEST(P.unit == "p_h");
  BOOST_TEST(P.meaning == "pressure");

  const results::Array x = file.numbers("/grid/x");
  BOOST_TEST(x.values.front() == -4.5);
  BOOST_TEST(x.values.back() == 1.5);
  BOOST_TEST(file.numbers("/grid/y").values[1] == 0.0);
  BOOST_TEST(file.text("/deck") == example.content.deck);
  BOOST_TEST(file.text("/provenance/version") == "0.1");
  BOOST_TEST(file.numbers("/scales/a").values[0] == 136.5e-6);
  BOOST_TEST(file.numbers("/scales/a").unit == "m");
  BOOST_TEST((file.kind("/scales/unknown") == results::ResultFile::Kind::missing));
  BOOST_TEST(file.numbers("/summary/converged").values[0] == 1.0);
  BOOST_TEST(file.numbers("/levels/level").values[2] == 3.0);
  BOOST_TEST(std::isnan(file.numbers("/levels/Hc").values[1]));
  BOOST_TEST(file.attribute("/levels", "columns") == "level Hc");
  BOOST_TEST((file.names("/levels") == std::vector<std::string>{"Hc", "level"}));
  BOOST_TEST((file.kind("/levels") == results::ResultFile::Kind::group));
  BOOST_TEST((file.kind("/deck") == results::ResultFile::Kind::text));
  BOOST_CHECK_THROW(file.numbers("/fields/Q"), core::FileError);
  BOOST_CHECK_THROW(file.numbers("/deck"), core::FileError);
  BOOST_CHECK_THROW(file.text("/grid/x"), core::FileError);
}

// Two runs of the same case differ only in their provenance: equal content gives equal bytes.
BOOST_AUTO_TEST_CASE(the_same_content_gives_the_same_bytes) {
  const support::TemporaryFolder folder;
  const Example example;
  results::write(folder / "one.h5", example.content, false);
  results::write(folder / "two.h5", example.content, false);
  BOOST_TEST((folder.read("one.h5") == folder.read("two.h5")));
  const hid_t file = H5Fopen((folder / "one.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  H5O_info_t info{};
  H5Oget_info_by_name2(file, "/fields/P", &info, H5O_INFO_TIME, H5P_DEFAULT);
  H5Fclose(file);
  BOOST_TEST(info.ctime == 0);  // no time stamp, which would differ a second later
  BOOST_TEST(folder.read("one.h5").size() < results::expected_bytes(example.grid, 1));
}

// Groups, the root and the file of a sweep's results have no time stamps either.
BOOST_AUTO_TEST_CASE(no_object_has_a_time) {
  const support::TemporaryFolder folder;
  const Example example;
  results::write(folder / "r.h5", example.content, false);
  const auto kept = [&](const std::string& path) {
    results::write_collection(path, {{0, "contact.M=20"}, {1, "contact.M=50"}}, [&](const results::Member&) {
      return results::Source{.image = results::image("r", example.content)};
    });
  };
  kept(folder / "one.h5");
  for (const char* name : {"r.h5", "one.h5"}) {
    const hid_t file = H5Fopen((folder / name).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const auto visit = [](hid_t, const char* path, const H5O_info_t* info, void*) -> herr_t {
      BOOST_TEST((info->ctime == 0 && info->mtime == 0 && info->btime == 0), path);
      return 0;
    };
    H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_NATIVE, visit, nullptr, H5O_INFO_TIME);
    H5Fclose(file);
  }
  // Waits for the next second.
  const std::time_t began = std::time(nullptr);
  while (std::time(nullptr) == began) ::usleep(20000);
  results::write(folder / "later.h5", example.content, false);
  kept(folder / "two.h5");
  BOOST_TEST((folder.read("r.h5") == folder.read("later.h5")));
  BOOST_TEST((folder.read("one.h5") == folder.read("two.h5")));
}

// The file that is replaced is not read: it may be larger than the memory.
BOOST_AUTO_TEST_CASE(the_old_file_is_not_read) {
  const support::TemporaryFolder folder;
  const Example example;
  constexpr long large = 1L << 30;
  std::filesystem::resize_file(folder.write("r.h5", "x"), large);
  const auto most_kilobytes = [] {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  const long before = most_kilobytes();
  results::write(folder / "r.h5", example.content, true);
  BOOST_TEST_MESSAGE(most_kilobytes() - before << " kB more for writing over a file of 1 GB");
  BOOST_TEST(most_kilobytes() - before < 100000);
  BOOST_TEST(results::ResultFile(folder / "r.h5").numbers("/summary/converged").values[0] == 1.0);
}

BOOST_AUTO_TEST_CASE(files_that_are_no_results) {
  const support::TemporaryFolder folder;
  const Example example;
  results::write(folder / "r.h5", example.content, false);
  const std::string whole = folder.read("r.h5");
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{7}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
    const std::string reason = refusal(folder.write("cut.h5", whole.substr(0, length)));
    BOOST_TEST_MESSAGE(length << " bytes: " << reason);
    BOOST_TEST(reason.find("cut.h5: cannot be read") != std::string::npos, reason);
  }
  BOOST_TEST(refusal(folder.write("text.h5", "hello")).find("not an HDF5 file") != std::string::npos);
  BOOST_TEST(refusal(folder / "missing.h5").find("No such file") != std::string::npos);
  BOOST_TEST(refusal(folder.path()).find("directory") != std::string::npos);

  const std::string foreign = folder / "foreign.h5";
  H5Fclose(H5Fcreate(foreign.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  BOOST_TEST(refusal(foreign).find("not a result of ehl") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(xdmf_names_the_datasets_and_is_escaped) {
  const support::TemporaryFolder folder;
  const Example example;
  results::write(folder / "r.h5", example.content, false);
  const std::string text = folder.read("r.xmf");
  for (const char* part : {"Dimensions=\"3 5\"", "r.h5:/fields/P", "r.h5:/grid/x", "an &lt;example&gt; &amp; more"})
    BOOST_TEST(text.find(part) != std::string::npos, part);
  BOOST_TEST(results::xdmf_name("a.b/c.h5") == "a.b/c.xmf");
  Example in_si;
  in_si.content.si = {{"p_h", "Pa", 2e9}, {"a", "m", 1e-4}};
  results::write(folder / "s.h5", in_si.content, false);
  const std::string si = folder.read("s.xmf");
  for (const char* part :
       {"Name=\"P_Pa\"", "Function=\"2000000000.0000000 * $0\"", "Function=\"0.00010000000", "s.h5:/fields/P"})
    BOOST_TEST(si.find(part) != std::string::npos, part);
}

BOOST_AUTO_TEST_SUITE_END()
