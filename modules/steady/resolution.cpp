#include "steady/resolution.hpp"

#include <algorithm>

namespace ehl::steady {

double resolving_step(const Tuning& tuning, const ContactScales& scales, reynolds::Wedge wedge) {
  const bool second_order = wedge != reynolds::Wedge::upstream1;
  const double share = second_order ? tuning.resolving_share : tuning.resolving_share_first_order;
  const double coarsest = second_order ? tuning.resolving_size : tuning.resolving_size_first_order;
  return std::min(coarsest * scales.shorter_size, share * scales.film_zone);
}

double cell_aspect(const Tuning& tuning, const contact::Ellipse& shape) {
  const contact::Extent reach = contact::extent(shape);
  if (reach.Y > tuning.wide_from * reach.X) return 2.0;
  if (reach.X < tuning.elongated_from * reach.Y || contact::gap(shape).oblique()) return 1.0;
  double stretch = 1.0;
  while (2.0 * stretch <= std::min(tuning.longest_cells, reach.X / reach.Y)) stretch *= 2.0;
  return 1.0 / stretch;
}

bool elongated(const Tuning& tuning, const contact::Ellipse& shape) {
  return tuning.elongated_from * shape.kappa < 1.0;
}

int resolving_cells(double step, double length, int fewest, int most) {
  int cells = fewest;
  while (2 * cells <= most && length / cells > step) cells *= 2;
  return cells;
}

}  // namespace ehl::steady
