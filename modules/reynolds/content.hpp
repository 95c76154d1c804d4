#pragma once
// The mass-conserving cavitation model: P >= 0, Q <= rho_bar H, P (rho_bar H - Q) = 0, with the oil content Q, the oil
// between the surfaces per area. A full point has Q = rho_bar H; a cavitated one has P = 0 and Q < rho_bar H.
//
//   F_i = Poiseuille_i - U (Fl_{i+1/2} - Fl_{i-1/2})/hx,   Fl_{i+1/2} = Q_i + phi_i/2 (Q_i - Q_{i-1}),
//   phi_i = 1 where i-1 is full, else 0 (upstream1: always 0);   Fl_{1/2} = (Q_0 + Q_1)/2 where 0 is full, else Q_0
//
// In an implicit time step F_i also loses c Q_i, and the known part of dQ/dT is in f: a cavitated point keeps a part of
// what flows into it. upstream3 adds its third-order flux, computed from rho_bar H, where i-1 is full. A cavitated
// point carries the share Q_i/(rho_bar H) of that flux: on few cells the gap behind the film opens by many times the
// content, and all of the flux would make the content negative.
//
// No row depends on whether its own point is full, so that its residual is continuous as the point changes between full
// and cavitated. Other fluxes have no discrete solution, and their cavitated nodes chatter: that of upstream2 at an
// inlet meniscus in two dimensions, and phi = 1 only where both i and i-1 are full at the edge of rupture. Where a node
// chatters nevertheless, phi downstream of it is 0. Where all points are full this is the equation with rho_bar H.
#include <array>
#include <span>

#include "reynolds/residual.hpp"
#include "reynolds/row.hpp"

namespace ehl::reynolds {

/// March along one line of constant Y, or along a batch of lines, from the inlet on. The content of a cavitated point
/// follows exactly from what flows into it. For every i = 1, 2, ..: residual(), then go_on().
template <class Number>
class March {
 public:
  using Mask = decltype(Number{} <= 0.0);

  /// in: Q and rho_bar H of the first column.
  March(const Transport& transport, double hx, Number Q, Number full)
      : second_order_(transport.wedge != Wedge::upstream1),
        third_order_(third_order(transport.wedge)),
        per_step_(transport.speed / hx),
        squeeze_(transport.squeeze),
        Q_(Q),
        flux_(Q),
        full1_(Q >= full),
        smooth1_(Q >= full),
        smooth2_(Q >= full) {}

  /// r = f - L(P) of point i as if it were full. In a cavitated point r >= 0, in proportion to how much oil it lacks.
  /// in: rho_bar H of i and i+1; theta of the faces west and east of i (flux.hpp; only with a third-order wedge); the
  /// inflow by pressure, less f.
  Number residual(Number full, Number east, const ThirdOrder<Number>& theta, Number inflow) {
    const Number none{};
    const Number half = none + 0.5;
    const Number lead = second_order_ ? (smooth1_ ? half : none) : none;
    first_ = first_row_ ? lead : none;
    theta_ = {(full1_ & smooth2_) ? theta.west : none, smooth1_ ? theta.east : none};
    flux_ += first_ * (full - Q_);
    behind_ = full + lead * (full - Q_);
    carries_ = 1.0 + lead;
    if (third_order_) {
      const Number third = third_order_part(theta_.east, Q_, full, east);
      behind_ += third;
      carries_ += full > 0.0 ? third / full : none;
    }
    lead_west_ = lead_;
    lead_ = lead;
    return per_step_ * (behind_ - flux_) - (inflow - squeeze_ * full);
  }
  /// Weights of rho_bar H at i, i-1, i-2, i+1 in that row; 0 for cavitated points, whose content does not depend on
  /// their gap.
  std::array<Number, 4> weights() const {
    const Number none{};
    const Number west = theta_.west * (1.0 / 3.0);
    const Number east = theta_.east * (1.0 / 3.0);
    const Number own = 1.0 + lead_ - first_;
    return {per_step_ * (own - 2.0 * east - west) + squeeze_,
            full1_ ? per_step_ * (east + 2.0 * west - own - lead_west_) : none,
            full1_ ? per_step_ * (lead_west_ - west) : none, per_step_ * east};
  }
  /// Weights of rho_bar H at i, i-1, i+1 in the flux downstream of i if i is full, over U.
  std::array<Number, 3> weights_behind() const {
    const Number third = theta_.east * (1.0 / 3.0);
    return {1.0 + lead_ - 2.0 * third, third - lead_, third};
  }
  /// theta of both faces, 0 where they carry no third-order flux.
  const ThirdOrder<Number>& third_order_share() const { return theta_; }
  /// True where i-1 is cavitated: what flows back into it from i by pressure partly returns with its content.
  Mask behind_dry() const {
    const Mask no = Number{} > 0.0;
    return first_row_ ? no : full1_ == no;
  }
  /// The part that returns: all of it in a steady film.
  Number part_that_returns() const { return returns_; }

  /// Goes on to the next point. in: true where P = 0; r of residual(); true where the flux downstream of the next point
  /// is of first order although this one is full.
  void go_on(Number full, Mask without_pressure, Number r, Mask first_order = Mask{}) {
    const Number lost = (without_pressure & (r > 0.0)) ? r / of_content() : Number{};
    pass(full - lost, lost, first_order);
  }
  /// Goes on to the next point with a given content. out: r with this content.
  Number go_on_with(Number full, Number Q, Number r, Mask first_order = Mask{}) {
    const Number lost = full - Q;
    const Number held = r - of_content() * lost;
    pass(Q, lost, first_order);
    return held;
  }

  Number Q() const { return Q_; }        ///< content of the last point
  Number flux() const { return flux_; }  ///< flux downstream of it, over U

 private:
  /// dr_i/dQ_i of a cavitated point.
  Number of_content() const { return per_step_ * (carries_ - first_) + squeeze_; }

  void pass(Number Q, Number lost, Mask first_order) {
    if (squeeze_ > 0.0) returns_ = per_step_ * (carries_ - first_) / of_content();
    Q_ = Q;
    flux_ = behind_ - carries_ * lost;
    smooth2_ = smooth1_;
    full1_ = lost <= 0.0;
    smooth1_ = full1_ & (first_order == Mask{});
    first_row_ = false;
  }

  bool second_order_, third_order_;
  bool first_row_ = true;
  double per_step_, squeeze_;
  Number Q_, flux_;                  // of i-1, and downstream of it
  Mask full1_;                       // i-1
  Mask smooth1_, smooth2_;           // i-1 and i-2: the flux downstream of the next point is of higher order
  Number behind_{};                  // flux downstream of i if i is full
  Number carries_{};                 // derivative of that flux with respect to the content of i if i is cavitated
  Number lead_{}, lead_west_{};      // phi/2 of i and i-1
  Number first_{};                   // share of i = 1 in the flux through the first face
  Number returns_ = Number{} + 1.0;  // share of the back flow into i-1 that returns
  ThirdOrder<Number> theta_{};
};

/// The oil content of a level, and the supply.
struct Content {
  core::Field& Q;
  /// What the surfaces bring in, per line: in the first column Q is this, or rho_bar H if that is less.
  std::span<const double> supply;
};

/// residual() of this model. The content of cavitated points follows from what flows into them; r there is proportional
/// to what they lack, r >= 0. out: Q, with ghost lines; on the boundaries of constant Y it is the supply, as far as the
/// gap takes it. limits: U > 0, or a squeeze. threads: the result is independent of their number.
void residual(const core::Patch& grid, const Fields& state, const Content& content, const Transport& transport,
              int threads, core::Field& r);
/// residual() with the content held: r = f - L(P, Q).
void residual_of_content(const core::Patch& grid, const Fields& state, const Content& content,
                         const Transport& transport, int threads, core::Field& r);

/// True where the flux downstream of the next node is of first order although this node is full.
inline bool first_order_behind(const Fields& state, int i, int j) {
  return i > 0 && state.chatters != nullptr && (*state.chatters)(i, j) > 0.0;
}
/// What the film carries through the face downstream of node i of a line, over U, with a given content. in: Q and
/// rho_bar H of column k; theta of the face; true where the flux is of first order although i-1 is full.
template <class Column, class Gap>
double carried_content(Wedge wedge, int i, Column Q, Gap full, double theta, bool first_order) {
  if (i == 0) return Q(0) >= full(0) ? carried(wedge, 0, Q) : Q(0);
  if (first_order || Q(i - 1) < full(i - 1)) return Q(i);
  if (!third_order(wedge)) return carried(wedge, i, Q);
  const double filled = Q(i) < full(i) && full(i) > 0.0 ? Q(i) / full(i) : 1.0;
  return carried(wedge, i, Q) + filled * third_order_part(theta, Q(i - 1), full(i), full(i + 1));
}

}  // namespace ehl::reynolds
