#include "case/scene.hpp"

#include <cmath>
#include <filesystem>

#include "case/catalogue.hpp"
#include "case/effects.hpp"
#include "case/grid_input.hpp"
#include "case/needs.hpp"
#include "commands/machine.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;

// What the deck leaves open of the domain may grow.
steady::AccuracyTarget accuracy_of(deck::Deck& deck) {
  steady::AccuracyTarget target;
  if (!given(deck, "grid", "accuracy")) return target;
  target.error = deck::number(deck, "grid", "accuracy");
  if (given(deck, "grid", "cells"))
    complain(deck, "grid", "accuracy", "and cells are both given: keep one of them; accuracy finds the cells itself");
  target.domain_is_free = !given(deck, "domain", "x_inlet") && !given(deck, "domain", "y_half");
  constexpr double bytes_per_node = 24.0 * sizeof(double);
  constexpr double share_of_memory = 0.8;
  target.most_nodes = share_of_memory * usable_memory() / bytes_per_node;
  return target;
}

reynolds::Wedge wedge_of(const deck::Deck& deck) {
  return deck::word(deck, "discretization", "wedge") == "upstream1" ? reynolds::Wedge::upstream1
                                                                    : reynolds::Wedge::upstream2;
}

mlmi::Parameters deformation_of(deck::Deck& deck) {
  mlmi::Parameters parameters;
  const std::string method = deck::word(deck, "deformation", "method");
  parameters.method = method == "fft"      ? mlmi::Method::fft
                      : method == "direct" ? mlmi::Method::direct
                                           : mlmi::Method::mlmi;
  parameters.order = deck::integer(deck, "deformation", "order", parameters.order);
  parameters.patch_along = deck::integer(deck, "deformation", "patch_along", parameters.patch_along);
  parameters.patch_across = deck::integer(deck, "deformation", "patch_across", parameters.patch_across);
  parameters.coarsenings = deck::integer(deck, "deformation", "coarsenings", parameters.coarsenings);
  parameters.coarsest_direct = deck::word(deck, "deformation", "coarsest_sum") == "direct";
  if (parameters.order % 2 != 0) complain(deck, "deformation", "order", "must be 4, 6 or 8");
  return parameters;
}

void check_coarsenings(deck::Deck& deck, const steady::Scene& scene) {
  const int most = mlmi::most_coarsenings(scene.grid);
  if (scene.deformation.coarsenings > most)
    complain(deck, "deformation", "coarsenings",
             "must be <= " + std::to_string(most) + " on a grid of " + std::to_string(scene.grid.nx) + " x " +
                 std::to_string(scene.grid.ny) + " cells: every direction that is coarsened keeps 8 cells");
}

fmg::Parameters multigrid_of(deck::Deck& deck) {
  fmg::Parameters parameters;
  const std::string cycle = deck::word(deck, "multigrid", "cycle");
  if (!cycle.empty()) parameters.cycle = cycle == "V" ? fmg::Cycle::V : cycle == "F" ? fmg::Cycle::F : fmg::Cycle::W;
  parameters.pre = deck::integer(deck, "multigrid", "pre", parameters.pre);
  if (given(deck, "multigrid", "post")) parameters.post = deck::integer(deck, "multigrid", "post", 1);
  parameters.cycles = deck::integer(deck, "multigrid", "cycles", parameters.cycles);
  parameters.extra_cycles = deck::integer(deck, "multigrid", "extra_cycles", parameters.extra_cycles);
  parameters.max_cycles = deck::integer(deck, "multigrid", "max_cycles", parameters.max_cycles);
  parameters.tolerance = deck::number(deck, "multigrid", "tolerance");
  parameters.coarsest_cells = deck::integer(deck, "grid", "coarsest", 0);
  if (deck::word(deck, "multigrid", "line_solver") == "decimation")
    parameters.relaxation.line_solver = fmg::LineSolver::decimation;
  const int kernel_terms = deck::integer(deck, "multigrid", "kernel_terms", 2 * parameters.relaxation.reach + 1);
  if (kernel_terms % 2 == 0)
    complain(deck, "multigrid", "kernel_terms", "must be 3, 5 or 7: a point and its neighbours");
  parameters.relaxation.reach = kernel_terms / 2;
  if (parameters.pre == 0 && parameters.post.value_or(0) == 0)
    complain(deck, "multigrid", "pre", "pre + post = 0: a cycle without relaxation cannot converge");
  return parameters;
}

double first_load_ratio(deck::Deck& deck, const Physics& physics) {
  const bool by_M = given(deck, "continuation", "M_start");
  const bool by_load = given(deck, "continuation", "load_start");
  if (by_load && physics.language != Language::si && physics.language != Language::none)
    complain(deck, "continuation", "load_start", "is in newtons and the contact is not given in SI: use M_start");
  else if (by_load && by_M)
    complain(deck, "continuation", "load_start", "the first load is given as M_start already: keep one of them");
  else if (by_load && physics.si)
    return deck::number(deck, "continuation", "load_start") / physics.si->contact.load;
  return deck::number(deck, "continuation", "M_start") / physics.groups.M;
}

steady::ContinuationParameters continuation_of(deck::Deck& deck, const Physics& physics) {
  steady::ContinuationParameters parameters;
  using Path = steady::ContinuationParameters::Path;
  const std::string path = deck::word(deck, "continuation", "path");
  parameters.path = path == "load" ? Path::load : path == "off" ? Path::off : Path::automatic;
  parameters.load_ratio = first_load_ratio(deck, physics);
  if (parameters.load_ratio == 1.0)
    complain(deck, "continuation", given(deck, "continuation", "M_start") ? "M_start" : "load_start",
             "is the load of the contact itself: nothing to continue");
  parameters.step = deck::number(deck, "continuation", "step");
  parameters.max_steps = deck::integer(deck, "continuation", "max_steps", parameters.max_steps);
  return parameters;
}

std::string stem_of(const std::string& path) {
  const std::string stem = std::filesystem::path(path).stem();
  return (stem.empty() ? "result" : stem) + ".h5";
}

}  // namespace

Case read_case(const std::string& path, const std::vector<std::string>& overrides, int threads) {
  return case_of(deck::read(path, overrides, catalogue()), path, threads);
}

Case read_lubricated_case(const std::string& path, const std::vector<std::string>& overrides, int threads,
                          const std::string& command) {
  Case result = read_case(path, overrides, threads);
  if (result.dry)
    throw core::InputError(path + ": [case] kind = dry: `ehl " + command +
                           "` compares films, and this contact has none");
  return result;
}

Case case_of(deck::Deck understood, const std::string& path, int threads) {
  Case result;
  result.deck = std::move(understood);
  deck::Deck& deck = result.deck;
  result.dry = dry_input(deck);
  result.physics = result.dry ? dry_physics(*result.dry) : physical_input(deck);
  result.scene.deformation = deformation_of(deck);
  result.scene.multigrid = multigrid_of(deck);

  result.scene.accuracy = accuracy_of(deck);
  result.scene.wedge = wedge_of(deck);
  if (!result.dry) choose_grid(deck, result.physics.groups, result.scene.wedge);
  result.scene.grid = grid_input(deck, result.dry || result.physics.groups.M > 0.0);
  result.scene.continuation = continuation_of(deck, result.physics);
  const std::string polish = deck::word(deck, "multigrid", "polish");
  result.scene.polish = polish == "always" ? steady::Polish::always
                        : polish == "off"  ? steady::Polish::off
                                           : steady::Polish::rescue;
  result.scene.threads = threads;
  result.scene.M = result.physics.groups.M;
  result.scene.L = result.physics.groups.L;
  result.scene.lambda = result.physics.groups.lambda;
  result.scene.shape = result.physics.groups.shape;
  result.scene.viscosity = result.physics.viscosity;
  result.scene.density = result.physics.density;
  const Motion motion = result.dry                             ? Motion::dry
                        : given(deck, "transient", "end_time") ? Motion::in_time
                                                               : Motion::steady;
  result.surfaces = surface_input(deck, result.physics, result.scene.grid, motion);
  result.transient = transient_input(deck, result.physics, result.surfaces, result.scene.grid);
  if (!result.transient) let_stand(result.surfaces, result.scene);
  read_effects(result);
  if (result.scene.grid.ny > 0) {
    check_coarsenings(deck, result.scene);
    if (!result.dry && result.scene.M > 0.0) check_domain(deck, result.scene);
    check_memory(result);
  }
  if (deck.errors.empty()) refuse_idle(result);
  deck::throw_if_wrong(deck);

  result.title = deck::word(deck, "case", "title");
  if (!given(deck, "case", "title")) {
    result.title = std::filesystem::path(path).stem();
    deck::choose(deck, "case", "title", result.title, "name of the deck");
  }
  result.fields = deck::words(deck, "output", "fields");
  result.output = given(deck, "output", "file") ? deck::word(deck, "output", "file") : stem_of(path);
  return result;
}

}  // namespace ehl::program
