#pragma once
// Surface temperature of a moving half-space whose heat flux varies in time. Heat flows along the normal only, as in
// line_weights(), so that each point of the material has its own history:
//
//   theta(xi, Y, T) = factor int_0^T q(xi, Y, T')/sqrt(T - T') dT',   xi = X - displacement of the body.
//
// The latest step is integrated exactly for a flux that is linear in time at the point of the material. Earlier fluxes
// enter by a sum of exponentials, each of which obeys a recursion at nodes that move with the body; nothing that is
// remembered is interpolated again. Material that enters the domain has no history.
#include <cstddef>
#include <functional>
#include <vector>

#include "core/field.hpp"
#include "thermal/exponential_sum.hpp"

namespace ehl::thermal {

/// Weights of a flux that rests while the material passes at a varying speed,
///   int q dT'/sqrt(T - T') = sum_m w_m q_{i-m},   m = 0..n,
/// for q linear between nodes. At a constant speed they are those of line_weights(), but for a factor. in: ago(d), the
/// time since the material was displaced by d less than now, d >= 0; it grows with d.
std::vector<double> passing_weights(int n, double hx, const std::function<double(double)>& ago);

/// The history of the flux into a body since T = 0.
class BodyMemory {
 public:
  /// in: factor of the integral; kernel: 1/sqrt(t) from the shortest step to the whole time.
  BodyMemory(const core::Patch& patch, double factor, ExponentialSum kernel, int threads);

  /// Begins a step. in: its length; how far the body moves in it, in a, >= 0. out: history, the temperature at its end,
  /// at the nodes of the patch, except for self() q of the flux q at the end. May be called again with another step.
  void look(double length, double moved, core::Field& history);
  double self() const { return self_; }
  /// Ends the step of the last look(). in: the flux at its end.
  void accept(const core::Field& q);

  std::size_t bytes() const { return sizeof(double) * (memory_.size() + flux_.size() + known_.size()); }

 private:
  std::size_t terms() const { return kernel_.rate.size(); }
  std::size_t lines() const { return static_cast<std::size_t>(patch_.nodes_y()); }
  // Storage of the material at node m; its places are reused in turn.
  std::size_t place(int m) const { return static_cast<std::size_t>(((m - passed_) % count_ + count_) % count_); }

  core::Patch patch_;
  double factor_;
  ExponentialSum kernel_;
  int threads_;
  int count_;                   ///< material nodes: those of the patch and some upstream
  int passed_ = 0;              ///< whole cells by which the body has moved, modulo count_
  double offset_ = 0.0;         ///< the rest of its displacement, in cells, below 1
  std::vector<double> memory_;  ///< int exp(-rate (T - T')) q dT': place, term, line
  std::vector<double> flux_;    ///< q at the end of the last step: place, line
  std::vector<double> known_;   ///< history at the material nodes: m, line
  double length_ = 0.0, moved_ = 0.0, self_ = 0.0;
};

}  // namespace ehl::thermal
