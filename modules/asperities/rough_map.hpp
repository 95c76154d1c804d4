#pragma once
// Asperity pressure and flow factors of a measured map.
#include <functional>
#include <string>
#include <vector>

#include "asperities/rough_contact.hpp"
#include "asperities/roughness_numbers.hpp"
#include "core/constants.hpp"
#include "surface/height_map.hpp"

namespace ehl::asperities {

/// How the map is computed.
struct MapParameters {
  double E_prime = 0.0;       ///< [Pa]
  double hardness = 0.0;      ///< [Pa]; infinity: elastic
  int rows = 13;              ///< number of mean pressures
  int most_points = 512;      ///< along each axis; a map with more is averaged over blocks of points
  double tolerance = 1e-5;    ///< of the contact, see solve()
  int max_iterations = 1000;  ///< of the contact
  bool error = true;          ///< also with half of the points along each axis
  int threads = 1;
};

/// One row of the table.
struct MapRow {
  double gap = 0.0;       ///< distance of the mean planes of the deformed surfaces [m]
  double film = 0.0;      ///< mean open gap [m]
  double pressure = 0.0;  ///< mean pressure [Pa]; 0: the surfaces do not touch
  double area = 0.0;      ///< share in contact
  double phi_x = 0.0, phi_y = 0.0;
  double largest_pressure = 0.0;  ///< [Pa]
  double yielded = 0.0;           ///< share of the area at the hardness
  /// Differences from the same mean pressure on half of the points; NaN: not computed.
  double error_gap = core::unknown, error_phi_x = core::unknown, error_phi_y = core::unknown;
  /// Beside: the pressure of Greenwood and Williamson for the map's spectral moments [Pa], and the factors of Patir and
  /// Cheng for its gamma; NaN where they do not apply.
  double pressure_gw = 0.0, phi_x_pc = 0.0, phi_y_pc = 0.0;
  int iterations = 0;  ///< of the contact
  bool converged = true;
};

/// A column of the table, as it is written and read: a name, the SI unit of the values, and its value in a row.
struct MapColumn {
  const char* name;
  const char* unit;
  double (*of)(const MapRow& row);
};
const std::vector<MapColumn>& map_columns();

struct MapResult {
  Cell cell{};          ///< of the computation
  int block = 1;        ///< points of the map along each axis that one point of the cell averages
  double Sq_map = 0.0;  ///< before averaging [m]
  RoughnessNumbers roughness{};
  std::vector<MapRow> rows{};  ///< increasing gap
};

/// Receives the share of the work that is done and the present step. Returns false to stop: core::Interrupted.
using MapObserver = std::function<bool(double share, const std::string& step)>;

/// Mirrors the map at its edges, which makes it periodic without a jump and keeps its heights, presses it on a smooth
/// plane at mean pressures from 3e-4 to 0.5 times (E'/2) slope, and lets oil flow through the gaps along both axes;
/// then also through three wider gaps without contact. Pressures of 0.9 times the hardness and more are left out.
/// in: heights, positive outwards, levelled, at least 8 x 8 [m]; distances of the points [m].
/// limits: a lay at an angle to the axes becomes, mirrored, a lay at both angles.
/// errors: core::Interrupted.
MapResult compute(const surface::Heights& heights, double dx, double dy, const MapParameters& parameters,
                  const MapObserver& observe = {});

}  // namespace ehl::asperities
