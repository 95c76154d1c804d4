// Random effects: runs in time, moving bodies, surfaces, probes, dry contacts. Most values are
// typical, a few are extreme.
#include <algorithm>
#include <array>
#include <cmath>

#include "hard/random_deck.hpp"

namespace hard {
namespace {

using Entries = std::vector<Entry>;

// A value in its typical range or, rarely, in the wider one.
double sometimes_far(Random& random, double low, double high, double lowest, double highest) {
  return random.chance(0.1) ? log_between(random, lowest, highest) : log_between(random, low, high);
}

// Two numbers separated by a blank. One random number per statement: within one expression the
// compiler chooses the order.
std::string two(Random& random, double first, double second) {
  const std::string text = written(random, first);
  return text + " " + written(random, second);
}

// A schedule of "time:value" pairs. Times do not decrease; two equal ones are a jump.
std::string schedule(Random& random, double end, double low, double high, double rarely) {
  std::string text;
  double T = random.chance(0.5) ? 0.0 : random.between(0.0, 0.5 * end);
  for (int points = whole(random, 1, 4); points > 0; --points) {
    const double value = random.chance(0.04) ? rarely : random.between(low, high);
    if (!text.empty()) text += " ";
    const std::string time = written(random, T);
    T = std::stod(time);
    text += time + ":" + written(random, value);
    if (random.chance(0.7)) T += random.chance(0.1) ? 1e-6 * end : random.between(0.0, end);
  }
  return text;
}

void add_speeds(Entries& entries, Random& random, double end) {
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"transient", name, value}); };
  const std::string u1 = schedule(random, end, 0.0, 2.0, random.chance(0.5) ? 0.0 : -3.0);
  add("u1", u1);
  if (random.chance(0.6)) add("u2", random.chance(0.5) ? u1 : schedule(random, end, 0.0, 2.0, 0.0));
  if (!random.chance(0.2)) return;
  const double amplitude = random.between(-1.2, 1.2);
  add("u2_wave", two(random, amplitude, log_between(random, 0.1, 5.0)));
}

void add_body(Entries& entries, Random& random, double mass) {
  const auto add = [&](const char* name, double value) { entries.push_back({"body", name, written(random, value)}); };
  add("mass", mass);
  if (random.chance(0.4)) add("damping", sometimes_far(random, 1e-3, 10.0, 1e-8, 1e8));
  if (random.chance(0.5)) add("gap", sometimes_far(random, 0.02, 3.0, 1e-6, 1e3));
  if (random.chance(0.6))
    add("velocity", random.chance(0.8) ? -sometimes_far(random, 0.01, 3.0, 1e-8, 1e4) : random.between(0.0, 1.0));
}

void add_surface(Entries& entries, Random& random, const std::string& of, bool stands_in_Moes) {
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({of, name, value}); };
  const auto shape =
      pick<std::string>(random, {"dimple", "bump", "ridge", "groove", "waviness", "cavity", "map", "map"});
  add("shape", shape);
  if (stands_in_Moes) add("at_rest", "yes");
  if (shape == "map") {
    add("file", "map_" + of + ".csv");
    add("unit", written(random, sometimes_far(random, 1e-3, 0.1, 1e-8, 10.0)));
    add("dx", written(random, sometimes_far(random, 0.05, 0.5, 1e-4, 10.0)));
    if (random.chance(0.4)) add("dy", written(random, log_between(random, 0.05, 0.5)));
    if (random.chance(0.3)) add("taper", written(random, random.between(0.0, 0.5)));
  } else {
    add(random.chance(0.1) ? "height_m" : "height", written(random, sometimes_far(random, 2e-3, 0.3, 1e-7, 50.0)));
    add("width", written(random, sometimes_far(random, 0.8, 2.5, 1e-3, 100.0)));
    const bool has_direction = shape == "ridge" || shape == "groove" || shape == "waviness";
    if (has_direction && random.chance(0.5)) add("angle", written(random, random.between(-90.0, 90.0)));
  }
  if (random.chance(0.4)) add("x", written(random, random.between(-5.0, 1.0)));
  if (random.chance(0.3)) add("y", written(random, random.between(-1.0, 1.0)));
}

void add_surfaces(Entries& entries, Random& random, bool stands_in_Moes) {
  const bool both = random.chance(0.2);
  const bool first = random.chance(0.5);
  if (first || both) add_surface(entries, random, "surface1", stands_in_Moes && !both);
  if (!first || both) add_surface(entries, random, "surface2", stands_in_Moes);
}

// A map of unusual size, with or without a heading, with any separator.
std::string random_map(Random& random) {
  const int along = random.chance(0.9) ? whole(random, 8, 70) : whole(random, 1, 400);
  const int across = random.chance(0.9) ? whole(random, 8, 70) : whole(random, 1, 100);
  const auto separator = pick<std::string>(random, {",", ";", " ", ", "});
  const double wave = log_between(random, 2.0, 100.0);
  const double slope = random.between(-0.1, 0.1);
  std::string text = random.chance(0.3) ? "height in nm\n" : "";
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < along; ++i) {
      const double z = std::sin(6.28 * i / wave) * std::cos(3.0 * j / wave) + slope * i + 0.1 * random.between(-1, 1);
      text += written(random, z);
      text += i + 1 < along ? separator : "\n";
    }
  return text;
}

std::string random_table(Random& random) {
  std::string text = random.chance(0.5) ? "time, load\n" : "";
  double T = 0.0;
  for (int rows = whole(random, 1, 40); rows > 0; --rows) {
    text += written(random, T) + ", ";
    text += written(random, random.between(0.3, 1.5)) + "\n";
    T += log_between(random, 0.01, 0.3);
  }
  return text;
}

}  // namespace

void add_in_time(std::vector<Entry>& entries, Random& random, bool si) {
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"transient", name, value}); };
  const bool seconds = si && random.chance(0.3);
  const bool moves = random.chance(0.35);
  const double mass = sometimes_far(random, 1e-3, 10.0, 1e-7, 1e7);
  double end = seconds ? log_between(random, 1e-6, 1e-2) : sometimes_far(random, 0.05, 1.5, 1e-9, 20.0);
  if (moves && !seconds) end *= std::min(1.0, 30.0 * std::sqrt(mass));  // a few periods of vibration
  add("end_time", written(random, end));
  if (seconds) add("time_unit", "seconds");
  if (random.chance(0.4)) add("rtol", written(random, log_between(random, 1e-6, 5e-2)));
  const bool short_steps = random.chance(0.1);
  if (short_steps) add("max_step", written(random, end * log_between(random, 1e-3, 2.0)));
  if (seconds || short_steps || random.chance(0.2)) add("max_steps", std::to_string(whole(random, 1, 200)));
  if (random.chance(0.4)) add("output_interval", written(random, end * sometimes_far(random, 0.05, 1.5, 1e-9, 10.0)));
  if (random.chance(0.5))
    add("load", random.chance(0.1) ? "load.csv" : schedule(random, end, 0.05, 3.0, random.chance(0.5) ? 0.0 : -1.0));
  if (random.chance(0.2)) {
    const double amplitude = random.between(-0.95, 0.95);
    const std::string wave = two(random, amplitude, end * log_between(random, 0.05, 5.0));
    add("load_wave", wave + (random.chance(0.3) ? " 0.1" : ""));
  }
  if (random.chance(0.35)) add_speeds(entries, random, end);
  if (random.chance(0.1)) add("stop_film", written(random, log_between(random, 1e-3, 0.3)));
  if (random.chance(0.1)) add("stop_steady", written(random, log_between(random, 1e-8, 1e-2)));
  if (moves) add_body(entries, random, mass);
  if (random.chance(0.5)) add_surfaces(entries, random, false);
  if (random.chance(0.4))
    entries.push_back({"output", "probe",
                       pick<std::string>(random, {"0 0", "0 0, 0.7 0.2", "-1 -1, 1 1, 0.123 -0.456", "1.3 0", "-2.5 0",
                                                  "0 1.02", "99 0", "0, 0", "0 0,", "0 0 0", "nan 0", "1e-300 -0"})});
}

// Few planes, to save time.
void add_subsurface(std::vector<Entry>& entries, Random& random) {
  const auto add = [&](const char* name, const std::string& value) { entries.push_back({"subsurface", name, value}); };
  add("depth", written(random, log_between(random, 0.02, 10.0)));
  add("planes", std::to_string(whole(random, 3, 8)));
  if (random.chance(0.5)) add("cells", std::to_string(whole(random, 16, 200)));
  if (random.chance(0.5)) add("poisson", written(random, random.between(-0.5, 0.5)));
  if (random.chance(0.5)) add("friction", written(random, random.between(-0.6, 0.6)));
  if (random.chance(0.3)) add("fields", pick<std::string>(random, {"tau_xz", "sigma_x, sigma_mises", "tau_max"}));
}

void add_at_rest(std::vector<Entry>& entries, Random& random, bool si) {
  if (si && random.chance(0.9)) {
    std::erase_if(entries, [](const Entry& entry) { return entry.section == "motion"; });
    const std::string u = written(random, log_between(random, 1e-3, 20.0));
    const bool first_stands = random.chance(0.5);
    entries.push_back({"motion", "u1", first_stands ? "0" : u});
    entries.push_back({"motion", "u2", first_stands ? u : "0"});
  }
  add_surfaces(entries, random, !si);
}

std::vector<Entry> random_dry_case(Random& random) {
  Entries entries{{"case", "kind", "dry"}};
  const auto add = [&](const char* section, const char* name, const std::string& value) {
    entries.push_back({section, name, value});
  };
  const bool si = random.chance(0.5);
  if (si) {
    add("contact", "load", written(random, sometimes_far(random, 1.0, 100.0, 1e-8, 1e8)));
    add("contact", "radius_x", written(random, log_between(random, 1e-3, 0.1)));
    add("contact", "E_prime", written(random, log_between(random, 1e7, 5e11)));
  }
  if (random.chance(0.3)) add("domain", "x_inlet", written(random, -sometimes_far(random, 1.1, 3.0, 1.001, 500.0)));
  if (random.chance(0.3)) add("domain", "x_outlet", written(random, sometimes_far(random, 1.1, 3.0, 1.001, 500.0)));
  if (random.chance(0.3)) add("domain", "y_half", written(random, random.between(1.02, 3.0)));
  add("grid", "cells", pick<std::string>(random, {"16", "32", "48", "64", "64", "128"}));
  if (random.chance(0.5)) add("deformation", "method", pick<std::string>(random, {"mlmi", "fft"}));
  if (random.chance(0.3)) add("dry", "tolerance", written(random, log_between(random, 1e-12, 1e-2)));
  if (random.chance(0.3)) add("dry", "max_iterations", std::to_string(whole(random, 1, 1000)));
  if (random.chance(0.5)) add_surfaces(entries, random, false);
  if (random.chance(0.3)) add_subsurface(entries, random);
  return entries;
}

std::vector<File> files_of(const std::vector<Entry>& entries, Random& random) {
  std::vector<File> files;
  for (const Entry& entry : entries)
    if (entry.value.starts_with("map_"))
      files.push_back({entry.value, random_map(random)});
    else if (entry.value == "load.csv")
      files.push_back({entry.value, random_table(random)});
  return files;
}

void make_elliptic(std::vector<Entry>& entries, Random random, bool& ordinary) {
  const bool has_radius = std::ranges::any_of(entries, [](const Entry& entry) { return entry.name == "radius_y"; });
  if (has_radius || !random.chance(0.15)) return;
  entries.push_back({"contact", "radius_ratio", written(random, log_between(random, 0.06, 16.0))});
  if (random.chance(0.4)) entries.push_back({"motion", "angle", written(random, random.between(-90.0, 90.0))});
  ordinary = false;
}

void make_line(std::vector<Entry>& entries, Random random, double share, bool& ordinary) {
  const bool dry = entries.front().section == "case";
  if (dry || !random.chance(share)) return;
  ordinary = false;  // some decks keep what is allowed for points but refused for lines
  constexpr std::array of_points{"y_half", "radius_y",  "radius_ratio", "angle", "patch_across",
                                 "passes", "returning", "pass_time",    "y",     "probe"};
  const auto refused = [&](const Entry& entry) {
    return entry.section == "body" || std::ranges::find(of_points, entry.name) != of_points.end();
  };
  if (random.chance(0.95)) std::erase_if(entries, refused);
  const bool finer = random.chance(0.7);
  for (Entry& entry : entries) {
    const bool load = entry.section == "contact" && entry.name == "load";
    const bool round = entry.value == "dimple" || entry.value == "bump" || entry.value == "cavity";
    if (entry.name == "shape" && round) entry.value = "ridge";
    if (load) entry = {"contact", "load_per_length", written(random, log_between(random, 1e3, 1e6))};
    if (entry.name == "flow_m3_per_s")
      entry = {"supply", "flow_m2_per_s", written(random, log_between(random, 1e-9, 1e-5))};
    if (finer && entry.name == "cells" && entry.section == "grid")
      entry.value = std::to_string(8 * std::stoi(entry.value));
  }
  entries.push_back({"contact", "kind", "line"});
}

}  // namespace hard
