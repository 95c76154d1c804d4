#pragma once
// The oil of the deck beyond the simple laws: fluids by name, laws of liquids, tables.
#include <limits>
#include <optional>

#include "deck/deck.hpp"
#include "rheology/laws.hpp"

namespace ehl::program {

/// The laws for P = p in pascals; none: a simple law (isoviscous, barus, roelands; incompressible, dowson-higginson).
struct Liquid {
  std::optional<rheology::ViscosityLaw> viscosity{};
  std::optional<rheology::DensityLaw> density{};
  double table_end = std::numeric_limits<double>::quiet_NaN();  ///< highest pressure of the table [Pa]
};

/// What [lubricant] says beyond the simple laws. A fluid by name chooses the keys that it stands for; a law that brings
/// its own viscosity at ambient pressure or its own pressure coefficient alpha* chooses eta0 and alpha. What is
/// missing, without influence or contradictory is added to deck.errors.
Liquid liquid_input(deck::Deck& deck);

/// True where the deck's viscosity law brings its own pressure coefficient: doolittle, yasutomi, table.
bool brings_alpha(const deck::Deck& deck);
/// True where it brings its own viscosity at ambient pressure: yasutomi, table.
bool brings_eta0(const deck::Deck& deck);

/// Roelands' z as given, else from eta0 and recorded in the deck. in: alpha [1/Pa], p0 [Pa].
double roelands_z(deck::Deck& deck, double alpha, double p0);

/// Complains about a table that ends below the Hertz pressure [Pa].
void check_reach(deck::Deck& deck, const Liquid& liquid, double p_h);

}  // namespace ehl::program
