#pragma once
// The steady problem on one grid as equations F(u) = 0 for Newton's method: residual, Jacobian, complementarity.
#include <cstddef>
#include <span>
#include <vector>

#include "core/field.hpp"
#include "fmg/hierarchy.hpp"

namespace ehl::newton {

/// The unknowns u are a number z per interior node and, as the last one, H00. With P = max(z, 0) and the residual
/// r = -L(P) of the Reynolds equation
///   F_ij = s_ij r_ij + min(z_ij, 0),   F_last = (hx hy sum P - load) / load.
/// F = 0 is the complementarity problem P >= 0, r >= 0, P r = 0 (Robinson's normal map): a wet node has z = P and
/// r = 0, a cavitated one P = 0 and r = -z/s. P is never negative, whatever u. The row scale s_ij > 0, one over the
/// local part of dr_ij/dP_ij, gives every F the unit of a pressure; it changes nothing in the solution.
/// Nodes in order of storage: along Y fastest.
class Equations {
 public:
  /// Takes over levels[l] as it is: the unknowns come from its P and from H00. limits: no right-hand sides f, F; a
  /// given load; cavitation.
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

  /// What the nodes' own and nearest values do to r, with K cut to its self term: for the preconditioner.
  struct Local {
    core::Field eps;         ///< d eps/dP
    core::Field q;           ///< d (rho_bar H)/dP
    core::Field eps_across;  ///< of epsilon along Y where it is another one; else empty
  };
  const Local& local() const { return local_; }
  const core::Field& local_eps_across() const { return anisotropic() ? local_.eps_across : local_.eps; }
  /// d eps/dH, along X and along Y.
  const core::Field& deps_dH() const { return along_.dH; }
  const core::Field& deps_dH_across() const { return anisotropic() ? across_.dH : along_.dH; }
  bool wet(std::size_t node) const { return wet_[node] != 0; }
  double scale(std::size_t node) const { return scale_[node]; }
  const reynolds::Transport& transport() const { return hierarchy_.transport; }

 private:
  /// Derivatives of an epsilon at the point of linearization, P and H as independent variables, and its change in
  /// jacobian().
  struct Epsilon {
    core::Field dP, dH, change;
  };

  bool anisotropic() const { return film::anisotropic(hierarchy_.problem.film); }
  void make_scale();

  fmg::Hierarchy& hierarchy_;
  fmg::Level& level_;
  std::size_t nodes_;
  int threads_;
  std::vector<double> scale_;
  std::vector<char> wet_;
  Epsilon along_, across_;  // the second one empty where there is one epsilon only
  core::Field dq_dP_;
  Local local_;
  core::Field dP_, dH_;  // work space of jacobian()
};

}  // namespace ehl::newton
