#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "deck/deck.hpp"
#include "rheology/laws.hpp"

namespace ehl::rheology {

/// Laws for P = p in pascals; empty for the simple laws (isoviscous, barus, roelands; incompressible,
/// dowson-higginson).
struct Liquid {
  std::optional<ViscosityLaw> viscosity{};
  std::optional<DensityLaw> density{};
  double table_end = core::unknown;  ///< highest pressure of the table [Pa]
};

/// An oil at ambient pressure, from its viscosities at 40 and 100 C.
struct AmbientOil {
  double T = 0.0;    ///< temperature of the contact [C]
  double nu = 0.0;   ///< kinematic viscosity at T [mm^2/s]
  double rho = 0.0;  ///< density at T [kg/m^3]
};

/// [lubricant]; NaN if neither the deck nor a law or fluid gives the value.
struct Oil {
  bool brings_eta0 = false;   ///< eta0 follows from the fluid, the law, or kinematic viscosities
  bool brings_alpha = false;  ///< alpha follows from the fluid, the law, or alpha*
  std::string viscosity{};    ///< name of the law as in the deck; empty: refused
  std::string density{};
  double eta0 = core::unknown;            ///< [Pa s]
  double alpha = core::unknown;           ///< alpha of the dimensionless groups [1/Pa]: as given, or alpha* of the law
  double roelands_alpha = core::unknown;  ///< slope of Roelands' law at ambient pressure [1/Pa]
  double p0 = core::unknown;              ///< of Roelands' law [Pa]
  double z = core::unknown;               ///< of Roelands' law
  std::optional<AmbientOil> ambient{};
  Liquid liquid{};
};

/// Keys of [lubricant].
std::vector<deck::Key> keys();
/// Derived values: a named fluid sets its keys; kinematic viscosities give eta0; a law with its own ambient viscosity
/// or its own alpha* gives eta0 and alpha; z follows from eta0, and from alpha_star if that replaces alpha. Keys that
/// are missing, without effect or contradictory are added to deck.errors. errors: core::FileError if a table cannot be
/// read.
Oil read(deck::Deck& deck);

/// Keys that belong to single laws.
std::vector<deck::Key> liquid_keys();
/// Reads these keys. in: eta0 is known.
Liquid read_liquid(const deck::Part& lubricant);

/// Key of the named fluids.
deck::Key fluid_key();
/// Sets the keys of the named fluid; does nothing without one.
void choose_fluid(const deck::Part& lubricant);

/// Keys for temperature, kinematic viscosities and alpha*.
std::vector<deck::Key> data_sheet_keys();
/// The oil at its temperature, if the deck or the fluid gives kinematic viscosities; sets eta0.
std::optional<AmbientOil> read_ambient(const deck::Part& lubricant);
/// Sets what follows from alpha_star, if given. in, out: oil, with all other values set.
void read_alpha_star(const deck::Part& lubricant, Oil& oil);

/// Sets a key whose value follows from others, and reports a different value in the deck. The same value may be
/// repeated, as in the deck that a result stores.
void settle(const deck::Part& lubricant, const std::string& name, const std::string& text, const std::string& why);
/// Sets a number that follows from others at the temperature, and reports it if it is out of range. in: from, what it
/// follows from, for both messages.
void settle_at_temperature(const deck::Part& lubricant, const std::string& name, double value, const std::string& from);
/// Reports each of the names that has no value.
void demand(const deck::Part& lubricant, const std::vector<std::string>& names, const std::string& law);

}  // namespace ehl::rheology
