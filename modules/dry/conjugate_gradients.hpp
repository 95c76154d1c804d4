#pragma once
// Conjugate gradient iteration of Polonsky and Keer on one grid.
#include "core/field.hpp"
#include "core/grid.hpp"
#include "mlmi/deformation.hpp"

namespace ehl::dry {

/// The iterate on one grid and its work space. After every step P >= 0, hx hy sum P = load, and H = H00 + gap + K*P.
class ConjugateGradients {
 public:
  /// in: gap at the nodes; P: initial guess with at least one positive value; load > 0. The references must outlive the
  /// object.
  ConjugateGradients(const core::Patch& grid, const core::Field& gap, double load, mlmi::Deformation& deformation,
                     const core::Field& P);

  /// One step; H, H00 and error() then belong to the new P.
  void step();

  const core::Field& P() const { return P_; }
  /// The gap; H00 is such that its mean over the contact (P > 0) is 0.
  const core::Field& H() const { return H_; }
  double H00() const { return H00_; }
  /// Largest |H| where P > 0 and largest -H where P = 0; NaN if any number is not finite.
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
  double old_square_ = 1.0;  // sum of H^2 over the contact, in the previous step
  bool conjugate_ = false;   // false: the contact has grown, so the next direction is the gradient
};

}  // namespace ehl::dry
