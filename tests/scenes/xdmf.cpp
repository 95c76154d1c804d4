// The XDMF file beside a run in time: every time of it, by VTK's reader where that is installed.
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

// Prints "time, P at some nodes" of every time, as VTK's reader has them.
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

BOOST_AUTO_TEST_SUITE(xdmf)

BOOST_AUTO_TEST_CASE(a_collection_in_time_names_every_field) {
  const Scene scene;
  const std::string text = scene.folder.read("d.xmf");
  BOOST_TEST(
      support::contains(text, "a &lt;run&gt; &amp; its times\" GridType=\"Collection\" CollectionType=\"Temporal\""));
  for (const char* time : {"0", "0.125", "0.25", "0.375", "0.5"})
    BOOST_TEST(support::contains(text, std::string("<Time Value=\"") + time + "\"/>"), time);
  // Plane 4 of five; VTK wants a slab of as many dimensions as the grid.
  const std::string nodes = "57 65";  // along y, along x
  BOOST_TEST(support::contains(text, ">4 0 0 1 1 1 1 " + nodes + "</DataItem>"), text);
  BOOST_TEST(!support::contains(text, "/fields/"));  // those of the start
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
