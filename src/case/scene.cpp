#include "case/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/machine.hpp"
#include "case/catalogue.hpp"
#include "case/effects.hpp"
#include "case/machine_input.hpp"
#include "case/needs.hpp"
#include "case/numbers/names.hpp"
#include "case/roller_input.hpp"
#include "case/supply_input.hpp"
#include "case/touching.hpp"
#include "core/constants.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "effects/mixed/keys.hpp"
#include "effects/roller/slices.hpp"
#include "machines/keys.hpp"
#include "mlmi/keys.hpp"
#include "multigrid/keys.hpp"
#include "reynolds/keys.hpp"
#include "steady/keys.hpp"
#include "steady/newton_fallback.hpp"
#include "steady/resolution.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;

/// Limit of cycles on a large finest grid if the surfaces touch. [bench: most_cycles_where_they_touch]
constexpr int most_cycles_where_they_touch = 6;

// The unit of a load for a contact in SI.
deck::PlainUnit newton_of(const Physics& physics) {
  const bool known = physics.language == Language::si || physics.language == Language::none;
  return {.in_SI = physics.si ? physics.si->contact.load : core::unknown, .known = known};
}

void check_coarsenings(deck::Deck& deck, const steady::Scene& scene) {
  const int most = mlmi::most_coarsenings(scene.grid);
  if (scene.deformation.coarsenings > most)
    complain(deck, "deformation", "coarsenings",
             fmt::format("must be <= {} on a grid of {} x {} cells: every coarsened direction must keep 8 cells", most,
                         scene.grid.nx, scene.grid.ny));
}

// Refuses sections that are not available for line contacts or rollers.
void refuse_sections(deck::Deck& deck, std::initializer_list<const char*> sections, const std::string& which) {
  for (const char* section : sections)
    for (const deck::Key& key : deck.catalogue.keys)
      if (key.section == section && given(deck, key.section, key.name)) {
        complain(deck, key.section, key.name,
                 "is not available for " + which + ": remove the section, or change [contact] kind");
        break;
      }
}

void refuse_beyond_roller(deck::Deck& deck) {
  refuse_sections(deck, {"transient", "body", "supply", "thermal"}, "rollers");
  if (deck::word(deck, "shear", "flow") == "on")
    complain(deck, "shear", "flow", "is not available for rollers: set flow = off, or change [contact] kind");
}

void refuse_beyond_line(deck::Deck& deck) {
  refuse_sections(deck, {"body"}, "line contacts");
  for (const char* section : {"surface1", "surface2"}) {
    const deck::Part surface{deck, section};
    const std::string shape = surface.word("shape");
    if (surface.given("shape") && shape != "ridge" && shape != "groove" && shape != "waviness")
      surface.complain("shape", "varies along y, and a line contact does not: use ridge, groove or waviness");
    if (surface.given("angle") && surface.number("angle") != 0.0)
      surface.complain("angle", "must be 0 for a line contact, where nothing varies along y");
    if (surface.given("y") && surface.number("y") != 0.0)
      surface.complain("y", "must be 0 for a line contact, where nothing varies along y");
  }
}

// The far field of a line contact assumes one uniform flow; in time the flow varies along the film.
void settle_line_in_time(deck::Deck& deck) {
  if (!deck::called_for(deck, "transient")) return;
  const deck::Part domain{deck, "domain"};
  if (domain.given("far_field") && domain.word("far_field") == "closed")
    domain.complain("far_field", "closed holds for a steady line contact: set zero for one in time, or remove it");
  domain.follow("far_field", std::string("zero"), "line contact in time");
}

// Reads the names of the case and of its result, and the fields to keep. in: path of the deck.
void read_names(const std::string& path, Case& input) {
  const deck::Part title{input.deck, "case"}, output{input.deck, "output"};
  const std::string stem = std::filesystem::path(path).stem();
  title.fill("title", deck::is_utf8(stem) ? stem : "untitled", "name of the deck");
  input.title = title.word("title");
  input.fields = output.words("fields");
  const std::string file = output.word("file");
  input.output = !file.empty() ? file : (stem.empty() ? "result" : stem) + ".h5";
}

void read_errors(Case& input, bool steady) {
  steady::Scene& scene = input.scene;
  scene.error_maps =
      std::ranges::any_of(input.fields, [](const std::string& one) { return one.starts_with("error_map_"); });
  if (scene.grid.line && !scene.error_maps)
    deck::Part{input.deck, "grid"}.follow("errors", std::string("levels"), "line contact");
  if (mixed::called_for(input.deck))
    deck::Part{input.deck, "grid"}.follow("errors", std::string("levels"),
                                          "adjoint error estimates need surfaces apart");
  scene.adjoint_errors = steady::read_adjoint_errors(input.deck);
  if (scene.error_maps && deck::called_for(input.deck, "supply"))
    deck::Part{input.deck, "output"}.complain(
        "fields", "error_map_Hc and error_map_Hm are available for flooded contacts only: remove them, or [supply]");
  else if (scene.error_maps && !(steady && scene.adjoint_errors && reynolds::third_order(scene.wedge)))
    deck::Part{input.deck, "output"}.complain(
        "fields",
        "error_map_Hc and error_map_Hm are available for steady contacts with wedge = "
        "upstream3 and [grid] errors = adjoint only");
}

}  // namespace

std::vector<deck::Key> case_keys() {
  using deck::Type;
  return deck::together(
      {deck::in_section(
           "case",
           {{.name = "title",
             .type = Type::text,
             .default_text = "untitled",
             .meaning = "Title of the case, printed on reports and pictures.",
             .example = "Venner and ten Napel 1992, M = 50, L = 10",
             .example_is_active = true},
            {.name = "kind",
             .default_text = "lubricated",
             .words = {"lubricated", "dry", machines::ball_race, machines::roller_race, machines::gear_mesh,
                       machines::cam_and_tappet, machines::reciprocating, machines::impact},
             .meaning =
                 "Kind of case. lubricated: a lubricated contact. dry: elastic bodies in contact without lubricant, "
                 "smooth (Hertz) or with the shapes of [surface1] and [surface2]; [contact] then has load, radius_x "
                 "and the elastic data, or nothing (units of Hertz), and keys of a film are errors. ball_race, "
                 "roller_race: radii, speeds and load of [contact] and [motion] follow from [bearing]. gear_mesh: they "
                 "follow from [gear]. cam: they follow from [cam]. In these four, E' and the oil are given as usual. "
                 "reciprocating: the speeds follow from [stroke]; load and radii are given as usual. impact: a body "
                 "with the mass and velocity of [impact] meets the film; [contact] then has no load. With [transient] "
                 "cycle = machine a run in time follows the cam, the pair of teeth or the stroke."}}),
       deck::in_section(
           "output",
           {{.name = "file",
             .type = Type::text,
             .default_note = "name of the deck with the ending .h5",
             .meaning = "Name of the result file (HDF5). --output has precedence.",
             .example = "contact.h5"},
            {.name = "fields",
             .type = Type::words,
             .default_text = "P, H",
             .words = {"P", "H", "rho_bar", "ln_eta_bar", id::error_map_Hc, id::error_map_Hm},
             .meaning =
                 "Fields to store. P: pressure. H: film thickness. rho_bar: density. ln_eta_bar: logarithm of "
                 "the viscosity. error_map_Hc, error_map_Hm: maps of the contributions to the discretization errors of "
                 "Hc and Hm, with [grid] errors = adjoint and wedge = upstream3."}})});
}

Case read_case(const std::string& path, const std::vector<std::string>& overrides, int threads) {
  return case_of(deck::read(path, overrides, catalogue()), path, threads);
}

Case read_lubricated_case(const std::string& path, const std::vector<std::string>& overrides, int threads,
                          const std::string& command) {
  Case result = read_case(path, overrides, threads);
  if (result.dry)
    throw core::InputError(path + ": [case] kind = dry: `ehl " + command + "` needs a lubricated contact");
  return result;
}

Case case_of(deck::Deck understood, const std::string& path, int threads) {
  Case result;
  result.deck = std::move(understood);
  deck::Deck& deck = result.deck;
  result.machine = machine_input(deck);
  deck::check_influence(deck);
  result.dry = dry_input(deck);
  result.physics = result.dry ? dry_physics(*result.dry) : physical_input(deck);
  steady::Scene& scene = result.scene;
  scene.deformation = mlmi::read(deck);
  scene.solver = multigrid::read(deck);
  result.tuning = read_tuning(deck);
  scene.solver.tuning = result.tuning.multigrid;
  scene.solver.judgement = result.tuning.judgement;
  scene.newton = result.tuning.newton;
  scene.tuning = result.tuning.steady;
  const contact::Groups& groups = result.physics.groups;
  scene.contact = steady::scales_of(groups.M, groups.L, groups.shape);
  settle_boundary_of_supply(deck);
  if (contact::roller(groups.shape)) {
    settle_roller(deck);
    result.roller = roller_profile(deck, result.physics);
  } else if (contact::line(groups.shape)) {
    settle_line_in_time(deck);
  }
  if (!result.dry) {
    scene.accuracy = steady::read_accuracy(deck);
    scene.wedge = reynolds::read(deck);
    scene.face = reynolds::read_face(deck);
    const transient::FarDemands far = far_demands(deck, result.physics, result.machine);
    scene.far_field = steady::read_far_field(deck, scene.tuning, groups.shape, far.steepest_load, far.why_zero);
    steady::choose_grid(deck, scene.tuning, scene.contact, scene.wedge,
                        result.roller ? roller::bearing(*result.roller).widest : 1.0);
  }
  const bool contact_known = result.dry || groups.M > 0.0;
  if (contact_known) steady::check_contains(deck, groups.shape);
  std::optional<double> size;
  if (contact_known) size = result.dry ? 1.0 : scene.contact.size;
  const steady::GridInput grid = steady::read_grid(deck, size, steady::cell_aspect(scene.tuning, groups.shape),
                                                   contact::line(groups.shape) && !contact::roller(groups.shape));
  scene.grid = grid.finest;
  scene.solver.coarsest_cells = grid.coarsest;
  if (result.dry) result.dry->parameters.coarsest_cells = grid.coarsest;
  scene.continuation = steady::read_continuation(deck, groups.M, newton_of(result.physics));
  scene.polish = steady::read_polish(deck);
  scene.threads = threads;
  scene.lambda = groups.lambda;
  scene.viscosity = result.physics.viscosity;
  scene.density = result.physics.density;
  const Motion motion = result.dry                             ? Motion::dry
                        : given(deck, "transient", "end_time") ? Motion::in_time
                                                               : Motion::steady;
  read_names(path, result);
  read_errors(result, motion == Motion::steady);
  result.surfaces = surface_input(deck, result.physics, scene.grid, motion);
  result.transient =
      transient_input(deck, result.tuning.transient, result.physics, result.surfaces, result.machine, scene.grid);
  read_effects(result);
  if (contact::roller(groups.shape)) refuse_beyond_roller(deck);
  if (scene.grid.line) refuse_beyond_line(deck);
  if (scene.grid.ny > 0) {
    check_coarsenings(deck, scene);
    if (scene.contact.M > 0.0) check_domain(deck, scene);
    check_memory(result);
    bound_accuracy(result);
  }
  if (deck.errors.empty()) refuse_idle(result);
  deck::throw_if_wrong(deck);
  if (!scene.boundary_film) scene.one_start_only = why_they_touch(result);
  const bool large =
      static_cast<double>(scene.grid.nodes_x()) * scene.grid.nodes_y() > steady::most_nodes_of_second_newton;
  if (!scene.one_start_only.empty() && large && !given(deck, "multigrid", "max_cycles"))
    scene.solver.max_cycles = most_cycles_where_they_touch;

  result.files = deck::named_files(deck);
  return result;
}

}  // namespace ehl::program
