#include "hard/random_deck.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace hard {
namespace {

using Entries = std::vector<Entry>;

// The length of a domain that the program chooses; it is at least as long as most.
constexpr double unknown_length = 48.0;

enum class Language { moes, hamrock_dowson, si };

std::string text(int value) { return std::to_string(value); }

// Moes' groups of the case, whatever the deck gives.
struct Groups {
  double M = 0.0;
  double L = 0.0;
};

Groups random_groups(Random& random, double most_M) {
  Groups groups;
  groups.M = log_between(random, 1.0, most_M);
  groups.L = random.chance(0.15) ? 0.0 : random.between(0.0, 30.0);
  return groups;
}

void add_lubricant(Entries& entries, Random& random, double L, bool si) {
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"lubricant", name, value}); };
  const std::string law = L == 0.0 ? "isoviscous" : pick<std::string>(random, {"barus", "roelands", "roelands"});
  if (law != "roelands" || random.chance(0.7)) add("viscosity", law);
  if (L == 0.0 && !si) {
    add("density", "incompressible");
    return;
  }
  const std::string density = pick<std::string>(random, {"incompressible", "dowson-higginson", "dowson-higginson"});
  if (density == "incompressible" || random.chance(0.7)) add("density", density);
  if (law != "isoviscous") add("alpha", written(random, log_between(random, 8e-9, 3.5e-8)));
  if (law == "roelands" && (si || random.chance(0.5))) add("z", written(random, random.between(0.4, 0.9)));
  if (law == "roelands" && random.chance(0.1)) add("p0", written(random, log_between(random, 1e8, 4e8)));
}

// Converts M and L to W, U, G with a typical speed number.
void add_hamrock_dowson(Entries& entries, Random& random, const Groups& groups) {
  const double U = log_between(random, 1e-13, 1e-9);
  entries.push_back({"contact", "W", written(random, groups.M * std::pow(2.0 * U, 0.75))});
  entries.push_back({"contact", "U", written(random, U)});
  entries.push_back({"contact", "G", groups.L == 0.0 ? "0" : written(random, groups.L * std::pow(2.0 * U, -0.25))});
}

double add_elastic(Entries& entries, Random& random) {
  const auto add = [&](const char* name, double value) {
    entries.push_back({"contact", name, written(random, value)});
  };
  const auto modulus = [&] { return random.chance(0.7) ? 206e9 : log_between(random, 1e7, 6e11); };
  const double E1 = modulus();
  if (random.chance(0.5)) {
    add("E_prime", E1);
    return E1;
  }
  const double E2 = modulus();
  add("E1", E1);
  add("nu1", random.between(0.15, 0.49));
  add("E2", E2);
  add("nu2", random.between(0.15, 0.49));
  return 2.2 / (1.0 / E1 + 1.0 / E2);  // approximately
}

void add_motion(Entries& entries, Random& random, double u_m) {
  const double srr = random.chance(0.5) ? 0.0 : random.between(-2.5, 2.5);
  if (random.chance(0.6)) {
    entries.push_back({"motion", "u_m", written(random, u_m)});
    if (srr != 0.0) entries.push_back({"motion", "srr", written(random, srr)});
  } else {
    entries.push_back({"motion", "u1", written(random, u_m * (1.0 + 0.5 * srr))});
    entries.push_back({"motion", "u2", written(random, u_m * (1.0 - 0.5 * srr))});
  }
}

// Radii, speeds, solids and oils of real machines, with the load that gives M. Occasionally one number is extreme.
void add_si(Entries& entries, Random& random, double most_M) {
  const int strange = random.chance(0.1) ? whole(random, 0, 2) : -1;
  const double far = log_between(random, 1e-6, 1e6);
  const double radius = log_between(random, 2e-3, 0.2);
  const double u_m = log_between(random, 1e-3, 20.0);
  const double eta0 = log_between(random, 2e-3, 3.0);
  const double M = log_between(random, 1.0, most_M);
  entries.push_back({"contact", "radius_x", written(random, radius * (strange == 0 ? far : 1.0))});
  if (random.chance(0.1)) entries.push_back({"contact", "radius_y", entries.front().value});
  const double E_prime = add_elastic(entries, random);
  const double U = eta0 * u_m / (E_prime * radius);
  const double load = M * std::pow(2.0 * U, 0.75) * E_prime * radius * radius;
  entries.push_back({"contact", "load", written(random, load * (strange == 1 ? far : 1.0))});
  add_motion(entries, random, u_m * (strange == 2 ? far : 1.0));
  entries.push_back({"lubricant", "eta0", written(random, eta0)});
  add_lubricant(entries, random, random.chance(0.1) ? 0.0 : 1.0, true);
}

void add_contact(Entries& entries, Random& random, double most_M, bool& ordinary) {
  const Language language =
      pick<Language>(random, {Language::moes, Language::moes, Language::hamrock_dowson, Language::si, Language::si});
  if (language == Language::si) {
    add_si(entries, random, most_M);
    ordinary = false;  // any L may result
    return;
  }
  const Groups groups = random_groups(random, most_M);
  if (language == Language::moes) {
    entries.push_back({"contact", "M", written(random, groups.M)});
    entries.push_back({"contact", "L", written(random, groups.L)});
  } else {
    add_hamrock_dowson(entries, random, groups);
  }
  add_lubricant(entries, random, groups.L, false);
  if (groups.L < 0.1) ordinary = ordinary && groups.L == 0.0;  // a very low Hertz pressure may be refused
}

// The domain: the program's own, or starved, narrow or very long. in: share of cases with a given inlet. out: its
// approximate length.
double add_domain(Entries& entries, Random& random, double share, bool& ordinary) {
  double length = unknown_length;
  if (random.chance(share)) {
    double inlet = random.between(2.5, 8.0);
    if (random.chance(0.15)) inlet = 1.0 + log_between(random, 0.01, 1.0);
    if (random.chance(0.1)) inlet = log_between(random, 8.0, 300.0);
    entries.push_back({"domain", "x_inlet", written(random, -inlet)});
    length = inlet + 1.5;
  } else {
    ordinary = false;  // a light load gets a long domain, for which the grid may be too coarse
  }
  if (random.chance(0.4)) {
    double outlet = random.between(1.3, 3.0);
    if (random.chance(0.2)) outlet = 1.0 + log_between(random, 0.01, 20.0);
    entries.push_back({"domain", "x_outlet", written(random, outlet)});
    length += outlet - 1.5;
  }
  return length;
}

// The grid, mostly fine enough for the domain. in: most: largest number of cells on an axis. out: cells along x.
int add_grid(Entries& entries, Random& random, double length, int most, bool& ordinary) {
  constexpr double widest_cell = 0.45;
  const bool with_coarsest = random.chance(0.3);
  int cells = with_coarsest ? whole(random, 4, 40) : whole(random, 16, 63);
  if (random.chance(0.4)) cells = pick<int>(random, {16, 32, 64});
  const int coarsest = cells;
  const bool careful = random.chance(0.9);
  while (2 * cells <= most && (cells < 16 || (careful && length / cells > widest_cell) || random.chance(0.7)))
    cells *= 2;
  if (random.chance(0.05)) cells = whole(random, 16, most);
  ordinary = ordinary && length / cells < widest_cell && (cells == coarsest || cells % (2 * coarsest) == 0);
  entries.push_back({"grid", "cells", text(cells)});
  if (with_coarsest) entries.push_back({"grid", "coarsest", text(coarsest)});
  return cells;
}

void add_width(Entries& entries, Random& random, double length, int cells) {
  // The length of the program's own domain, which limits this width, is not known here.
  const auto is_inlet = [](const Entry& entry) { return entry.name == "x_inlet"; };
  if (std::ranges::none_of(entries, is_inlet) || !random.chance(0.5)) return;
  double half_width = random.between(1.5, 5.0);
  if (random.chance(0.3)) half_width = log_between(random, 1.02, 60.0);
  const double widest = std::max(1.01, 0.5 * length * 128.0 / cells);
  entries.push_back({"domain", "y_half", written(random, std::min(half_width, widest))});
}

void add_deformation(Entries& entries, Random& random, int cells, bool& ordinary) {
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"deformation", name, value}); };
  if (random.chance(0.3)) return;
  // On the largest of these grids the direct sum would take a minute.
  const std::string method = cells <= 32 && random.chance(0.4) ? "direct" : random.chance(0.35) ? "fft" : "mlmi";
  add("method", method);
  if (method != "mlmi") return;
  if (random.chance(0.3)) add("order", pick<std::string>(random, {"4", "6", "8"}));
  if (random.chance(0.2)) add("patch_along", text(whole(random, 1, 14)));
  if (random.chance(0.2)) add("patch_across", text(whole(random, 1, 14)));
  if (random.chance(0.2)) {
    add("coarsenings", text(whole(random, 0, 6)));
    ordinary = false;  // some numbers do not fit the grid
  }
  if (random.chance(0.2)) add("coarsest_sum", pick<std::string>(random, {"fft", "direct"}));
}

void add_multigrid(Entries& entries, Random& random, bool& ordinary) {
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"multigrid", name, value}); };
  if (random.chance(0.4)) return;
  if (random.chance(0.5)) add("cycle", pick<std::string>(random, {"V", "W", "F"}));
  if (random.chance(0.4)) {
    const int pre = whole(random, 0, 3);
    const int post = whole(random, 0, 3);
    add("pre", text(pre));
    add("post", text(post));
    ordinary = ordinary && pre + post > 0;
  }
  if (random.chance(0.3)) add("cycles", text(whole(random, 1, 6)));
  if (random.chance(0.4)) add("tolerance", written(random, log_between(random, 1e-11, 1e-1)));
  if (random.chance(0.4)) add("max_cycles", text(whole(random, 1, 60)));
  if (random.chance(0.2)) add("line_solver", pick<std::string>(random, {"elimination", "decimation"}));
  if (random.chance(0.2)) add("kernel_terms", pick<std::string>(random, {"3", "5", "7"}));
}

void add_path(Entries& entries, Random& random, bool& ordinary) {
  const auto add = [&](const char* section, const char* name, const std::string& value) {
    entries.push_back({section, name, value});
  };
  if (random.chance(0.2)) add("multigrid", "polish", pick<std::string>(random, {"rescue", "always", "off"}));
  if (!random.chance(0.2)) return;
  const std::string path = pick<std::string>(random, {"automatic", "load", "load", "off"});
  add("continuation", "path", path);
  if (path == "off") return;
  const bool si = entries.front().name == "radius_x";
  if (random.chance(0.3))
    add("continuation", si ? "load_start" : "M_start", written(random, log_between(random, 0.5, 200.0)));
  if (random.chance(0.3)) add("continuation", "step", written(random, random.between(1.1, 5.0)));
  if (random.chance(0.3)) add("continuation", "max_steps", text(whole(random, 1, 30)));
  ordinary = ordinary && !si;  // the load may exceed all limits
}

}  // namespace

std::vector<Entry> random_case(Random& random, bool& ordinary) {
  const double kind = random.between(0.0, 1.0);
  const bool in_time = kind < 0.25;
  const bool at_rest = !in_time && kind < 0.32;
  const bool smooth = kind >= 0.4;
  ordinary = ordinary && smooth;
  if (!in_time && !at_rest && !smooth) return random_dry_case(random);
  Entries entries;
  add_contact(entries, random, in_time ? 200.0 : 1e4, ordinary);  // higher loads need finer grids
  const bool si = entries.front().name == "radius_x";
  if (random.chance(0.5))
    entries.push_back(
        {"case", "title", pick<std::string>(random, {"a", "two words", "\"q\" \\ /", "µ — 薄膜", "50 %s %n"})});
  const double length = add_domain(entries, random, smooth ? 0.7 : 0.9, ordinary);
  const int cells = add_grid(entries, random, length, in_time ? 64 : 128, ordinary);
  add_width(entries, random, length, cells);
  if (random.chance(0.6))
    entries.push_back({"discretization", "wedge", pick<std::string>(random, {"upstream1", "upstream2"})});
  add_deformation(entries, random, cells, ordinary);
  add_multigrid(entries, random, ordinary);
  if (random.chance(0.2))
    entries.push_back(
        {"output", "fields", pick<std::string>(random, {"P", "P, H", "H P rho_bar", "P,H,rho_bar,ln_eta_bar"})});
  add_path(entries, random, ordinary);
  if (random.chance(0.1)) add_subsurface(entries, random);
  if (in_time) add_in_time(entries, random, si);
  if (at_rest) add_at_rest(entries, random, si);
  return entries;
}

RandomDeck random_deck(std::uint64_t seed, const std::vector<KnownKey>& keys, const Shares& shares) {
  // Neighbouring seeds must give unrelated decks.
  Random random(seed * 0x9E3779B97F4A7C15ULL + 1);
  constexpr double share_of_damaged = 0.35;
  RandomDeck deck;
  deck.ordinary = true;
  Entries entries = random_case(random, deck.ordinary);
  make_elliptic(entries, Random(seed * 0x9E3779B97F4A7C15ULL + 3), deck.ordinary);
  vary_oil(entries, deck.files, Random(seed * 0x9E3779B97F4A7C15ULL + 5), deck.ordinary);
  vary_supply(entries, Random(seed * 0x9E3779B97F4A7C15ULL + 7), shares.supplies, deck.ordinary);
  add_heat(entries, Random(seed * 0x9E3779B97F4A7C15ULL + 9), shares.heat, deck.ordinary);
  make_line(entries, Random(seed * 0x9E3779B97F4A7C15ULL + 11), shares.lines, deck.ordinary);
  take_input(entries, deck.files, Random(seed * 0x9E3779B97F4A7C15ULL + 13), shares.inputs, deck.ordinary);
  const bool damaged = random.chance(share_of_damaged);
  if (damaged && random.chance(0.6)) damage_entries(entries, keys, random, deck.damage);
  if (random.chance(0.2)) {
    const Entry moved = entries.back();
    if (random.chance(0.5)) entries.pop_back();
    deck.overrides.push_back(moved.section + "." + moved.name + "=" + moved.value);
  }
  if (random.chance(0.2)) deck.threads = 2;
  deck.text = deck_text(entries, random);
  std::ranges::move(files_of(entries, random), std::back_inserter(deck.files));
  if (random.chance(0.1))
    for (File& file : deck.files) damage_text(file.text, random, deck.damage);
  if (damaged && deck.damage.empty()) damage_text(deck.text, random, deck.damage);
  if (damaged || !deck.damage.empty()) deck.ordinary = false;
  return deck;
}

}  // namespace hard
