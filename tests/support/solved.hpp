#pragma once
// Results of the program, and how far they are apart.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
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

/// What `ehl run --json` prints of a deck, which must be solved.
inline nlohmann::json solved_json(const TemporaryFolder& folder, const std::string& deck,
                                  const std::string& more = "") {
  folder.write("case.ini", deck);
  const Ended run = support::ehl(folder, "run case.ini --json --quiet --overwrite " + more);
  BOOST_TEST_REQUIRE(run.status == 0, run.err);
  return nlohmann::json::parse(run.out);
}

/// A number at every step of a run in time.
inline std::vector<double> column(const ehl::results::ResultFile& file, const std::string& name) {
  return file.numbers("/transient/" + name).values;
}
inline double summary(const ehl::results::ResultFile& file, const std::string& name) {
  return file.numbers("/summary/" + name).values.at(0);
}

/// The largest absolute value of a list.
inline double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// The largest distance of two lists, where the second one is multiplied by a factor.
inline double distance(const std::vector<double>& one, const std::vector<double>& other, double factor = 1.0) {
  BOOST_TEST_REQUIRE(one.size() == other.size());
  double most = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k) most = std::max(most, std::abs(one[k] - factor * other[k]));
  return most;
}

}  // namespace support
