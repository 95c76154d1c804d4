#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "deck/deck.hpp"
#include "transient/march.hpp"

namespace ehl::transient {

/// What lengths, forces and times of a deck in SI are divided by; NaN where the contact is not in SI.
struct Scales {
  static constexpr double unset = std::numeric_limits<double>::quiet_NaN();
  bool in_SI = false;         ///< the deck speaks SI, rightly or wrongly
  double a = unset;           ///< Hertz radius [m]
  double height = unset;      ///< a^2/R [m]
  double time = unset;        ///< a/u_m [s]
  double load = unset;        ///< [N]
  double radius = unset;      ///< R [m]
  double u1 = 1.0, u2 = 1.0;  ///< speeds of [motion] over u_m
};

/// What a deck says of a contact in time.
struct Input {
  Conditions conditions{};
  MarchParameters parameters{};
  double seconds_between_checkpoints = 60.0;  ///< of the clock on the wall
  double second = 0.0;                        ///< in a/u_m; NaN where the contact is not in SI
  bool in_seconds = false;                    ///< the deck's own unit of time; else a/u_m
};

/// The keys of [transient], those of [output] for a run in time, and those of [body].
std::vector<deck::Key> keys();
/// in: what the surfaces carry, in the conditions; the finest grid. errors: core::FileError where a .csv that the deck
/// names cannot be read.
Input read(deck::Deck& deck, const Scales& scales, const Conditions& carried, const core::Grid& grid);

/// The steepest slope of such a deck's load, in a/u_m; NaN where it cannot be read, which read() tells.
double steepest_load(const deck::Deck& deck, const Scales& scales);

/// Those of what varies. in: unit of time, in a/u_m.
std::vector<deck::Key> drive_keys();
void read_drive(const deck::Part& transient, double unit, const Scales& scales, Conditions& conditions);
/// Complains about a load or a speed that no march can follow.
void check_drive(const deck::Part& transient, const Conditions& conditions, double end);

/// Those of [body]; nothing where the load is imposed.
std::vector<deck::Key> body_keys();
std::optional<Body> read_body(deck::Deck& deck, const Scales& scales);

}  // namespace ehl::transient
