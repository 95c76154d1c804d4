// Keys of [transient] that are schedules, and all keys of [body].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "deck/file.hpp"
#include "deck/record.hpp"
#include "deck/text_table.hpp"
#include "transient/keys.hpp"

namespace ehl::transient {

std::vector<deck::Key> drive_keys() {
  using namespace deck::record;
  const auto schedule = [](const char* name, const char* note, const char* meaning, const char* shown) {
    return key(name, deck::Names::file_or_list, otherwise(note), example(shown), meaning);
  };
  const char* const of_motion = "constant: from [motion], else 1";
  return {
      schedule(
          "load", "constant",
          "Load over that of [contact] against time: 'time:value ...', linear between the times; a time given twice is "
          "a jump. Or the name of a text file with the columns t and load, in the working folder or beside the deck; "
          "its heading may name the unit of t.",
          "1:1 1.1:1.3"),
      schedule("load_wave", "none",
               "Oscillating load, 'amplitude period [start]': multiplies the load by 1 + amplitude sin(2 pi (t - "
               "start)/period).",
               "0.3 2"),
      schedule(
          "u1", of_motion,
          "Speed of surface 1 over the entrainment speed u_m of [motion] (of M and L without [motion]), written like "
          "load. The film moves with (u1 + u2)/2. Where that turns negative the oil enters at positive x; the domain "
          "must then extend equally far to both sides.",
          "1:1 2:0 3:0 4:1"),
      schedule("u1_wave", "none", "Oscillation of u1, written like load_wave.", "0.5 4"),
      schedule("u2", of_motion, "Speed of surface 2, written like u1.", "1:1 2:0 3:0 4:1"),
      schedule("u2_wave", "none", "Oscillation of u2, written like load_wave.", "0.5 4"),
      schedule(
          "supply", "constant",
          "Supplied oil over that of [supply] against time, written like load; it must be 1 at time 0. A layer on a "
          "surface arrives with the speed of that surface; a given flow is a thicker layer when the motion is slower.",
          "1:1 2:0.3"),
      schedule("supply_wave", "none", "Oscillation of supply, written like load_wave.", "0.3 2")};
}

std::vector<deck::Key> body_keys() {
  using namespace deck::record;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {key("mass", in_SI("_kg", "kg", "0.1"), positive, otherwise("none: the load is prescribed"), example("2"),
              "Mass of the moving body, in F R/u_m^2. H00 then follows mass H00'' + damping H00' = load that the film "
              "carries - load that acts, both over the load of [contact]. The load that acts may be zero."),
          key("damping", in_SI("_Nspm", "N s/m", "100"), Range{0.0, infinity}, otherwise("0"), example("0.1"),
              "Damping of the moving body, in F R/(a u_m)."),
          key("gap", in_SI("_m", "m", "1e-6"), positive, otherwise("none: the run starts from the steady film"),
              example("2"), "H00 at time 0, in a^2/R: the bodies start separated, without pressure."),
          key("velocity", in_SI("_mps", "m/s", "-0.1"), Range{-infinity, infinity}, otherwise("0"), example("-1"),
              "H00' at time 0, in a u_m/R. A negative value means that the bodies approach.")};
}

namespace {

// An entry is NaN if its cell is not a number.
std::vector<double> numbers_in(const std::vector<std::string>& cells) {
  std::vector<double> numbers;
  for (const std::string& cell : cells) numbers.push_back(deck::read_number(cell).value);
  return numbers;
}

bool all_finite(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

std::vector<Schedule::Point> points_of_file(const deck::Part& part, const std::string& key) {
  const std::string path = deck::found_beside(part.deck, part.section, key);
  const std::string time_unit = part.word("time_unit") == "seconds" ? "s" : "a/u_m";
  const char* unit_of_time = time_unit == "s" ? "" : "or in seconds with time_unit = seconds";
  const char* whole = key == "load"     ? "relative to that of [contact]"
                      : key == "supply" ? "relative to that of [supply]"
                                        : "relative to the entrainment speed of [motion]";
  const deck::ReadColumns read = deck::read_columns(
      path, {{{"t", "time", "T"}, time_unit, true, unit_of_time}, {{key, "value", "factor"}, "-", true, whole}},
      " ([transient] " + key + ")");
  std::vector<Schedule::Point> points;
  if (const auto* wrong = std::get_if<std::string>(&read))
    part.complain(key, *wrong);
  else
    for (const deck::ColumnRow& row : std::get<deck::ColumnTable>(read).rows)
      points.push_back({row.values[0], row.values[1]});
  return points;
}

std::vector<Schedule::Point> points_of_words(const deck::Part& part, const std::string& key, const std::string& text) {
  std::vector<Schedule::Point> points;
  for (const std::string& word : deck::split_words(text)) {
    const std::size_t colon = std::min(word.find(':'), word.size());
    const double T = deck::read_number(word.substr(0, colon)).value;
    const double value = colon < word.size() ? deck::read_number(word.substr(colon + 1)).value : core::unknown;
    if (!std::isfinite(T + value)) {
      part.complain(key, "'" + word + "' is not of the form time:value, as in 1:1 1.1:1.3");
      return {};
    }
    points.push_back({T, value});
  }
  return points;
}

// A schedule with times in a/u_m. in: key; unit of time; value if the deck gives none.
Schedule schedule_of(const deck::Part& part, const std::string& key, double unit, double otherwise) {
  Schedule schedule;
  if (otherwise != 1.0) schedule.points = {{0.0, otherwise}};
  const std::string text = part.word(key);
  if (!text.empty())
    schedule.points = deck::names_file(*deck::find_key(part.deck.catalogue, part.section, key), text)
                          ? points_of_file(part, key)
                          : points_of_words(part, key, text);
  for (std::size_t k = 0; k < schedule.points.size(); ++k) {
    if (schedule.points[k].T < 0.0) part.complain(key, "contains a negative time: times must be >= 0");
    if (k > 0 && schedule.points[k].T < schedule.points[k - 1].T)
      part.complain(key, "contains times that fall: they must rise, or be equal for a jump");
    if (k > 1 && schedule.points[k].T == schedule.points[k - 2].T)
      part.complain(key, "contains the same time three times: a jump has two values");
  }
  for (Schedule::Point& point : schedule.points) point.T /= unit;
  const std::string wave_key = key + "_wave";
  const std::vector<double> wave = numbers_in(deck::split_words(part.word(wave_key)));
  if (!part.given(wave_key)) return schedule;
  const bool right = (wave.size() == 2 || wave.size() == 3) && all_finite(wave);
  if (!right)
    part.complain(wave_key, "must be 'amplitude period' or 'amplitude period start'");
  else if (!(wave[1] > 0.0) || (wave.size() == 3 && wave[2] < 0.0))
    part.complain(wave_key, "the period must be positive and the start not negative");
  else
    schedule.wave = Schedule::Wave{wave[0], wave[1] / unit, wave.size() == 3 ? wave[2] / unit : 0.0};
  return schedule;
}

}  // namespace

double reversal(const Conditions& conditions, double end) {
  constexpr int samples = 4000;  // times between the stops, for the wave; a shorter dip is not seen
  std::vector<double> times = stops_of(conditions, end);
  for (int k = 0; k <= samples; ++k) times.push_back(end * k / samples);
  for (const Schedule* speed : {&conditions.u1, &conditions.u2})
    for (const Schedule::Point& point : speed->points)
      if (point.T <= end) times.push_back(point.T);
  std::ranges::sort(times);
  const auto backwards = [&](double T) { return drive_at(conditions, T).speed < 0.0; };
  const auto found = std::ranges::find_if(times, backwards);
  if (found == times.end()) return std::numeric_limits<double>::infinity();
  double before = found == times.begin() ? 0.0 : *(found - 1), after = *found;
  constexpr int halvings = 50;
  for (int k = 0; k < halvings; ++k) (backwards(0.5 * (before + after)) ? after : before) = 0.5 * (before + after);
  return before;
}

std::optional<Cycle> read_drive(const deck::Part& transient, double unit, const Scales& scales,
                                const deck::ColumnTable* of_machine, Conditions& conditions) {
  conditions.load = schedule_of(transient, "load", unit, 1.0);
  conditions.u1 = schedule_of(transient, "u1", unit, scales.u1);
  conditions.u2 = schedule_of(transient, "u2", unit, scales.u2);
  conditions.supply.factor = schedule_of(transient, "supply", unit, 1.0);
  std::optional<Cycle> cycle = read_cycle(transient, unit, scales, of_machine);
  if (!cycle) return cycle;
  const auto take = [&](const char* key, const Schedule& column, Schedule& schedule) {
    if (column.points.empty()) return;
    const std::string wave = std::string(key) + "_wave";
    transient.refuse({key, wave}, std::string("the table of cycle has a column ") + key + ": remove one of them");
    schedule = column;
  };
  take("load", cycle->load, conditions.load);
  take("u1", cycle->u1, conditions.u1);
  take("u2", cycle->u2, conditions.u2);
  conditions.radius = cycle->radius;
  return cycle;
}

namespace {

// A flow that reverses is computed on the mirror image of the grid.
void check_reversal(const deck::Part& part, const std::string& key, double time, const core::Grid& grid) {
  if (grid.X_b == -grid.X_a) return;
  const std::string unit = part.word("time_unit") == "seconds" ? "s" : "a/u_m";
  part.complain(key, fmt::format("(u1 + u2)/2 turns negative after {:.6g} {}, and the oil then enters at positive x, "
                                 "but the domain ends there at {:g} Hertz radii: set [domain] x_outlet = {:g}",
                                 time, unit, grid.X_b, -grid.X_a));
}

}  // namespace

void check_drive(const deck::Part& part, double unit, const Conditions& conditions, double end,
                 const core::Grid& grid) {
  const std::optional<Body>& body = conditions.body;
  const char* of_load = part.given("load_wave") ? "load_wave" : part.given("load") ? "load" : "cycle";
  if (body && least(conditions.load, end) < 0.0) part.complain(of_load, "the load must not be negative");
  if (body && !body->gap && !(value(conditions.load, 0.0) > 0.0))
    part.complain(of_load,
                  "the load must be positive at time 0, because the body starts from the steady film; or give a gap");
  if (!body && !(least(conditions.load, end) > 0.0))
    part.complain(of_load,
                  "the load must stay positive until the end: otherwise the bodies would separate; [body] allows that");
  const char* key = part.given("cycle") ? "cycle" : part.given("u1") || part.given("u1_wave") ? "u1" : "u2";
  if (const double turn = reversal(conditions, end); turn <= end && turn > 0.0)
    check_reversal(part, key, turn * unit, grid);
  if (value(conditions.supply.factor, 0.0) != 1.0)
    part.complain("supply", "must be 1 at time 0, because [supply] gives the oil at that time");
  if (least(conditions.supply.factor, end) < 0.0)
    part.complain(part.given("supply_wave") ? "supply_wave" : "supply",
                  "the oil that [supply] gives must not be negative");
  const bool from_steady = (!body || !body->gap) && part.word("mode") != "quasi_steady";
  if (from_steady && drive_at(conditions, 0.0).speed <= 0.0)
    part.complain(key,
                  "(u1 + u2)/2 must be positive at time 0, because the run starts from that steady film: begin at "
                  "another time, or reverse x and both speeds");
}

std::optional<Body> read_body(deck::Deck& deck, const Scales& scales) {
  const double length = scales.radius, load = scales.load, u_m = scales.a / scales.time;
  Body body;
  // True if the deck gives the quantity.
  const auto take = [&](const char* name, const char* suffix, double unit, auto& quantity) {
    const double found = deck::number_in(deck, "body", name, {suffix, unit, scales.in_SI});
    if (std::isfinite(found)) quantity = found;
    return std::isfinite(found);
  };
  if (!take("mass", "_kg", load * length / (u_m * u_m), body.mass)) return std::nullopt;
  take("damping", "_Nspm", load * length / (scales.a * u_m), body.damping);
  take("gap", "_m", scales.height, body.gap);
  take("velocity", "_mps", scales.height / scales.time, body.velocity);
  return body;
}

}  // namespace ehl::transient
