#pragma once
// Results of the program, and how far they are apart.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "results/read.hpp"
#include "support/program.hpp"

namespace support {

/// The result of a deck, which must be solved. in: name: of the files, without the ending; more: arguments.
inline ehl::results::ResultFile solved(const TemporaryFolder& folder, const std::string& name, const std::string& deck,
                                       const std::string& more = "") {
  folder.write(name + ".ini", deck);
  const Ended ended = support::ehl(folder, "run " + name + ".ini --overwrite --quiet " + more);
  BOOST_TEST_REQUIRE(ended.status == 0, ended.err);
  return ehl::results::ResultFile(folder / (name + ".h5"));
}

/// The largest distance of two lists, where the second one is multiplied by a factor.
inline double distance(const std::vector<double>& one, const std::vector<double>& other, double factor = 1.0) {
  BOOST_TEST_REQUIRE(one.size() == other.size());
  double most = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k) most = std::max(most, std::abs(one[k] - factor * other[k]));
  return most;
}

}  // namespace support
