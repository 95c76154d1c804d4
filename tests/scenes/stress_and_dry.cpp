// Stresses below the contact, and contacts without lubricant, through the program.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/columns.hpp"
#include "support/json.hpp"
#include "support/refused.hpp"
#include "support/text.hpp"

namespace {

using support::rows_of;

const std::string oiled =
    "[contact]\nM = 50\nL = 10\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n"
    "[domain]\nx_inlet = -4.5\nx_outlet = 1.5\ny_half = 3\n[grid]\ncells = 64\n";
const std::string dry = "[case]\nkind = dry\n[grid]\ncells = 64\n";
const std::string stresses = "[subsurface]\ndepth = 1.5\nplanes = 21\n";

using support::contains;

double number(const support::TemporaryFolder& folder, const std::string& file, const std::string& name) {
  const support::Ended extracted = support::ehl(folder, "extract " + file + " " + name);
  BOOST_REQUIRE_MESSAGE(extracted.status == 0, extracted.err);
  return std::stod(extracted.out.substr(extracted.out.find('\n')));
}

std::string values(const support::TemporaryFolder& folder, const std::string& file, const std::string& name) {
  const std::string out = support::ehl(folder, "extract " + file + " " + name).out;
  return out.substr(out.find('\n'));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_stress_and_dry)

BOOST_AUTO_TEST_CASE(what_is_wrong_is_refused) {
  support::check_refused({
      {"no depth", oiled + "[subsurface]\nfriction = 0.1\n", {"d.ini:14", "friction"}},
      {"above the surface", oiled + "[subsurface]\ndepth = -1\n", {"d.ini:14", "depth = -1"}},
      {"no solid", oiled + stresses + "poisson = 0.7\n", {"d.ini:16", "poisson = 0.7", "0.5"}},
      {"one plane", oiled + "[subsurface]\ndepth = 1\nplanes = 1\n", {"planes = 1"}},
      {"unknown stress", oiled + stresses + "fields = mises\n", {"fields"}},
      {"in time", oiled + stresses + "[transient]\nend_time = 1\n", {"depth = 1.5", "[transient]"}},
      {"no memory",
       "[case]\nkind = dry\n[grid]\ncells = 4096\n[subsurface]\ndepth = 1\nplanes = 1000\ncells = 4096\n",
       {"planes = 1000"}},
      {"neither", "[case]\nkind = wet\n", {"d.ini:2", "kind = wet"}},
      {"a dry film", dry + "[contact]\nM = 50\nL = 10\n", {"d.ini:6", "M = 50", "kind = dry", "d.ini:7", "L = 10"}},
      {"a dry line",
       dry + "[contact]\nkind = line\nload_per_length = 2e5\nradius_x = 0.01\nE_prime = 227e9\n",
       {"kind = line", "load_per_length = 2e5"}},
      {"dry oil", dry + "[lubricant]\neta0 = 0.1\n", {"d.ini:6", "eta0"}},
      {"dry cycles", dry + "[multigrid]\ncycle = V\n", {"d.ini:6", "cycle = V"}},
      {"dry far field", dry + "[domain]\nfar_field = zero\n", {"d.ini:6", "far_field = zero"}},
      {"dry motion", dry + "[motion]\nu_m = 1\n", {"d.ini:6", "u_m = 1"}},
      {"dry in time", dry + "[transient]\nend_time = 1\n", {"d.ini:6", "end_time = 1"}},
      {"dry fields", dry + "[output]\nfields = P\n", {"d.ini:6", "fields = P"}},
      {"half a contact", dry + "[contact]\nload = 1\nradius_x = 0.01\n", {"E_prime"}},
      {"a negative modulus",
       dry + "[contact]\nload = 1\nradius_x = 0.01\nE_prime = -2e11\n",
       {"d.ini:8", "E_prime = -2e11"}},
      {"wrong units", dry + "[contact]\nload = 1\nradius_x = 10\nE_prime = 200\n", {"load = 1"}},
      {"dry keys in oil", oiled + "[dry]\ntolerance = 1e-6\n", {"d.ini:14", "tolerance"}},
      {"no tolerance", dry + "[dry]\ntolerance = 0\n", {"d.ini:6", "tolerance = 0"}},
      {"coarse", "[case]\nkind = dry\n[grid]\ncells = 17\n[domain]\nx_inlet = -50\n", {"cells = 17"}},
  });
}

BOOST_AUTO_TEST_CASE(dry_hertz_and_its_stresses) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", dry + stresses +
                            "[contact]\nload = 15\nradius_x = 0.0125\nE1 = 206e9\nnu1 = 0.3\nE2 = 81e9\n"
                            "nu2 = 0.208\n");
  const support::Ended ended = support::ehl(folder, "run d.ini --quiet");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  BOOST_TEST(ended.err.empty(), ended.err);
  BOOST_TEST(contains(ended.out, "0.4132 GPa"), ended.out);
  const double P_max = number(folder, "d.h5", "P_max"), H00 = number(folder, "d.h5", "H00");
  const double largest = number(folder, "d.h5", "/subsurface/largest_tau_max");
  const double depth = number(folder, "d.h5", "/subsurface/largest_tau_max_z");
  BOOST_TEST_MESSAGE("P_max " << P_max << " (1), H00 " << H00 << " (-1), tau_max " << largest << " (0.3100) at "
                              << depth << " (0.4809)");
  BOOST_TEST(std::abs(P_max - 1.0) < 1e-3);
  BOOST_TEST(std::abs(H00 + 1.0) < 1e-3);
  BOOST_TEST(std::abs(largest / 0.3100 - 1.0) < 0.005);
  BOOST_TEST(std::abs(depth / 0.4809 - 1.0) < 0.01);
  BOOST_TEST(number(folder, "d.h5", "converged") == 1.0);
  BOOST_TEST(std::abs(number(folder, "d.h5", "/scales/p_h") / 413.2e6 - 1.0) < 1e-3);
}

BOOST_AUTO_TEST_CASE(the_stresses_in_a_file) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", dry + stresses);
  BOOST_REQUIRE(support::ehl(folder, "run d.ini").status == 0);
  // On the axis, the section and the planes agree: -1/(1 + z^2), to single precision.
  const auto axis = rows_of(support::ehl(folder, "extract d.h5 /subsurface/section/sigma_z --along z --at x=0").out);
  const auto mises = rows_of(support::ehl(folder, "extract d.h5 /subsurface/section/sigma_mises --along z").out);
  BOOST_REQUIRE(axis.size() == 21U);
  double error = 0.0, difference = 0.0;
  for (std::size_t k = 0; k < axis.size(); ++k) {
    error = std::max(error, std::abs(axis[k][1] + 1.0 / (1.0 + axis[k][0] * axis[k][0])));
    const std::string step = std::to_string(k);
    const auto plane = rows_of(support::ehl(folder, "extract d.h5 sigma_mises --step " + step + " --along x").out);
    difference = std::max(difference, std::abs(plane[32][1] - mises[k][1]));
  }
  BOOST_TEST_MESSAGE("sigma_z on the axis " << error << " (2e-3), section against planes " << difference << " (1e-7)");
  BOOST_TEST(error < 2e-3);
  BOOST_TEST(difference < 1e-7);
  const support::Ended all = support::ehl(folder, "extract d.h5 sigma_mises --along x --at y=0");
  BOOST_TEST(contains(all.out, "# z x sigma_mises"), all.out.substr(0, 200));
  BOOST_TEST(rows_of(all.out).size() == 21U * 65U);
  BOOST_TEST(support::ehl(folder, "extract d.h5 /subsurface/section/sigma_z --along y").status == 2);
  BOOST_TEST(contains(support::ehl(folder, "extract d.h5 /subsurface").out, "largest_sigma_mises_z"));
  const std::string xdmf = folder.read("d.xmf");
  BOOST_TEST(contains(xdmf, "3DRectMesh\" Dimensions=\"21 65 65\""));
  BOOST_TEST(contains(xdmf, "d.h5:/subsurface/tau_max"));
}

BOOST_AUTO_TEST_CASE(a_lubricated_contact_is_the_same_with_and_without) {
  const support::TemporaryFolder folder;
  folder.write("with.ini", oiled + stresses);
  folder.write("without.ini", oiled);
  BOOST_REQUIRE(support::ehl(folder, "run with.ini --threads 2").status == 0);
  BOOST_REQUIRE(support::ehl(folder, "run without.ini --threads 1").status == 0);
  for (const char* field : {"P", "H"})
    BOOST_TEST((values(folder, "with.h5", field) == values(folder, "without.h5", field)), field << " differs");
  BOOST_TEST(support::ehl(folder, "extract without.h5 /subsurface").status == 2);
  BOOST_TEST(!contains(support::ehl(folder, "extract without.h5 deck").out, "subsurface"));
  BOOST_TEST(!contains(folder.read("without.xmf"), "subsurface"));
  const support::Ended json = support::ehl(folder, "run with.ini --json --overwrite");
  BOOST_TEST(support::is_json(json.out));
  BOOST_TEST(contains(json.out, "\"subsurface\":{\"sigma_mises\":{\"value\":0.6"), json.out);
  const support::Ended checked = support::ehl(folder, "check with.ini");
  BOOST_TEST(contains(checked.out, "[subsurface] depth = 1.5"), checked.out);
  for (const char* part : {"65 x 65", "21 planes"}) BOOST_TEST(contains(checked.out, part), checked.out);
}

// Heavily loaded and isoviscous, the pressure is that of Hertz except at its ends: tau_max = 0.3003 at z = 0.7862.
BOOST_AUTO_TEST_CASE(below_a_line_contact) {
  const support::TemporaryFolder folder;
  folder.write("d.ini",
               "[contact]\nkind = line\nM = 1000\nL = 0\n[lubricant]\nviscosity = isoviscous\ndensity = "
               "incompressible\n[subsurface]\ndepth = 2\ncells = 512\n");
  const support::Ended ended = support::ehl(folder, "run d.ini --quiet");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  BOOST_TEST(contains(ended.out, "41 planes"), ended.out);
  const double largest = number(folder, "d.h5", "/subsurface/largest_tau_max");
  const double depth = number(folder, "d.h5", "/subsurface/largest_tau_max_z");
  BOOST_TEST_MESSAGE("tau_max " << largest << " (0.3003) at " << depth << " (0.7862)");
  BOOST_TEST(std::abs(largest / 0.3003 - 1.0) < 0.003);
  BOOST_TEST(std::abs(depth / 0.7862 - 1.0) < 0.01);
  // A file contains one line: as many values as nodes and planes.
  const auto rows = rows_of(support::ehl(folder, "extract d.h5 tau_max --along x --at y=0").out);
  const auto x = rows_of(support::ehl(folder, "extract d.h5 /subsurface/x").out);
  BOOST_TEST(rows.size() == 41U * x.size());
}

BOOST_AUTO_TEST_CASE(the_deck_in_a_result_gives_the_same_result) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", dry + stresses +
                            "friction = 0.2\n[dry]\ntolerance = 1e-9\n[contact]\nload = 15\n"
                            "radius_x = 0.0125\nE_prime = 110e9\n");
  BOOST_REQUIRE(support::ehl(folder, "run d.ini --output one.h5 --threads 1").status == 0);
  folder.write("again.ini", support::ehl(folder, "extract one.h5 deck").out);
  const support::Ended again = support::ehl(folder, "run again.ini --output two.h5 --threads 2");
  BOOST_REQUIRE_MESSAGE(again.status == 0, again.err);
  for (const char* field : {"P", "gap", "/subsurface/section/tau_xz"})
    BOOST_TEST((values(folder, "one.h5", field) == values(folder, "two.h5", field)), field << " differs");
}

BOOST_AUTO_TEST_CASE(dry_without_convergence) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", dry);
  const support::Ended hasty = support::ehl(folder, "run d.ini --set dry.max_iterations=2");
  BOOST_TEST(hasty.status == 3);
  BOOST_TEST(hasty.says({"64 x 64"}), hasty.err);
  BOOST_TEST(number(folder, "d.h5", "converged") == 0.0);
  const support::Ended narrow =
      support::ehl(folder, "run d.ini --overwrite --json --set domain.x_inlet=-1.01 --set domain.x_outlet=0.9999");
  BOOST_TEST(narrow.status == 2, narrow.err);
  const support::Ended kept = support::ehl(folder, "run d.ini");
  BOOST_TEST(kept.status == 4, kept.err);
  const support::Ended json = support::ehl(folder, "run d.ini --overwrite --json");
  BOOST_TEST(json.status == 0);
  BOOST_TEST(support::is_json(json.out));
  BOOST_TEST(contains(json.out, "\"kind\":\"dry\""));
  // Commands that compare films refuse a dry contact; a sweep records it as refused cases.
  const support::Ended study = support::ehl(folder, "study d.ini");
  BOOST_TEST(study.status == 2);
  BOOST_TEST(study.says({"kind = dry"}), study.err);
  const support::Ended sweep = support::ehl(folder, "sweep d.ini --vary grid.cells=32,64");
  BOOST_TEST(sweep.status == 2);
  BOOST_TEST(sweep.says({"grid.cells=32", "kind = dry"}), sweep.err);
  BOOST_TEST(contains(folder.read("d_sweep.csv"), "kind = dry"));
}

BOOST_AUTO_TEST_SUITE_END()
