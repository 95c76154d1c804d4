#pragma once
// Restriction and correction between two neighbouring levels of the full approximation scheme (FAS).
#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

/// Poses on `coarse` the problem whose solution corrects `fine` (FAS): restricted P and H, and the right-hand sides of
/// the Reynolds equation, the film equation and the force balance.
///
/// - P: full weighting where all nine fine points carry pressure, injection otherwise.
/// - H: injection; F so that the coarse film equation gives the injected H at the restricted P.
/// - Residual: weights of the nine points by their coupling epsilon/h^2 (see restrict_residual). It is zero in
///   cavitated points and next to them, where points of the fine grid may still change between full and cavitated. A
///   coarse point that is cavitated on the fine grid keeps the slack that it has there, f = L(P) + slack.
///
/// in: the complete state of fine. Overwrites fine.r.
void restrict_problem(Hierarchy& hierarchy, Level& fine, Level& coarse);

/// fine.P += interpolation of (coarse.P - coarse.finer->P), limited to P >= 0, except in cavitated points and next
/// to them; then the film. The interpolation is bilinear, but weighted by the face conductances on stretched cells,
/// for oblique contacts, and if `weighted`. Overwrites the correction of both levels.
void correct_from_coarse(Hierarchy& hierarchy, Level& coarse, Level& fine, bool weighted);

/// Full weighting of a residual with weights that follow the coupling: a point half-way between two coarse points gives
/// each a share proportional to e + `elastic_coupling`, e = epsilon/h^2 at the half point towards it. Where epsilon is
/// smooth or small these are the usual weights. Where it jumps (the edge of the contact, the flanks of the pressure
/// spike), they keep the large residuals of the strongly coupled side from coarse points whose own equation is orders
/// weaker and would give corrections that are orders too large. in: r and epsilon of `fine`. out: the interior of
/// `coarse`.
void restrict_residual(const Hierarchy& hierarchy, const Level& fine, core::Field& coarse);

}  // namespace ehl::multigrid
