#pragma once
#include <optional>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "deck/text_table.hpp"
#include "transient/march.hpp"

namespace ehl::transient {

/// Units by which lengths, forces and times of a deck in SI are divided; NaN if the contact is not given in SI.
struct Scales {
  bool in_SI = false;             ///< the deck uses SI keys, whether or not the contact can be converted
  double a = core::unknown;       ///< Hertz radius [m]
  double height = core::unknown;  ///< a^2/R [m]
  double time = core::unknown;    ///< a/u_m [s]
  double load = core::unknown;    ///< [N]
  double radius = core::unknown;  ///< R [m]
  double u1 = 1.0, u2 = 1.0;      ///< speeds of [motion] over u_m
};

/// What is computed of a cycle: the run in time, the steady states of its single times, or both.
enum class Mode { in_time, quasi_steady, both };

/// What a deck says about a contact in time.
struct Input {
  Conditions conditions{};
  MarchParameters parameters{};
  double seconds_between_checkpoints = 60.0;  ///< wall-clock time
  double second = 0.0;                        ///< one second in a/u_m; NaN if the contact is not in SI
  bool in_seconds = false;                    ///< unit of time of the deck is the second; else a/u_m
  Mode mode = Mode::in_time;
  bool error_bars = false;       ///< from two more runs
  std::vector<double> states{};  ///< times of the quasi-steady states, if the mode has any
};

/// The keys of [transient], those of [output] for a run in time, and those of [body].
std::vector<deck::Key> keys();
/// Reads all of them. in: carried, the conditions with the reliefs of the surfaces; the finest grid; of_machine, the
/// table in SI that cycle = machine stands for, or nullptr. errors: core::FileError if a .csv file named by the deck
/// cannot be read.
Input read(deck::Deck& deck, const Scales& scales, const Conditions& carried, const core::Grid& grid,
           const deck::ColumnTable* of_machine = nullptr);

/// What the drive of a deck means for the far field.
struct FarDemands {
  double steepest_load = 0.0;  ///< slope of the load, per a/u_m; NaN if it cannot be read, which read() reports
  std::string why_zero{};      ///< why a closed far field is not available; empty: it is
};
FarDemands far_demands(const deck::Deck& deck, const Scales& scales, const deck::ColumnTable* of_machine = nullptr);

/// Keys of a cycle, which are read by read_cycle().
std::vector<deck::Key> cycle_keys();
/// What a table of a cycle prescribes, with times in a/u_m. An empty schedule: the table lacks that column.
struct Cycle {
  Schedule radius{}, load{}, u1{}, u2{};
  double period = core::unknown;  ///< NaN: the cycle is run through once
  std::vector<double> times{};    ///< of its rows
};
/// Reads the table; nullopt if the deck names none. in: unit of time in a/u_m. Errors are added to the deck.
std::optional<Cycle> read_cycle(const deck::Part& transient, double unit, const Scales& scales,
                                const deck::ColumnTable* of_machine);

/// Keys of the schedules. in: unit of time in a/u_m.
std::vector<deck::Key> drive_keys();
/// Reads the schedules and the cycle into `conditions`. in: unit of time in a/u_m. out: the cycle. Errors are added to
/// the deck.
std::optional<Cycle> read_drive(const deck::Part& transient, double unit, const Scales& scales,
                                const deck::ColumnTable* of_machine, Conditions& conditions);
/// Reports a load or speed that no time integration can follow. in: unit of time of the deck in a/u_m; end of the run;
/// the finest grid.
void check_drive(const deck::Part& transient, double unit, const Conditions& conditions, double end,
                 const core::Grid& grid);

/// The time at which (u1 + u2)/2 turns negative; infinite: it does not until the end.
double reversal(const Conditions& conditions, double end);

/// Keys of [body]; nullopt if the load is imposed.
std::vector<deck::Key> body_keys();
/// Reads [body]. returns nullopt if the deck gives no mass; errors are added to the deck.
std::optional<Body> read_body(deck::Deck& deck, const Scales& scales);

}  // namespace ehl::transient
