// Every key in the catalogue is read in one of the decks that come with the program, and the
// effective deck is valid again.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <set>

#include "case/catalogue.hpp"
#include "case/scene.hpp"
#include "core/errors.hpp"
#include "deck/write.hpp"

using namespace ehl;

namespace {

// The "section.key" of every key that was read while the case was made.
void add_read(const deck::Deck& deck, std::set<std::string>& read) {
  for (std::size_t k = 0; k < deck.values.size(); ++k)
    if (deck.values[k].read) read.insert(deck.catalogue.keys[k].section + "." + deck.catalogue.keys[k].name);
}

// The deck that a result keeps is accepted in the folder of the first deck, and gives exactly the same case.
void check_again(const std::string& path, const std::vector<std::string>& overrides = {}) {
  const program::Case once = program::read_case(path, overrides, 1);
  const std::string text = deck::effective_deck(once.deck);
  try {
    const program::Case again = program::case_of(deck::read_text(text, path, {}, program::catalogue()), path, 1);
    BOOST_TEST(again.physics.groups.M == once.physics.groups.M, path);
    BOOST_TEST(again.physics.groups.L == once.physics.groups.L, path);
    BOOST_TEST((again.scene.grid == once.scene.grid), path);
    BOOST_TEST(again.roller.has_value() == once.roller.has_value(), path);
    if (once.roller) BOOST_TEST(again.roller->tilt == once.roller->tilt, path);
  } catch (const core::InputError& error) {
    BOOST_ERROR(path << ": " << error.what() << "\n" << text);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_keys)

BOOST_AUTO_TEST_CASE(every_declared_key_is_read) {
  std::set<std::string> read;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(EHL_INPUTS))
    if (entry.path().extension() == ".ini") add_read(program::read_case(entry.path(), {}, 1).deck, read);
  add_read(
      program::read_case(
          EHL_INPUTS "/surfaces/dry_roughness.ini",
          {"surface1.shape=map", "surface1.file=measured_map.csv", "surface1.unit_m=1e-9", "surface1.dx_m=3e-6"}, 1)
          .deck,
      read);
  add_read(program::read_case(EHL_INPUTS "/starved/bearing_track.ini",
                              {"supply.returning=surface1", "supply.split=0.5", "supply.reflow_time=10"}, 1)
               .deck,
           read);
  add_read(program::read_case(EHL_INPUTS "/line/gear_tooth.ini", {"supply.flow_m2_per_s=1e-6"}, 1).deck, read);
  add_read(program::read_case(EHL_INPUTS "/mixed/stribeck.ini", {"mixed.hardness=8e9"}, 1).deck, read);
  for (const deck::Key& key : program::catalogue().keys) {
    const std::string name = key.section + "." + key.name;
    BOOST_TEST(read.contains(name), name << " is declared, and nobody reads it");
  }
}

BOOST_AUTO_TEST_CASE(what_was_understood_is_a_deck_again) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(EHL_INPUTS))
    if (entry.path().extension() == ".ini") check_again(entry.path());
  const std::vector<std::string> ends{"roller.profile=crowned", "roller.crown_radius_m=2", "roller.tilt_mrad=0.1"};
  check_again(EHL_INPUTS "/gears/spur_gear.ini", ends);
  check_again(EHL_INPUTS "/bearings/roller_nu206.ini", ends);
  check_again(EHL_INPUTS "/rollers/measured_profile.ini", {"roller.tilt_mrad=0.1"});
  check_again(EHL_INPUTS "/surfaces/dry_roughness.ini",
              {"surface1.shape=map", "surface1.file=measured_map.csv", "surface1.unit_m=1e-9", "surface1.dx_m=3e-6"});
}

BOOST_AUTO_TEST_SUITE_END()
