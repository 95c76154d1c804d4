#pragma once
// Converts the deck's [surface1] and [surface2] to the reliefs of the surfaces.
#include <optional>
#include <string>
#include <vector>

#include "case/physical_input.hpp"
#include "core/warning.hpp"
#include "deck/deck.hpp"
#include "steady/scene.hpp"
#include "surface/relief.hpp"

namespace ehl::program {

/// How a measured map was processed.
struct MapRecord {
  std::string file{};
  surface::Plane plane{};                          ///< the plane that was removed, in units of the file
  bool plane_taken = true;                         ///< false: only the mean was removed
  int filled = 0;                                  ///< number of missing points that were filled
  double longest_wave = 0.0, shortest_wave = 0.0;  ///< cut-off wavelengths of the filters, in a; 0: none
  double rms_levelled = 0.0;                       ///< Sq after levelling, before the filters, in a^2/R
  double rms = 0.0;                                ///< Sq after the filters, before the taper, in a^2/R
  double mean = 0.0;                               ///< Sa, the mean of the absolute heights, at the same stage
  double taper = 0.0;
};

struct CarriedSurface {
  std::string section{};  ///< "surface1"
  std::string shape{};    ///< name of the shape in the deck
  surface::Relief relief{};
  std::optional<MapRecord> map{};
};

struct SurfaceInput {
  std::optional<CarriedSurface> on_1{};
  std::optional<CarriedSurface> on_2{};
};

/// The motion of the surfaces. steady: a surface that is not smooth must be at rest; in_time: surfaces move as
/// [transient] says; dry: nothing moves.
enum class Motion { steady, in_time, dry };

/// Reads both surfaces. Errors are added to the deck. in: the physics and the finest grid of the case. errors:
/// core::FileError if a file that the deck names cannot be read.
SurfaceInput surface_input(deck::Deck& deck, const Physics& physics, const core::Grid& grid, Motion motion);

/// The surfaces that are not smooth.
std::vector<const CarriedSurface*> carried(const SurfaceInput& surfaces);

/// Adds the gap of both reliefs, at rest, to a steady scene; does nothing if the surfaces are smooth.
void let_stand(const SurfaceInput& surfaces, steady::Scene& scene);

/// One line per surface: its relief and, for a map, its processing and its resolution on this grid.
std::vector<std::string> surface_lines(const SurfaceInput& surfaces, const Physics& physics, const core::Grid& grid);

/// The lines as a printed report: "surface2     map, ...", with one line for each part.
std::string surface_report(const SurfaceInput& surfaces, const Physics& physics, const core::Grid& grid);

/// Warnings about maps of which the grid resolves too little.
core::Warnings surface_warnings(const SurfaceInput& surfaces, const core::Grid& grid);

}  // namespace ehl::program
