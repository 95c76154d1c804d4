#pragma once
#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

/// One coarse grid correction cycle (V, W or F) from levels[l] down to the coarsest grid and back, with nu_1
/// relaxations before and nu_2 after each correction. The force balance is relaxed on the coarsest grid only (eq. 26).
/// in: how, the parameters to use instead of the hierarchy's own. errors: core::SolverError.
void fas_cycle(Hierarchy& hierarchy, std::size_t l, const Parameters& how);
inline void fas_cycle(Hierarchy& hierarchy, std::size_t l) { fas_cycle(hierarchy, l, hierarchy.parameters); }

/// Relaxations on one level, each followed by H00 <- H00 - c (load - h^2 sum P) (eq. 26). They solve the coarsest grid.
void relax_with_force_balance(Hierarchy& hierarchy, Level& level, int sweeps, const Parameters& how);

}  // namespace ehl::multigrid
