// The conversion of decks to the input of the solver, compared with numbers computed elsewhere.
#include "case/scene.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "case/catalogue.hpp"
#include "core/errors.hpp"
#include "deck/write.hpp"
#include "support/temporary_folder.hpp"

using namespace ehl;
using boost::test_tools::tolerance;

namespace {

program::Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const support::TemporaryFolder folder;
  return program::read_case(folder.write("case.ini", text), overrides, 1);
}

const std::string moes = "[contact]\nM = 50\nL = 10\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_scene)

// M = 50, L = 10: alpha_bar = 13.42, lambda = 0.0596 (Venner and ten Napel 1992).
BOOST_AUTO_TEST_CASE(the_papers_case) {
  const program::Case input = read(moes, {"domain.far_field=zero"});
  BOOST_TEST_MESSAGE("alpha_bar " << input.physics.groups.alpha_bar << ", lambda " << input.scene.lambda);
  BOOST_TEST(input.physics.groups.alpha_bar == 13.42, tolerance(5e-4));
  BOOST_TEST(input.scene.lambda == 0.0596, tolerance(5e-4));
  const auto& law = std::get<rheology::Roelands>(input.scene.viscosity);
  BOOST_TEST(law.alpha_p0_over_z == 1.7e-8 * 1.96e8 / 0.6, tolerance(1e-14));
  BOOST_TEST(law.p_h_over_p0 == 13.42 / 1.7e-8 / 1.96e8, tolerance(5e-4));
  BOOST_TEST(input.scene.grid.X_a == -4.5);
  BOOST_TEST(input.scene.grid.Y_b == 3.0);
  BOOST_TEST(input.scene.grid.ny == 256);
}

// Mourier et al. 2006: M = 63.78, L = 5.788, z = 0.5205; Hertz: a = 136.7 um and p_h = 383 MPa.
BOOST_AUTO_TEST_CASE(a_contact_in_si) {
  const program::Case input = read(
      "[contact]\nload = 15\nradius_x = 0.0125\nE_prime = 110e9\n[motion]\nu_m = 0.09\nsrr = 0.5\n"
      "[lubricant]\neta0 = 0.25\nalpha = 22e-9\n");
  BOOST_TEST(input.physics.groups.M == 63.78, tolerance(1e-4));
  BOOST_TEST(input.physics.groups.L == 5.788, tolerance(1e-4));
  BOOST_TEST(std::get<rheology::Roelands>(input.scene.viscosity).z == 0.5205, tolerance(1e-4));
  BOOST_TEST(input.physics.si->hertz.a == 136.7e-6, tolerance(1e-3));
  BOOST_TEST(input.physics.si->u1 == 0.1125, tolerance(1e-14));
  BOOST_TEST(input.physics.si->u2 == 0.0675, tolerance(1e-14));
}

// The three languages describe one contact: W, U, G of the case in SI give the same groups.
BOOST_AUTO_TEST_CASE(three_languages_one_contact) {
  const program::Case si = read(
      "[contact]\nload = 15\nradius_x = 0.0125\nE_prime = 110e9\n[motion]\nu1 = 0.09\nu2 = 0.09\n"
      "[lubricant]\neta0 = 0.25\nalpha = 22e-9\nz = 0.52\n");
  const auto number = [](double value) { return std::to_string(value * 1e9) + "e-9"; };
  const program::Case wug = read("[contact]\nW = " + number(15 / (110e9 * 0.0125 * 0.0125)) +
                                 "\nU = " + std::to_string(0.25 * 0.09 / (110e9 * 0.0125) * 1e18) + "e-18\nG = 2420\n" +
                                 "[lubricant]\nalpha = 22e-9\nz = 0.52\n");
  const program::Case ml =
      read("[contact]\nM = 63.78171405228822\nL = 5.788190550245156\n[lubricant]\nalpha = 22e-9\nz = 0.52\n");
  for (const program::Case* other : {&wug, &ml}) {
    BOOST_TEST(other->physics.groups.M == si.physics.groups.M, tolerance(1e-6));
    BOOST_TEST(other->physics.groups.L == si.physics.groups.L, tolerance(1e-6));
    BOOST_TEST(other->physics.p_h == si.physics.p_h, tolerance(1e-6));
    BOOST_TEST(other->scene.lambda == si.scene.lambda, tolerance(1e-6));
  }
}

// An ellipse in SI and by its ratio; the angle; a suitable domain and suitable cells.
BOOST_AUTO_TEST_CASE(elliptic_contacts) {
  const std::string steel =
      "[contact]\nload = 15\nradius_x = 0.01\nE_prime = 110e9\n[motion]\nu_m = 0.09\nangle = 30\n"
      "[lubricant]\neta0 = 0.25\nalpha = 22e-9\n";
  const program::Case by_radius = read(steel + "[contact]\nradius_y = 0.02\n");
  const program::Case by_ratio = read(steel + "[contact]\nradius_ratio = 0.5\n");
  for (const program::Case* one : {&by_radius, &by_ratio}) {
    BOOST_TEST(one->scene.contact.shape.radius_ratio == 0.5);
    BOOST_TEST(one->scene.contact.shape.angle == 30.0);
    BOOST_TEST(one->scene.contact.shape.kappa == 1.5858021197, tolerance(1e-9));
    BOOST_TEST(one->physics.si->hertz.b / one->physics.si->hertz.a == 1.5858021197, tolerance(1e-9));
    BOOST_TEST(one->physics.groups.alpha_bar == 22e-9 * one->physics.p_h, tolerance(1e-12));
  }
  const program::Case ml = read("[contact]\nM = 63\nL = 6\nradius_ratio = 0.5\n[lubricant]\nalpha = 22e-9\nz = 0.52\n");
  BOOST_TEST(ml.scene.contact.shape.angle == 0.0);
  BOOST_TEST(ml.scene.grid.hx() == ml.scene.grid.hy(), tolerance(1e-12));
  BOOST_TEST(ml.scene.grid.Y_b > 1.4 * 1.58);
  const program::Case circle =
      read("[contact]\nM = 63\nL = 6\nradius_ratio = 1\n[lubricant]\nalpha = 22e-9\nz = 0.52\n");
  BOOST_TEST(circle.scene.grid.Y_b == 1.25 * 0.5 * (circle.scene.grid.X_b - circle.scene.grid.X_a));
  BOOST_TEST(contact::circular(circle.scene.contact.shape));
}

BOOST_AUTO_TEST_CASE(isoviscous_and_barus) {
  const program::Case iso =
      read("[contact]\nM = 5\nL = 0\n[lubricant]\nviscosity = isoviscous\ndensity = incompressible\n");
  BOOST_TEST(std::holds_alternative<rheology::Isoviscous>(iso.scene.viscosity));
  BOOST_TEST(iso.physics.groups.alpha_bar == 0.0);
  const program::Case barus =
      read("[contact]\nM = 20\nL = 10\n[lubricant]\nviscosity = barus\ndensity = incompressible\n");
  // (L/pi)(3M/2)^(1/3)
  BOOST_TEST(std::get<rheology::Barus>(barus.scene.viscosity).alpha_bar == 10.0 / M_PI * std::cbrt(30.0),
             tolerance(1e-12));
}

// L = 0 with a piezoviscous lubricant is a limit without a Hertz pressure.
BOOST_AUTO_TEST_CASE(no_pressure_no_piezoviscosity) {
  const program::Case limit = read(moes, {"contact.L=0"});
  BOOST_TEST(std::get<rheology::Roelands>(limit.scene.viscosity).p_h_over_p0 == 0.0);
  BOOST_TEST(std::get<rheology::DowsonHigginson>(limit.scene.density).p_h_over_B == 0.0);
}

BOOST_AUTO_TEST_CASE(continuation_and_polish) {
  using Path = steady::ContinuationParameters::Path;
  const program::Case plain = read(moes);
  BOOST_TEST((plain.scene.continuation.path == Path::automatic));
  BOOST_TEST((plain.scene.polish == steady::Polish::fallback));
  const program::Case asked = read(
      moes, {"continuation.path=load", "continuation.M_start=20", "continuation.step=1.5", "multigrid.polish=always"});
  BOOST_TEST((asked.scene.continuation.path == Path::load));
  BOOST_TEST(asked.scene.continuation.load_ratio == 0.4);
  BOOST_TEST(asked.scene.continuation.step == 1.5);
  BOOST_TEST((asked.scene.polish == steady::Polish::always));
}

BOOST_AUTO_TEST_CASE(the_grid_follows_the_domain) {
  const program::Case heavy = read(moes, {"contact.M=1000", "domain.far_field=zero"});
  BOOST_TEST(heavy.scene.grid.X_a == -2.5);
  BOOST_TEST(heavy.scene.grid.Y_b == 2.0);
  // The number of cells that resolves the film (modules/steady): 256 for M = 50, more if the film is thinner.
  BOOST_TEST(read(moes).scene.grid.nx == 256);
  BOOST_TEST(heavy.scene.grid.nx == 512);
  BOOST_TEST(heavy.scene.grid.ny == 512);
  BOOST_TEST(read(moes, {"contact.M=5000"}).scene.grid.nx == 1024);
  BOOST_TEST(read(moes, {"grid.coarsest=24"}).scene.grid.nx == 384);
  // The far field of a light load extends further, and its film is so thick that it cavitates further downstream.
  const program::Case light = read(moes, {"contact.M=2", "contact.L=2", "domain.far_field=zero"});
  BOOST_TEST(light.scene.grid.X_a == -189.0);
  BOOST_TEST(light.scene.grid.X_b == 3.0);
  BOOST_TEST(light.scene.grid.Y_b == 96.0);
  // With the far field in closed form, the domain needs only the size of the film zone: some eight
  // times sqrt(2 Hc), Hc = 6.
  const program::Case closed = read(moes, {"contact.M=2", "contact.L=2"});
  BOOST_TEST_MESSAGE("closed: X from " << closed.scene.grid.X_a << " to " << closed.scene.grid.X_b);
  BOOST_TEST((closed.scene.far_field && closed.scene.grid.X_a > -30.0 && closed.scene.grid.X_b > 10.0));
  const program::Case wide = read(moes, {"domain.y_half=4", "grid.cells=128", "domain.far_field=zero"});
  // 128 x 8/6 = 170.7; on the coarsest grid (32) 42.7, of which 42 is the nearest even number: 168.
  BOOST_TEST(wide.scene.grid.ny == 168);
  BOOST_TEST(std::abs(wide.scene.grid.hy() / wide.scene.grid.hx() - 1.0) < 0.03);
  const program::Case odd = read(moes, {"grid.cells=96", "grid.coarsest=12"});
  BOOST_TEST(odd.scene.solver.coarsest_cells == 12);
  BOOST_TEST(odd.scene.grid.ny % 8 == 0);
}

BOOST_AUTO_TEST_CASE(the_self_written_deck_is_the_papers_case) {
  const program::Case input = read(deck::commented_deck(program::catalogue()));
  BOOST_TEST(input.physics.groups.M == 50.0);
  BOOST_TEST(input.scene.grid.nx == 256);
}

// The deck in a result, read again, gives exactly the same case.
BOOST_AUTO_TEST_CASE(the_effective_deck_gives_the_same_case) {
  const std::string si =
      "[contact]\nload = 15\nradius_x = 0.0125\nE1 = 206e9\nnu1 = 0.3\nE2 = 81e9\nnu2 = 0.208\n[motion]\nu1 = 0.1\nu2 "
      "= "
      "0.08\n[lubricant]\neta0 = 0.25\nalpha = 22e-9\n[multigrid]\ntolerance = 1e-8\n";
  for (const std::string& text : {moes, si}) {
    const program::Case once = read(text);
    const program::Case twice = read(deck::effective_deck(once.deck));
    BOOST_TEST(once.scene.lambda == twice.scene.lambda);
    BOOST_TEST((once.scene.grid == twice.scene.grid));
    BOOST_TEST(std::get<rheology::Roelands>(once.scene.viscosity).z ==
               std::get<rheology::Roelands>(twice.scene.viscosity).z);
    BOOST_TEST(once.title == twice.title);
  }
}

// Every key in the catalogue can be given without being called unknown.
BOOST_AUTO_TEST_CASE(the_catalogue_is_sound) {
  const deck::Catalogue all = program::catalogue();
  for (const deck::Key& key : all.keys) {
    const std::string name = key.section + "." + key.name;
    BOOST_TEST(!key.meaning.empty(), name);
    BOOST_TEST((!key.default_text.empty() || !key.default_note.empty() || !key.example.empty()), name);
    BOOST_TEST((deck::find_key(all, key.section, key.name) == &key), name << " is declared twice");
    BOOST_TEST((key.needs.name.empty() || deck::find_key(all, deck::section_needed(key), key.needs.name) != nullptr),
               name);
    if (key.type == deck::Type::word || key.type == deck::Type::words) BOOST_TEST(!key.words.empty(), name);
  }
}

// A coating of the material of its body is none. One of another material changes the scales to those of bodies that
// yield as much: a very thick one is a body of its material, a very thin one is not felt.
BOOST_AUTO_TEST_CASE(coatings_of_bodies) {
  const std::string uncoated =
      "[contact]\nload = 20\nradius_x = 0.01\nE1 = 210e9\nnu1 = 0.3\nE2 = 200e9\nnu2 = 0.25\n[motion]\nu_m = 1\n"
      "[lubricant]\neta0 = 0.04\nalpha = 2e-8\n";
  const auto coated = [&](const std::string& E, const std::string& nu, const std::string& thickness) {
    return read(uncoated,
                {"contact.coating1_E=" + E, "contact.coating1_nu=" + nu, "contact.coating1_thickness=" + thickness});
  };
  const double E_prime = read(uncoated).physics.si->contact.E_prime;
  const program::Case equal = coated("210e9", "0.3", "1e-5");
  BOOST_TEST((equal.physics.si->contact.E_prime == E_prime && equal.scene.coatings.parts.empty()));
  BOOST_TEST(coated("100e9", "0.2", "1e-12").physics.si->contact.E_prime == E_prime, tolerance(1e-6));
  const double of_thick = contact::reduced_modulus({100e9, 0.2}, {200e9, 0.25});
  BOOST_TEST(coated("100e9", "0.2", "0.1").physics.si->contact.E_prime == of_thick, tolerance(1e-9));
  const program::Case input = coated("100e9", "0.2", "1e-5");
  BOOST_TEST(input.scene.coatings.parts.front().thickness() == 1e-5 / input.physics.si->hertz.a, tolerance(1e-14));
  BOOST_TEST((input.physics.si->contact.E_prime < E_prime && input.physics.si->contact.E_prime > of_thick));

  const auto refused = [&](std::vector<std::string> overrides, const std::string& word, const char* E = "100e9") {
    for (const auto& key : {std::string("contact.coating1_E=") + E, std::string("contact.coating1_nu=0.2"),
                            std::string("contact.coating1_thickness=1e-5")})
      overrides.insert(overrides.begin(), key);
    BOOST_CHECK_EXCEPTION(read(uncoated, overrides), core::InputError, [&](const core::InputError& error) {
      return std::string(error.what()).find(word) != std::string::npos;
    });
  };
  refused({"-contact.coating1_nu"}, "coating1_nu");
  refused({}, "between 0.001 and 1000", "1e7");
  refused({"subsurface.depth=1"}, "[subsurface]");
  refused({"-contact.E1", "-contact.nu1", "-contact.E2", "-contact.nu2", "contact.E_prime=220e9"},
          "instead of E_prime");
  refused({"contact.kind=roller", "contact.length_m=0.01", "roller.profile=straight"}, "roller");
}

BOOST_AUTO_TEST_SUITE_END()
