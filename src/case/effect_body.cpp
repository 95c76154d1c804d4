// The effect `body`: a body that moves under the load and the film's pressure.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/effects.hpp"
#include "case/numbers/records.hpp"
#include "core/constants.hpp"

namespace ehl::program {
namespace numbers {
namespace {

const transient::Body& body_of(Of s) { return *s.input.transient->conditions.body; }

// Numbers of a body that flies through a gap to the film and back.
bool falls(Of s) { return s.computed.in_time && body_of(s).gap && body_of(s).velocity < 0.0; }

// Velocity at the end over that at time 0; NaN while the body still approaches or is carried.
double restitution(Of s) {
  const transient::StepRow& last = s.computed.in_time->rows.back();
  constexpr double free = 0.01;  // of the load of the contact
  return last.velocity > 0.0 && last.carried < free ? -last.velocity / body_of(s).velocity : core::unknown;
}

double largest_load(Of s) {
  const std::vector<transient::StepRow>& rows = s.computed.in_time->rows;
  return std::ranges::max(rows, {}, &transient::StepRow::carried).carried;
}

// The time between the first and the last hundredth of the largest load.
double contact_time(Of s) {
  const std::vector<transient::StepRow>& rows = s.computed.in_time->rows;
  const double enough = 0.01 * largest_load(s);
  const auto carries = [&](const transient::StepRow& row) { return row.carried > enough; };
  const auto first = std::ranges::find_if(rows, carries);
  const auto last = std::find_if(rows.rbegin(), rows.rend(), carries);
  return first == rows.end() ? core::unknown : last->T - first->T;
}

Group body_numbers() {
  Group group{.name = "body", .prefix = "body_"};
  group.on = falls;
  group.numbers = {
      number("restitution", "-",
             "velocity with which the body leaves over that with which it came; unknown if it has "
             "not left",
             restitution),
      number("largest_load", "-", "largest load that the film carries over that of the contact", largest_load),
      number("contact_time", "a/u_m", "time during which the film carries more than a hundredth of its largest load",
             contact_time)};
  return group;
}

}  // namespace
}  // namespace numbers

namespace {

std::string summary(const Case& input, const Computed& computed) {
  const numbers::Solved solved{input, computed};
  if (!numbers::falls(solved)) return "";
  const double e = numbers::restitution(solved), time = numbers::contact_time(solved);
  const std::optional<SiScales> si = si_scales(input.physics);
  std::string text = fmt::format("impact       largest load {:.4g} of that{}", numbers::largest_load(solved),
                                 input.machine ? " of the dry impact" : " of [contact]");
  text += si ? fmt::format("; carried for {:.4g} ms", 1e3 * si->time * time)
             : fmt::format("; carried for {:.4g} a/u_m", time);
  if (std::isnan(e)) return text + "; the body has not left at the end: a longer end_time computes the rebound\n";
  return text + fmt::format("; the body leaves with {:.4g} of its velocity and {:.4g} of its energy\n", e, e * e);
}

}  // namespace

Effect body_effect() {
  return {.name = "body",
          .meaning = "A body with mass that moves under the load and the film: impact, rebound, vibration.",
          .sections = {{.name = "body",
                        .meaning =
                            "Equation of motion of a body, instead of a prescribed load. Used only with [transient].",
                        .called_by = {"mass", "mass_kg"}}},
          .numbers = numbers::body_numbers,
          .on = [](const Case& input) { return input.transient && input.transient->conditions.body; },
          .what =
              [](const Case& input) {
                const transient::Body& body = *input.transient->conditions.body;
                const std::string start = body.gap ? fmt::format("a gap of {:.4g}", *body.gap) : "the steady film";
                return fmt::format(
                    "mass {:.4g}, damping {:.4g}, starts from {} with velocity {:.4g}; {:.4g} vibrations per a/u_m on "
                    "the dry contact",
                    body.mass, body.damping, start, body.velocity,
                    transient::natural_frequency(body) / (2.0 * std::numbers::pi));
              },
          .summary = summary,
          .add_content =
              [](const Case& input, const Computed& computed, results::Content& content) {
                numbers::append("body", {input, computed}, content.summary);
              },
          .example = {"body.mass=2"},
          .upon = "transient"};
}

}  // namespace ehl::program
