// Every key that the catalogue declares is read by somebody, in one of the decks that come with the program.

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <set>

#include "case/catalogue.hpp"
#include "case/scene.hpp"

using namespace ehl;

namespace {

// "section.key" of all that was asked for while the case was made.
void add_read(const deck::Deck& deck, std::set<std::string>& read) {
  for (std::size_t k = 0; k < deck.values.size(); ++k)
    if (deck.values[k].read) read.insert(deck.catalogue.keys[k].section + "." + deck.catalogue.keys[k].name);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(keys)

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
  for (const deck::Key& key : program::catalogue().keys) {
    const std::string name = key.section + "." + key.name;
    BOOST_TEST(read.contains(name), name << " is declared, and nobody reads it");
  }
}

BOOST_AUTO_TEST_SUITE_END()
