// Limits of a machine or a batch system: memory, CPU time, folders.
#include <boost/test/unit_test.hpp>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(test_limits_of_machine)

namespace {

const std::string program = std::string("'") + EHL_PROGRAM + "' ";
const std::string deck = "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\n[grid]\ncells = 64\n";

}  // namespace

// A lack of memory causes a message and a status, in every thread and every library, but never a signal.
BOOST_AUTO_TEST_CASE(little_memory) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  BOOST_TEST_REQUIRE(support::ehl(folder, "run d.ini --quiet --output r.h5").status == 0);
  const std::string in_time = " --set transient.end_time=0.05 --set domain.far_field=zero";
  for (const std::string& command :
       {std::string("run d.ini --quiet --overwrite"), "run d.ini --quiet --overwrite" + in_time,
        std::string("run d.ini --quiet --overwrite --set grid.cells=256 --threads 2"), std::string("plot r.h5"),
        std::string("report r.h5 --overwrite"), std::string("extract r.h5 P --along x")})
    for (const int kilobytes : {40000, 50000, 60000, 75000, 100000}) {
      const support::Ended ended =
          support::shell(folder, "ulimit -c 0; ulimit -v " + std::to_string(kilobytes) + "; " + program + command);
      BOOST_TEST((ended.status == 0 || ended.status == 1 || ended.status == 4 || ended.status == 127),
                 command << " with " << kilobytes << " kB ends with " << ended.status << ": " << ended.err);
      if (ended.status != 0) BOOST_TEST(!ended.err.empty(), command);
    }
}

// A batch system's limit of CPU time acts like Ctrl-C; a run in time writes a checkpoint.
BOOST_AUTO_TEST_CASE(limit_of_cpu_time) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  for (const char* signal : {"XCPU", "HUP"}) {
    const support::Ended ended = support::shell(
        folder, program +
                    "run d.ini --quiet --overwrite --set grid.cells=1024 --set multigrid.tolerance=1e-13 & p=$!; " +
                    support::until_it_handles_signals + "kill -" + signal + " $p; wait $p");
    BOOST_TEST(ended.status == 130, signal << " ends with " << ended.status);
  }
}

BOOST_AUTO_TEST_CASE(a_working_folder_that_is_gone) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  folder.write("m.csv", "srr,mu\n0.1,0.02\n0.2,0.03\n");
  BOOST_TEST_REQUIRE(support::ehl(folder, "run d.ini --quiet --output r.h5").status == 0);
  for (const char* command :
       {"run ../d.ini", "sweep ../d.ini --vary contact.M=2,3", "study ../d.ini",
        "fit ../d.ini --measured ../m.csv --free friction.limit", "run d.ini", "sweep $D/d.ini --vary contact.M=2,3",
        "run $D/d.ini", "plot $D/r.h5 --output x.png", "report $D/r.h5 --output x.html"}) {
    const support::Ended ended =
        support::shell(folder, "D=$PWD; mkdir gone && cd gone && rmdir ../gone && " + program + command);
    BOOST_TEST((ended.status == 2 || ended.status == 4), command << " ends with " << ended.status << ": " << ended.err);
    BOOST_TEST(ended.err.find("internal") == std::string::npos, ended.err);
  }
}

BOOST_AUTO_TEST_CASE(a_free_key_that_there_is_not) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  folder.write("m.csv", "srr,mu\n0.1,0.02\n0.2,0.03\n");
  for (const char* key : {"shaer.tau_0", "shear.tau0", "tau_0", ".", "shear."}) {
    const support::Ended ended = support::ehl(folder, std::string("fit d.ini --measured m.csv --free ") + key);
    BOOST_TEST(ended.status == 2, key << " ends with " << ended.status);
    BOOST_TEST(ended.says({std::string("--free ") + key}), ended.err);
  }
}

BOOST_AUTO_TEST_SUITE_END()
