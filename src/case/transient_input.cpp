#include "case/transient_input.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "case/file_beside.hpp"
#include "case/transient_probes.hpp"
#include "deck/text.hpp"
#include "report/text_format.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;
using transient::Schedule;

constexpr const char* section = "transient";
constexpr double unset = std::numeric_limits<double>::quiet_NaN();

// Hertz radii over metres, a^2/R over metres, a/u_m over seconds; NaN without SI.
struct Units {
  double a = unset;
  double height = a;
  double time = a;
};

Units units_of(const Physics& physics) {
  if (!physics.si) return {};
  const double u_m = 0.5 * physics.si->contact.u_s;
  return {physics.si->hertz.a, physics.si->hertz.h_scale, physics.si->hertz.a / u_m};
}

std::vector<double> numbers_in(const std::string& text) {
  std::string spaced = text;
  std::ranges::replace(spaced, ',', ' ');
  std::ranges::replace(spaced, ';', ' ');
  std::vector<double> numbers;
  for (const std::string& word : deck::split_words(spaced)) {
    const deck::ReadNumber read = deck::read_number(word);
    numbers.push_back(read.status == deck::ReadNumber::Status::number ? read.value
                                                                      : std::numeric_limits<double>::quiet_NaN());
  }
  return numbers;
}

std::vector<Schedule::Point> points_of_file(deck::Deck& deck, const std::string& key) {
  const std::string path = found_beside(deck, section, key);
  std::ifstream file = opened(path, " ([transient] " + key + ")");
  std::vector<Schedule::Point> points;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    line = deck::trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    const std::vector<double> row = numbers_in(line);
    const bool numeric = row.size() == 2 && std::isfinite(row[0]) && std::isfinite(row[1]);
    if (!numeric && points.empty() && number == 1) continue;  // a heading
    if (!numeric) {
      complain(deck, section, key, path + ":" + std::to_string(number) + ": must be two numbers, time and value");
      return {};
    }
    points.push_back({row[0], row[1]});
  }
  if (points.empty()) complain(deck, section, key, path + " has no rows");
  return points;
}

std::vector<Schedule::Point> points_of_words(deck::Deck& deck, const std::string& key, const std::string& text) {
  std::vector<Schedule::Point> points;
  std::string spaced = text;
  std::ranges::replace(spaced, ',', ' ');
  for (const std::string& word : deck::split_words(spaced)) {
    const std::size_t colon = word.find(':');
    const std::vector<double> T = numbers_in(word.substr(0, colon));
    const std::vector<double> v = colon == std::string::npos ? T : numbers_in(word.substr(colon + 1));
    if (colon == std::string::npos || T.size() != 1 || v.size() != 1 || !std::isfinite(T[0] + v[0])) {
      complain(deck, section, key, "'" + word + "' is not time:value, as in 1:1 1.1:1.3");
      return {};
    }
    points.push_back({T[0], v[0]});
  }
  return points;
}

// A schedule in a/u_m. in: key; unit of time; value where the deck says nothing.
Schedule schedule_of(deck::Deck& deck, const std::string& key, double unit, double otherwise) {
  Schedule schedule;
  if (otherwise != 1.0) schedule.points = {{0.0, otherwise}};
  const std::string text = deck::word(deck, section, key);
  if (!text.empty())
    schedule.points = text.ends_with(".csv") ? points_of_file(deck, key) : points_of_words(deck, key, text);
  for (std::size_t k = 0; k < schedule.points.size(); ++k) {
    if (schedule.points[k].T < 0.0) complain(deck, section, key, "a time is negative");
    if (k > 0 && schedule.points[k].T < schedule.points[k - 1].T)
      complain(deck, section, key, "the times must not fall");
    if (k > 1 && schedule.points[k].T == schedule.points[k - 2].T)
      complain(deck, section, key, "the same time stands three times: a jump needs two");
  }
  for (Schedule::Point& point : schedule.points) point.T /= unit;
  const std::string wave_key = key + "_wave";
  if (!given(deck, section, wave_key)) return schedule;
  const std::vector<double> wave = numbers_in(deck::word(deck, section, wave_key));
  const bool right =
      (wave.size() == 2 || wave.size() == 3) && std::ranges::all_of(wave, [](double v) { return std::isfinite(v); });
  if (!right)
    complain(deck, section, wave_key, "must be 'amplitude period' or 'amplitude period start'");
  else if (!(wave[1] > 0.0) || (wave.size() == 3 && wave[2] < 0.0))
    complain(deck, section, wave_key, "the period must be positive and the start not negative");
  else
    schedule.wave = Schedule::Wave{wave[0], wave[1] / unit, wave.size() == 3 ? wave[2] / unit : 0.0};
  return schedule;
}

std::optional<transient::Body> body_of(deck::Deck& deck, const Physics& physics, const Units& units) {
  const double length = physics.si ? physics.si->contact.radius : unset;
  const double load = physics.si ? physics.si->contact.load : unset;
  const double u_m = units.a / units.time;
  const auto quantity = [&](const char* key, const char* suffix, double unit) {
    return deck::number_in(deck, "body", key, {suffix, unit, physics.language == Language::si});
  };
  transient::Body body;
  body.mass = quantity("mass", "_kg", load * length / (u_m * u_m));
  if (std::isnan(body.mass)) return std::nullopt;
  const double damping = quantity("damping", "_Nspm", load * length / (units.a * u_m));
  if (std::isfinite(damping)) body.damping = damping;
  const double gap = quantity("gap", "_m", units.height);
  if (std::isfinite(gap)) body.gap = gap;
  const double velocity = quantity("velocity", "_mps", units.height / units.time);
  if (std::isfinite(velocity)) body.velocity = velocity;
  return body;
}

void check_drive(deck::Deck& deck, const TransientInput& input) {
  const double end = input.parameters.end;
  const std::optional<transient::Body>& body = input.conditions.body;
  if (body && transient::least(input.conditions.load, end) < 0.0)
    complain(deck, section, given(deck, section, "load_wave") ? "load_wave" : "load", "the load must not be negative");
  if (body && !body->gap && !(transient::value(input.conditions.load, 0.0) > 0.0))
    complain(deck, section, "load",
             "must be positive at time 0, from whose steady film the body starts; or give a gap");
  if (!body && !(transient::least(input.conditions.load, end) > 0.0))
    complain(deck, section, given(deck, section, "load_wave") ? "load_wave" : "load",
             "the load must stay positive until the end: the bodies would part");
  constexpr int samples = 4000;
  std::vector<double> times = transient::stops_of(input.conditions, end);
  for (int k = 0; k <= samples; ++k) times.push_back(end * k / samples);
  const char* key = given(deck, section, "u1") || given(deck, section, "u1_wave") ? "u1" : "u2";
  for (const double T : times)
    if (transient::drive_at(input.conditions, T).speed < 0.0) {
      complain(deck, section, key,
               "(u1 + u2)/2 turns negative at " + deck::shortest(T) +
                   " a/u_m: the oil would enter at the other side, which this version does not solve");
      return;
    }
  const bool from_steady = !body || !body->gap;
  if (from_steady && transient::drive_at(input.conditions, 0.0).speed <= 0.0)
    complain(deck, section, key, "(u1 + u2)/2 must be positive at time 0: there is no steady film to start from");
}

// in: the longest step where the deck says nothing.
void check_steps(deck::Deck& deck, const transient::MarchParameters& march, double otherwise) {
  const double longest = std::isnan(march.longest_step) ? otherwise : march.longest_step;
  const double steps = std::ceil(march.end / longest);
  const bool bounded = given(deck, section, "max_steps") || given(deck, section, "stop_film");
  if (bounded || given(deck, section, "stop_steady") || !(steps > march.most_steps)) return;
  complain(
      deck, section, "end_time",
      formatted("takes at least %.3g steps of at most %.3g a/u_m, and max_steps is %d: a shorter time, or more steps",
                steps, longest, march.most_steps));
}

}  // namespace

std::optional<TransientInput> transient_input(deck::Deck& deck, const Physics& physics, const SurfaceInput& surfaces,
                                              const core::Grid& grid) {
  const bool timed = given(deck, section, "end_time");
  if (!timed) return std::nullopt;
  if (given(deck, "grid", "accuracy"))
    complain(deck, "grid", "accuracy", "is for steady contacts: give cells for a transient one");
  const Units units = units_of(physics);
  TransientInput input;
  input.second = 1.0 / units.time;
  const bool seconds = deck::word(deck, section, "time_unit") == "seconds";
  if (seconds && std::isnan(units.time))
    complain(deck, section, "time_unit", "seconds need a contact and a motion in SI: use contact");
  const double unit = seconds && std::isfinite(units.time) ? units.time : 1.0;
  const auto time = [&](const char* key) { return deck::number(deck, section, key) / unit; };
  const double u_m = physics.si ? 0.5 * physics.si->contact.u_s : 1.0;
  input.conditions.load = schedule_of(deck, "load", unit, 1.0);
  input.conditions.u1 = schedule_of(deck, "u1", unit, physics.si ? physics.si->u1 / u_m : 1.0);
  input.conditions.u2 = schedule_of(deck, "u2", unit, physics.si ? physics.si->u2 / u_m : 1.0);
  if (surfaces.on_1) input.conditions.on_1 = surfaces.on_1->relief;
  if (surfaces.on_2) input.conditions.on_2 = surfaces.on_2->relief;
  input.conditions.body = body_of(deck, physics, units);
  input.parameters.end = time("end_time");
  input.parameters.rtol = deck::number(deck, section, "rtol");
  input.parameters.longest_step = time("max_step");
  input.parameters.most_steps = deck::integer(deck, section, "max_steps", input.parameters.most_steps);
  input.parameters.output_interval = time("output_interval");
  input.parameters.stop_film = deck::number(deck, section, "stop_film");
  input.parameters.stop_steady = deck::number(deck, section, "stop_steady");
  if (given(deck, "output", "checkpoint"))
    input.seconds_between_checkpoints = deck::number(deck, "output", "checkpoint");
  input.parameters.probes = probes_of(deck, grid);
  if (std::isfinite(input.parameters.end)) check_drive(deck, input);
  if (deck.errors.empty())
    check_steps(deck, input.parameters, transient::longest_step(input.conditions, input.parameters.end));
  return input;
}

Way way_of(const CarriedSurface& surface, const TransientInput& input) {
  const double X = std::visit([](const auto& relief) { return relief.X; }, surface.relief);
  const Schedule& speed = surface.section == "surface1" ? input.conditions.u1 : input.conditions.u2;
  return {X, X + transient::integral(speed, input.parameters.end)};
}

}  // namespace ehl::program
