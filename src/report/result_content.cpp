#include "report/result_content.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "commands/machine.hpp"
#include "core/processor_level.hpp"
#include "deck/text.hpp"
#include "deck/write.hpp"
#include "report/version.hpp"
#include "surface/resample.hpp"

namespace ehl::program {
namespace {

using results::Column;
using results::Quantity;
using results::Table;
using results::Text;

bool wanted(const Case& input, const std::string& field) {
  return std::find(input.fields.begin(), input.fields.end(), field) != input.fields.end();
}

std::vector<Quantity> scales(const Case& input) {
  const Physics& physics = input.physics;
  const contact::Groups& g = physics.groups;
  std::vector<Quantity> list{{"M", g.M, "-", "Moes load number"},
                             {"L", g.L, "-", "Moes material number"},
                             {"W", g.W, "-", "Hamrock-Dowson load number"},
                             {"U", g.U, "-", "Hamrock-Dowson speed number"},
                             {"G", g.G, "-", "Hamrock-Dowson material number"},
                             {"lambda", g.lambda, "-", "6 eta0 u_s R^2/(a^3 p_h)"},
                             {"alpha_bar", g.alpha_bar, "-", "alpha p_h"},
                             {"p_h", physics.p_h, "Pa", "Hertz pressure, the scale of P"},
                             {"H_moes", contact::H_to_moes_units(1.0, g.M, g.shape), "-", "film in Moes units over H"}};
  const bool elliptic = !contact::circular(g.shape);
  if (elliptic) {
    list.push_back({"radius_ratio", g.shape.radius_ratio, "-", "R_x/R_y"});
    list.push_back({"angle", g.shape.angle, "degrees", "from the direction of R_x to the entrainment"});
    list.push_back({"kappa", g.shape.kappa, "-", "b/a, the semi-axes along R_y and R_x"});
  }
  if (!physics.si) return list;
  const contact::SiContact& c = physics.si->contact;
  const std::vector<Quantity> more{{"a", physics.si->hertz.a, "m", "Hertz radius, the scale of X and Y"},
                                   {"h", physics.si->hertz.h_scale, "m", "a^2/R, the scale of H"},
                                   {"load", c.load, "N", "normal load"},
                                   {"R", c.radius, "m", "reduced radius"},
                                   {"E_prime", c.E_prime, "Pa", "reduced modulus"},
                                   {"u1", physics.si->u1, "m/s", "speed of surface 1"},
                                   {"u2", physics.si->u2, "m/s", "speed of surface 2"},
                                   {"u_s", c.u_s, "m/s", "u1 + u2"},
                                   {"eta0", c.eta0, "Pa s", "viscosity at ambient pressure"}};
  list.insert(list.end(), more.begin(), more.end());
  if (elliptic) {
    list.push_back({"b", physics.si->hertz.b, "m", "semi-axis along R_y"});
    list.push_back({"R_y", c.radius / c.shape.radius_ratio, "m", "reduced radius across R_x"});
  }
  return list;
}

void add_verification(const steady::Verification& checked, bool elliptic, std::vector<Quantity>& list) {
  const char* through = elliptic ? "mass flow through the contact at x = 0, as wide as the ellipse"
                                 : "mass flow through the contact, |y| <= 1 at x = 0";
  const char* imbalance = elliptic ? "mass flow out of 1.5 times the ellipse's reach less in, over flow_through"
                                   : "mass flow out of |x|, |y| <= 1.5 less in, over flow_through";
  const std::vector<Quantity> more{
      {"largest_residual", checked.largest_residual, "-", "at one node, relative to the wedge term like the residual"},
      {"largest_residual_x", checked.largest_residual_X, "a", "where it is"},
      {"largest_residual_y", checked.largest_residual_Y, "a", "where it is"},
      {"least_P", checked.least_P, "p_h", "lowest pressure of all nodes"},
      {"dry_violation", checked.dry_violation, "-", "largest residual of a cavitated node that wants pressure"},
      {"change_Hc", checked.change_Hc, "-", "relative change of Hc in the last cycle"},
      {"change_Hm", checked.change_Hm, "-", "relative change of Hm in the last cycle"},
      {"algebraic_error_Hc", checked.algebraic_error_Hc, "-", "what further cycles would change, foretold"},
      {"algebraic_error_Hm", checked.algebraic_error_Hm, "-", "what further cycles would change, foretold"},
      {"flow_through", checked.flow_through, "rho0 u_m a^3/R", through},
      {"flow_imbalance", checked.flow_imbalance, "-", imbalance},
      {"flow_imbalance_whole", checked.flow_imbalance_whole, "-", "the same of all of the pressurised region"}};
  list.insert(list.end(), more.begin(), more.end());
}

// Where an accuracy was asked for, the deck of the result names the grid that it led to instead.
deck::Deck with_grid_of(const steady::Solution& solution, deck::Deck deck) {
  if (std::isnan(solution.accuracy.asked)) return deck;
  const std::string why = "for the accuracy " + deck::shortest(solution.accuracy.asked) + " that was asked for";
  for (std::size_t k = 0; k < deck.values.size(); ++k)
    if (deck.catalogue.keys[k].section == "grid" && deck.catalogue.keys[k].name == "accuracy")
      deck.values[k] = {.origin = deck::Origin::absent, .number = std::nan("")};
  deck::choose(deck, "grid", "cells", solution.grid.nx, why);
  if (!deck::given(deck, "domain", "x_inlet")) deck::choose(deck, "domain", "x_inlet", solution.grid.X_a, why);
  if (!deck::given(deck, "domain", "y_half")) deck::choose(deck, "domain", "y_half", solution.grid.Y_b, why);
  return deck;
}

void add_error_bars(const steady::ErrorBars& bars, std::vector<Quantity>& list) {
  const std::vector<Quantity> more{
      {"Hc_extrapolated", bars.Hc_extrapolated.value, "a^2/R", "Hc extrapolated to mesh size zero"},
      {"error_Hc_extrapolated", bars.Hc_extrapolated.error, "-", "its estimated relative error"},
      {"Hm_extrapolated", bars.Hm_extrapolated.value, "a^2/R", "Hm_fitted extrapolated to mesh size zero"},
      {"error_Hm_extrapolated", bars.Hm_extrapolated.error, "-", "its estimated relative error"},
      {"Hm_fitted", bars.Hm_fitted_value, "a^2/R", "smallest film between the nodes, by a paraboloid"},
      {"Hm_fitted_x", bars.Hm_fitted_X, "a", "where it is"},
      {"Hm_fitted_y", bars.Hm_fitted_Y, "a", "where it is"},
      {"error_Hm_fitted", bars.Hm_fitted.total(), "-", "its estimated relative error on this domain"},
      {"total_error_Hc", bars.Hc.total(), "-", "estimated relative error on this domain: mesh and cycles"},
      {"total_error_Hm", bars.Hm.total(), "-", "estimated relative error on this domain: mesh and cycles"},
      {"domain_error", bars.domain, "-", "estimated relative change of Hc on a domain without end"},
      {"error_P_max", bars.P_max, "-", "estimated relative error of P_max; NaN where it does not converge"},
      {"P_max_converging", bars.P_max_converging ? 1.0 : 0.0, "-", "0: P_max grows with the mesh", true}};
  list.insert(list.end(), more.begin(), more.end());
}

std::vector<Quantity> summary_numbers(const steady::Solution& solution, const Outcome& outcome, bool elliptic) {
  std::vector<Quantity> list{{"converged", solution.converged ? 1.0 : 0.0, "-", "1: all checks passed, 0: not", true},
                             {"Hc", outcome.Hc, "a^2/R", "film at (0,0)"},
                             {"Hm", outcome.Hm.value, "a^2/R", "smallest film of all nodes"},
                             {"Hm_x", outcome.Hm.X, "a", "where the smallest film is"},
                             {"Hm_y", outcome.Hm.Y, "a", "where the smallest film is"},
                             {"Hc_moes", outcome.Hc_moes, "-", "(h/R)(2U)^(-1/2) at the centre"},
                             {"Hm_moes", outcome.Hm_moes, "-", "(h/R)(2U)^(-1/2), smallest"},
                             {"hc", outcome.hc, "m", "film at (0,0)"},
                             {"hm", outcome.hm, "m", "smallest film"},
                             {"P_max", outcome.P_max.value, "p_h", "highest pressure of all nodes"},
                             {"P_max_x", outcome.P_max.X, "a", "where the highest pressure is"},
                             {"P_max_y", outcome.P_max.Y, "a", "where the highest pressure is"},
                             {"H00", solution.H00, "a^2/R", "mutual approach"},
                             {"seconds", solution.seconds, "s", "time of the solution"}};
  if (!solution.levels.empty()) {
    const steady::LevelRow& last = solution.levels.back();
    list.push_back({"residual", last.residual, "-", "relative residual of the Reynolds equation"});
    list.push_back({"load_error", last.load_error, "-", "|integral of P - 2 pi/3| over 2 pi/3"});
    list.push_back({"error_Hc", last.error_Hc, "-", "estimated relative discretization error of Hc"});
    list.push_back({"error_Hm", last.error_Hm, "-", "estimated relative discretization error of Hm"});
  }
  add_error_bars(solution.error_bars, list);
  add_verification(solution.verification, elliptic, list);
  return list;
}

template <class Row>
Column column(const std::vector<Row>& rows, const std::string& name, const std::string& unit,
              const std::string& meaning, bool whole, const std::function<double(const Row&)>& value) {
  Column made{name, unit, meaning, whole, {}};
  for (const Row& row : rows) made.values.push_back(value(row));
  return made;
}

Table level_rows(const steady::Solution& solution) {
  using Row = steady::LevelRow;
  const auto number = [&](const char* name, const char* unit, const char* meaning, double Row::*member) {
    return column<Row>(solution.levels, name, unit, meaning, false, [member](const Row& row) { return row.*member; });
  };
  const auto count = [&](const char* name, const char* meaning, int Row::*member) {
    return column<Row>(solution.levels, name, "-", meaning, true, [member](const Row& row) { return row.*member; });
  };
  return {"levels",
          "the full multigrid, level by level: what accuracy cost in time",
          {count("level", "grid level", &Row::level), count("nx", "cells along x", &Row::nx),
           count("ny", "cells along y", &Row::ny), number("Hc", "a^2/R", "film at (0,0)", &Row::Hc),
           number("Hm", "a^2/R", "smallest film of all nodes", &Row::Hm),
           number("error_Hc", "-", "estimated relative discretization error", &Row::error_Hc),
           number("error_Hm", "-", "estimated relative discretization error", &Row::error_Hm),
           number("Hm_fitted", "a^2/R", "smallest film between the nodes", &Row::Hm_fitted),
           number("P_max", "p_h", "highest pressure of all nodes", &Row::P_max),
           number("order_Hc", "-", "observed order of convergence", &Row::order_Hc),
           number("residual", "-", "relative residual of the Reynolds equation", &Row::residual),
           number("load_error", "-", "relative error of the load", &Row::load_error),
           count("cycles", "cycles on the level", &Row::cycles),
           number("work_units", "-", "in residual and deformation evaluations on the level", &Row::work_units),
           number("seconds", "s", "time on the level", &Row::seconds)}};
}

Table cycle_rows(const steady::Solution& solution) {
  using Row = steady::CycleRow;
  const auto number = [&](const char* name, const char* unit, const char* meaning, double Row::*member) {
    return column<Row>(solution.history, name, unit, meaning, false, [member](const Row& row) { return row.*member; });
  };
  const auto count = [&](const char* name, const char* meaning, int Row::*member) {
    return column<Row>(solution.history, name, "-", meaning, true, [member](const Row& row) { return row.*member; });
  };
  return {"history",
          "every cycle on every level",
          {count("level", "grid level", &Row::level), count("cycle", "cycle on the level", &Row::cycle),
           number("residual", "-", "relative residual of the Reynolds equation", &Row::residual),
           number("load_error", "-", "relative error of the load", &Row::load_error),
           number("Hc", "a^2/R", "film at (0,0)", &Row::Hc),
           number("Hm", "a^2/R", "smallest film of all nodes", &Row::Hm)}};
}

Table continuation_rows(const steady::Solution& solution) {
  using Row = steady::ContinuationStep;
  const auto number = [&](const char* name, const char* unit, const char* meaning, double Row::*member) {
    return column<Row>(solution.continuation, name, unit, meaning, false,
                       [member](const Row& row) { return row.*member; });
  };
  return {"continuation",
          "load continuation: every load that was solved for",
          {number("M", "-", "Moes load number", &Row::M),
           number("load_ratio", "-", "load over that of the case", &Row::load_ratio),
           number("Hc", "a^2/R", "film at (0,0)", &Row::Hc), number("Hm", "a^2/R", "smallest film", &Row::Hm),
           number("residual", "-", "relative residual of the Reynolds equation", &Row::residual),
           column<Row>(solution.continuation, "cycles", "-", "cycles for this load", true,
                       [](const Row& row) { return row.cycles; }),
           column<Row>(solution.continuation, "converged", "-", "1: solved; 0: rejected, a shorter step follows", true,
                       [](const Row& row) { return row.converged ? 1.0 : 0.0; })}};
}

// What the mesh holds of each measured map.
void add_resolution(const Case& input, const core::Grid& grid, std::vector<Quantity>& list) {
  for (const CarriedSurface* one : carried(input.surfaces)) {
    const auto* map = std::get_if<surface::HeightMap>(&one->relief);
    if (!map) continue;
    const surface::Resolution left = surface::resolution(*map, grid);
    list.push_back({one->section + "_variance_lost", left.variance_lost, "-", "share of the map's variance"});
    list.push_back({one->section + "_shortest_wave_x", left.shortest_wave_X, "a", "that the mesh holds along x"});
    list.push_back({one->section + "_shortest_wave_y", left.shortest_wave_Y, "a", "that the mesh holds along y"});
  }
}

}  // namespace

std::vector<Text> provenance(const Case& input) {
  const Version built = version();
  const std::string folder = input.deck.folders.empty() ? "" : input.deck.folders.front();
  return {{"program", "ehl", "program that wrote the file"},
          {"version", built.number, "its version"},
          {"commit", built.commit, "commit of its source"},
          {"dirty", built.dirty ? "true" : "false", "whether the source had changes that no commit holds"},
          {"compiler", built.compiler, ""},
          {"host_cpu", processor(), "processor of the machine"},
          {"cpu_level", core::processor_level(), "what the numerics in use were compiled for"},
          {"threads", std::to_string(input.scene.threads), "threads used"},
          {"deck_folder", folder, "where the deck lay, and files that it names are looked for"},
          {"date", utc_date(), "UTC date of the run"}};
}

void add_surface_records(const Case& input, const core::Grid& grid, results::Content& content) {
  for (const std::string& line : surface_lines(input.surfaces, input.physics, grid))
    content.remarks.push_back({line.substr(0, line.find(':')), line.substr(line.find(':') + 2), "what it carries"});
  add_resolution(input, grid, content.summary);
}

DerivedFields derived_fields(const Case& input, const steady::Solution& solution) {
  DerivedFields derived;
  if (wanted(input, "rho_bar")) derived.rho_bar = core::Field(solution.grid);
  if (wanted(input, "ln_eta_bar")) derived.ln_eta_bar = core::Field(solution.grid);
  if (input.scene.surface) {
    derived.S = core::Field(solution.grid);
    input.scene.surface(solution.grid, derived.S);
  }
  for (int i = 0; i < solution.grid.nodes_x(); ++i) {
    if (wanted(input, "rho_bar"))
      rheology::density(input.scene.density, solution.P.station(i), derived.rho_bar.station(i));
    if (wanted(input, "ln_eta_bar"))
      rheology::log_viscosity(input.scene.viscosity, solution.P.station(i), derived.ln_eta_bar.station(i));
  }
  return derived;
}

results::Content result_content(const Case& input, const steady::Solution& solution, const Outcome& outcome,
                                const DerivedFields& derived) {
  results::Content content;
  content.title = input.title;
  content.deck = deck::effective_deck(with_grid_of(solution, input.deck));
  content.provenance = provenance(input);
  content.scales = scales(input);
  content.grid = solution.grid;
  const std::vector<results::NamedField> fields{{"P", "p_h", "pressure p/p_h", &solution.P},
                                                {"H", "a^2/R", "film thickness h R/a^2", &solution.H},
                                                {"rho_bar", "rho0", "density rho/rho0", &derived.rho_bar},
                                                {"ln_eta_bar", "-", "ln(eta/eta0)", &derived.ln_eta_bar}};
  for (const results::NamedField& field : fields)
    if (wanted(input, field.name)) content.fields.push_back(field);
  if (input.scene.surface)
    content.fields.push_back(
        {"S", "a^2/R", "what the surfaces at rest add to the gap, as means over cells", &derived.S});
  content.summary = summary_numbers(solution, outcome, !contact::circular(input.scene.shape));
  content.remarks = {{"failed_check", solution.failed_check, "empty when converged"},
                     {"warnings", deck::joined(outcome.warnings, "\n"), "one a line"},
                     {"method", solution.method, "the way that led to the solution"},
                     {"regime", outcome.regime, "regime of lubrication"},
                     {"deformation", solution.deformation, "how the elastic deformation was evaluated"}};
  add_surface_records(input, solution.grid, content);
  content.tables = {level_rows(solution), cycle_rows(solution)};
  if (!solution.continuation.empty()) content.tables.push_back(continuation_rows(solution));
  return content;
}

}  // namespace ehl::program
