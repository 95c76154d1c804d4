#include "steady/keys.hpp"

#include <limits>
#include <string>

#include "deck/text.hpp"
#include "steady/scene.hpp"

namespace ehl::steady {
namespace {

using deck::Key;
using deck::Type;

std::vector<Key> domain_keys() {
  const std::string remedy = "the domain must contain the contact, a circle of radius 1";
  return {
      Key{.section = "domain",
          .name = "x_inlet",
          .default_note = "so far upstream that the film loses less than about 0.6 %",
          .range = {-1000.0, -1.0, false, true},
          .remedy = remedy,
          .meaning = "Inlet boundary in Hertz radii. Light loads need a longer inlet.",
          .example = "-4.5"},
      Key{.section = "domain",
          .name = "x_outlet",
          .default_note = "1.5, or 3 for light loads",
          .range = {1.0, 1000.0, true, false},
          .remedy = remedy,
          .meaning = "Outlet boundary in Hertz radii.",
          .source = "Venner and ten Napel 1992: -4.5 to 1.5",
          .example = "1.5"},
      Key{.section = "domain",
          .name = "y_half",
          .default_note = "half the length of the domain",
          .range = {1.0, 1000.0, true, false},
          .remedy = remedy,
          .meaning = "Half width of the domain in Hertz radii.",
          .source = "Venner and ten Napel 1992: -3 to 3",
          .example = "3"},
  };
}

std::vector<Key> grid_keys() {
  return {
      Key{.section = "grid",
          .name = "cells",
          .type = Type::integer,
          .default_note = "256, 512 or 1024, the first that resolves the film",
          .range = {16, 1048576},
          .remedy = "cells along x of the finest grid, e.g. 256",
          .meaning =
              "Cells of the finest grid along x, the coarsest grid's times a power of two; along y they follow from "
              "the domain, as nearly square as possible.",
          .example = "256"},
      Key{.section = "grid",
          .name = "coarsest",
          .type = Type::integer,
          .default_note = "chosen for the case",
          .range = {4, 4096},
          .meaning = "Cells of the coarsest grid along x.",
          .example = "32"},
      Key{.section = "grid",
          .name = "accuracy",
          .default_note = "none: the grid is given or chosen",
          .range = {1e-6, 0.5},
          .remedy = "a relative error, e.g. 0.01",
          .meaning =
              "Relative error of Hc and Hm to reach, instead of cells: the run refines the grid, up to 8192 cells, and "
              "extends the domain where x_inlet and y_half are left open, until the estimated error is below it. A "
              "domain that is given is kept and its error told, not counted.",
          .source = "modules/steady/README.md",
          .example = "0.01"},
  };
}

std::vector<Key> path_keys() {
  const ContinuationParameters defaults;
  const deck::Condition on_the_path{.name = "path", .words = {"automatic", "load"}};
  return {
      Key{.section = "multigrid",
          .name = "polish",
          .type = Type::word,
          .default_text = "rescue",
          .words = {"rescue", "always", "off"},
          .meaning = "Newton's method (Newton-Krylov) on the finest grid: where nothing else leads to a solution; "
                     "always, also after the cycles and down to rounding errors; or never.",
          .source = "modules/steady/README.md"},
      Key{.section = "continuation",
          .name = "path",
          .type = Type::word,
          .default_text = "automatic",
          .words = {"automatic", "load", "off"},
          .meaning =
              "Load continuation, from a lower load to the deck's one: where the full multigrid alone does not lead "
              "to a solution; always; or never."},
      Key{.section = "continuation",
          .name = "M_start",
          .default_note = "a hundredth of the contact's M, 20 at least",
          .range = {0.1, 1e5},
          .meaning = "First load of a continuation, as Moes load number M; L does not depend on the load.",
          .needs = on_the_path,
          .example = "20"},
      Key{.section = "continuation",
          .name = "load_start",
          .default_note = "see M_start",
          .unit = "N",
          .range = {0.0, std::numeric_limits<double>::infinity(), true, true},
          .meaning = "The same in newtons, for a contact in SI.",
          .needs = on_the_path,
          .example = "10"},
      Key{.section = "continuation",
          .name = "step",
          .default_text = deck::shortest(defaults.step),
          .range = {1.0, 10.0, true, false},
          .meaning = "Factor between the first two loads; later ones follow from the number of cycles.",
          .needs = on_the_path},
      Key{.section = "continuation",
          .name = "max_steps",
          .type = Type::integer,
          .default_text = std::to_string(defaults.max_steps),
          .range = {1, 10000},
          .meaning = "Loads to solve for at most, rejected steps included.",
          .needs = on_the_path},
  };
}

std::vector<Key> output_keys() {
  return {
      Key{.section = "output",
          .name = "file",
          .type = Type::text,
          .default_note = "name of the deck with .h5",
          .meaning = "The result file (HDF5); --output overrides it.",
          .example = "contact.h5"},
      Key{.section = "output",
          .name = "fields",
          .type = Type::words,
          .default_text = "P, H",
          .words = {"P", "H", "rho_bar", "ln_eta_bar"},
          .meaning = "The fields to keep: pressure, film, density, logarithm of the viscosity."},
  };
}

}  // namespace

std::vector<Key> keys() {
  std::vector<Key> all{Key{.section = "case",
                           .name = "title",
                           .type = Type::text,
                           .default_text = "untitled",
                           .meaning = "Title of the case, on the report and the pictures.",
                           .example = "Venner and ten Napel 1992, M = 50, L = 10",
                           .example_is_active = true}};
  for (const std::vector<Key>& more : {domain_keys(), grid_keys(), path_keys(), output_keys()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace ehl::steady
