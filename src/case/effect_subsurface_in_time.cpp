// Stresses at the stored times of a run in time, and what the material of the bodies meets during the over-rolling.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text_format.hpp"
#include "case/numbers/records.hpp"
#include "case/subsurface_in_time.hpp"
#include "core/timer.hpp"
#include "deck/text.hpp"

namespace ehl::program {

using subsurface::History;
using subsurface::Maximum;
using subsurface::Met;

namespace numbers {
namespace {

// What the material of a body has met. in: number: 1 or 2.
template <int number>
Group history_numbers() {
  const std::string home = "history_" + std::to_string(number);
  Group group{.name = home, .home = "/" + home};
  group.on = [](Of s) { return s.computed.stress_course.has_value(); };
  for (int met = 0; met < subsurface::met; ++met) {
    const auto what = static_cast<Met>(met);
    const std::string name = subsurface::name(what);
    const auto of = [met](double Maximum::*part) {
      return [=](Of s) {
        return s.computed.stress_course->bodies[number - 1].largest[static_cast<std::size_t>(met)].*part;
      };
    };
    const std::string path = home + "/" + name;
    group.numbers.push_back(numbers::number(
        name, "p_h", subsurface::meaning(what), json(path + "/value"),
        label(std::string(subsurface::meaning(what)) + ", body " + std::to_string(number)), of(&Maximum::value)));
    group.numbers.push_back(numbers::number(name + "_x", "a", "its position in coordinates that move with the body",
                                            json(path + "/X"), of(&Maximum::X)));
    group.numbers.push_back(numbers::number(name + "_y", "a", "its position", json(path + "/Y"), of(&Maximum::Y)));
    group.numbers.push_back(
        numbers::number(name + "_z", "a", "its position: depth", json(path + "/Z"), of(&Maximum::Z)));
  }
  return group;
}

}  // namespace
}  // namespace numbers

namespace {

/// A body moves by at most so many cells between two samples of its history, else the run warns: then no point of its
/// material is further than a cell from a node of the stresses at some sample.
constexpr double longest_move = 2.0;

// The friction coefficient on a body at a time between two steps.
double coefficient_at(const std::vector<double>& values, const std::vector<transient::StepRow>& rows, double T) {
  const auto after = std::ranges::lower_bound(rows, T, {}, &transient::StepRow::T);
  const auto k = static_cast<std::size_t>(after - rows.begin());
  if (k >= rows.size()) return values.back();
  if (k == 0 || std::isnan(values[k - 1])) return values[k];
  const double share = (rows[k].T - T) / (rows[k].T - rows[k - 1].T);
  return share * values[k - 1] + (1.0 - share) * values[k];
}

// The traction over the pressure on both bodies at a time. Where the film carries nothing there is neither.
std::array<double, 2> tractions_at(const Case& input, const std::vector<double>& mu_1, const std::vector<double>& mu_2,
                                   const TransientResult& run, double T) {
  const double given = input.subsurface->friction;
  if (!std::isnan(given)) return {given, given == 0.0 ? 0.0 : -given};
  const double one = coefficient_at(mu_1, run.rows, T), other = coefficient_at(mu_2, run.rows, T);
  return std::isnan(one + other) ? std::array{0.0, 0.0} : std::array{one, other};
}

std::vector<double> displacements(const transient::Schedule& speed, const std::vector<transient::Frame>& frames) {
  std::vector<double> list;
  for (const transient::Frame& frame : frames) list.push_back(integral(speed, frame.T));
  return list;
}

StressCourse::Body body_of(const History& history) {
  StressCourse::Body body{.longest_move = history.longest_move()};
  for (int i = 0; i < history.grid().nodes_x(); ++i) body.x.push_back(history.grid().X(i));
  for (int met = 0; met < subsurface::met; ++met) {
    body.largest.push_back(history.largest(static_cast<Met>(met)));
    body.sections.push_back(history.section(static_cast<Met>(met)));
  }
  return body;
}

void warn_of_coarse(const Case& input, StressCourse& course) {
  for (std::size_t k = 0; k < course.bodies.size(); ++k) {
    const double move = course.bodies[k].longest_move;
    if (move <= longest_move) continue;
    const double interval = input.transient->parameters.output_interval;
    course.warnings.push_back(
        {"coarse-history",
         fmt::format("subsurface: surface {} moves by {:.2g} cells of the stresses between two stored times, and the "
                     "history of its material needs {:g}: take [transient] output_interval = {:.2g} a/u_m or less, or "
                     "fewer [subsurface] cells",
                     k + 1, move, longest_move, interval * longest_move / move)});
  }
}

}  // namespace

void check_subsurface_in_time(Case& input) {
  if (input.dry || !deck::given(input.deck, "transient", "end_time")) return;
  if (!deck::given(input.deck, "transient", "output_interval"))
    deck::complain(input.deck, "subsurface", "depth",
                   "needs [transient] output_interval: the stresses are computed at the stored times");
  if (std::ranges::find(input.fields, "P") == input.fields.end())
    deck::complain(input.deck, "output", "fields",
                   "must contain P: the stresses in time are computed from the stored pressures");
}

void compute_stress_course(const Case& input, RunSettings& settings, Computed& computed) {
  const double began = core::now();
  const TransientResult& run = *computed.in_time;
  if (run.frames.empty()) return;
  const std::vector<double> mu_1 = column_of(run, id::mu_1), mu_2 = column_of(run, id::mu_2);
  const std::vector<double> moved[2] = {displacements(input.transient->conditions.u1, run.frames),
                                        displacements(input.transient->conditions.u2, run.frames)};
  subsurface::Parameters parameters = *input.subsurface;
  parameters.kept = {subsurface::sigma_mises, subsurface::tau_max, subsurface::tau_xz};
  StressCourse& course = computed.stress_course.emplace();
  course.grid = subsurface::stress_grid(input.scene.grid, parameters);
  course.depths = subsurface::depths_of(parameters);
  course.sections.resize(subsurface::quantities);
  std::vector<History> histories;
  for (const std::vector<double>& of_body : moved) {
    const auto [from, to] = std::ranges::minmax(of_body);
    histories.emplace_back(course.grid, course.depths, from, to);
  }
  const int threads = input.scene.threads;
  subsurface::Kernels kernels;
  const auto below = [&](const core::Field& P, double friction) {
    parameters.friction = friction;
    return subsurface::stress_below(input.scene.grid, P, parameters, threads, {}, &kernels);
  };
  for (std::size_t k = 0; k < run.frames.size(); ++k) {
    const transient::Frame& frame = run.frames[k];
    if (!settings.progress.show(static_cast<double>(k) / static_cast<double>(run.frames.size()),
                                fmt::format("stresses: {} of {} times", k, run.frames.size()))) {
      course.warnings.push_back({"stresses-stopped", fmt::format("subsurface: the computation was stopped after {} of "
                                                                 "{} times; the history is that of these times",
                                                                 k, run.frames.size())});
      break;
    }
    const std::array<double, 2> tractions = tractions_at(input, mu_1, mu_2, run, frame.T);
    subsurface::StressField field = below(frame.P, tractions[0]);
    histories[0].add(field, moved[0][k], threads);
    course.rows.push_back({frame.T, field.mises, field.shear});
    for (std::size_t q = 0; q < course.sections.size(); ++q) course.sections[q].push_back(std::move(field.section[q]));
    if (tractions[1] != tractions[0]) field = below(frame.P, tractions[1]);
    histories[1].add(field, moved[1][k], threads);
  }
  for (const History& history : histories) course.bodies.push_back(body_of(history));
  warn_of_coarse(input, course);
  course.seconds = core::now() - began;
}

std::vector<numbers::Group> stress_history_numbers() {
  return {numbers::history_numbers<1>(), numbers::history_numbers<2>()};
}

std::string stress_course_summary(const Case& input, const StressCourse& course) {
  const std::optional<SiScales> si = si_scales(input.physics);
  const SiUnit unit = si ? si_unit("p_h", *si) : SiUnit{"p_h", 1.0}, length = si ? si_unit("a", *si) : SiUnit{"a", 1.0};
  const auto rounded = [&](double place) { return (std::abs(place) < 5e-5 ? 0.0 : place) * length.factor; };
  const auto line = [&](const char* label, const std::string& words, const Maximum& most, const std::string& place) {
    return fmt::format("{}{} {:.5g} {} at x = {:.4g}, y = {:.3g}, depth {:.4g} {}{}\n", label, words,
                       most.value * unit.factor, unit.name, rounded(most.X), rounded(most.Y), most.Z * length.factor,
                       length.name, place);
  };
  std::string text;
  if (!course.rows.empty()) {
    const auto most = std::ranges::max_element(course.rows, {}, [](const auto& row) { return row.mises.value; });
    text += line("             in time: ", "largest von Mises stress", most->mises,
                 fmt::format(", at time {:.4g} a/u_m", most->T));
  }
  for (std::size_t k = 0; k < course.bodies.size(); ++k)
    for (int met = 0; met < subsurface::met; ++met)
      text +=
          line(met == 0 ? fmt::format("             body {}: ", k + 1).c_str() : "                     ",
               subsurface::meaning(static_cast<Met>(met)), course.bodies[k].largest[static_cast<std::size_t>(met)], "");
  return text + fmt::format("             {} times, {:.3f} s\n", course.rows.size(), course.seconds);
}

void add_stress_course(const Case& input, const Computed& computed, results::Content& content) {
  using Row = StressCourse::Row;
  const StressCourse& course = *computed.stress_course;
  const results::Column z{"z", "a", "depth below the surface, in Hertz radii", false, course.depths};
  results::Section in_time{.group = "/stresses_in_time",
                           .meaning =
                               "stresses below surface 1 at the stored times: the section y = 0, and the "
                               "largest of all nodes",
                           .across = z};
  for (int i = 0; i < course.grid.nodes_x(); ++i) in_time.x.push_back(course.grid.X(i));
  const auto column = [&](const std::string& name, const std::function<double(const Row&)>& of) {
    const numbers::Number& number = numbers::number_of(name);
    results::Column made{number.name, number.unit.name, number.meaning, false, {}};
    for (const Row& row : course.rows) made.values.push_back(of(row));
    in_time.columns.push_back(std::move(made));
  };
  column(id::step_time, &Row::T);
  for (const auto& [quantity, most] :
       {std::pair(subsurface::sigma_mises, &Row::mises), {subsurface::tau_max, &Row::shear}})
    for (const auto& [end, part] :
         {std::pair("", &Maximum::value), {"_x", &Maximum::X}, {"_y", &Maximum::Y}, {"_z", &Maximum::Z}})
      column(std::string("largest_") + subsurface::name(quantity) + end,
             [most = most, part = part](const Row& row) { return row.*most.*part; });
  for (int q = 0; q < subsurface::quantities; ++q) {
    const auto quantity = static_cast<subsurface::Quantity>(q);
    results::Series series{subsurface::name(quantity), "p_h", subsurface::meaning(quantity), {}, true};
    for (const core::Field& section : course.sections[static_cast<std::size_t>(q)]) series.fields.push_back(&section);
    in_time.series.push_back(std::move(series));
  }
  content.more_sections.push_back(std::move(in_time));
  for (std::size_t k = 0; k < course.bodies.size(); ++k) {
    const StressCourse::Body& body = course.bodies[k];
    const std::string name = "history_" + std::to_string(k + 1);
    results::Section made{.group = "/" + name,
                          .meaning = "what the material of body " + std::to_string(k + 1) +
                                     " has met, over x - integral of its speed and depth, at y = 0",
                          .across = z,
                          .x = body.x,
                          .numbers = numbers::quantities(name, {input, computed})};
    for (int met = 0; met < subsurface::met; ++met)
      made.fields.push_back({std::string("section_") + subsurface::name(static_cast<Met>(met)), "p_h",
                             subsurface::meaning(static_cast<Met>(met)),
                             &body.sections[static_cast<std::size_t>(met)]});
    content.more_sections.push_back(std::move(made));
  }
}

}  // namespace ehl::program
