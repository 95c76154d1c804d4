// Random oils beyond the three common laws, shear thinning, and friction.
#include <algorithm>
#include <cmath>

#include "hard/random_deck.hpp"

namespace hard {
namespace {

using Entries = std::vector<Entry>;

// A value close to that of a real oil; occasionally several times that.
double near(Random& random, double value) {
  return value * (random.chance(0.1) ? log_between(random, 0.2, 5.0) : random.between(0.9, 1.1));
}

std::string random_oil_table(Random& random) {
  std::string text = random.chance(0.7) ? "p [Pa], eta [Pa s], rho [kg/m^3]\n" : "";
  const double alpha = log_between(random, 5e-9, 3e-8);
  const double highest = log_between(random, 3e8, 2e10);
  const int rows = random.chance(0.9) ? whole(random, 4, 60) : whole(random, 1, 4);
  double p = 0.0;
  for (int row = 0; row < rows; ++row) {
    const double eta = 0.05 * std::exp(alpha * 5e8 * std::log1p(p / 5e8));
    text += written(random, p) + ", ";
    text += written(random, eta) + ", ";
    text += written(random, 850.0 * (5.9e8 + 1.34 * p) / (5.9e8 + p)) + "\n";
    p += highest / rows * random.between(0.2, 1.8);
  }
  return text;
}

void add_tait(Entries& entries, Random& random) {
  const auto add = [&](const char* name, double value) {
    entries.push_back({"lubricant", name, written(random, value)});
  };
  add("K0", near(random, 1.4e9));
  add("K0_prime", near(random, 10.5));
}

void add_doolittle(Entries& entries, Random& random) {
  const auto add = [&](const char* name, double value) {
    entries.push_back({"lubricant", name, written(random, value)});
  };
  add("doolittle_B", near(random, 4.2));
  add("doolittle_R0", near(random, 0.67));
}

void add_yasutomi(Entries& entries, Random& random) {
  const auto add = [&](const char* name, double value) {
    entries.push_back({"lubricant", name, written(random, value)});
  };
  add("temperature", near(random, 30.0));
  add("Tg0", -near(random, 83.2));
  add("A1", near(random, 189.0));
  add("A2", near(random, 0.72e-9));
  add("b1", near(random, 8.2e-9));
  add("b2", -near(random, 0.53));
  add("C1", near(random, 16.1));
  add("C2", near(random, 17.4));
  add("eta_g", 1e12);
}

void replace_oil(Entries& entries, Random& random) {
  const auto of_oil = [](const Entry& entry) { return entry.section == "lubricant"; };
  const auto is_eta0 = [&](const Entry& entry) { return of_oil(entry) && entry.name == "eta0"; };
  const auto found = std::ranges::find_if(entries, is_eta0);
  const std::string eta0 = found == entries.end() ? "0.05" : found->value;
  std::erase_if(entries, of_oil);
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"lubricant", name, value}); };
  const auto oil = pick<std::string>(random, {"fluid", "table", "doolittle", "yasutomi", "roelands"});
  if (oil == "fluid") {
    const auto name =
        pick<std::string>(random, {"mourier", "mineral-vg32", "mineral-vg460", "pao4", "pao40", "squalane"});
    add("fluid", name);
    const bool graded = name.starts_with("mineral") || name.starts_with("pao");
    if (graded && random.chance(0.5)) add("temperature", written(random, random.between(-30.0, 190.0)));
    return;
  }
  add("viscosity", oil);
  if (oil == "table") add("table", "oil.csv");
  if (oil == "doolittle" || oil == "roelands") add("eta0", eta0);
  if (oil == "doolittle") add_doolittle(entries, random);
  if (oil == "yasutomi") add_yasutomi(entries, random);
  if (oil == "roelands") add("alpha", written(random, log_between(random, 8e-9, 3.5e-8)));
  const auto density =
      pick<std::string>(random, {"tait", "murnaghan", "dowson-higginson", oil == "table" ? "table" : "tait"});
  add("density", density);
  if (oil == "doolittle" || density == "tait" || density == "murnaghan") add_tait(entries, random);
}

void add_shear(Entries& entries, Random& random) {
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"shear", name, value}); };
  const bool eyring = random.chance(0.5);
  add("law", eyring ? "eyring" : "carreau");
  const double stress = random.chance(0.1) ? log_between(random, 1.0, 1e14) : log_between(random, 1e6, 3e7);
  add(eyring ? "tau_0" : "G", written(random, stress));
  if (!eyring) add("n", written(random, random.chance(0.1) ? random.between(0.01, 1.0) : random.between(0.3, 0.9)));
  const auto slides = [](const Entry& entry) { return entry.section == "motion" && entry.name != "u_m"; };
  if (std::ranges::none_of(entries, slides))
    entries.push_back({"motion", "srr", written(random, random.between(-2.0, 2.0))});
}

void add_friction(Entries& entries, Random& random) {
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"friction", name, value}); };
  add("cavitated", pick<std::string>(random, {"none", "striated", "full"}));
  if (random.chance(0.3)) add("limit", written(random, log_between(random, 0.01, 1.0)));
  if (random.chance(0.3)) add("fields", pick<std::string>(random, {"tau1", "tau1, tau2"}));
}

}  // namespace

void vary_oil(std::vector<Entry>& entries, std::vector<File>& files, Random random, bool& ordinary) {
  if (entries.front().section == "case") return;  // a dry contact
  const bool si = entries.front().name == "radius_x";
  const bool in_time = std::ranges::any_of(entries, [](const Entry& entry) { return entry.section == "transient"; });
  const auto vary = [&](double share, auto how) {
    if (!random.chance(share)) return;
    how(entries, random);
    ordinary = false;
  };
  vary(si ? 0.3 : 0.02, replace_oil);
  vary(in_time ? 0.01 : si ? 0.2 : 0.05, add_shear);
  vary(si ? 0.3 : in_time ? 0.2 : 0.05, add_friction);
  const auto slides = [](const Entry& entry) { return entry.section == "shear" || entry.section == "friction"; };
  const bool moes = std::ranges::any_of(entries, [](const Entry& entry) { return entry.name == "M"; });
  if (moes && std::ranges::any_of(entries, slides))
    entries.push_back({"contact", "a_over_R", written(random, log_between(random, 1e-3, 5e-2))});
  if (std::ranges::any_of(entries, [](const Entry& entry) { return entry.value == "oil.csv"; }))
    files.push_back({"oil.csv", random_oil_table(random)});
}

}  // namespace hard
