#pragma once
// The balance of oil, of the cavitation model that conserves mass.
#include <optional>

#include "fmg/hierarchy.hpp"
#include "reynolds/flow_balance.hpp"

namespace ehl::fmg {

/// Of the level behind update_residual().
reynolds::OilBalance oil_of(const Hierarchy& hierarchy, const Level& level);

/// In all interior nodes, in rho0 a^4/R.
double stored_oil(const Level& level);

/// theta = Q/(rho_bar H) of the level behind update_residual().
core::Field theta_of(const Level& level);

/// What full nodes' rows lack, all together: oil that leaves the domain, or is stored there, and came from nowhere; in
/// rho0 u_m a^3/R. in: the level behind update_residual().
double oil_from_nowhere(const Hierarchy& hierarchy, const Level& level);

/// Makes that zero within a share of `flow`, by default of that through the inlet. The rows of dry nodes hold exactly,
/// so it is the sum of what cycles have left in those of full ones; one number puts it right, by Newton's method along
/// a line. In a steady film the pressure of the inlet gets a common factor, and all the pressure another one for the
/// same load: the residual stands beside the meniscus, the film in the contact hardly moves. In an implicit step of
/// time H00 moves, by less than 1e-6. cost: a film and three times its coefficients and residual.
/// out: true where it was made so; false where it was already, or neither is enough and all stays as it was.
bool balance_oil(Hierarchy& hierarchy, Level& level, std::optional<double> flow = {});

/// The same for a steady film that is solved in all else: on the line through the states before and behind the last
/// cycle, which leaves the excess of the other sign as a rule; else by balance_oil(), and once more behind a relaxation
/// of what that has made rough beside the meniscus. cost: as above. out: true where the state moved.
bool close_oil(Hierarchy& hierarchy, Level& level, const State& before, const RelaxationParameters& relaxation);

}  // namespace ehl::fmg
