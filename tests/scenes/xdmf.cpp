// The XDMF file of a run in time, read by independent readers: the XDMF library, and VTK's reader if it is installed.
#include <XdmfAttribute.hpp>
#include <XdmfDomain.hpp>
#include <XdmfGridCollection.hpp>
#include <XdmfReader.hpp>
#include <XdmfRectilinearGrid.hpp>
#include <XdmfTime.hpp>
#include <boost/test/unit_test.hpp>
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
