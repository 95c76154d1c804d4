// Stresses below the contact.
#include "case/effects.hpp"
#include "effects/subsurface/keys.hpp"
#include "report/json.hpp"
#include "report/subsurface_report.hpp"
#include "report/text_format.hpp"

namespace ehl::program {
namespace {

void read(Case& input) {
  deck::Deck& deck = input.deck;
  if (!deck::given(deck, "subsurface", "depth")) return;
  if (deck::given(deck, "transient", "end_time"))
    deck::complain(deck, "subsurface", "depth", "is for steady contacts: remove it, or [transient]");
  input.subsurface = subsurface::read(deck, deck::number(deck, "contact", "nu1"));
}

Needs expense(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  return {.bytes = subsurface::expected_bytes(grid, *input.subsurface, input.scene.threads),
          .seconds = subsurface::expected_seconds(grid, *input.subsurface) / input.scene.threads};
}

void compute(const Case& input, RunSettings& settings, Computed& computed) {
  const steady::Solution& solution = computed.solution;
  const int planes = input.subsurface->planes;
  computed.stresses =
      subsurface::stress_below(solution.grid, solution.P, *input.subsurface, input.scene.threads, [&](int done) {
        return settings.progress.show(static_cast<double>(done) / planes,
                                      formatted("stresses below the contact: %d of %d planes", done, planes));
      });
}

}  // namespace

Effect subsurface_effect() {
  return {.name = "subsurface",
          .meaning = "The stresses below the contact, from the steady pressure.",
          .sections = {{.name = "subsurface", .called_by = {"depth"}}},
          .costly = {"subsurface", "planes"},
          .keys = subsurface::keys,
          .read = read,
          .on = [](const Case& input) { return input.subsurface.has_value(); },
          .what = [](const Case& input) { return subsurface_plan(*input.subsurface, input.scene.grid); },
          .expense = expense,
          .compute = compute,
          .summary =
              [](const Case& input, const Computed& computed) {
                return subsurface_summary(*computed.stresses, input.physics.p_h,
                                          computed.solution.converged ? "" : "  (NOT CONVERGED)");
              },
          .json = [](const Computed& computed) { return subsurface_json(*computed.stresses); },
          .add_content = [](const Case&, const Computed& computed,
                            results::Content& content) { add_subsurface(*computed.stresses, content); },
          .seconds = [](const Computed& computed) { return computed.stresses->seconds; },
          .example = {"subsurface.depth=1", "subsurface.planes=5", "subsurface.cells=32"}};
}

}  // namespace ehl::program
