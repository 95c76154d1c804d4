// A feature that this version lacks is answered with the nearest one that it has, and one mistake gives one error.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(test_nearest_thing)

namespace {

const std::string good =
    "[contact]\nload = 20\nradius_x = 0.01\nE_prime = 226e9\n[motion]\nu_m = 1\n[lubricant]\neta0 = 0.05\nalpha = "
    "2e-8\n";

struct Mistake {
  std::string deck, arguments, part;
};

void check(const Mistake& mistake) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", mistake.deck);
  const support::Ended ended = support::ehl(folder, "check d.ini " + mistake.arguments);
  BOOST_TEST(ended.status == 2, mistake.arguments << " ends with " << ended.status);
  BOOST_TEST(ended.says({mistake.part}), ended.err);
  BOOST_TEST(std::ranges::count(ended.err, '\n') == 1, "one error, and not\n" << ended.err);
}

}  // namespace

BOOST_AUTO_TEST_CASE(names_that_are_not_there) {
  for (const Mistake& mistake : {
           Mistake{good + "[asperities]\nsigma = 1\n", "", "[mixed] lets surfaces touch at a boundary film"},
           Mistake{good + "[coating]\nE = 1\n", "", "give coating1_E"},
           Mistake{good + "[wear]\nk = 1\n", "", "wear is not computed"},
           Mistake{good + "[grease]\nk = 1\n", "", "give the base oil in [lubricant]"},
           Mistake{good, "--set contact.p_h=1e9", "2 pi^3 R^2 p_h^3/(3 E'^2)"},
           Mistake{good, "--set lubricant.fluid=grease", "give the base oil"},
           Mistake{good, "--set lubricant.viscosity=herschel-bulkley", "[shear] law = eyring or carreau"},
           Mistake{good, "--set case.kind=bevel", "gear_mesh holds for spur gears"},
           Mistake{good, "--set gear.helix_angle=10", "gear_mesh holds for spur gears"},
           Mistake{good, "--set bearing.axial_load=500", "F_a/(elements sin(contact_angle))"},
           Mistake{good, "--set motion.u1=0 --set motion.u2=0 --unset motion.u_m", "u1 + u2 = 0 m/s"},
           Mistake{good, "--unset contact.foo", "--unset contact.foo: unknown key"},
       })
    check(mistake);
}

// After an error elsewhere, the other keys of a data sheet are not called unused.
BOOST_AUTO_TEST_CASE(a_slip_beside_a_data_sheet) {
  const std::string sheet =
      "[contact]\nload = 20\nradius_x = 0.01\nE_prime = 226e9\n[motion]\nu_m = 1\n[lubricant]\nkv40 = 68\nkv100 = 8.7\n"
      "density15 = 880\nalpha_star = 2e-8\nalpha_temperature = 40\ntemperature = 60\n";
  check({sheet, "--set grid.cellz=64", "did you mean cells?"});
  check({sheet, "--set contact.load=-20", "load = -20"});
  check({sheet, "--set lubricant.viscocity=barus", "did you mean viscosity?"});
}

BOOST_AUTO_TEST_CASE(advice_that_helps) {
  // Water: its viscosity rises too little with pressure for Roelands' law.
  const std::string water = "--set lubricant.eta0=1e-3 --set lubricant.alpha=6e-10";
  check(
      {good, water, "rises too little with pressure for Roelands' law, as that of water does: set viscosity = barus"});
  const support::TemporaryFolder folder;
  folder.write("d.ini", good);
  BOOST_TEST(support::ehl(folder, "check d.ini --set lubricant.viscosity=barus " + water).status == 0);
  check(
      {"[contact]\nkind = line\nload_per_length = 2824.6\nradius_x = 0.054831\nE_prime = 434e9\n[motion]\n"
       "u_m = 1.41939\n[lubricant]\neta0 = 0.01381\nalpha = 16e-9\n",
       "", "so light that the bodies stay rigid"});
}

BOOST_AUTO_TEST_SUITE_END()
