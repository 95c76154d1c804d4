#pragma once
// The steady problem on one grid as equations F(u) = 0 for Newton's method: residual, Jacobian, complementarity.
#include <cstddef>
#include <span>
#include <vector>

#include "core/field.hpp"
#include "fmg/hierarchy.hpp"
#include "newton/content_rows.hpp"
#include "reynolds/flux.hpp"

namespace ehl::newton {

/// The unknowns u are a number z per interior node and, as the last one, H00. With P = max(z, 0) and the residual
/// r = -L(P) of the Reynolds equation
///   F_ij = s_ij r_ij + min(z_ij, 0),   F_last = (hx hy sum P - load) / load.
/// F = 0 is the complementarity problem P >= 0, r >= 0, P r = 0 (Robinson's normal map): a wet node has z = P and
/// r = 0, a cavitated one P = 0 and r = -z/s. P is never negative, whatever u. The row scale s_ij > 0, one over the
/// local part of dr_ij/dP_ij, gives every F the unit of a pressure; it changes nothing in the solution.
/// In an implicit step of time the load may grow with H00, and the level has right-hand sides f and F.
/// Nodes in order of storage: along Y fastest.
class Equations {
 public:
  /// Takes over levels[l] as it is: the unknowns come from its P and from H00. limits: a given load; cavitation.
  Equations(fmg::Hierarchy& hierarchy, std::size_t l);

  std::size_t size() const { return nodes_ + 1; }
  const fmg::Level& level() const { return level_; }
  const core::Patch& grid() const { return level_.grid; }
  /// Places of node (i, j), 1 <= i < nx, 1 <= j <= last_line, in u and F.
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i - 1) * static_cast<std::size_t>(level_.grid.last_line()) +
           static_cast<std::size_t>(j - 1);
  }

  /// u of the level's state, cavitated nodes with z = -s r; makes the row scale anew from it.
  void unknowns(std::span<double> u);
  /// The level's P, film and coefficients from u.
  void set_state(std::span<const double> u);
  /// set_state(u), then F(u).
  void residual(std::span<const double> u, std::span<double> F);
  /// Prepares jacobian() and the local coefficients at u; the level must be in that state.
  void linearize(std::span<const double> u);
  /// Jv = F'(u) v, exact: epsilon through P and H, the wedge through rho_bar and H, H = K*P + H00 by the level's film
  /// evaluation. At z = 0, where F has two slopes, the cavitated one.
  void jacobian(std::span<const double> v, std::span<double> Jv);
  /// w = K*p by the level's film evaluation.
  void deform(const core::Field& p, core::Field& w);
  /// What changes of P and of H at all nodes, each on its own, change of r at the nodes inside. in: dP with ghost
  /// lines; dH, whose values are not kept. out: in order of storage.
  void change_of_residual(const core::Field& dP, core::Field& dH, std::span<double> dr);

  /// What the nodes' own and nearest values do to r, with K cut to its self term: for the preconditioner.
  struct Local {
    core::Field eps;         ///< d eps/dP; at half points by the pressure of the node before
    core::Field q;           ///< d (rho_bar H)/dP
    core::Field eps_across;  ///< of epsilon along Y where it is another one; else empty
    core::Field eps_behind;  ///< at half points by the pressure of the node behind; else empty
    core::Field eps_across_behind;
  };
  const Local& local() const { return local_; }
  const core::Field& local_eps_across() const { return two_epsilons() ? local_.eps_across : local_.eps; }
  /// What a change of H everywhere, H00's, changes of epsilon along X and along Y.
  const core::Field& deps_dH00() const { return at_half_points() ? along_.dH00 : along_.dH; }
  const core::Field& deps_dH00_across() const {
    return at_half_points() ? across_.dH00 : anisotropic() ? across_.dH : along_.dH;
  }
  reynolds::Face face() const { return level_.scheme.face; }
  /// theta at the faces west and east of a node.
  reynolds::ThirdOrder<double> third_order_around(int i, int j) const {
    const core::Field& theta = level_.third_order;
    return theta.nodes_x() > 0 ? reynolds::ThirdOrder<double>{theta(i - 1, j), theta(i, j)}
                               : reynolds::ThirdOrder<double>{};
  }
  /// Of a mass conserving model; else nullptr.
  const ContentRows* content_rows() const { return fmg::conserves_mass(level_) ? &content_rows_ : nullptr; }
  bool wet(std::size_t node) const { return wet_[node] != 0; }
  double scale(std::size_t node) const { return scale_[node]; }
  /// What H00 changes of F_last: of a load that grows with it.
  double load_by_H00() const {
    return 0.0 - (hierarchy_.load_line.slope + hierarchy_.outside_line.slope) / level_.load;
  }
  reynolds::Transport transport() const { return fmg::transport_on(hierarchy_, level_); }

 private:
  /// Derivatives of an epsilon at the point of linearization, P and H as independent variables, and its change in
  /// jacobian(). At half points those of ln eta_bar of the nodes take the place of those of epsilon.
  struct Epsilon {
    core::Field dP, dH, change;
    core::Field dH00{};  ///< at half points; else empty
  };
  /// What a node's P and H change of what epsilon at half points is made of.
  struct NodeChange {
    double dP = 0.0, dH = 0.0;
  };

  bool anisotropic() const { return film::anisotropic(hierarchy_.problem.film); }
  bool at_half_points() const { return fmg::at_half_points(level_); }
  /// True where theta follows epsilon.
  bool switched() const { return level_.scheme.wedge == reynolds::Wedge::upstream3; }
  bool two_epsilons() const { return anisotropic() || at_half_points(); }
  /// Calls action(j) for all lines; of a line contact for the one of the unknowns, of which the others are copies.
  template <class Action>
  void for_lines(Action action) const {
    if (grid().domain.line) return action(1);
    for (int j = 0; j <= grid().ny; ++j) action(j);
  }
  /// True where epsilon between lines j and j + 1 takes part: nothing flows across a line contact.
  bool flows_across(int j) const { return !grid().domain.line && j < grid().domain.ny; }
  struct NodeEpsilon {
    double value = 0.0, change = 0.0;
  };
  NodeEpsilon node_epsilon(int i, int j, NodeChange node) const;
  /// The change of theta at all faces along X.
  template <class At>
  void change_third_order(At at);
  void make_scale();
  void linearize_half_points();
  /// d eps at (i + 1/2, j), or at (i, j + 1/2), for changes of the nodes on the line around it. at(i, j): of a node.
  template <class At>
  double half_point_change(bool along_x, int i, int j, At at) const;

  fmg::Hierarchy& hierarchy_;
  fmg::Level& level_;
  std::size_t nodes_;
  int threads_;
  std::vector<double> scale_;
  std::vector<char> wet_;
  Epsilon along_, across_;  // the second one empty where there is one epsilon only
  ContentRows content_rows_;
  core::Field dq_dP_;
  Local local_;
  core::Field dP_, dH_, dtheta_;  // work space of jacobian()
};

}  // namespace ehl::newton
