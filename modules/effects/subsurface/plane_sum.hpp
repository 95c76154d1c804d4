#pragma once
// Stress in a plane of constant depth: the sum of the contributions of all surface cells, by zero-padded Fourier
// transforms, exact to rounding.
#include <array>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "effects/subsurface/patch.hpp"
#include "effects/subsurface/plane_kernel.hpp"
#include "mlmi/buffer.hpp"
#include "mlmi/fourier_transform.hpp"

namespace ehl::subsurface {

using StressFields = std::array<core::Field, components>;

/// Elastic body and its surface traction.
struct Body {
  double nu = 0.3;        ///< Poisson's ratio
  double friction = 0.0;  ///< shear traction along +x over pressure
};

/// s_k(X_i, Y_j, z) = sum over the cells of P times the stress below a cell, for one P and any number of depths. Each
/// node has a cell of hx by hy around it that carries the node's pressure, on the boundary too.
/// cost: six transforms of four times the nodes per plane: O(N ln N).
class PlaneSum {
 public:
  /// in: P on the nodes of the grid. The constructor transforms P.
  PlaneSum(const core::Grid& grid, const core::Field& P);

  /// Buffers of one caller.
  class Work {
   public:
    explicit Work(const PlaneSum& sum);

   private:
    friend class PlaneSum;
    mlmi::RealTransform row_;
    mlmi::ColumnTransform column_;
    mlmi::Buffer half_, real_, block_, transformed_;
  };
  /// in: the kernel of the plane, of the same grid; friction: shear traction along +x over pressure, 0 if the kernel
  /// has no shear. out: the six components. Concurrent calls are allowed, each with its own work space and output.
  void evaluate(const PlaneKernel& kernel, double friction, Work& work, StressFields& stress) const;

 private:
  void multiply(const PlaneKernel& kernel, double friction, std::size_t component, int block, double* product) const;

  core::Grid grid_;
  Padding padding_;
  mlmi::Buffer spectrum_;  // spectrum of P, divided by the number of points
};

/// Reference for tests: the sum at one point, cell by cell. in: any X, Y; z > 0, or z = 0 at a node.
Stress stress_at(const core::Grid& grid, const core::Field& P, const Body& body, double X, double Y, double z);

}  // namespace ehl::subsurface
