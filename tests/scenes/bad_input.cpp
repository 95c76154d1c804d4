// Bad input gives exit status 2 and a message with file, line, key and remedy. Nothing is solved here.
#include <unistd.h>

#include <boost/test/unit_test.hpp>

#include "support/refused.hpp"

namespace {

const std::string moes = "[contact]\nM = 50\nL = 10\n";
const std::string oil = "[lubricant]\nalpha = 1.7e-8\nz = 0.6\n";
const std::string steel =
    "[contact]\nload = 15\nradius_x = 0.0125\nE_prime = 110e9\n[motion]\nu_m = 0.09\n"
    "[lubricant]\neta0 = 0.25\nalpha = 22e-9\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(test_bad_input)

BOOST_AUTO_TEST_CASE(names_and_values) {
  support::check_refused({
      {"misspelt key", moes + oil + "[grid]\ncels = 64\n", {"d.ini:8", "[grid] cels = 64"}},
      {"misspelt section", moes + oil + "[gird]\ncells = 64\n", {"d.ini:7", "[gird]"}},
      {"nan", "[contact]\nM = nan\nL = 10\n" + oil, {"d.ini:2", "[contact] M = nan"}},
      {"inf", steel + "[domain]\nx_outlet = inf\n", {"d.ini:11", "x_outlet = inf"}},
      {"negative load", "[contact]\nload = -15\n", {"d.ini:2", "[contact] load = -15"}},
      {"text for a number", "[contact]\nM = fifty\nL = 10\n" + oil, {"d.ini:2", "M = fifty"}},
      {"unit suffix", "[contact]\nload = 15 N\n", {"d.ini:2"}},
      {"missing value", "[contact]\nM =\nL = 10\n" + oil, {"d.ini:2", "[contact] M"}},
      {"unknown law", moes + "[lubricant]\nviscosity = rolands\nalpha = 1e-8\n", {"d.ini:5", "viscosity = rolands"}},
      {"duplicate", moes + "M = 20\n" + oil, {"d.ini:4", "M = 20", "d.ini:2"}},
      {"no assignment", moes + oil + "nonsense\n", {"d.ini:7"}},
      {"checkpoint of nothing", moes + oil + "[output]\ncheckpoint = 1\n", {"d.ini:8", "checkpoint", "end_time"}},
      {"two grids", moes + oil + "[grid]\ncells = 256\naccuracy = 0.01\n", {"d.ini:9", "accuracy = 0.01"}},
      {"accuracy", moes + oil + "[grid]\naccuracy = 1\n", {"d.ini:8", "accuracy = 1", "0.5"}},
      {"empty section", moes + oil + "[domain]\n", {"d.ini:7", "[domain]", "x_inlet"}},
  });
}

BOOST_AUTO_TEST_CASE(line_contacts) {
  const std::string line = "[contact]\nkind = line\n";
  const std::string rest = "E_prime = 110e9\n[motion]\nu_m = 0.09\n[lubricant]\neta0 = 0.25\nalpha = 22e-9\n";
  const std::string bodies = "load_per_length = 1e5\nradius_x = 0.0125\n" + rest;
  const std::string numbers = line + "M = 20\nL = 5\n" + oil;
  support::check_refused({
      {"kind", "[contact]\nkind = lines\nM = 20\nL = 5\n" + oil, {"d.ini:2"}},
      {"load of a point", line + "load = 1e3\nradius_x = 0.0125\n" + rest, {"d.ini:3"}},
      {"load of a line", "[contact]\n" + bodies, {"load_per_length"}},
      {"negative", line + "load_per_length = -1\n", {"d.ini:3"}},
      {"radius_y", line + "radius_y = 0.1\n" + bodies, {"d.ini:3", "radius_y"}},
      {"radius_ratio", line + "radius_ratio = 0.1\nM = 20\nL = 5\n" + oil, {"radius_ratio"}},
      {"angle", numbers + "[motion]\nangle = 10\n", {"[motion] angle"}},
      {"y_half", numbers + "[domain]\ny_half = 2\n", {"[domain] y_half"}},
      {"dry", "[case]\nkind = dry\n" + line, {"[contact] kind"}},
      {"dimple",
       numbers + "[surface1]\nshape = dimple\nheight = 0.01\nwidth = 0.5\nat_rest = yes\n",
       {"[surface1] shape"}},
      {"in time with the far field of a steady one",
       numbers + "[transient]\nend_time = 1\n[domain]\nfar_field = closed\n",
       {"far_field = closed"}},
      {"a probe beside the line", numbers + "[transient]\nend_time = 1\n[output]\nprobe = 0 0.5\n", {"Y = 0"}},
  });
}

BOOST_AUTO_TEST_CASE(languages_and_groups) {
  support::check_refused({
      {"two languages", "[contact]\nM = 50\nL = 10\nload = 15\n" + oil, {"d.ini:4", "load = 15", "d.ini:2"}},
      {"a stray key", steel + "[contact]\nM = 50\n", {"d.ini:11", "M = 50"}},
      {"no language", oil, {"[contact] M"}},
      {"half a language", "[contact]\nM = 50\n" + oil, {"d.ini: [contact] L"}},
      {"no speed",
       "[contact]\nload = 1\nradius_x = 1\nE_prime = 1e11\n[lubricant]\neta0 = 1\nalpha = 1e-8\n",
       {"[motion] u_m"}},
      {"no moduli",
       "[contact]\nload = 1\nradius_x = 1\n[motion]\nu_m = 1\n[lubricant]\neta0 = 1\nalpha = 1e-8\n",
       {"E_prime"}},
      {"moduli twice", steel + "[contact]\nE1 = 1e11\n", {"d.ini:11", "E1 = 1e11"}},
      {"nearly a line", steel + "[contact]\nradius_y = 3\n", {"d.ini:11", "radius_y = 3"}},
      {"no radius", steel + "[contact]\nradius_y = 0\n", {"d.ini:11", "radius_y = 0"}},
      {"radius twice", steel + "[contact]\nradius_y = 0.02\nradius_ratio = 0.5\n", {"d.ini:12", "radius_ratio = 0.5"}},
      {"ratio out of range",
       "[contact]\nM = 50\nL = 10\nradius_ratio = 250\n" + oil,
       {"d.ini:4", "radius_ratio = 250", "200"}},
      {"negative ratio",
       "[contact]\nM = 50\nL = 10\nradius_ratio = -1\n" + oil,
       {"d.ini:4", "radius_ratio = -1", "0.005"}},
      {"angle without ellipse", moes + oil + "[motion]\nangle = 30\n", {"d.ini:8", "angle = 30", "radius_ratio"}},
      {"angle without ellipse in SI",
       steel + "[contact]\nradius_y = 0.0125\n[motion]\nangle = 30\n",
       {"d.ini:13", "angle = 30"}},
      {"angle too large",
       "[contact]\nM = 50\nL = 10\nradius_ratio = 0.5\n" + oil + "[motion]\nangle = 120\n",
       {"d.ini:9", "angle = 120", "90"}},
      {"against the inlet",
       "[contact]\nload = 1\nradius_x = 1\nE_prime = 1e11\n[motion]\nu1 = -2\nu2 = 1\n[lubricant]\neta0 = 1\nalpha = "
       "1e-8\n",
       {"d.ini:7"}},
      {"speed without use", moes + oil + "[motion]\nu_m = 1\n", {"d.ini:8", "u_m = 1"}},
      {"no alpha", moes, {"[lubricant] alpha"}},
      {"z for Barus",
       moes + "[lubricant]\nviscosity = barus\ndensity = incompressible\nz = 0.6\n",
       {"d.ini:7", "z = 0.6"}},
      {"L without use",
       moes + "[lubricant]\nviscosity = isoviscous\ndensity = incompressible\n",
       {"d.ini:3", "L = 10"}},
      {"continuation switched off and described",
       moes + oil + "[continuation]\npath = off\nM_start = 10\n",
       {"d.ini:9", "M_start = 10", "path = off"}},
      {"continuation from newtons",
       moes + oil + "[continuation]\nload_start = 10\n",
       {"d.ini:8", "load_start = 10", "M_start"}},
      {"continuation to where it is", moes + oil + "[continuation]\nM_start = 50\n", {"d.ini:8", "M_start = 50"}},
      {"a load that is carried far away",
       "[contact]\nM = 0.2\nL = 0\n[lubricant]\nviscosity = isoviscous\ndensity = incompressible\n[domain]\nfar_field "
       "= "
       "zero\n",
       {"[domain] x_inlet", "-189"}},
      {"wrong units",
       "[contact]\nload = 15\nradius_x = 12.5\nE_prime = 110\n[motion]\nu_m = 0.09\n[lubricant]\neta0 = 0.25\nalpha = "
       "22e-9\n",
       {"d.ini:2", "load = 15"}},
      {"thin oil",
       "[contact]\nload = 15\nradius_x = 0.0125\nE_prime = 110e9\n[motion]\nu_m = 30\n[lubricant]\neta0 = 1e-4\nalpha "
       "= 22e-9\n",
       {"d.ini:8", "eta0 = 1e-4"}},
  });
}

BOOST_AUTO_TEST_CASE(grids_and_domains) {
  const std::string good = moes + oil;
  support::check_refused({
      {"no cells", good + "[grid]\ncells = 0\n", {"d.ini:8", "cells = 0"}},
      {"77 cells", good + "[grid]\ncells = 77\n", {"d.ini:8", "[grid] cells = 77"}},
      {"too many cells", good + "[grid]\ncells = 1048576\n", {"d.ini:8", "cells = 1048576"}},
      {"beyond integers", good + "[grid]\ncells = 99999999999999999999\n", {"d.ini:8"}},
      {"not the coarsest's multiple", good + "[grid]\ncells = 64\ncoarsest = 24\n", {"d.ini:8"}},
      {"no inlet", good + "[domain]\nx_inlet = -0.5\n", {"d.ini:8", "x_inlet = -0.5"}},
      {"no outlet", good + "[domain]\nx_outlet = 0.9\n", {"d.ini:8", "x_outlet = 0.9"}},
      {"no sides of an ellipse",
       "[contact]\nM = 50\nL = 10\nradius_ratio = 0.2\n" + oil + "[domain]\ny_half = 2\n",
       {"d.ini:9", "y_half = 2", "2.89"}},
      {"no sides", good + "[domain]\ny_half = 1\n", {"d.ini:8", "y_half = 1"}},
      {"too coarse", good + "[domain]\nx_inlet = -100\n[grid]\ncells = 64\n", {"d.ini:10"}},
      {"a mile wide", good + "[domain]\ny_half = 1000\n[grid]\ncells = 65536\n", {"d.ini"}},
      {"far field too near",
       "[contact]\nM = 0.5\nL = 0\nradius_ratio = 0.4\n[lubricant]\nviscosity = isoviscous\ndensity = "
       "incompressible\n[domain]\nx_inlet = -12\n"
       "x_outlet = 8\ny_half = 10\n[grid]\ncells = 128\n",
       {"d.ini:9", "x_inlet = -12", "far_field = zero"}},
      {"odd order", good + "[deformation]\norder = 5\n", {"d.ini:8", "order = 5"}},
      {"coarsenings", good + "[grid]\ncells = 64\n[deformation]\ncoarsenings = 7\n", {"d.ini:10", "coarsenings = 7"}},
      {"order for FFT", good + "[deformation]\nmethod = fft\norder = 6\n", {"d.ini:9", "order = 6"}},
      {"first load without use", good + "[continuation]\npath = off\nM_start = 20\n", {"d.ini:9", "M_start = 20"}},
      {"first load in newtons", good + "[continuation]\nload_start = 3\n", {"d.ini:8", "load_start = 3"}},
      {"no relaxation", good + "[multigrid]\npre = 0\npost = 0\n", {"d.ini:8"}},
  });
}

BOOST_AUTO_TEST_CASE(all_slips_are_listed_at_once) {
  const support::TemporaryFolder folder;
  folder.write("d.ini",
               "[contact]\nM = 50\nlaod = 3\n[grid]\ncells = 77\n[lubricant]\nviscosity = water\n[thermal]\nk = 1\n");
  const support::Ended ended = support::ehl(folder, "check d.ini");
  BOOST_TEST(ended.status == 2);
  for (const char* part : {"laod", "cells = 77", "viscosity = water"})
    BOOST_TEST(ended.says({part}), part << " is missing in\n" << ended.err);
  // Errors that follow from these are reported only when these are corrected.
  folder.write("d.ini", "[contact]\nM = 50\n[grid]\ncells = 64\n[lubricant]\nviscosity = barus\n[thermal]\nk = 1\n");
  BOOST_TEST(support::ehl(folder, "check d.ini").says({"contact] L"}));
}

// If the contact has an error, no domain is chosen, so no message about too few cells may appear.
BOOST_AUTO_TEST_CASE(a_slip_in_the_contact_says_nothing_of_the_mesh) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", "[contact]\nload = 10\nradius_x = 0.01\nE_prime = 2e11\n[grid]\ncells = 64\n");
  const support::Ended ended = support::ehl(folder, "check d.ini");
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.says({"[motion] u_m"}), ended.err);
  BOOST_TEST(!ended.says({"cells"}), ended.err);
}

BOOST_AUTO_TEST_CASE(files_that_are_no_decks) {
  const support::TemporaryFolder folder;
  folder.write("empty.ini", "");
  folder.write("noise.ini", std::string("\x01\x00\xff\xfe", 4));
  const std::string locked = folder.write("locked.ini", moes);
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  const auto refused = [&](const std::string& name) {
    const support::Ended ended = support::ehl(folder, "run '" + name + "'");
    BOOST_TEST(ended.status == 2, name << " ends with " << ended.status);
    BOOST_TEST(ended.says({name + ": "}), name << " says\n" << ended.err);
  };
  for (const char* name : {"empty.ini", "noise.ini", ".", "missing.ini", "/dev/zero"}) refused(name);
  if (::geteuid() != 0) refused("locked.ini");
}

// If the contact has an error, no domain or grid follows from it, so no message about a short wave may appear.
BOOST_AUTO_TEST_CASE(no_error_follows_from_another_one) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", moes + "[motion]\nsrr = 2\n[surface2]\nshape = waviness\nheight = 0.01\nwidth = 0.4\n" + oil);
  const support::Ended ended = support::ehl(folder, "check d.ini");
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.says({"d.ini:5", "srr = 2"}), ended.err);
  BOOST_TEST(ended.err.find("cells") == std::string::npos, ended.err);
}

BOOST_AUTO_TEST_CASE(command_lines) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", moes + oil);
  for (const char* line : {"", "rnu d.ini", "run", "run d.ini e.ini", "run d.ini --ouput x.h5", "run d.ini --output",
                           "run d.ini --quiet=3", "run d.ini --output a.h5 --output b.h5", "run d.ini --threads 0",
                           "run d.ini --threads two", "run d.ini --output r.xmf", "check d.ini --set grid.cells",
                           "check d.ini --set grid.cells=77", "check d.ini --set gird.cells=64",
                           "check d.ini --set contact.load=3", "keys grid.cels", "keys grid --deck", "help rum"}) {
    const support::Ended ended = support::ehl(folder, line);
    BOOST_TEST(ended.status == 2, line << " ends with " << ended.status);
    BOOST_TEST(!ended.err.empty(), line);
  }
  BOOST_TEST(folder.entries() == 1);
}

BOOST_AUTO_TEST_SUITE_END()
