#pragma once
// The elastic deformation w = K*P: three evaluators behind one interface.
#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "kernel/kernel.hpp"

namespace ehl::mlmi {

enum class Method { mlmi, fft, direct };

/// How to evaluate the deformation. Zero or negative numbers mean a choice by the program for the grid.
struct Parameters {
  Method method = Method::mlmi;
  int order = 0;                 ///< transfer order 2p = 4, 6 or 8
  int patch_along = 0;           ///< correction patch radius m1 along the coarsening direction [fine points]
  int patch_across = 0;          ///< correction patch radius m2 across it [fine points]
  int coarsenings = -1;          ///< number of semi-coarsenings before the coarsest sum
  bool coarsest_direct = false;  ///< coarsest sum directly instead of by FFT
  double line_unit = 1.0;        ///< line contacts: distance at which K is zero [a]
};

/// Largest number of semi-coarsenings that a grid allows: each coarsened direction keeps at least 8 cells.
int most_coarsenings(const core::Grid& grid);
/// The parameters for a coarser grid than the one they are meant for, with no more coarsenings than it allows.
Parameters fitting(Parameters parameters, const core::Patch& coarser);

/// Evaluates w_ij = factor sum_kl K_ijkl P_kl on one grid, K and the factor of a kernel::Kernel. Owns the tables, plans
/// and work space; not copyable; serves one caller at a time.
///
/// Grids have any size from 1 x 1 cells on, odd numbers too; hx != hy is allowed. With an axis of symmetry the sum
/// includes the images at half of the cost, or goes over the whole domain if the numbers of cells do not allow that. In
/// a line contact all coarsenings go along X, and all stored lines get the sum. The result
/// has the same bits for any number of threads; grids below 256 cells per direction use one.
class Deformation {
 public:
  /// in: a kernel of a half-plane for line contacts, else of a half-space. errors: core::InputError when the parameters
  /// do not fit the grid.
  Deformation(const core::Patch& grid, const Parameters& parameters, int threads,
              const kernel::Kernel& kernel = kernel::half_space());
  ~Deformation();
  Deformation(Deformation&&) noexcept;
  Deformation& operator=(Deformation&&) noexcept;

  /// w = factor K*P. in: P on the nodes of the grid; boundary values take part in the sum. out: w on all nodes.
  /// Allocates nothing. limits: P and w are different fields of this grid; their padding is neither used nor kept.
  void evaluate(const core::Field& P, core::Field& w);

  /// w = factor K*P in a line contact, with the nodes as contiguous arrays. limits: P and w are different arrays.
  void evaluate_along(std::span<const double> P, std::span<double> w);

  /// The method and its parameters, for the report: "mlmi, order 6, patch 9x3, 2 coarsenings, FFT on 129x129".
  std::string description() const;
  std::size_t bytes() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ehl::mlmi
