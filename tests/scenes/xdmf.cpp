// The XDMF file of a run in time, read by independent readers: the XDMF library, and VTK's reader if it is installed.
#include <XdmfAttribute.hpp>
#include <XdmfDomain.hpp>
#include <XdmfGridCollection.hpp>
#include <XdmfReader.hpp>
#include <XdmfRectilinearGrid.hpp>
#include <XdmfTime.hpp>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

#include "results/read.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

namespace {

const std::string deck =
    "[case]\ntitle = a <run> & its times\n[contact]\nM = 20\nL = 5\n[lubricant]\nalpha = 2e-8\n[domain]\nx_inlet = "
    "-3\nx_outlet = 1.5\ny_half = 2\n[grid]\ncells = 64\n"
    "[transient]\nend_time = 0.5\noutput_interval = 0.125\nload = 0:1 0.1:1 0.3:1.5\n";

// Prints "time, P at some nodes" for every time, as read by VTK.
const std::string vtk =
    "import sys\n"
    "from vtkmodules.vtkIOXdmf2 import vtkXdmfReader\n"
    "from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline\n"
    "reader = vtkXdmfReader(); reader.SetFileName(sys.argv[1]); reader.UpdateInformation()\n"
    "info = reader.GetOutputInformation(0); steps = pipeline.TIME_STEPS()\n"
    "for k in range(info.Length(steps)):\n"
    "    time = info.Get(steps, k); reader.UpdateTimeStep(time)\n"
    "    P = reader.GetOutputDataObject(0).GetPointData().GetArray('P')\n"
    "    print(repr(time), P.GetNumberOfTuples(), *[repr(P.GetTuple1(i)) for i in range(0, P.GetNumberOfTuples(), "
    "97)])\n";

struct Scene {
  support::TemporaryFolder folder;
  Scene() {
    folder.write("d.ini", deck);
    const support::Ended ended = support::ehl(folder, "run d.ini --quiet");
    BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(test_xdmf)

BOOST_AUTO_TEST_CASE(the_library_reads_every_time) {
  const Scene scene;
  const ehl::results::ResultFile file(scene.folder / "d.h5");
  const std::vector<double> times = file.numbers("/transient/frames/time").values;
  BOOST_REQUIRE(times.size() == 5u);
  const auto domain = shared_dynamic_cast<XdmfDomain>(XdmfReader::New()->read(scene.folder / "d.xmf"));
  BOOST_REQUIRE(domain->getNumberGridCollections() == 1u);
  BOOST_TEST(domain->getNumberRectilinearGrids() == 0u);  // the start is among the times
  const auto collection = domain->getGridCollection(0);
  BOOST_TEST(collection->getName() == "a <run> & its times");
  BOOST_REQUIRE(collection->getNumberRectilinearGrids() == times.size());
  for (unsigned k = 0; k < times.size(); ++k) {
    const auto grid = collection->getRectilinearGrid(k);
    BOOST_TEST(grid->getTime()->getValue() == times[k]);
    for (const char* name : {"P", "H"}) {
      const std::vector<double> written = file.frame(std::string("/transient/frames/") + name, k).values;
      const auto read = grid->getAttribute(name);
      read->read();
      BOOST_REQUIRE(read->getSize() == written.size());
      std::size_t differing = 0;
      for (unsigned i = 0; i < written.size(); ++i) differing += read->getValue<double>(i) == written[i] ? 0 : 1;
      BOOST_TEST(differing == 0u, name << " at time " << times[k] << ": " << differing << " values differ");
    }
  }
}

// A contact in SI: fields in Pa and m, places in m, times in s.
BOOST_AUTO_TEST_CASE(a_contact_in_si_is_in_si) {
  const support::TemporaryFolder folder;
  folder.write("si.ini",
               "[contact]\nload = 20\nradius_x = 0.01\nE_prime = 2.3e11\n[motion]\nu_m = 1\n[lubricant]\neta0 = "
               "0.04\nalpha = 2e-8\n[domain]\nx_inlet = -3\nx_outlet = 1.5\ny_half = 2\n[grid]\ncells = 64\n"
               "[transient]\nend_time = 0.25\noutput_interval = 0.125\nload = 0:1 0.1:1 0.3:1.5\n");
  const support::Ended ended = support::ehl(folder, "run si.ini --quiet");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  const ehl::results::ResultFile file(folder / "si.h5");
  const auto scale = [&](const char* name) { return file.numbers(std::string("/scales/") + name).values.at(0); };
  const double p_h = scale("p_h"), a = scale("a"), height = scale("h");
  const double second = a / 1.0;  // a/u_m at 1 m/s
  const std::vector<double> times = file.numbers("/transient/frames/time").values;
  const auto domain = shared_dynamic_cast<XdmfDomain>(XdmfReader::New()->read(folder / "si.xmf"));
  const auto collection = domain->getGridCollection(0);
  BOOST_REQUIRE(collection->getNumberRectilinearGrids() == times.size());
  const auto agrees = [](const shared_ptr<XdmfArray>& read, const std::vector<double>& written, double factor,
                         const std::string& name) {
    read->read();
    BOOST_REQUIRE_MESSAGE(read->getSize() == written.size(), name << " has " << read->getSize() << " values");
    double worst = 0.0;
    for (unsigned i = 0; i < written.size(); ++i)
      worst = std::max(worst, std::abs(read->getValue<double>(i) - factor * written[i]));
    const double largest = factor * std::abs(*std::ranges::max_element(written));
    BOOST_TEST(worst <= 1e-14 * largest, name << " differs by " << worst << " of " << largest);
  };
  for (unsigned k = 0; k < times.size(); ++k) {
    const auto grid = collection->getRectilinearGrid(k);
    BOOST_TEST(std::abs(grid->getTime()->getValue() - times[k] * second) <= 1e-14 * second);
    BOOST_REQUIRE((grid->getAttribute("P_Pa") && grid->getAttribute("H_m")));
    agrees(grid->getAttribute("P_Pa"), file.frame("/transient/frames/P", k).values, p_h, "P_Pa");
    agrees(grid->getAttribute("H_m"), file.frame("/transient/frames/H", k).values, height, "H_m");
    agrees(grid->getCoordinates(0), file.numbers("/grid/x").values, a, "x");
    agrees(grid->getCoordinates(1), file.numbers("/grid/y").values, a, "y");
  }
}

BOOST_AUTO_TEST_CASE(vtk_reads_every_time) {
  const Scene scene;
  if (support::shell(scene.folder, "/usr/bin/python3 -c 'import vtkmodules.vtkIOXdmf2'").status != 0) {
    BOOST_TEST_MESSAGE("VTK's reader of XDMF is not installed (Debian: python3-paraview, 900 MB): not tried");
    return;
  }
  const support::Ended ended =
      support::shell(scene.folder, "/usr/bin/python3 '" + scene.folder.write("read.py", vtk) + "' d.xmf");
  BOOST_TEST(ended.err.empty(), ended.err);
  const ehl::results::ResultFile file(scene.folder / "d.h5");
  const std::vector<double> times = file.numbers("/transient/frames/time").values;
  std::istringstream lines(ended.out);
  unsigned k = 0;
  for (std::string line; std::getline(lines, line); ++k) {
    std::istringstream numbers(line);
    double time = 0.0, P = 0.0;
    std::size_t count = 0, i = 0;
    numbers >> time >> count;
    BOOST_REQUIRE(k < times.size());
    const std::vector<double> written = file.frame("/transient/frames/P", k).values;
    BOOST_TEST(time == times[k]);
    BOOST_REQUIRE(count == written.size());
    for (; numbers >> P; i += 97) BOOST_TEST(P == written[i]);
  }
  BOOST_TEST(k == times.size());
}

BOOST_AUTO_TEST_SUITE_END()
