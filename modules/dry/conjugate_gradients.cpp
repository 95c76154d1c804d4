#include "dry/conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>

namespace ehl::dry {
namespace {

// Calls visit(i, j, n) for all nodes; n is the number of nodes of the whole domain that a node stands for.
template <class Visit>
void for_nodes(const core::Patch& grid, Visit visit) {
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j) visit(i, j, grid.lines(j));
}

}  // namespace

ConjugateGradients::ConjugateGradients(const core::Patch& grid, const core::Field& gap, double load,
                                       mlmi::Deformation& deformation, const core::Field& P)
    : grid_(grid), gap_(gap), load_(load), deformation_(deformation), P_(P), H_(grid), direction_(grid), change_(grid) {
  scale_to_load();
  update_gap();
}

double ConjugateGradients::area() const {
  double nodes = 0.0;
  for_nodes(grid_, [&](int i, int j, double lines) { nodes += P_(i, j) > 0.0 ? lines : 0.0; });
  return nodes * grid_.hx() * grid_.hy();
}

double ConjugateGradients::mean_over_contact(const core::Field& f) const {
  double sum = 0.0, nodes = 0.0;
  for_nodes(grid_, [&](int i, int j, double lines) {
    if (P_(i, j) > 0.0) {
      sum += lines * f(i, j);
      nodes += lines;
    }
  });
  return sum / nodes;
}

void ConjugateGradients::scale_to_load() {
  double sum = 0.0;
  for_nodes(grid_, [&](int i, int j, double lines) { sum += lines * P_(i, j); });
  const double factor = load_ / (sum * grid_.hx() * grid_.hy());
  for_nodes(grid_, [&](int i, int j, double) { P_(i, j) *= factor; });
}

void ConjugateGradients::update_gap() {
  deformation_.evaluate(P_, H_);
  for_nodes(grid_, [&](int i, int j, double) { H_(i, j) += gap_(i, j); });
  H00_ = -mean_over_contact(H_);
  error_ = 0.0;
  for_nodes(grid_, [&](int i, int j, double) {
    H_(i, j) += H00_;
    const double wrong = P_(i, j) > 0.0 ? std::abs(H_(i, j)) : -H_(i, j);
    // std::max would lose a NaN.
    if (!(wrong <= error_)) error_ = wrong;
  });
}

void ConjugateGradients::step() {
  double square = 0.0;
  for_nodes(grid_, [&](int i, int j, double lines) {
    if (P_(i, j) > 0.0) square += lines * H_(i, j) * H_(i, j);
  });
  const double share = conjugate_ ? square / old_square_ : 0.0;
  old_square_ = square;
  for_nodes(grid_, [&](int i, int j, double) {
    direction_(i, j) = P_(i, j) > 0.0 ? H_(i, j) + share * direction_(i, j) : 0.0;
  });

  deformation_.evaluate(direction_, change_);
  const double mean = mean_over_contact(change_);
  double along = 0.0, curvature = 0.0;
  for_nodes(grid_, [&](int i, int j, double lines) {
    along += lines * H_(i, j) * direction_(i, j);
    curvature += lines * (change_(i, j) - mean) * direction_(i, j);
  });
  const double length = curvature > 0.0 ? along / curvature : 0.0;

  bool grew = false;
  for_nodes(grid_, [&](int i, int j, double) {
    double& P = P_(i, j);
    if (P > 0.0) {
      P = std::max(0.0, P - length * direction_(i, j));
    } else if (H_(i, j) < 0.0) {
      P = -length * H_(i, j);
      grew = true;
    }
  });
  conjugate_ = !grew;
  scale_to_load();
  update_gap();
}

}  // namespace ehl::dry
