// Random supplies of oil.
#include <algorithm>

#include "hard/random_deck.hpp"

namespace hard {
namespace {

using Entries = std::vector<Entry>;

bool has(const Entries& entries, const char* section, const char* name) {
  return std::ranges::any_of(entries, [&](const Entry& e) { return e.section == section && e.name == name; });
}

void add_passes(Entries& entries, Random& random, bool si) {
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"supply", name, value}); };
  add("passes", std::to_string(whole(random, 1, 4)));
  if (random.chance(0.3)) add("returning", pick<std::string>(random, {"both", "surface1", "surface2"}));
  if (si && random.chance(0.3)) add("pass_time", written(random, log_between(random, 1e-3, 10.0)));
}

void vary_in_time(Entries& entries, Random& random) {
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"transient", name, value}); };
  if (random.chance(0.4)) {
    const std::string time = written(random, log_between(random, 1e-3, 1.0));
    add("supply", "0:1 " + time + ":" + written(random, random.chance(0.1) ? 0.0 : random.between(0.2, 2.0)));
  }
  if (random.chance(0.2)) add("supply_wave", written(random, random.between(-0.9, 0.9)) + " 0.5");
}

}  // namespace

void vary_supply(Entries& entries, Random random, double share, bool& ordinary) {
  const bool in_time = has(entries, "transient", "end_time");
  const bool si = has(entries, "contact", "radius_x");
  if (in_time && random.chance(0.15)) entries.push_back({"transient", "cavitation", "content"});
  if (!random.chance(share)) return;
  ordinary = false;
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"supply", name, value}); };
  const double H_oil = random.chance(0.1) ? log_between(random, 1e-4, 1e2) : log_between(random, 0.01, 1.0);
  const double micrometres = 1e-6 * H_oil;
  const int way = si ? whole(random, 0, 3) : 0;
  if (way == 0) add("H_oil", written(random, H_oil));
  if (way == 1) add("layer_m", written(random, micrometres));
  if (way == 2) {
    add("layer1_m", written(random, micrometres));
    add("layer2_m", random.chance(0.3) ? "0" : written(random, 2.0 * micrometres));
  }
  if (way == 3) add("flow_m3_per_s", written(random, log_between(random, 1e-14, 1e-8)));
  if (random.chance(in_time ? 0.03 : 0.2)) add_passes(entries, random, si);
  if (in_time) vary_in_time(entries, random);
}

}  // namespace hard
