#pragma once
// Polonsky and Keer's iteration on one grid.
#include "core/field.hpp"
#include "core/grid.hpp"
#include "mlmi/deformation.hpp"

namespace ehl::dry {

/// The iterate on one grid and its work space.
/// P >= 0 with hx hy sum P = load at all times; H = H00 + gap + K*P belongs to P after every step.
class ConjugateGradients {
 public:
  /// in: gap on the nodes; P a first guess with at least one positive value; load > 0. The references must outlive it.
  ConjugateGradients(const core::Patch& grid, const core::Field& gap, double load, mlmi::Deformation& deformation,
                     const core::Field& P);

  /// One step; then H, H00 and error() are those of the new P.
  void step();

  const core::Field& P() const { return P_; }
  /// The gap, with H00 such that its mean over the contact (P > 0) is 0.
  const core::Field& H() const { return H_; }
  double H00() const { return H00_; }
  /// max of |H| where P > 0 and of -H where P = 0; NaN where a number is not finite.
  double error() const { return error_; }
  /// hx hy times the number of nodes with P > 0.
  double area() const;

 private:
  void update_gap();
  void scale_to_load();
  double mean_over_contact(const core::Field& f) const;

  core::Patch grid_;
  const core::Field& gap_;
  double load_;
  mlmi::Deformation& deformation_;
  core::Field P_, H_, direction_, change_;
  double H00_ = 0.0, error_ = 0.0;
  double old_square_ = 1.0;  // of H over the contact, one step before
  bool conjugate_ = false;   // false: the contact grew, begin again
};

}  // namespace ehl::dry
