#pragma once
// Runs contacts with heat through the program, and checks what holds for all of them.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "support/json.hpp"
#include "support/program.hpp"

namespace support {

/// A folder that contains the deck d.ini.
struct HeatedScene {
  TemporaryFolder folder;
  explicit HeatedScene(const std::string& deck) { folder.write("d.ini", deck); }
  Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }
  /// The JSON report of a run. in: changes to the deck, as options.
  nlohmann::json run(const std::string& changes) const {
    const Ended ended = ehl("run d.ini --json --quiet --overwrite --output d.h5 " + changes);
    BOOST_TEST_REQUIRE(ended.status == 0, changes << ": " << ended.err);
    return parsed(ended.out);
  }
};

inline void check_close(const std::string& name, double value, double reference, double tolerance) {
  BOOST_TEST_MESSAGE(name << " " << value << ", expected " << reference << ", " << value / reference - 1
                          << " off (tolerance " << tolerance << ")");
  BOOST_TEST(std::abs(value / reference - 1) < tolerance);
}

/// The isothermal film of a run with heat equals that of the deck without [thermal] bit for bit.
inline void check_isothermal_beside(const nlohmann::json& with, const nlohmann::json& without) {
  BOOST_TEST(number_at(with, "/thermal/Hc_isothermal") == number_at(without, "/Hc"));
  BOOST_TEST(number_at(with, "/thermal/Hm_isothermal") == number_at(without, "/Hm"));
  BOOST_TEST(number_at(with, "/thermal/mu_isothermal") == number_at(without, "/friction/mu"));
}

/// If the bodies are swapped, the film stays the same and the friction changes its sign.
inline void check_mirrored(const nlohmann::json& one, const nlohmann::json& other) {
  const auto same = [&](const char* name, const char* mirrored, double sign) {
    const double off = number_at(one, name) / (sign * number_at(other, mirrored)) - 1;
    BOOST_TEST_MESSAGE(name << ": " << off << " off (tolerance 1e-10)");
    BOOST_TEST(std::abs(off) < 1e-10);
  };
  same("/thermal/mu", "/thermal/mu", -1);
  same("/Hc", "/Hc", 1);
  same("/Hm", "/Hm", 1);
  same("/thermal/T_film_max", "/thermal/T_film_max", 1);
  same("/thermal/T1_max", "/thermal/T2_max", 1);
  same("/thermal/heat_1", "/thermal/heat_2", 1);
}

/// With a small dependence on temperature and no expansion, the loss of friction is proportional to beta. out: the
/// smaller of two losses of friction.
inline double check_little_change(const HeatedScene& scene) {
  const std::string bare = "--set thermal.expansion=0 --set thermal.compression=off --set thermal.beta=";
  const auto loss = [](const nlohmann::json& found) {
    return 1 - number_at(found, "/thermal/mu") / number_at(found, "/thermal/mu_isothermal");
  };
  const double more = loss(scene.run(bare + "4e-4")), less = loss(scene.run(bare + "2e-4"));
  BOOST_TEST_MESSAGE("loss of friction " << more << " and " << less << ", ratio " << more / less << " (2 +- 0.1)");
  BOOST_TEST(less > 0);
  BOOST_TEST(std::abs(more / less - 2) < 0.1);
  return less;
}

}  // namespace support
