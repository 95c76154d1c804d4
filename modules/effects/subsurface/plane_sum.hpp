#pragma once
// Stress in a plane of constant depth: the sum of the contributions of all surface cells, by zero-padded Fourier
// transforms, exact to rounding.
#include <array>
#include <cstddef>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "effects/subsurface/patch.hpp"
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
/// cost: per plane six kernels and six sums, each a transform of four times the nodes: O(N ln N).
class PlaneSum {
 public:
  /// in: P on the nodes of the grid. The constructor transforms P.
  PlaneSum(const core::Grid& grid, const core::Field& P, const Body& body);

  /// Buffers of one caller.
  class Work {
   public:
    explicit Work(const PlaneSum& sum);

   private:
    friend class PlaneSum;
    mlmi::RealTransform row_;
    mlmi::ColumnTransform column_;
    mlmi::Buffer half_, real_, block_, transformed_;
    // Corners of two neighbouring columns of cells; then one offset per node: [component][d_x][d_y].
    std::vector<Stress> corners_[2][2];
    std::array<std::vector<double>, components> normal_, shear_;
  };
  /// out: the six components at depth z >= 0. Concurrent calls are allowed, each with its own work space and output.
  void evaluate(double z, Work& work, StressFields& stress) const;

 private:
  void fill_kernels(double z, Work& work) const;
  void transform_kernel(int component, Work& work) const;
  void row_of_kernel(int component, int d_x, bool left, Work& work) const;
  void sum(Work& work, core::Field& out) const;

  core::Grid grid_;
  Body body_;
  int length_x_, length_y_;  // padded numbers of nodes
  int blocks_;               // number of blocks of ColumnTransform::columns complex columns
  std::ptrdiff_t stride_;    // doubles per row of the spectra
  mlmi::Buffer spectrum_;    // spectrum of P, divided by the number of points
};

/// Reference for tests: the sum at one point, cell by cell. in: any X, Y; z > 0, or z = 0 at a node.
Stress stress_at(const core::Grid& grid, const core::Field& P, const Body& body, double X, double Y, double z);

}  // namespace ehl::subsurface
