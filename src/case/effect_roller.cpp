// The effect `roller`: rollers of finite length.
#include <fmt/core.h>

#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "case/numbers/records.hpp"
#include "case/roller_input.hpp"
#include "case/roller_report.hpp"
#include "deck/text.hpp"
#include "effects/roller/keys.hpp"

namespace ehl::program {

namespace numbers {
namespace {

const roller::Analysis& rolled(Of s) { return *s.computed.roller; }
RollerBars roller_bars(Of s) { return bars_of(rolled(s)); }
const roller::Trace& trace(Of s) { return s.input.roller->trace; }
bool traced(Of s) { return s.input.roller->shape == roller::Profile::Shape::table; }
bool stressed(Of s) { return std::isfinite(rolled(s).mises.end); }

Group roller_numbers() {
  const auto bar_of = [](double RollerBars::*part) { return [part](Of s) { return roller_bars(s).*part; }; };
  Group group{.name = "roller", .prefix = "roller_"};
  group.on = [](Of s) { return s.computed.roller.has_value(); };
  group.asked = [](const deck::Deck& deck) { return deck::called_for(deck, "roller"); };
  group.numbers = {
      number("length", "a", "length of the roller", [](Of s) { return s.input.roller->length; }),
      number("P_middle", "p_h", "highest pressure on the line y = 0", column(701),
             [](Of s) { return rolled(s).found.middle.P_max; }),
      number("error_P_middle", "-", "its relative error by the grid of half as many cells",
             bar_of(&RollerBars::P_middle)),
      number("P_middle_dry", "p_h", "the same without oil", [](Of s) { return rolled(s).dry.middle.P_max; }),
      number("load_middle", "-", "load per length there over the mean",
             [](Of s) { return rolled(s).found.middle.load; }),
      number("P_end", "p_h", "highest pressure on the outer tenth of the length", column(702),
             [](Of s) { return harder(rolled(s).found).P; }),
      number("P_end_y", "a", "its position", [](Of s) { return harder(rolled(s).found).P_Y; }),
      number("error_P_end", "-", "its relative error by the grid of half as many cells", bar_of(&RollerBars::P_end)),
      number("P_end_dry", "p_h", "the same without oil", [](Of s) { return harder(rolled(s).dry).P; }),
      number("H_end", "a^2/R", "least film on the outer tenth of the length", column(703),
             [](Of s) { return least_at_ends(rolled(s).found); }),
      number("error_H_end", "-", "its relative error by the grid of half as many cells", bar_of(&RollerBars::H_end)),
      number("load_centre", "a", "y of the resultant of the pressure", column(704),
             [](Of s) { return rolled(s).found.load_centre; }),
      number("moment", "N m", "moment of the pressure about the x axis", column_only_si(705),
             [](Of s) { return moment_Nm(s.input, rolled(s).found); }),
      number("Rq", "a^2/R", "roughness of the traced profile without its form", only_if(traced),
             [](Of s) { return trace(s).rough; }),
      number("Rq_before_filter", "a^2/R", "the same before short waves were taken away", only_if(traced),
             [](Of s) { return trace(s).rough_before; }),
      number("levelled_slope", "-", "dH/dY that was taken away of the trace", only_if(traced),
             [](Of s) { return trace(s).slope; }),
      number("mises_middle", "p_h", "largest von Mises stress below the middle half", only_if(stressed),
             [](Of s) { return rolled(s).mises.middle; }),
      number("error_mises_middle", "-", "its relative error by the grid of half as many cells", only_if(stressed),
             bar_of(&RollerBars::mises_middle)),
      number("mises_end", "p_h", "the same below the outer tenth of the length", only_if(stressed),
             [](Of s) { return rolled(s).mises.end; }),
      number("error_mises_end", "-", "its relative error", only_if(stressed), bar_of(&RollerBars::mises_end))};
  return group;
}

}  // namespace
}  // namespace numbers

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
          .warnings = [](const Case&, const Computed& computed) { return roller_warnings(*computed.roller); },
          .add_content = add_content,
          .seconds = [](const Computed& computed) { return computed.roller->seconds; },
          .example = {"contact.kind=roller", "contact.length=20", "roller.profile=logarithmic", "-domain.y_half"}};
}

}  // namespace ehl::program
