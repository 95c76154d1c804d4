// The effect `friction`: friction on both surfaces.
#include <fmt/core.h>

#include <cmath>

#include "base/json.hpp"
#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "case/friction_in_time.hpp"
#include "case/numbers/records.hpp"
#include "case/sliding_input.hpp"
#include "deck/text.hpp"
#include "effects/friction/keys.hpp"
#include "effects/friction/of_scene.hpp"
#include "steady/multigrid_solve.hpp"

namespace ehl::program {
namespace numbers {
namespace {

using friction::Friction;

const Friction& rubbed(Of s) { return *s.computed.friction; }

bool beyond(Of s) { return rubbed(s).counts_outside; }
bool upstream(Of s) { return beyond(s) && rubbed(s).line; }
bool around(Of s) { return beyond(s) && !rubbed(s).line; }
bool has_meniscus(Of s) { return std::isfinite(rubbed(s).parameters.meniscus); }
bool touches(Of s) { return s.input.scene.boundary_film.has_value(); }
bool has_outer(Of s) { return rubbed(s).outer != 0.0; }
bool has_side(Of s) { return std::isfinite(rubbed(s).side); }

Group friction_numbers() {
  const auto of = [](double Friction::*part) { return [part](Of s) { return rubbed(s).*part; }; };
  Group group{.name = "friction"};
  group.on = [](Of s) { return s.computed.friction.has_value(); };
  group.asked = [](const deck::Deck& deck) { return deck::given(deck, "friction", "cavitated"); };
  group.numbers = {
      number(id::mu, "-", "sliding friction over the load, positive if surface 1 is the faster one", bar(id::error_mu),
             label("friction coefficient μ"), column(401), on_page(9), sweep_page(OfSweep::as_curve),
             of(&Friction::sliding)),
      number(id::error_mu, "-", "estimated relative error of mu on this domain", column(402),
             of(&Friction::error_sliding)),
      number(id::mu_rolling, "-", "rolling friction over the load, the same on both surfaces", bar("error_mu_rolling"),
             label("rolling friction"), column(403), on_page(11), of(&Friction::rolling)),
      number("error_mu_rolling", "-", "estimated relative error of mu_rolling on this domain", column(404),
             of(&Friction::error_rolling)),
      number(id::mu_1, "-", "force of the film on surface 1 along +x over the load", column(405), of(&Friction::on_1)),
      number(id::mu_2, "-", "force of the film on surface 2 along +x over the load", column(406), of(&Friction::on_2)),
      number("mu_boundary", "-", "part of mu from touching surfaces, mu_b times their load share", column(407),
             only_if(touches), of(&Friction::boundary)),
      number(id::mu_cavitated, "-", "part of mu from the cavitated region", of(&Friction::cavitated)),
      number(id::largest_shear_stress, "p_h", "largest shear stress of sliding, in the pressurized film",
             json("largest_stress"), of(&Friction::largest_stress)),
      number(id::limited_share, "-", "share of the load on which the limiting stress acts",
             of(&Friction::limited_share)),
      number(id::mu_beyond, "-", "part of mu from outside the domain", only_if(beyond), of(&Friction::beyond)),
      number("mu_upstream", "-", "part of mu_rolling from upstream of the domain", only_if(upstream),
             of(&Friction::rolling_beyond)),
      number(id::mu_rolling_beyond, "-", "part of mu_rolling from outside of the domain, up to the meniscus",
             only_if(around), of(&Friction::rolling_beyond)),
      number("meniscus", "a", "distance of the inlet meniscus up to which friction is counted", only_if(has_meniscus),
             [](Of s) { return rubbed(s).parameters.meniscus; }),
      number("mu_rolling_outer", "-",
             "part of mu_rolling from the outer half of the inlet; a domain of twice the length adds about as much if "
             "it is full of oil",
             only_if(has_outer), of(&Friction::outer)),
      number(id::mu_side, "-", "force of the film on each surface along +y over the load", only_if(has_side),
             of(&Friction::side)),
      number(id::slide_roll_ratio, "-", "(u1 - u2)/u_m", not_json, [](Of s) { return s.input.physics.srr; })};
  return group;
}

}  // namespace
}  // namespace numbers

namespace {

using friction::Friction;

std::string oil(const Case& input) { return input.scene.thinning ? "shear-thinning" : "Newtonian"; }

const char* thermal(const Case& input) { return input.heat ? "with heat" : "isothermal"; }

std::string what(const Case& input) {
  const friction::Parameters& parameters = *input.friction;
  return fmt::format("{}, {}, slide-roll ratio {:.4g}, ", thermal(input), oil(input), input.physics.srr) +
         (std::isfinite(parameters.limit) ? fmt::format("limited to {:.4g} p", parameters.limit)
                                          : "no limiting stress") +
         ", cavitated region: " + deck::word(input.deck, "friction", "cavitated") +
         (input.transient ? "; at every step in time" : "");
}

Needs expense(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  const double nodes = static_cast<double>(grid.nodes_x()) * grid.nodes_y();
  const int kept = (input.friction->keep_tau1 ? 1 : 0) + (input.friction->keep_tau2 ? 1 : 0);
  constexpr double seconds_per_node = 4e-8;
  const double times = input.transient ? 1.0 + expected_steps(input) : 1.0;
  return {.bytes = nodes * sizeof(double) * kept, .seconds = times * nodes * seconds_per_node};
}

// The region in which friction is computed.
std::string reach_of(const Case& input) {
  const double meniscus = input.friction->meniscus;
  if (std::isinf(meniscus)) return "to infinity";
  const std::optional<SiScales> si = si_scales(input.physics);
  return fmt::format("with the meniscus at {:.4g} a", -meniscus) +
         (si ? fmt::format(" ({:.4g} mm)", -1e3 * meniscus * si->a) : "");
}

std::string summary(const Case& input, const Computed& computed) {
  const Friction& f = *computed.friction;
  const auto in_newtons = [&](double mu) {
    if (!input.physics.si) return std::string();
    const char* unit = numbers::per_length(input) ? "N/m" : "N";
    return fmt::format(" ({:.3g} {})", mu * whole_load(*input.physics.si), unit);
  };
  const auto with_bar = [](double mu, double error) {
    return std::isfinite(error) && mu != 0.0 ? " +- " + percent(error) : "";
  };
  std::string text = fmt::format(
      "friction     {}mu = {:.5g}{} sliding{}, {:.3g}{} rolling{}{}\n", computed.in_time ? "at the start " : "",
      f.sliding, with_bar(f.sliding, f.error_sliding), in_newtons(f.sliding), f.rolling,
      with_bar(f.rolling, f.error_rolling), in_newtons(f.rolling), convergence_mark(computed.solution.converged));
  text += fmt::format(
      "             on surface 1 {:.5g}, on surface 2 {:.5g} of the load along +x; cavitated region {:.2g}\n", f.on_1,
      f.on_2, f.cavitated);
  if (f.boundary != 0.0)
    text += fmt::format("             of which {:.5g} from touching surfaces and {:.5g} from the oil\n", f.boundary,
                        f.sliding - f.boundary);
  if (f.counts_outside)
    text += fmt::format("             of which {:.3g} and {:.3g} from outside the domain, {}\n", f.beyond,
                        f.rolling_beyond, reach_of(input));
  if (f.outer != 0.0)
    text += fmt::format(
        "             {:.3g} of the rolling friction is from the outer half of the inlet; an inlet of twice the length "
        "adds about as much\n",
        f.outer);
  if (std::isfinite(f.side))
    text += fmt::format("             side force {:.3g} of the load along +y, on each surface{}\n", f.side,
                        in_newtons(f.side));
  const std::string own = fmt::format("{:.4g} p_h", f.largest_stress);
  const std::string absolute =
      std::isfinite(input.physics.p_h) ? pressure(f.largest_stress * input.physics.p_h) : std::string();
  text += "             largest shear stress of sliding ";
  text += input.physics.si ? absolute + " (" + own + ")" : own + (absolute.empty() ? "" : ", " + absolute);
  if (std::isfinite(f.parameters.limit))
    text += fmt::format(", limited on {:.0f} % of the load", 100.0 * f.limited_share);
  text += std::string("; ") + thermal(input) + ", " + oil(input) + "\n";
  return text + friction_in_time_summary(input, computed);
}

// The course of the friction in time.
void json(const Case& input, const Computed& computed, Json& report) {
  if (computed.in_time) add(numbers::quantities("course of friction", {input, computed}), report);
}

void add_content(const Case& input, const Computed& computed, results::Content& content) {
  const Friction& f = *computed.friction;
  if (f.parameters.keep_tau1)
    content.fields.push_back({"tau1", "p_h", "shear stress of the film on surface 1 along +x", &f.tau1});
  if (f.parameters.keep_tau2)
    content.fields.push_back({"tau2", "p_h", "shear stress of the film on surface 2 along +x", &f.tau2});
  numbers::append("friction", {input, computed}, content.summary);
  content.summary.push_back({"friction", what(input), "", "model of the friction"});
}

/// What observe_friction() observes: mu and mu_rolling.
constexpr std::size_t observed_numbers = 2;

friction::Parameters parameters_of(const Case& input) {
  return input.friction ? *input.friction : friction_of_contact(input.physics, input.scene);
}

}  // namespace

friction::Friction friction_of(const Case& input, const steady::Solution& solution, const heat::Fields* film) {
  friction::Parameters parameters = parameters_of(input);
  parameters.oblique = !input.scene.grid.line && !steady::on_one_half(input.scene);
  friction::Friction found = friction::friction_of(input.scene,
                                                   {.grid = solution.grid,
                                                    .P = steady::fluid_pressure(solution),
                                                    .H = solution.H,
                                                    .H00 = solution.H00,
                                                    .I0 = film ? &film->I0 : nullptr,
                                                    .less_tau = film ? &film->less_tau : nullptr,
                                                    .P_c = solution.P_c.nodes_x() > 0 ? &solution.P_c : nullptr},
                                                   parameters);
  if (const std::vector<double>& errors = solution.error_bars.observed; errors.size() >= observed_numbers) {
    found.error_sliding = errors[0];
    found.error_rolling = errors[1];
  }
  return found;
}

void observe_friction(Case& input) {
  if (!(input.friction || input.heat || input.flow_thinning)) return;
  friction::Parameters parameters = parameters_of(input);
  parameters.keep_tau1 = parameters.keep_tau2 = false;
  input.scene.observer = [parameters](const steady::Scene& scene, const steady::SolvedFilm& film) {
    const Friction found = friction::friction_of(scene, film, parameters);
    return std::vector<double>{found.sliding, found.rolling};
  };
}

Effect friction_effect() {
  return {.name = "friction",
          .meaning = "Friction on both surfaces, from the pressure and the film; in time at every step.",
          .sections = {{.name = "friction", .called_by = {"cavitated"}}},
          .costly = {"friction", "fields"},
          .keys = friction::keys,
          .numbers = numbers::friction_numbers,
          .more_numbers = friction_step_numbers,
          .read =
              [](Case& input) {
                if (deck::called_for(input.deck, "friction")) settle_sliding_at_start(input);
                input.friction = friction_input(input.deck, input.physics, input.scene);
              },
          .stages = {.scene = observe_friction,
                     .in_steps = friction_in_steps,
                     .after_solution =
                         [](const Case& input, RunSettings&, Computed& computed) {
                           computed.friction =
                               friction_of(input, computed.solution, fields_of_film(computed.heat, computed.flow));
                         },
                     .from = Extent::row},
          .on = [](const Case& input) { return input.friction.has_value(); },
          .what = what,
          .expense = expense,
          .summary = summary,
          .json = json,
          .warnings =
              [](const Case& input, const Computed& computed) {
                return computed.in_time ? friction_in_time_warnings(input, *computed.in_time)
                                        : friction::warnings(*computed.friction);
              },
          .add_content = add_content,
          .seconds =
              [](const Computed& computed) {
                return computed.friction->seconds + (computed.in_time ? computed.in_time->seconds.at("friction") : 0.0);
              },
          .example = {"motion.srr=0.5", "contact.a_over_R=0.01", "friction.cavitated=striated"}};
}

}  // namespace ehl::program
