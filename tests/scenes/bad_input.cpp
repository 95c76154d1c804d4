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
      {"misspelt key", moes + oil + "[grid]\ncels = 64\n", {"d.ini:8", "[grid] cels = 64", "did you mean cells?"}},
      {"misspelt section", moes + oil + "[gird]\ncells = 64\n", {"d.ini:7", "[gird]", "did you mean grid?"}},
      {"nan", "[contact]\nM = nan\nL = 10\n" + oil, {"d.ini:2", "[contact] M = nan", "not a finite number"}},
      {"inf", steel + "[domain]\nx_outlet = inf\n", {"d.ini:11", "x_outlet = inf", "not a finite number"}},
      {"negative load", "[contact]\nload = -15\n", {"d.ini:2", "[contact] load = -15", "> 0 N"}},
      {"text for a number", "[contact]\nM = fifty\nL = 10\n" + oil, {"d.ini:2", "M = fifty", "not a number"}},
      {"unit suffix", "[contact]\nload = 15 N\n", {"d.ini:2", "the number alone", "unit is N"}},
      {"missing value", "[contact]\nM =\nL = 10\n" + oil, {"d.ini:2", "[contact] M", "value is missing"}},
      {"unknown law",
       moes + "[lubricant]\nviscosity = rolands\nalpha = 1e-8\n",
       {"d.ini:5", "viscosity = rolands", "did you mean roelands?", "isoviscous, barus, roelands"}},
      {"duplicate", moes + "M = 20\n" + oil, {"d.ini:4", "M = 20", "given twice", "d.ini:2"}},
      {"no assignment", moes + oil + "nonsense\n", {"d.ini:7", "nonsense", "= is missing"}},
      {"checkpoint of nothing", moes + oil + "[output]\ncheckpoint = 1\n", {"d.ini:8", "checkpoint", "end_time"}},
      {"two grids",
       moes + oil + "[grid]\ncells = 256\naccuracy = 0.01\n",
       {"d.ini:9", "accuracy = 0.01", "cells are both given"}},
      {"accuracy", moes + oil + "[grid]\naccuracy = 1\n", {"d.ini:8", "accuracy = 1", "0.5"}},
      {"empty section", moes + oil + "[domain]\n", {"d.ini:7", "[domain]", "no influence", "x_inlet"}},
  });
}

BOOST_AUTO_TEST_CASE(line_contacts) {
  const std::string line = "[contact]\nkind = line\n";
  const std::string rest = "E_prime = 110e9\n[motion]\nu_m = 0.09\n[lubricant]\neta0 = 0.25\nalpha = 22e-9\n";
  const std::string bodies = "load_per_length = 1e5\nradius_x = 0.0125\n" + rest;
  const std::string numbers = line + "M = 20\nL = 5\n" + oil;
  support::check_refused({
      {"kind", "[contact]\nkind = lines\nM = 20\nL = 5\n" + oil, {"d.ini:2", "did you mean line?", "point, line"}},
      {"load of a point", line + "load = 1e3\nradius_x = 0.0125\n" + rest, {"d.ini:3", "load_per_length [N/m]"}},
      {"load of a line", "[contact]\n" + bodies, {"load_per_length", "set kind = line"}},
      {"negative", line + "load_per_length = -1\n", {"d.ini:3", "> 0 N/m"}},
      {"radius_y", line + "radius_y = 0.1\n" + bodies, {"d.ini:3", "radius_y", "no influence on a line"}},
      {"radius_ratio", line + "radius_ratio = 0.1\nM = 20\nL = 5\n" + oil, {"radius_ratio", "no influence"}},
      {"angle", numbers + "[motion]\nangle = 10\n", {"[motion] angle", "no influence on a line"}},
      {"y_half", numbers + "[domain]\ny_half = 2\n", {"[domain] y_half", "no sides"}},
      {"dry", "[case]\nkind = dry\n" + line, {"[contact] kind", "a dry contact is always circular"}},
      {"dimple",
       numbers + "[surface1]\nshape = dimple\nheight = 0.01\nwidth = 0.5\nat_rest = yes\n",
       {"dimple", "ridge, groove or waviness"}},
      {"in time with the far field of a steady one",
       numbers + "[transient]\nend_time = 1\n[domain]\nfar_field = closed\n",
       {"far_field = closed", "set zero"}},
      {"a probe beside the line",
       numbers + "[transient]\nend_time = 1\n[output]\nprobe = 0 0.5\n",
       {"(0, 0.5)", "Y = 0"}},
  });
}

BOOST_AUTO_TEST_CASE(languages_and_groups) {
  support::check_refused({
      {"two languages",
       "[contact]\nM = 50\nL = 10\nload = 15\n" + oil,
       {"d.ini:4", "load = 15", "already given by M, L", "d.ini:2"}},
      {"a stray key", steel + "[contact]\nM = 50\n", {"d.ini:11", "M = 50", "load, radius_x, E_prime (d.ini:2)"}},
      {"no language", oil, {"[contact] M", "the contact is missing", "load, radius_x"}},
      {"half a language", "[contact]\nM = 50\n" + oil, {"d.ini: [contact] L", "is missing"}},
      {"no speed",
       "[contact]\nload = 1\nradius_x = 1\nE_prime = 1e11\n[lubricant]\neta0 = 1\nalpha = 1e-8\n",
       {"[motion] u_m", "is missing"}},
      {"no moduli",
       "[contact]\nload = 1\nradius_x = 1\n[motion]\nu_m = 1\n[lubricant]\neta0 = 1\nalpha = 1e-8\n",
       {"E_prime", "is missing", "E1, nu1, E2"}},
      {"moduli twice", steel + "[contact]\nE1 = 1e11\n", {"d.ini:11", "E1 = 1e11", "keep either E_prime"}},
      {"nearly a line",
       steel + "[contact]\nradius_y = 3\n",
       {"d.ini:11", "radius_y = 3", "radius_x/radius_y = 0.004167", ">= 0.005", "nearly a line"}},
      {"no radius", steel + "[contact]\nradius_y = 0\n", {"d.ini:11", "radius_y = 0", "> 0"}},
      {"radius twice",
       steel + "[contact]\nradius_y = 0.02\nradius_ratio = 0.5\n",
       {"d.ini:12", "radius_ratio = 0.5", "radius_y is given as well"}},
      {"ratio out of range",
       "[contact]\nM = 50\nL = 10\nradius_ratio = 250\n" + oil,
       {"d.ini:4", "radius_ratio = 250", "200", "nearly a line"}},
      {"negative ratio",
       "[contact]\nM = 50\nL = 10\nradius_ratio = -1\n" + oil,
       {"d.ini:4", "radius_ratio = -1", "0.005"}},
      {"angle without ellipse",
       moes + oil + "[motion]\nangle = 30\n",
       {"d.ini:8", "angle = 30", "no influence on a circular contact", "radius_ratio"}},
      {"angle without ellipse in SI",
       steel + "[contact]\nradius_y = 0.0125\n[motion]\nangle = 30\n",
       {"d.ini:13", "angle = 30", "no influence on a circular contact"}},
      {"angle too large",
       "[contact]\nM = 50\nL = 10\nradius_ratio = 0.5\n" + oil + "[motion]\nangle = 120\n",
       {"d.ini:9", "angle = 120", "90"}},
      {"against the inlet",
       "[contact]\nload = 1\nradius_x = 1\nE_prime = 1e11\n[motion]\nu1 = -2\nu2 = 1\n[lubricant]\neta0 = 1\nalpha = "
       "1e-8\n",
       {"d.ini:7", "u1 + u2 = -1 m/s", "> 0"}},
      {"speed without use", moes + oil + "[motion]\nu_m = 1\n", {"d.ini:8", "u_m = 1", "no influence"}},
      {"no alpha", moes, {"[lubricant] alpha", "is missing", "p_h"}},
      {"z for Barus",
       moes + "[lubricant]\nviscosity = barus\ndensity = incompressible\nz = 0.6\n",
       {"d.ini:7", "z = 0.6", "no influence"}},
      {"L without use",
       moes + "[lubricant]\nviscosity = isoviscous\ndensity = incompressible\n",
       {"d.ini:3", "L = 10", "set L = 0"}},
      {"continuation switched off and described",
       moes + oil + "[continuation]\npath = off\nM_start = 10\n",
       {"d.ini:9", "M_start = 10", "no influence", "path = off"}},
      {"continuation from newtons",
       moes + oil + "[continuation]\nload_start = 10\n",
       {"d.ini:8", "load_start = 10", "not given in SI", "M_start"}},
      {"continuation to where it is",
       moes + oil + "[continuation]\nM_start = 50\n",
       {"d.ini:8", "M_start = 50", "nothing to continue"}},
      {"a load that is carried far away",
       "[contact]\nM = 0.2\nL = 0\n[lubricant]\nviscosity = isoviscous\ndensity = incompressible\n[domain]\nfar_field "
       "= "
       "zero\n",
       {"[domain] x_inlet", "-189", "% of the film", "Give x_inlet"}},
      {"wrong units",
       "[contact]\nload = 15\nradius_x = 12.5\nE_prime = 110\n[motion]\nu_m = 0.09\n[lubricant]\neta0 = 0.25\nalpha = "
       "22e-9\n",
       {"d.ini:2", "load = 15", "Hertz pressure of 3.83 Pa", "check the units"}},
      {"thin oil",
       "[contact]\nload = 15\nradius_x = 0.0125\nE_prime = 110e9\n[motion]\nu_m = 30\n[lubricant]\neta0 = 1e-4\nalpha "
       "= 22e-9\n",
       {"d.ini:8", "eta0 = 1e-4", "it means z =", "give z"}},
  });
}

BOOST_AUTO_TEST_CASE(grids_and_domains) {
  const std::string good = moes + oil;
  support::check_refused({
      {"no cells", good + "[grid]\ncells = 0\n", {"d.ini:8", "cells = 0", ">= 16"}},
      {"77 cells", good + "[grid]\ncells = 77\n", {"d.ini:8", "[grid] cells = 77", "power of two", "e.g. 64 or 128"}},
      {"too many cells",
       good + "[grid]\ncells = 1048576\n",
       {"d.ini:8", "cells = 1048576", "GB of memory", "use at most"}},
      {"beyond integers", good + "[grid]\ncells = 99999999999999999999\n", {"d.ini:8", "whole number"}},
      {"not the coarsest's multiple",
       good + "[grid]\ncells = 64\ncoarsest = 24\n",
       {"d.ini:8", "24 cells", "e.g. 48 or 96"}},
      {"no inlet", good + "[domain]\nx_inlet = -0.5\n", {"d.ini:8", "x_inlet = -0.5", "must contain the contact"}},
      {"no outlet", good + "[domain]\nx_outlet = 0.9\n", {"d.ini:8", "x_outlet = 0.9", "must contain the contact"}},
      {"no sides of an ellipse",
       "[contact]\nM = 50\nL = 10\nradius_ratio = 0.2\n" + oil + "[domain]\ny_half = 2\n",
       {"d.ini:9", "y_half = 2", "must contain the contact", "2.89"}},
      {"no sides", good + "[domain]\ny_half = 1\n", {"d.ini:8", "y_half = 1", "must contain the contact"}},
      {"too coarse",
       good + "[domain]\nx_inlet = -100\n[grid]\ncells = 64\n",
       {"d.ini:10", "too coarse for -100 <= x <= 1.5", "1.59 Hertz", "use e.g. 256 cells"}},
      {"a mile wide", good + "[domain]\ny_half = 1000\n[grid]\ncells = 65536\n", {"d.ini"}},
      {"far field too near",
       "[contact]\nM = 0.5\nL = 0\nradius_ratio = 0.4\n[lubricant]\nviscosity = isoviscous\ndensity = "
       "incompressible\n[domain]\nx_inlet = -12\n"
       "x_outlet = 8\ny_half = 10\n[grid]\ncells = 128\n",
       {"d.ini:9", "x_inlet = -12", "closed far field does not hold", "far_field = zero"}},
      {"odd order", good + "[deformation]\norder = 5\n", {"d.ini:8", "order = 5", "4, 6 or 8"}},
      {"coarsenings",
       good + "[grid]\ncells = 64\n[deformation]\ncoarsenings = 7\n",
       {"d.ini:10", "coarsenings = 7: must be <= 6"}},
      {"order for FFT",
       good + "[deformation]\nmethod = fft\norder = 6\n",
       {"d.ini:9", "order = 6", "no influence with method = fft"}},
      {"first load without use",
       good + "[continuation]\npath = off\nM_start = 20\n",
       {"d.ini:9", "M_start = 20", "no influence with path = off"}},
      {"first load in newtons",
       good + "[continuation]\nload_start = 3\n",
       {"d.ini:8", "load_start = 3", "use M_start"}},
      {"no relaxation", good + "[multigrid]\npre = 0\npost = 0\n", {"d.ini:8", "cannot converge"}},
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
  const auto refused = [&](const std::string& name, const std::string& part) {
    const support::Ended ended = support::ehl(folder, "run '" + name + "'");
    BOOST_TEST(ended.status == 2, name << " ends with " << ended.status);
    BOOST_TEST(ended.says({name + ": ", part}), name << " says\n" << ended.err);
  };
  refused("empty.ini", "the deck is empty");
  refused("noise.ini", "not a text file");
  refused(".", "directory");
  refused("missing.ini", "no such file");
  refused("/dev/zero", "larger than a megabyte");
  if (::geteuid() != 0) refused("locked.ini", "cannot be read: Permission denied");
}

// If the contact has an error, no domain or grid follows from it, so no message about a short wave may appear.
BOOST_AUTO_TEST_CASE(no_error_follows_from_another_one) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", moes + "[motion]\nsrr = 2\n[surface2]\nshape = waviness\nheight = 0.01\nwidth = 0.4\n" + oil);
  const support::Ended ended = support::ehl(folder, "check d.ini");
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.says({"d.ini:5", "srr = 2", "has no influence"}), ended.err);
  BOOST_TEST(ended.err.find("cells") == std::string::npos, ended.err);
}

BOOST_AUTO_TEST_CASE(command_lines) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", moes + oil);
  struct Line {
    std::string arguments;
    std::string part;
  };
  const std::vector<Line> lines{
      {"", "a command is missing"},
      {"rnu d.ini", "did you mean run?"},
      {"run", "DECK is missing"},
      {"run d.ini e.ini", "'e.ini' is one argument too many"},
      {"run d.ini --ouput x.h5", "did you mean --output?"},
      {"run d.ini --output", "the value is missing"},
      {"run d.ini --quiet=3", "takes no value"},
      {"run d.ini --output a.h5 --output b.h5", "given twice"},
      {"run d.ini --threads 0", "--threads 0"},
      {"run d.ini --threads two", "--threads two"},
      {"run d.ini --output r.xmf", "use .h5"},
      {"check d.ini --set grid.cells", "write section.key=value"},
      {"check d.ini --set grid.cells=77", "command line: [grid] cells = 77"},
      {"check d.ini --set gird.cells=64", "did you mean grid?"},
      {"check d.ini --set contact.load=3", "already given by"},
      {"keys grid.cels", "did you mean grid.cells?"},
      {"keys grid --deck", "leave grid out"},
      {"help rum", "did you mean run?"},
  };
  for (const Line& line : lines) {
    const support::Ended ended = support::ehl(folder, line.arguments);
    BOOST_TEST(ended.status == 2, line.arguments << " ends with " << ended.status);
    BOOST_TEST(ended.says({line.part}), line.arguments << " says\n" << ended.err);
  }
  BOOST_TEST(folder.entries() == 1);
}

BOOST_AUTO_TEST_SUITE_END()
