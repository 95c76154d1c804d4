#pragma once
// From the deck's [surface1] and [surface2] to what the surfaces carry.
#include <optional>
#include <string>
#include <vector>

#include "case/physical_input.hpp"
#include "deck/deck.hpp"
#include "steady/scene.hpp"
#include "surface/relief.hpp"

namespace ehl::program {

/// A map as it was read.
struct MapRecord {
  std::string file{};
  surface::Plane plane{};                          ///< that was taken away, in units of the file
  bool plane_taken = true;                         ///< else the mean alone
  int filled = 0;                                  ///< points that were missing
  double longest_wave = 0.0, shortest_wave = 0.0;  ///< cut-offs of the filters, in a; 0: none
  double rms_levelled = 0.0;                       ///< Sq before the filters, in a^2/R
  double rms = 0.0;                                ///< Sq of what is left before the taper, in a^2/R
  double mean = 0.0;                               ///< Sa of it: mean of the absolute heights
  double taper = 0.0;
};

struct CarriedSurface {
  std::string section{};  ///< "surface1"
  std::string shape{};    ///< as the deck calls it
  surface::Relief relief{};
  std::optional<MapRecord> map{};
};

struct SurfaceInput {
  std::optional<CarriedSurface> on_1{};
  std::optional<CarriedSurface> on_2{};
};

/// What is asked of the surfaces: in a steady film those that are not smooth must stand, in time they move as
/// [transient] says, and between dry bodies nothing moves.
enum class Motion { steady, in_time, dry };

/// Rules between keys are complained about in the deck. in: the physics and the finest grid of the case.
/// errors: core::FileError where a file that the deck names cannot be read.
SurfaceInput surface_input(deck::Deck& deck, const Physics& physics, const core::Grid& grid, Motion motion);

/// Those that there are.
std::vector<const CarriedSurface*> carried(const SurfaceInput& surfaces);

/// Gives a steady scene what its surfaces add to the gap, all of it at rest; nothing where they are smooth.
void let_stand(const SurfaceInput& surfaces, steady::Scene& scene);

/// One line for each surface: what it carries, and of a map what became of it on this grid.
std::vector<std::string> surface_lines(const SurfaceInput& surfaces, const Physics& physics, const core::Grid& grid);

/// The same for a person: "surface2     map, ...", and a line for each of its parts.
std::string surface_report(const SurfaceInput& surfaces, const Physics& physics, const core::Grid& grid);

/// Where the grid loses more of a map's variance than can be left unsaid.
std::vector<std::string> surface_warnings(const SurfaceInput& surfaces, const core::Grid& grid);

}  // namespace ehl::program
