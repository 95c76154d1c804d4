#pragma once
// The stress field below a contact, from its pressure.
#include <functional>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "effects/subsurface/patch.hpp"

namespace ehl::subsurface {

/// Everything that can be asked for: the two equivalent stresses, and the components.
enum Quantity { sigma_mises, tau_max, sigma_x, sigma_y, sigma_z, tau_xy, tau_xz, tau_yz };
inline constexpr int quantities = 8;
/// Name in the deck and in the result.
const char* name(Quantity quantity);
/// What it is, for the result.
const char* meaning(Quantity quantity);

struct Parameters {
  double depth = 2.0;     ///< of the lowest plane [a]
  int planes = 41;        ///< surface and lowest included
  int most_cells = 128;   ///< along x
  double nu = 0.3;        ///< Poisson's ratio of the body
  double friction = 0.0;  ///< shear traction on the body's surface along +x, over the pressure; NaN: to be computed
  std::vector<Quantity> kept = {sigma_mises, tau_max};
};

/// The largest value of all nodes and planes, and of a parabola through the neighbours along each axis; within two
/// cells of the surface that of the nodes.
struct Maximum {
  double value = 0.0;  ///< [p_h]
  double X = 0.0;      ///< [a]
  double Y = 0.0;
  double Z = 0.0;
  double on_node = 0.0;  ///< largest value of the nodes
};

/// A quantity in space: one field per plane.
struct Volume {
  Quantity quantity;
  std::vector<core::Field> planes;
};

/// Lengths in a, stresses in p_h; tension positive. The body lies at z >= 0, below the surface z = 0.
struct StressField {
  Parameters parameters;
  core::Grid grid;                   ///< of every plane
  std::vector<double> depths;        ///< of the planes, from 0 on
  std::vector<Volume> kept;          ///< what the parameters ask for
  double section_Y = 0.0;            ///< where the section lies: Y = 0 or the line next to it
  std::vector<core::Field> section;  ///< every quantity along x (first index) and depth (second)
  Maximum mises, shear;
  std::vector<std::string> warnings;
  double seconds = 0.0;
};

/// Depths of the planes, 0 = z_0 < .. < z_{n-1} = depth, z_k = depth (k/(n-1))^1.5: closer to each other at the
/// surface.
std::vector<double> depths_of(const Parameters& parameters);

/// The grid of the stresses: the contact's, halved until it has at most parameters.most_cells cells along x, as long as
/// both numbers of cells are even.
core::Grid stress_grid(const core::Patch& contact, const Parameters& parameters);

/// Bytes that stress_below() takes, nearly.
double expected_bytes(const core::Grid& contact, const Parameters& parameters, int threads);
/// Its seconds on one thread of a machine of the 2020s, nearly.
double expected_seconds(const core::Grid& contact, const Parameters& parameters);

/// Told after every plane how many are done, by one thread at a time. Returns false when the user asked to stop.
using Observer = std::function<bool(int planes_done)>;

/// The stresses below P. in: P on the nodes of all of a domain; threads >= 1.
/// Of a line contact those of plane strain, directly (strip.hpp), else by transforms (plane_sum.hpp).
/// A coarser stress grid takes P by full weighting, which keeps the load. Each cell carries its node's pressure.
/// order: 2 in the mesh size for z > 0 (patch.hpp, README.md); cost: 12 transforms of four times the nodes per plane.
/// Same bits for any number of threads. errors: core::Interrupted.
StressField stress_below(const core::Grid& grid, const core::Field& P, const Parameters& parameters, int threads,
                         const Observer& observe = {});

}  // namespace ehl::subsurface
