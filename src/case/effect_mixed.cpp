// The effect `mixed`: surfaces that touch at a boundary film.
#include <fmt/core.h>

#include <cmath>

#include "base/json.hpp"
#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "case/numbers/records.hpp"
#include "case/touching.hpp"
#include "contact/ellipse.hpp"
#include "core/constants.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/text.hpp"
#include "effects/mixed/contact.hpp"
#include "effects/mixed/keys.hpp"
#include "judgement/error_estimate.hpp"
#include "steady/mixed.hpp"

namespace ehl::program {
namespace {

/// Waves of a surface need this many cells.
constexpr double cells_per_wave = 8.0;

mixed::Contact contact_of(const steady::Scene& scene, const core::Grid& grid, const core::Field& P_c) {
  // The mean pressure of the smooth dry contact is 2/3 or, on a line, pi/4 of the largest one.
  const double load = contact::load(scene.contact.shape);
  return mixed::contact_of(grid, P_c, load, load / (grid.line ? 0.25 * core::pi : 2.0 / 3.0));
}

// ---- The deck

// The first of the deck's parts that is not available with touching surfaces, as a reason; empty: none.
std::string not_available(const Case& input) {
  if (input.dry) return "a dry contact: remove [mixed], or [case] kind = dry";
  if (input.transient) return "runs in time: remove [mixed], or [transient] end_time";
  if (input.roller) return "rollers: remove [mixed], or change [contact] kind";
  if (input.heat) return "films with heat: remove [mixed] or [thermal]";
  if (input.scene.supply) return "starved contacts: remove [mixed] or [supply]";
  if (input.flow_thinning) return "oils that thin by the flow: remove [mixed], or set [shear] flow = off";
  if (std::isfinite(input.scene.accuracy.error)) return "a required accuracy: give [grid] cells instead of accuracy";
  if (input.scene.polish == steady::Polish::off)
    return "cycles alone: Newton's method solves it; set [multigrid] polish = fallback";
  return {};
}

// Numbers of the contact, with an error bar from all levels; the observer of another effect stays.
void observe_contact(Case& input) {
  input.scene.observer = [before = input.scene.observer](const steady::Scene& scene, const steady::SolvedFilm& film) {
    std::vector<double> numbers;
    if (before) numbers = before(scene, film);
    const mixed::Contact found = film.P_c ? contact_of(scene, film.grid, *film.P_c) : mixed::Contact{};
    numbers.insert(numbers.end(), {found.share, found.area});
    return numbers;
  };
}
constexpr std::size_t observed_numbers = 2;

void mixed_input(Case& input) {
  deck::Deck& deck = input.deck;
  if (!mixed::called_for(deck)) return;
  const deck::Part mixed_part{deck, "mixed"};
  const char* first = mixed_part.given("h_b") ? "h_b" : "H_b";
  if (const std::string reason = not_available(input); !reason.empty())
    return mixed_part.complain(first, "is not available for " + reason);
  if (!deck.errors.empty()) return;
  const mixed::Input given = mixed::read(
      deck, {.height = input.physics.si && input.physics.language == Language::si ? input.physics.si->hertz.h_scale
                                                                                  : core::unknown,
             .p_h = input.physics.p_h});
  if (!deck.errors.empty()) return;
  if (input.friction && std::isnan(given.mu_b))
    return deck::complain(deck, "mixed", "mu_b",
                          "is missing: [friction] needs the friction coefficient of touching surfaces",
                          deck::Cause::missing);
  if (!input.friction && !std::isnan(given.mu_b))
    return mixed_part.complain("mu_b", "has an effect on friction only: give [friction] cavitated, or remove it");
  input.scene.boundary_film = multigrid::BoundaryFilm{.H_b = given.H_b};
  if (!std::isnan(given.hardness)) input.scene.boundary_film->hardness = given.hardness;
  if (input.friction) {
    input.friction->boundary = given.mu_b;
    observe_friction(input);
  }
  observe_contact(input);
}

// ---- The solution

// The share on the next coarser grid, by half the boundary film.
double share_of_half_film(const Case& input) {
  const steady::Solution solution = steady::solve_with_half_film(input.scene);
  return solution.converged ? contact_of(input.scene, solution.grid, solution.P_c).share : core::unknown;
}

std::size_t place_of_share(const steady::Solution& solution) {
  return solution.levels.back().observed.size() - observed_numbers;
}

void after_solution(const Case& input, RunSettings& settings, Computed& computed) {
  const double began = core::now();
  const steady::Solution& solution = computed.solution;
  MixedResult result{.contact = contact_of(input.scene, solution.grid, solution.P_c)};
  const std::vector<double>& errors = solution.error_bars.observed;
  if (errors.size() >= observed_numbers) {
    result.error_share = errors[errors.size() - 2];
    result.error_area = errors[errors.size() - 1];
  }
  if (!solution.levels.back().observed.empty()) {
    const std::vector<double> shares = multigrid::column_observed(solution.levels, place_of_share(solution));
    constexpr double order = 2.0, unsure = 1.0;
    const judgement::Extrapolation limit = judgement::extrapolate(shares, order, unsure);
    result.share_extrapolated = limit.value;
    const bool several = shares.size() > 1 && input.scene.grid.nx % 2 == 0 && input.scene.grid.ny % 2 == 0;
    if (settings.extent >= Extent::whole && solution.converged && result.contact.share > 0.0 && several) {
      result.share_coarse = shares.end()[-2];
      try {
        result.share_of_half_film = share_of_half_film(input);
      } catch (const core::SolverError&) {
        // The sensitivity is then not known.
      }
    }
  }
  result.seconds = core::now() - began;
  computed.mixed = result;
}

std::string what(const Case& input) {
  const multigrid::BoundaryFilm& film = *input.scene.boundary_film;
  return "surfaces touch at a boundary film of " + height_text(input, film.H_b) +
         (std::isfinite(film.hardness) ? fmt::format(", hardness {:.3g} p_h", film.hardness) : "");
}

std::string summary(const Case& input, const Computed& computed) {
  const MixedResult& mixed = *computed.mixed;
  const mixed::Contact& contact = mixed.contact;
  const std::string mark = convergence_mark(computed.solution.converged);
  if (contact.share == 0.0)
    return "contact      the surfaces do not touch: the film is nowhere as thin as the boundary film, " +
           height_text(input, input.scene.boundary_film->H_b) + mark + "\n";
  const auto bar = [](double error) { return std::isfinite(error) ? " +- " + percent(error) : ""; };
  std::string text = fmt::format("contact      carries {:.5g}{} of the load at h_b = {}", contact.share,
                                 bar(mixed.error_share), height_text(input, input.scene.boundary_film->H_b)) +
                     mark + "\n";
  if (std::isfinite(mixed.share_extrapolated))
    text += fmt::format("             extrapolated to mesh size zero: {:.4g}\n", mixed.share_extrapolated);
  text += fmt::format(
      "             touches on {:.4g}{} of the Hertz area, in {} patch{}; largest P_c {:.4g} p_h{}\n", contact.area,
      bar(mixed.error_area), contact.patches, contact.patches == 1 ? "" : "es", contact.P_c_max,
      std::isfinite(input.physics.p_h) ? " (" + pressure_in_GPa(contact.P_c_max * input.physics.p_h) + ")" : "");
  if (std::isfinite(mixed.share_of_half_film))
    text += fmt::format("             with half the boundary film {:.3g} instead of {:.3g}, on half as many cells\n",
                        mixed.share_of_half_film, mixed.share_coarse);
  const double wave = cells_per_wave * input.scene.grid.longest_step();
  if (input.scene.surface)
    text += "             waves shorter than " +
            (input.physics.si ? length(wave * input.physics.si->hertz.a) : fmt::format("{:.3g} a", wave)) +
            " are not resolved: they count as part of the boundary film\n";
  return text;
}

void add_content(const Case& input, const Computed& computed, results::Content& content) {
  const steady::Solution& solution = computed.solution;
  content.fields.push_back({"P_f", "p_h", "pressure of the oil", &solution.P_f});
  content.fields.push_back({"P_c", "p_h", "pressure between the touching surfaces", &solution.P_c});
  numbers::append("mixed", {input, computed}, content.summary);
}

}  // namespace

namespace numbers {
namespace {

const MixedResult& touched(Of s) { return *s.computed.mixed; }
bool has_half(Of s) { return std::isfinite(touched(s).share_of_half_film); }

Group mixed_numbers() {
  Group group{.name = "mixed"};
  group.on = [](Of s) { return s.computed.mixed.has_value(); };
  group.asked = mixed::called_for;
  const auto of = [](double MixedResult::*part) { return [part](Of s) { return touched(s).*part; }; };
  const auto in_contact = [](auto mixed::Contact::*part) { return [part](Of s) { return touched(s).contact.*part; }; };
  group.numbers = {
      number("load_share", "-", "share of the load that touching surfaces carry", bar("error_load_share"),
             label("load share of the contact"), column(801), on_page(18), sweep_page(OfSweep::as_curve),
             in_contact(&mixed::Contact::share)),
      number("error_load_share", "-", "estimated relative error of load_share", column(802),
             of(&MixedResult::error_share)),
      number("load_share_extrapolated", "-", "load_share extrapolated to mesh size zero", column(803),
             of(&MixedResult::share_extrapolated)),
      number("contact_area", "-", "area on which the surfaces touch, over that of the smooth dry contact",
             bar("error_contact_area"), label("contact area"), column(804), in_contact(&mixed::Contact::area)),
      number("error_contact_area", "-", "estimated relative error of contact_area", column(805),
             of(&MixedResult::error_area)),
      number("patches", "-", "number of separate contact areas", column(806), in_contact(&mixed::Contact::patches)),
      number("P_c_max", "p_h", "largest pressure between the surfaces", column(807),
             in_contact(&mixed::Contact::P_c_max)),
      number("P_c_max_x", "a", "its place", in_contact(&mixed::Contact::X)),
      number("P_c_max_y", "a", "its place", in_contact(&mixed::Contact::Y)),
      number("load_share_coarse", "-", "load_share on half as many cells", only_if(has_half),
             of(&MixedResult::share_coarse)),
      number("load_share_of_half_film", "-", "the same with half the boundary film", only_if(has_half),
             of(&MixedResult::share_of_half_film))};
  return group;
}

}  // namespace
}  // namespace numbers

Effect mixed_effect() {
  return {.name = "mixed",
          .meaning = "Mixed lubrication: rough or smooth surfaces that touch where the film falls to a boundary film.",
          .sections = {{.name = "mixed", .called_by = {"h_b", "H_b"}}},
          .keys = mixed::keys,
          .numbers = numbers::mixed_numbers,
          .stages = {.scene = mixed_input, .after_solution = after_solution, .from = Extent::row},
          .on = [](const Case& input) { return input.scene.boundary_film.has_value(); },
          .what = what,
          .summary = summary,
          .add_content = add_content,
          .seconds = [](const Computed& computed) { return computed.mixed ? computed.mixed->seconds : 0.0; },
          .example = {"mixed.H_b=0.02"}};
}

}  // namespace ehl::program
