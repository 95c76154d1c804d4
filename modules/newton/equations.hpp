#pragma once
// The problem on one grid as equations F(u) = 0 for Newton's method: residual, Jacobian, complementarity.
#include <cstddef>
#include <span>
#include <vector>

#include "core/field.hpp"
#include "multigrid/hierarchy.hpp"
#include "newton/content_rows.hpp"
#include "reynolds/row.hpp"

namespace ehl::newton {

/// The equations F(u) = 0. The unknowns u are one number z per interior node and, last, H00. With P = max(z, 0) and the
/// residual r = -L(P) of the Reynolds equation
///   F_ij = s_ij r_ij + min(z_ij, 0),   F_last = (hx hy sum P - load) / load.
/// F = 0 is the complementarity problem P >= 0, r >= 0, P r = 0 (Robinson's normal map): a wet node has z = P and r =
/// 0, a cavitated one P = 0 and r = -z/s. P is never negative, whatever u. The row scale s_ij > 0 is one over the local
/// part of dr_ij/dP_ij; it gives every F the unit of a pressure and does not change the solution.
/// Touching surfaces add one number w per node between z and H00, with P_c = w limited to 0 and the hardness P_y, and
/// the rows
///   F = s (H - H_b) + min(w, 0),   s = 1/K_00;
/// where w > P_y a surface has yielded by (w - P_y)/s, which is a part of H. So P_c = 0 and H >= H_b, or H = H_b.
/// In an implicit time step the load may grow with H00, and the level has right-hand sides f and F.
/// Nodes are numbered in storage order: along Y fastest.
class Equations {
 public:
  /// Uses levels[l] as it is: the unknowns come from its P and from H00. limits: a given load; cavitation.
  Equations(multigrid::Hierarchy& hierarchy, std::size_t l);

  std::size_t size() const { return (touching() ? 2 : 1) * nodes_ + 1; }
  std::size_t nodes() const { return nodes_; }
  bool touching() const { return level_.touching.has_value(); }
  const multigrid::Level& level() const { return level_; }
  const core::Patch& grid() const { return level_.grid; }
  /// Index of node (i, j) in u and F, 1 <= i < nx, 1 <= j <= last_line.
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i - 1) * static_cast<std::size_t>(level_.grid.last_line()) +
           static_cast<std::size_t>(j - 1);
  }

  /// The unknowns of the level's state, with z = -s r in cavitated nodes. The row scale is computed from that state.
  void unknowns(std::span<double> u);
  /// Sets the level's P, film and coefficients from u.
  void set_state(std::span<const double> u);
  /// set_state(u), then F(u).
  void residual(std::span<const double> u, std::span<double> F);
  /// Prepares jacobian() and the local derivatives at u; the level must be in that state.
  void linearize(std::span<const double> u);
  /// Jv = F'(u) v, exact: epsilon through P and H, the wedge through rho_bar and H, and H = K*P + H00 by the level's
  /// film evaluation. At z = 0, where F has two derivatives, that of the cavitated state.
  void jacobian(std::span<const double> v, std::span<double> Jv);
  /// The rows of w where the surfaces do not touch are identities in jacobian(). Sets their part of a step d from its
  /// other parts. in: -F before the step.
  void complete(std::span<const double> minus_F, std::span<double> d);
  /// w = K*p by the level's film evaluation.
  void deform(const core::Field& p, core::Field& w);
  /// Change of r at the interior nodes for given changes of P and H at all nodes, taken as independent. in: dP with
  /// ghost lines; dH, whose values are overwritten. out: in storage order.
  void change_of_residual(const core::Field& dP, core::Field& dH, std::span<double> dr);

  /// Derivatives of a node's quantities by pressure, with K reduced to its self term: for the preconditioner.
  struct Local {
    core::Field eps;         ///< d eps/dP; at half points by the pressure of the upstream node
    core::Field q;           ///< d (rho_bar H)/dP
    core::Field eps_across;  ///< d eps/dP of epsilon along Y, if it is a different one; else empty
    core::Field eps_behind;  ///< at half points by the pressure of the downstream node; else empty
    core::Field eps_across_behind;
  };
  const Local& local() const { return local_; }
  const core::Field& local_eps_across() const { return two_epsilons() ? local_.eps_across : local_.eps; }
  /// Derivatives by H00 of epsilon along X and along Y.
  const core::Field& deps_dH00() const { return at_half_points() ? along_.dH00 : touching() ? moved_.eps : along_.dH; }
  const core::Field& deps_dH00_across() const {
    return at_half_points() ? across_.dH00
           : anisotropic()  ? (touching() ? moved_.eps_across : across_.dH)
                            : deps_dH00();
  }
  /// Derivative of rho_bar H by H00.
  const core::Field& dq_dH00() const { return touching() ? moved_.q : level_.rho_bar; }
  reynolds::Face face() const { return level_.scheme.face; }
  reynolds::NodeRows rows() const { return multigrid::rows(hierarchy_, level_); }
  /// The rows of the mass conserving model; nullptr with another model.
  const ContentRows* content_rows() const { return multigrid::conserves_mass(level_) ? &content_rows_ : nullptr; }
  bool wet(std::size_t node) const { return wet_[node] != 0; }
  /// What a node's row of w says.
  enum class Touch : char { none, touches, yields };
  Touch touch(std::size_t node) const { return touch_.empty() ? Touch::none : touch_[node]; }
  /// Row scale of w.
  double touching_scale() const { return 1.0 / multigrid::film_response(level_, 0); }
  double scale(std::size_t node) const { return scale_[node]; }
  /// d F_last/d H00, for a load that grows with H00.
  double load_by_H00() const {
    return 0.0 - (hierarchy_.load_line.slope + hierarchy_.outside_line.slope) / level_.load;
  }
  reynolds::Transport transport() const { return multigrid::transport_on(hierarchy_, level_); }

 private:
  /// Derivatives of epsilon at the point of linearization, with P and H as independent variables, and its change in
  /// jacobian(). With epsilon at half points, dP and dH are those of the nodes' ln eta_bar.
  struct Epsilon {
    core::Field dP, dH, change;
    core::Field dH00{};  ///< with epsilon at half points; else empty
  };
  /// The changes of a node's P and H on which epsilon at half points depends.
  struct NodeChange {
    double dP = 0.0, dH = 0.0;
  };

  double hardness() const { return hierarchy_.problem.boundary_film->hardness; }
  /// dH/dP of a node in the preconditioner, where only its own pressure counts: 0 where the surfaces touch.
  double own_response(int i, int j) const { return moves(i, j) * multigrid::film_response(level_, 0); }
  /// 1 where H changes with H00 and with P; 0 where the surfaces touch, for j up to the last line of the domain.
  double moves(int i, int j) const {
    const int line = grid().holder(j);
    if (touch_.empty() || i < 1 || i >= grid().nx || line < 1 || line > grid().last_line()) return 1.0;
    return touch_[index(i, line)] == Touch::none ? 1.0 : 0.0;
  }
  /// Where the surfaces touch in the present state.
  void find_touching();
  void touching_unknowns(std::span<double> u) const;
  void set_touching(std::span<const double> u);
  void touching_residual(std::span<const double> u, std::span<double> F) const;
  /// Derivatives by H00 at the nodes, without those that touch.
  void make_moved();
  /// Adds the pressure of touching surfaces to a change dP of the fluid's, in dtotal_. out: the change of the load.
  double add_touching(std::span<const double> v, const core::Field& dP);
  /// Adds yielding to the change dH of the film, then the rows of w.
  void touching_rows(std::span<const double> v, core::Field& dH, std::span<double> Jv) const;

  bool anisotropic() const { return film::anisotropic(hierarchy_.problem.film); }
  bool at_half_points() const { return multigrid::at_half_points(level_); }
  /// True if theta depends on epsilon.
  bool switched() const { return level_.scheme.wedge == reynolds::Wedge::upstream3; }
  bool two_epsilons() const { return anisotropic() || at_half_points(); }
  /// Calls action(j) for all lines but copies.
  template <class Action>
  void for_lines(Action action) const {
    for (int j = 0; j <= grid().ny; ++j)
      if (grid().lines(j) > 0.0) action(j);
  }
  /// True if epsilon between lines j and j + 1 is used.
  bool flows_across(int j) const { return reynolds::flows_aside(grid()) && j < grid().domain.ny; }
  struct NodeEpsilon {
    double value = 0.0, change = 0.0;
  };
  NodeEpsilon node_epsilon(int i, int j, NodeChange node) const;
  /// Computes the change of theta at all faces along X.
  template <class At>
  void change_third_order(At at);
  void make_scale();
  void linearize_half_points();
  /// Change of epsilon at (i + 1/2, j), or at (i, j + 1/2), for changes of the nodes around it on its line. in: at(i,
  /// j), the change of a node.
  template <class At>
  double half_point_change(bool along_x, int i, int j, At at) const;

  multigrid::Hierarchy& hierarchy_;
  multigrid::Level& level_;
  std::size_t nodes_;
  int threads_;
  std::vector<double> scale_;
  std::vector<char> wet_;
  std::vector<Touch> touch_;  // empty if the surfaces do not touch
  Epsilon along_, across_;    // across_ is empty if there is one epsilon only
  ContentRows content_rows_;
  core::Field dq_dP_;
  Local local_;
  core::Field dP_, dH_, dtheta_, dtotal_;  // work space of jacobian()
  Local moved_;                            // make_moved()
};

}  // namespace ehl::newton
