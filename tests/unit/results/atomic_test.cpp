#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>

#include "core/errors.hpp"
#include "results/atomic_file.hpp"
#include "results/outputs.hpp"
#include "support/temporary_folder.hpp"
#include "support/text.hpp"

using namespace ehl;

namespace {

void write(const std::string& path, const std::string& text, bool overwrite) {
  results::write_atomically(path, std::as_bytes(std::span(text)), overwrite);
}

using support::contains;
using support::refusal;

}  // namespace

BOOST_AUTO_TEST_SUITE(test_results_atomic)

BOOST_AUTO_TEST_CASE(writes_and_replaces_only_on_request) {
  const support::TemporaryFolder folder;
  write(folder / "f", "old", false);
  BOOST_TEST(folder.read("f") == "old");
  BOOST_TEST(contains(refusal<core::FileError>([&] { write(folder / "f", "new", false); }), "not overwritten"));
  BOOST_TEST(folder.read("f") == "old");
  write(folder / "f", "new", true);
  BOOST_TEST(folder.read("f") == "new");
  BOOST_TEST(folder.entries() == 1);
}

// A limit on the file size has the effect of a full disk: the write fails in the middle.
BOOST_AUTO_TEST_CASE(a_write_that_fails_leaves_the_old_file_and_no_half_one) {
  const support::TemporaryFolder folder;
  write(folder / "f", "old", false);
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 1000;
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string reason = refusal<core::FileError>([&] { write(folder / "f", std::string(5000, 'x'), true); });
  setrlimit(RLIMIT_FSIZE, &before);
  BOOST_TEST(contains(reason, "cannot be written: File too large"), reason);
  BOOST_TEST(folder.read("f") == "old");
  BOOST_TEST(folder.entries() == 1);
}

BOOST_AUTO_TEST_CASE(outputs_refused_before_the_work) {
  const support::TemporaryFolder folder;
  const std::string existing = folder.write("there.h5", "x");
  const auto reason = [](const std::string& path, bool overwrite = false, std::size_t bytes = 10) {
    return refusal<core::FileError>([&] { results::check_writable(path, overwrite, bytes); });
  };
  BOOST_TEST(contains(reason(existing), "--overwrite"));
  BOOST_TEST(reason(existing, true) == "(none)");
  BOOST_TEST(reason(folder / "new.h5") == "(none)");
  BOOST_TEST(contains(reason(folder.path(), true), "directory"));
  BOOST_TEST(contains(reason(folder / "none/f.h5"), "no folder"));
  BOOST_TEST(contains(reason("/dev/null", true), "not a regular file"));
  BOOST_TEST(contains(reason("/proc/f.h5"), "cannot be written"));
  BOOST_TEST(contains(reason(folder / "new.h5", false, std::size_t{1} << 60), "the disk has room"));
  BOOST_TEST(contains(reason(""), "empty"));
  BOOST_TEST(folder.entries() == 1);
}

// A file that the command reads is never written, by whatever path it is reached; nor is a file of a
// kind other than the output.
BOOST_AUTO_TEST_CASE(no_input_and_no_foreign_file_is_replaced) {
  using results::FileKind;
  const support::TemporaryFolder folder;
  folder.write("t.csv", "# ehl sweep, table 1\n");
  std::filesystem::create_symlink("t.csv", folder / "soft.csv");
  std::filesystem::create_hard_link(folder / "t.csv", folder / "hard.csv");
  const auto reason = [](const std::vector<std::string>& inputs, const std::vector<results::Output>& outputs) {
    return refusal<core::FileError>([&] { results::check_files(inputs, outputs); });
  };
  for (const char* name : {"t.csv", "soft.csv", "hard.csv", "./t.csv"})
    BOOST_TEST(contains(reason({folder / "t.csv"}, {{folder / name, FileKind::table, true}}), "is read by this run"));
  BOOST_TEST(
      contains(reason({}, {{folder / "t.csv", FileKind::table, true}, {folder / "soft.csv", FileKind::table, true}}),
               "is the same file"));
  BOOST_TEST(reason({folder / "other"}, {{folder / "t.csv", FileKind::table, true}}) == "(none)");

  struct Kind {
    FileKind kind;
    std::string own;  // the beginning of a file of this kind
  };
  const Kind kinds[] = {{FileKind::table, "# ehl study in time, table 1\n"},
                        {FileKind::xdmf, "<?xml version=\"1.0\" ?>\n<Xdmf>"},
                        {FileKind::page, "<!DOCTYPE html>\n<p>Page written by ehl 1.2, commit"},
                        {FileKind::picture, "\x89PNG\r\n"},
                        {FileKind::result, ""},
                        {FileKind::kept_results, ""}};
  for (const Kind& one : kinds) {
    const std::string path = folder.write("f", "precious, 1\n");
    BOOST_TEST(contains(reason({}, {{path, one.kind, true}}), "not overwritten"), one.own);
    BOOST_TEST(folder.read("f") == "precious, 1\n");
    folder.write("f", one.own);
    BOOST_TEST(reason({}, {{path, one.kind, true}}) == "(none)", one.own);
  }
}

BOOST_AUTO_TEST_CASE(a_link_stays_and_its_file_is_replaced) {
  const support::TemporaryFolder folder;
  write(folder / "f", "old", false);
  std::filesystem::create_symlink("f", folder / "link");
  std::filesystem::create_symlink("new", folder / "open");
  write(folder / "link", "new", true);
  BOOST_TEST(folder.read("f") == "new");
  BOOST_TEST(std::filesystem::is_symlink(folder / "link"));
  write(folder / "open", "made", false);
  BOOST_TEST(folder.read("new") == "made");
  std::filesystem::create_symlink("/dev/null", folder / "device");
  BOOST_TEST(contains(refusal<core::FileError>([&] { write(folder / "device", "x", true); }), "not a regular file"));
  std::filesystem::create_symlink("circle", folder / "circle");
  BOOST_TEST(contains(refusal<core::FileError>([&] { write(folder / "circle", "x", true); }), "symbolic links"));
}

// A killed process leaves its temporary file, which the next process removes. The file of another running process
// stays, and links at this place are not followed.
BOOST_AUTO_TEST_CASE(temporary_files_of_killed_runs_go) {
  const support::TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  folder.write(".f." + std::to_string(child) + ".part", "half");
  folder.write(".f.1.part", "of a process that lives");
  folder.write(".f.x.part", "of nobody");
  folder.write("precious", "x");
  std::filesystem::create_symlink("precious", folder / (".f." + std::to_string(::getpid()) + ".part"));
  BOOST_TEST(
      contains(refusal<core::FileError>([&] { results::check_writable(folder / "f", false, 0); }), "File exists"));
  BOOST_TEST(folder.entries() == 4);
  BOOST_TEST(folder.read("precious") == "x");
}

BOOST_AUTO_TEST_SUITE_END()
