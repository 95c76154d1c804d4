#pragma once
// Stress field below a contact, from its pressure.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "core/warning.hpp"
#include "effects/subsurface/patch.hpp"
#include "effects/subsurface/plane_kernel.hpp"
#include "effects/subsurface/strip.hpp"

namespace ehl::subsurface {

/// All quantities a deck can ask for: two equivalent stresses and the components.
enum Quantity { sigma_mises, tau_max, sigma_x, sigma_y, sigma_z, tau_xy, tau_xz, tau_yz };
inline constexpr int quantities = 8;
/// Name in the deck and in the result.
const char* name(Quantity quantity);
/// Description in the result.
const char* meaning(Quantity quantity);

/// What is computed: planes, resolution, material and traction.
struct Parameters {
  double depth = 2.0;     ///< of the lowest plane [a]
  int planes = 41;        ///< including the surface and the lowest plane
  int most_cells = 128;   ///< along x
  double nu = 0.3;        ///< Poisson's ratio of the body
  double friction = 0.0;  ///< shear traction on the surface along +x over the pressure; NaN: take the computed friction
  std::vector<Quantity> kept = {sigma_mises, tau_max};
};

/// Largest value, by a parabola through the largest node and its neighbours along each axis. Within two cells of the
/// surface it is the nodal value.
struct Maximum {
  double value = 0.0;  ///< [p_h]
  double X = 0.0;      ///< [a]
  double Y = 0.0;
  double Z = 0.0;
  double on_node = 0.0;  ///< largest nodal value
};

/// A quantity on all planes, one field per plane.
struct Volume {
  Quantity quantity;
  std::vector<core::Field> planes;
};

/// Lengths in a, stresses in p_h; tension positive. The body occupies z >= 0.
struct StressField {
  Parameters parameters;
  core::Grid grid;                   ///< of every plane
  std::vector<double> depths;        ///< of the planes, beginning with 0
  std::vector<Volume> kept;          ///< quantities that the parameters ask for
  double section_Y = 0.0;            ///< Y of the section: 0 or the nearest line
  std::vector<core::Field> section;  ///< every quantity over x (first index) and depth (second)
  Maximum mises, shear;
  core::Warnings warnings;
  double seconds = 0.0;
};

/// Depths of the planes, 0 = z_0 < .. < z_{n-1} = depth, z_k = depth (k/(n-1))^1.5: denser near the surface.
std::vector<double> depths_of(const Parameters& parameters);

/// Grid of the stresses: that of the contact, coarsened until it has at most parameters.most_cells cells along x, as
/// long as both numbers of cells are even.
core::Grid stress_grid(const core::Patch& contact, const Parameters& parameters);

/// Approximate memory of stress_below() in bytes.
double expected_bytes(const core::Grid& contact, const Parameters& parameters, int threads);
/// Approximate time of stress_below() in seconds, on one thread.
double expected_seconds(const core::Grid& contact, const Parameters& parameters);

/// Called after each plane with the number of finished planes, by one thread at a time. Returns false if the user asked
/// to stop.
using Observer = std::function<bool(int planes_done)>;

/// The kernels of all planes, kept between calls of stress_below() on the same grid with the same depths and Poisson's
/// ratio. A plane's kernel is made when it is first needed.
struct Kernels {
  std::vector<std::optional<PlaneKernel>> planes;
  std::vector<std::optional<StripKernel>> strips;
};
/// Memory of the kernels in bytes, when all are made.
double bytes_of_kernels(const core::Grid& contact, const Parameters& parameters);

/// Stresses below P. in: P on the nodes of the whole domain; threads >= 1. Line contacts: plane strain by direct sums
/// (strip.hpp); else Fourier transforms (plane_sum.hpp). A coarser stress grid takes P by full weighting, which
/// conserves the load. Each cell carries its node's pressure.
/// kernels: if given, the kernels are kept there, those of a shear traction too, and later calls do not make them
/// again. order: 2 in the mesh size for z > 0 (patch.hpp, README.md). cost per plane: 6 transforms of four times the
/// nodes, and 6 more to make the kernel of each load. The result does not depend on the number of threads, nor on
/// whether kernels are kept. errors: core::Interrupted.
StressField stress_below(const core::Grid& grid, const core::Field& P, const Parameters& parameters, int threads,
                         const Observer& observe = {}, Kernels* kernels = nullptr);

}  // namespace ehl::subsurface
