#include "steady/keys.hpp"

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
          .default_text = "1.5",
          .range = {1.0, 1000.0, true, false},
          .remedy = remedy,
          .meaning = "Outlet boundary in Hertz radii.",
          .source = "Venner and ten Napel 1992: -4.5 to 1.5"},
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
          .default_text = "256",
          .range = {16, 1048576},
          .remedy = "cells along x of the finest grid, e.g. 256",
          .meaning =
              "Cells of the finest grid along x, the coarsest grid's times a power of two; along y they follow from "
              "the domain, as nearly square as possible."},
      Key{.section = "grid",
          .name = "coarsest",
          .type = Type::integer,
          .default_note = "chosen for the case",
          .range = {4, 4096},
          .meaning = "Cells of the coarsest grid along x.",
          .example = "32"},
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
  for (const std::vector<Key>& more : {domain_keys(), grid_keys(), output_keys()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace ehl::steady
