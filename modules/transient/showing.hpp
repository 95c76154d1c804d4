#pragma once
// Hands the rows and frames of a run to its observer, and counts them.
#include "transient/march.hpp"
#include "transient/periodic.hpp"
#include "transient/rest.hpp"
#include "transient/snapshot.hpp"

namespace ehl::transient {

/// A run as its observer sees it: all fields in the fixed coordinates. It refers to its arguments.
class Showing {
 public:
  /// in: of_unit, the shift of H00 per load by the unit of length in the logarithm of a line contact.
  Showing(const multigrid::Hierarchy& hierarchy, const ContactDae& dae, const Conditions& conditions,
          const MarchParameters& parameters, const Observer& observer, double of_unit);

  /// Hands out the row of a step whose state the level holds. returns false if the observer wants to stop.
  bool show(const StepReport& step);
  /// Hands out the present fields.
  void show_frame(double T);

  bool at_rest() const { return at_rest_; }
  bool periodic() const { return periodic_; }

  MarchReport report{};
  int frames = 0;
  double last_frame = -1.0;

 private:
  Snapshot snapshot(double T);
  const core::Field& fixed(const core::Field& field, core::Field& mirrored) const;

  const multigrid::Hierarchy& hierarchy_;
  const ContactDae& dae_;
  const Conditions& conditions_;
  const MarchParameters& parameters_;
  const Observer& observer_;
  double of_unit_;
  Rest rest_;
  Periodic period_;
  bool at_rest_ = false, periodic_ = false;
  core::Field P_mirrored_{}, H_mirrored_{};  ///< while the flow is reversed
};

}  // namespace ehl::transient
