#pragma once
// The global balance of oil in the mass-conserving cavitation model.
#include <optional>

#include "multigrid/hierarchy.hpp"
#include "reynolds/flow_balance.hpp"

namespace ehl::multigrid {

/// Flows of oil through the domain. in: the level after update_residual().
reynolds::OilBalance oil_of(const Hierarchy& hierarchy, const Level& level);

/// The oil in all interior nodes, in rho0 a^4/R.
double stored_oil(const Level& level);

/// theta = Q/(rho_bar H). in: the level after update_residual().
core::Field theta_of(const Level& level);

/// Global mass defect: the sum of the residuals of all full nodes, in rho0 u_m a^3/R. This oil leaves the domain, or is
/// stored in it, without having come in. in: the level after update_residual().
double mass_defect(const Hierarchy& hierarchy, const Level& level);

/// Global mass correction: reduces the mass defect to rounding, compared with `flow`, by default that through the
/// inlet. The rows of cavitated nodes hold exactly, so the defect is what cycles have left in the rows of full nodes.
/// One number is changed, by the secant method.
///
/// Steady: the pressure of the inlet gets a common factor, and all of the pressure another one for the same load. The
/// residual that this causes lies next to the meniscus, and the film in the contact hardly moves. Implicit time step,
/// or if that fails: H00 moves. cost: a film and some three evaluations of coefficients and residual. out: true if the
/// state was corrected; false if it balanced already, or if neither correction is enough and the state is as before.
bool balance_mass(Hierarchy& hierarchy, Level& level, std::optional<double> flow = {});

/// Global mass correction of a steady film that meets every other check. First along the line through the states before
/// and after the last cycle, whose defects have opposite signs as a rule; else by balance_mass(), and again after a
/// relaxation of the errors that it has caused next to the meniscus. cost: as balance_mass(). out: true if the state
/// moved.
bool correct_mass(Hierarchy& hierarchy, Level& level, const State& before, const RelaxationParameters& relaxation);

}  // namespace ehl::multigrid
