#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "rheology/laws.hpp"

namespace ehl::rheology {

/// The laws for P = p in pascals; none: a simple law (isoviscous, barus, roelands; incompressible, dowson-higginson).
struct Liquid {
  std::optional<ViscosityLaw> viscosity{};
  std::optional<DensityLaw> density{};
  double table_end = std::numeric_limits<double>::quiet_NaN();  ///< highest pressure of the table [Pa]
};

/// [lubricant]; NaN where the deck is silent and no law or fluid brings the number.
struct Oil {
  static constexpr double silent = std::numeric_limits<double>::quiet_NaN();
  bool by_name = false;     ///< it brings everything
  std::string viscosity{};  ///< the laws as the deck calls them; empty: refused
  std::string density{};
  double eta0 = silent;   ///< [Pa s]
  double alpha = silent;  ///< [1/Pa]
  double p0 = silent;     ///< of Roelands [Pa]
  double z = silent;      ///< likewise
  Liquid liquid{};

  /// The viscosity law brings its own viscosity at ambient pressure; its own pressure coefficient.
  bool brings_eta0() const { return viscosity == "yasutomi" || viscosity == "table"; }
  bool brings_alpha() const { return brings_eta0() || viscosity == "doolittle"; }
};

/// The deck's keys of [lubricant].
std::vector<deck::Key> keys();
/// A fluid by name chooses the keys that it stands for; a law that brings its own viscosity at ambient pressure or its
/// own pressure coefficient alpha* chooses eta0 and alpha; z follows from eta0. What is missing to the laws, without
/// influence or contradictory is added to deck.errors. errors: core::FileError where a table cannot be read.
Oil read(deck::Deck& deck);

/// Those among them that belong to single laws and to fluids by name.
std::vector<deck::Key> liquid_keys();
Liquid read_liquid(deck::Deck& deck);

}  // namespace ehl::rheology
