// The effect `roller`: rollers of finite length.
#include <fmt/core.h>

#include "base/json.hpp"
#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "case/numbers/number.hpp"
#include "case/roller_input.hpp"
#include "case/roller_report.hpp"
#include "deck/text.hpp"
#include "effects/roller/keys.hpp"

namespace ehl::program {

namespace numbers {
Group roller_numbers();  // in numbers/contacts.cpp
}

namespace {

// The filters and the roughness of a traced profile.
std::string trace_text(const Case& input) {
  const roller::Profile& profile = *input.roller;
  const roller::Trace& trace = profile.trace;
  if (profile.shape != roller::Profile::Shape::table) return {};
  const auto height = [&](double H) {
    return input.physics.si ? length(H * input.physics.si->hertz.h_scale) : fmt::format("{:.4g} a^2/R", H);
  };
  std::string text = ", Rq " + height(trace.rough) + " without the form";
  if (trace.shortest_wave > 0.0)
    text += fmt::format(" ({} before waves below {:.4g} half widths were removed)", height(trace.rough_before),
                        trace.shortest_wave);
  if (trace.level) text += fmt::format(", levelled by dH/dY = {:.4g}", trace.slope);
  return text;
}

std::string what(const Case& input) {
  const roller::Profile& profile = *input.roller;
  const std::string tilt = profile.tilt != 0.0 ? fmt::format(", tilt dH/dY = {:.4g}", profile.tilt) : "";
  return fmt::format("{:.4g} half widths long, profile {}, {:.4g} a^2/R below the middle at the ends{}{}",
                     profile.length, deck::word(input.deck, "roller", "profile"),
                     roller::drop(profile, 0.5 * profile.length), tilt, trace_text(input));
}

std::string asymmetry(const Case& input) {
  if (input.roller->tilt != 0.0) return "the roller is tilted";
  return roller::symmetric(*input.roller) ? "" : "the profile table is not symmetric";
}

// The cost of the grid of half as many cells; that of the dry contact is small.
Needs expense(const Case& input) { return {.seconds = basic_needs(input.scene).seconds}; }

void compute(const Case& input, RunSettings& settings, Computed& computed) {
  const steady::Solution& solution = computed.solution;
  if (settings.extent == Extent::row) {
    computed.roller = roller::Analysis{.found = roller::distribution(solution.grid, solution.P, solution.H)};
    return;
  }
  computed.roller =
      roller::analyse(input.scene, solution, input.roller->trace.rough > 0.0,
                      computed.stresses ? &*computed.stresses : nullptr, [&](const steady::Progress& now) {
                        return settings.progress.show(now.fraction, "roller on half as many cells");
                      });
}

Json json(const Case& input, const Computed& computed) {
  Json report;
  const std::vector<results::Quantity> list = numbers::quantities("roller", {input, computed});
  add(list, report);
  add_in_SI(list, si_scales(input.physics), report);
  report["seconds"] = computed.roller->seconds;
  return report;
}

void add_content(const Case& input, const Computed& computed, results::Content& content) {
  numbers::append("roller", {input, computed}, content.summary);
  content.tables.push_back(
      table_of("roller", "values along the roller, with oil", slice_columns(), computed.roller->found.slices));
  content.tables.push_back(
      table_of("roller_dry", "values along the roller, without oil", slice_columns(), computed.roller->dry.slices));
}

}  // namespace

Effect roller_effect() {
  return {.name = "roller",
          .meaning = "A roller of finite length: its profile along the axis, and its tilt.",
          .sections = {{.name = "roller", .called_by = {"profile"}}},
          .keys = roller::keys,
          .numbers = numbers::roller_numbers,
          .stages = {.scene = roller_input, .after_solution = compute, .from = Extent::row},
          .on = [](const Case& input) { return input.roller.has_value(); },
          .what = what,
          .expense = expense,
          .asymmetry = asymmetry,
          .summary = roller_summary,
          .json = json,
          .warnings = [](const Case&, const Computed& computed) { return roller_warnings(*computed.roller); },
          .add_content = add_content,
          .seconds = [](const Computed& computed) { return computed.roller->seconds; },
          .example = {"contact.kind=roller", "contact.length=20", "roller.profile=logarithmic", "-domain.y_half"}};
}

}  // namespace ehl::program
