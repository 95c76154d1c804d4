#pragma once
// Decks with one mistake each, which the program must refuse.
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace support {

struct Slip {
  std::string name;
  std::string deck;
  std::vector<std::string> parts;  ///< parts of the message
};

/// Both `check` and `run` must refuse the deck with the same message, and `run` must leave no file.
inline void check_refused(const TemporaryFolder& folder, const Slip& slip) {
  folder.write("d.ini", slip.deck);
  const std::size_t files = folder.entries();
  for (const char* command : {"check d.ini", "run d.ini"}) {
    const Ended ended = ehl(folder, command);
    BOOST_TEST(ended.status == 2, slip.name << ": " << command << " ends with " << ended.status << "\n" << ended.err);
    BOOST_TEST(ended.says(slip.parts), slip.name << " says\n" << ended.err);
    BOOST_TEST(ended.out.empty(), slip.name << " prints\n" << ended.out);
  }
  BOOST_TEST(folder.entries() == files, slip.name);
}

inline void check_refused(const std::vector<Slip>& slips) {
  const TemporaryFolder folder;
  for (const Slip& slip : slips) check_refused(folder, slip);
}

}  // namespace support
