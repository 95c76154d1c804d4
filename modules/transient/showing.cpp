#include "transient/showing.hpp"

#include <algorithm>

#include "core/norms.hpp"
#include "transient/nodes.hpp"

namespace ehl::transient {

Showing::Showing(const multigrid::Hierarchy& hierarchy, const ContactDae& dae, const Conditions& conditions,
                 const MarchParameters& parameters, const Observer& observer, double of_unit)
    : hierarchy_(hierarchy),
      dae_(dae),
      conditions_(conditions),
      parameters_(parameters),
      observer_(observer),
      of_unit_(of_unit),
      rest_(parameters.stop_steady),
      period_(parameters.period) {}

const core::Field& Showing::fixed(const core::Field& field, core::Field& mirrored) const {
  if (!dae_.reversed()) return field;
  const core::Patch& grid = hierarchy_.levels.back().grid;
  mirrored = field;
  mirror_in_X(grid, mirrored);
  core::fill_ghosts(grid, mirrored);
  return mirrored;
}

Snapshot Showing::snapshot(double T) {
  const multigrid::Level& level = hierarchy_.levels.back();
  return snapshot_of(hierarchy_, dae_, conditions_, T, fixed(level.P, P_mirrored_), fixed(level.H, H_mirrored_));
}

bool Showing::show(const StepReport& step) {
  StepRow row = row_of(hierarchy_, dae_, conditions_, step);
  row.H00 += row.carried * of_unit_;
  const Snapshot now = snapshot(step.T);
  row.probed = probed_at(now.grid, now.P, now.H, parameters_.probes);
  if (observer_.measure) row.measured = observer_.measure(now);
  report.worst_load_error = std::max(report.worst_load_error, row.load_error);
  report.worst_oil_error = std::max(report.worst_oil_error, row.oil.from_nowhere);
  at_rest_ = rest_.reached(row);
  if (period_.add(row)) periodic_ = period_.change() <= parameters_.stop_periodic;
  report.periods = period_.periods();
  report.change_of_period = period_.change();
  return !observer_.row || observer_.row(row);
}

void Showing::show_frame(double T) {
  ++frames;
  last_frame = T;
  if (!observer_.frame) return;
  const Snapshot now = snapshot(T);
  observer_.frame({T, core::on_domain(now.grid, now.P), core::on_domain(now.grid, now.H), dae_.theta(),
                   observer_.measure_fields ? observer_.measure_fields(now) : std::vector<core::Field>{}});
}

}  // namespace ehl::transient
