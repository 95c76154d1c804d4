// The effect `subsurface`: stresses below the contact.
#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "base/json.hpp"
#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "case/numbers/records.hpp"
#include "case/subsurface_in_time.hpp"
#include "deck/text.hpp"
#include "effects/subsurface/keys.hpp"

namespace ehl::program {

namespace numbers {
namespace {

const subsurface::StressField& stresses(Of s) { return *s.computed.stresses; }

Group stress_numbers() {
  Group group{.name = "stresses", .home = "/subsurface"};
  group.on = [](Of s) { return s.computed.stresses.has_value(); };
  std::vector<Number>& list = group.numbers;
  const auto add_maximum = [&](const std::string& name, const std::string& words, int place,
                               subsurface::Maximum subsurface::StressField::*part) {
    const std::string file = "largest_" + name;
    const auto of = [part](double subsurface::Maximum::*what) { return [=](Of s) { return stresses(s).*part.*what; }; };
    using M = subsurface::Maximum;
    list.push_back(number(file, "p_h", "largest value, interpolated by parabolas between nodes and planes",
                          json(name + "/value"), label(words), on_page(place), of(&M::value)));
    list.push_back(number(file + "_x", "a", "its position", json(name + "/X"), of(&M::X)));
    list.push_back(number(file + "_y", "a", "its position", json(name + "/Y"), of(&M::Y)));
    list.push_back(number(file + "_z", "a", "its position: depth", json(name + "/Z"), of(&M::Z)));
    list.push_back(number(file + "_on_node", "p_h", "largest value of all nodes", json(name + "/on_node"), not_in_file,
                          of(&M::on_node)));
  };
  add_maximum("sigma_mises", "largest von Mises stress below the surface", 18, &subsurface::StressField::mises);
  add_maximum("tau_max", "largest shear stress below the surface", 19, &subsurface::StressField::shear);
  list.push_back(number("poisson", "-", "Poisson's ratio of the body", [](Of s) { return stresses(s).parameters.nu; }));
  list.push_back(number("friction", "-", "shear traction along +x over pressure",
                        [](Of s) { return stresses(s).parameters.friction; }));
  list.push_back(number(id::seconds, "s", "time of the stresses", [](Of s) { return stresses(s).seconds; }));
  return group;
}

}  // namespace
}  // namespace numbers

namespace {

using subsurface::Maximum;
using subsurface::Parameters;
using subsurface::StressField;

std::string nodes(const core::Grid& grid, std::size_t planes) {
  if (grid.line) return fmt::format("{} nodes on {} planes to depth ", grid.nodes_x(), planes);
  return fmt::format("{} x {} nodes on {} planes to depth ", grid.nodes_x(), grid.nodes_y(), planes);
}

// True if the traction is the friction computed by [friction].
bool computes_friction(const Case& input) { return std::isnan(input.subsurface->friction); }

std::string body(const Case& input, const Parameters& parameters) {
  const char* from = !computes_friction(input) ? "" : " of surface 1, by [friction]";
  std::string traction = fmt::format("friction {:.4g}{}", parameters.friction, from);
  if (std::isnan(parameters.friction)) traction = std::string("friction") + from;
  if (parameters.friction == 0.0) traction = "frictionless";
  return fmt::format("Poisson's ratio {:.4g}, ", parameters.nu) + traction;
}

// A coordinate that rounding makes almost zero becomes zero, without a sign.
double shown(double place) { return std::abs(place) < 5e-5 ? 0.0 : place; }

std::string maximum_line(const char* label, const Maximum& maximum, const Physics& physics, const char* mark) {
  const std::string own = fmt::format("{:.5f} p_h", maximum.value);
  const std::string place =
      fmt::format("at ({:.3f}, {:.3f}) a, depth {:.4f} a{}\n", shown(maximum.X), shown(maximum.Y), maximum.Z, mark);
  const std::optional<SiScales> si = si_scales(physics);
  if (!si)
    return label + (" " + own) + (std::isfinite(physics.p_h) ? ", " + pressure(maximum.value * physics.p_h) : "") +
           ", " + place;
  return label + (" " + pressure_in_GPa(maximum.value * si->p_h)) + ", at " + place_text(maximum.X, maximum.Y, *si) +
         fmt::format(", depth {:.2f} um; ", 1e6 * si->a * maximum.Z) + own + ", " + place;
}

void read(Case& input) {
  deck::Deck& deck = input.deck;
  if (!deck::given(deck, "subsurface", "depth")) return;
  check_subsurface_in_time(input);
  input.subsurface =
      subsurface::read(deck, deck::number(deck, "contact", "nu1"), deck::given(deck, "friction", "cavitated"));
}

Needs expense(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  const Needs once{.bytes = subsurface::expected_bytes(grid, *input.subsurface, input.scene.threads),
                   .seconds = subsurface::expected_seconds(grid, *input.subsurface) / input.scene.threads};
  if (!input.transient) return once;
  const transient::MarchParameters& march = input.transient->parameters;
  constexpr double fields_of_history = 8.0;  // four of each body
  constexpr double with_kernels_kept = 0.2;  // of the time of one body and time [bench: subsurface_kernels_kept]
  const core::Grid own = subsurface::stress_grid(grid, *input.subsurface);
  const double nodes = static_cast<double>(own.nodes_x()) * own.nodes_y() * input.subsurface->planes;
  const double longer = 1.0 + march.end / (own.X_b - own.X_a);
  return {.bytes = once.bytes + fields_of_history * longer * nodes * sizeof(double) +
                   subsurface::bytes_of_kernels(grid, *input.subsurface),
          .seconds = once.seconds * (1.0 + with_kernels_kept * 2.0 * march.end / march.output_interval)};
}

// A run in time that was stopped has no stresses yet: `ehl resume` computes them at its end.
bool is_stopped(const Computed& computed) {
  return computed.in_time && computed.in_time->report.end == transient::MarchEnd::interrupted;
}

void compute(const Case& input, RunSettings& settings, Computed& computed) {
  if (is_stopped(computed)) return;
  const steady::Solution& solution = computed.solution;
  Parameters parameters = *input.subsurface;
  if (computes_friction(input))
    parameters.friction = friction_of(input, solution, fields_of_film(computed.heat, computed.flow)).on_1;
  const int planes = parameters.planes;
  computed.stresses =
      subsurface::stress_below(solution.grid, solution.P, parameters, input.scene.threads, [&](int done) {
        return settings.progress.show(static_cast<double>(done) / planes,
                                      fmt::format("stresses below the contact: {} of {} planes", done, planes));
      });
  if (computed.in_time) compute_stress_course(input, settings, computed);
}

std::string what(const Case& input) {
  const Parameters& parameters = *input.subsurface;
  return nodes(subsurface::stress_grid(input.scene.grid, parameters), static_cast<std::size_t>(parameters.planes)) +
         fmt::format("{:.4g} a; ", parameters.depth) + body(input, parameters);
}

std::string summary(const Case& input, const Computed& computed) {
  if (!computed.stresses) return {};
  const StressField& field = *computed.stresses;
  const char* mark = convergence_mark(computed.solution.converged);
  return maximum_line("von Mises   ", field.mises, input.physics, mark) +
         maximum_line("tau_max     ", field.shear, input.physics, mark) + "subsurface   " +
         nodes(field.grid, field.depths.size()) + fmt::format("{:.4g} a; ", field.depths.back()) +
         body(input, field.parameters) + fmt::format("; {:.3f} s\n", field.seconds) +
         (computed.stress_course ? stress_course_summary(input, *computed.stress_course) : "");
}

void json(const Case& input, const Computed& computed, Json& report) {
  if (!computed.stresses) return;
  const StressField& field = *computed.stresses;
  report["depth"] = field.depths.back();
  report["planes"] = field.depths.size();
  report[id::nx] = field.grid.nx;
  report[id::ny] = field.grid.ny;
  for (const numbers::Group& history : stress_history_numbers())
    add(numbers::quantities(history.name, {input, computed}), report);
}

void add_content(const Case& input, const Computed& computed, results::Content& content) {
  if (!computed.stresses) return;
  const StressField& field = *computed.stresses;
  results::Volume& volume = content.volume;
  volume.group = "/subsurface";
  volume.meaning = "stresses below the contact, the body at z >= 0; tension positive";
  volume.grid = field.grid;
  volume.depths = field.depths;
  for (const subsurface::Volume& kept : field.kept) {
    results::Series series{subsurface::name(kept.quantity), "p_h", subsurface::meaning(kept.quantity), {}, true};
    for (const core::Field& plane : kept.planes) series.fields.push_back(&plane);
    volume.series.push_back(std::move(series));
  }
  volume.section_meaning = "the section along x at y = " + deck::shortest(field.section_Y) + ": rows z, columns x";
  for (int k = 0; k < subsurface::quantities; ++k) {
    const auto quantity = static_cast<subsurface::Quantity>(k);
    volume.section.push_back({subsurface::name(quantity), "p_h", subsurface::meaning(quantity),
                              &field.section[static_cast<std::size_t>(k)]});
  }
  volume.numbers = numbers::quantities("stresses", {input, computed});
  if (computed.stress_course) add_stress_course(input, computed, content);
}

}  // namespace

Effect subsurface_effect() {
  return {
      .name = "subsurface",
      .meaning = "Stresses in the bodies below the contact; in time at the stored times, and what the material meets.",
      .sections = {{.name = "subsurface", .called_by = {"depth"}}},
      .costly = {"subsurface", "planes"},
      .keys = subsurface::keys,
      .numbers = numbers::stress_numbers,
      .more_numbers = stress_history_numbers,
      .read = read,
      .stages = {.after_solution = compute},
      .on = [](const Case& input) { return input.subsurface.has_value(); },
      .what = what,
      .expense = expense,
      .summary = summary,
      .json = json,
      .warnings =
          [](const Case&, const Computed& computed) {
            core::Warnings all = computed.stresses ? computed.stresses->warnings : core::Warnings{};
            if (computed.stress_course)
              all.insert(all.end(), computed.stress_course->warnings.begin(), computed.stress_course->warnings.end());
            return all;
          },
      .add_content = add_content,
      .seconds =
          [](const Computed& computed) {
            return (computed.stresses ? computed.stresses->seconds : 0.0) +
                   (computed.stress_course ? computed.stress_course->seconds : 0.0);
          },
      .example = {"subsurface.depth=1", "subsurface.planes=5", "subsurface.cells=32"}};
}

}  // namespace ehl::program
