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

/// An oil at ambient pressure, by its viscosities at 40 and 100 C.
struct AmbientOil {
  double T = 0.0;    ///< of the contact [C]
  double nu = 0.0;   ///< kinematic viscosity there [mm^2/s]
  double rho = 0.0;  ///< density there [kg/m^3]
};

/// [lubricant]; NaN where the deck is silent and no law or fluid brings the number.
struct Oil {
  static constexpr double silent = std::numeric_limits<double>::quiet_NaN();
  bool brings_eta0 = false;   ///< by name, by its law, or by kinematic viscosities
  bool brings_alpha = false;  ///< by name, by its law, or by alpha*
  std::string viscosity{};    ///< the laws as the deck calls them; empty: refused
  std::string density{};
  double eta0 = silent;            ///< [Pa s]
  double alpha = silent;           ///< of the groups [1/Pa]: as stated, or alpha* of the law
  double roelands_alpha = silent;  ///< slope of Roelands' law at ambient pressure [1/Pa]
  double p0 = silent;              ///< of Roelands [Pa]
  double z = silent;               ///< likewise
  std::optional<AmbientOil> ambient{};
  Liquid liquid{};
};

/// The deck's keys of [lubricant].
std::vector<deck::Key> keys();
/// A fluid by name chooses the keys that it stands for; kinematic viscosities choose eta0; a law that brings its own
/// viscosity at ambient pressure or its own pressure coefficient alpha* chooses eta0 and alpha; z follows from eta0,
/// and from alpha_star where that is given instead of alpha. What is missing to the laws, without influence or
/// contradictory is added to deck.errors. errors: core::FileError where a table cannot be read.
Oil read(deck::Deck& deck);

/// Those among them that belong to single laws.
std::vector<deck::Key> liquid_keys();
/// What they say; eta0 is known.
Liquid read_liquid(const deck::Part& lubricant);

/// Fluids by name.
deck::Key fluid_key();
/// The keys that the fluid stands for, chosen; nothing without one.
void choose_fluid(const deck::Part& lubricant);

/// Temperature, kinematic viscosities, alpha*.
std::vector<deck::Key> data_sheet_keys();
/// The oil at its temperature where the deck or the fluid gives kinematic viscosities; eta0 is chosen.
std::optional<AmbientOil> read_ambient(const deck::Part& lubricant);
/// What follows from alpha_star, where there is one. in, out: oil, with the rest of it.
void read_alpha_star(const deck::Part& lubricant, Oil& oil);

/// The value of a key follows from others: chosen, and a complaint where the deck gives another one. Repeated as it is,
/// as in the deck that a result keeps, it may stand.
void settle(const deck::Part& lubricant, const std::string& name, const std::string& text, const std::string& why);
/// The same for a number that holds at the temperature; a complaint about that where the number is out of its range.
/// in: what it follows from, for both.
void settle_at_temperature(const deck::Part& lubricant, const std::string& name, double value, const std::string& from);
/// Complains about each of the names that has no value at all.
void demand(const deck::Part& lubricant, const std::vector<std::string>& names, const std::string& law);

}  // namespace ehl::rheology
