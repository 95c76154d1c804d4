// Random heat and flow thinning.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "hard/random_deck.hpp"

namespace hard {
namespace {

using Entries = std::vector<Entry>;

template <class Is>
bool any(const Entries& entries, Is is) {
  return std::ranges::any_of(entries, is);
}

// Heat and flow thinning are drawn only if they are available; occasionally they are drawn nevertheless.
bool possible(const Entries& entries) {
  return entries.front().name == "radius_x" && !any(entries, [](const Entry& entry) {
           return entry.section == "transient" || (entry.name == "polish" && entry.value == "always");
         });
}

bool starved(const Entries& entries) {
  return any(entries, [](const Entry& entry) { return entry.section == "supply"; });
}

// True for oils without a temperature, or with one of their own.
bool with_beta(const Entries& entries) {
  return !any(entries, [](const Entry& entry) {
    return entry.name == "fluid" || entry.value == "doolittle" || entry.value == "yasutomi" || entry.value == "table";
  });
}

// A ball or roller on steel at typical pressures and speeds. A random contact that ignores heat seldom
// has a solution with heat.
Entries usual_contact(Random& random) {
  Entries entries;
  const auto add = [&](const char* section, const char* name, double value) {
    entries.push_back({section, name, written(random, value)});
  };
  const double R = log_between(random, 5e-3, 3e-2), E_prime = 2.26e11, p_h = random.between(0.4e9, 1.5e9);
  const double a = std::numbers::pi * p_h * R / E_prime;
  add("contact", "radius_x", R);
  add("contact", "load", 2.0 / 3.0 * std::numbers::pi * a * a * p_h);
  add("contact", "E_prime", E_prime);
  add("motion", "u_m", log_between(random, 0.5, 20.0));
  add("motion", "srr", random.chance(0.1) ? 0.0 : random.between(-2.0, 2.0));
  add("lubricant", "eta0", log_between(random, 0.01, 0.1));
  add("lubricant", "alpha", random.between(12e-9, 24e-9));
  entries.push_back({"grid", "cells", pick<std::string>(random, {"64", "96"})});
  if (random.chance(0.7)) {
    entries.push_back({"shear", "law", "eyring"});
    add("shear", "tau_0", log_between(random, 1e6, 1e7));
  }
  if (random.chance(0.5)) entries.push_back({"friction", "cavitated", "striated"});
  if (entries.back().section == "friction" && random.chance(0.5)) entries.push_back({"friction", "limit", "0.08"});
  return entries;
}

}  // namespace

void add_heat(std::vector<Entry>& entries, Random random, double share, bool& ordinary) {
  if (entries.front().section == "case") return;  // a dry contact
  const bool usual = random.chance(share);
  if (usual) {
    Entries supply;
    std::ranges::copy_if(entries, std::back_inserter(supply),
                         [](const Entry& entry) { return entry.section == "supply"; });
    entries = usual_contact(random);
    entries.insert(entries.end(), supply.begin(), supply.end());
  }
  const bool can = usual || possible(entries);
  const bool thins = any(entries, [](const Entry& entry) { return entry.section == "shear"; });
  if (thins && random.chance(can && !starved(entries) ? 0.3 : 0.01)) {
    entries.push_back({"shear", "flow", "on"});
    ordinary = false;
  }
  if (!random.chance(usual ? 0.9 : can ? 0.2 : 0.01)) return;
  ordinary = false;
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"thermal", name, value}); };
  const auto number = [&](const char* name, double value) { add(name, written(random, value)); };
  number("T_oil", random.between(20.0, 100.0));
  if (with_beta(entries) || random.chance(0.05)) number("beta", random.between(0.02, 0.06));
  if (random.chance(0.2)) number("T_body1", random.between(0.0, 120.0));
  for (const char* solid : {"solid1", "solid2"})
    add(solid, pick<std::string>(random, {"steel", "steel", "bk7", "sapphire", "si3n4", "wc", "zro2"}));
  if (random.chance(0.3)) number("k", random.between(0.1, 0.2));
  if (random.chance(0.3)) number("expansion", random.between(4e-4, 1e-3));
  if (random.chance(0.3)) add("nodes", pick<std::string>(random, {"9", "17", "33"}));
  if (random.chance(0.2)) add("convection", pick<std::string>(random, {"on", "off"}));
  if (random.chance(0.2)) add("compression", "off");
  if (random.chance(0.2)) add("solids", "lines");
  if (random.chance(0.3)) add("fields", "T_mid, section");
}

}  // namespace hard
