// The checks of the final state.
#include <cmath>

#include "case/numbers/records.hpp"

namespace ehl::program::numbers {
namespace {

const steady::Verification& checked(Of s) { return solution(s).verification; }

std::string by_shape(Of s, const char* line, const char* circle, const char* else_) {
  return of_line(s) ? line : contact::circular(s.input.scene.contact.shape) ? circle : else_;
}

std::string through(Of s) {
  return by_shape(s, "mass flow through the contact at x = 0, per length along y",
                  "mass flow through the contact, |y| <= 1 at x = 0",
                  "mass flow through the contact at x = 0, as wide as it is");
}

std::string imbalance(Of s) {
  return by_shape(s, "mass flow out of |x| <= 1.5 less in, over flow_through",
                  "mass flow out of |x|, |y| <= 1.5 less in, over flow_through",
                  "mass flow out of 1.5 times the contact's reach less in, over flow_through");
}

bool counts_oil(Of s) { return std::isfinite(checked(s).least_content); }

}  // namespace

std::vector<Number> verification_numbers() {
  const auto of = [](double steady::Verification::*part) { return [part](Of s) { return checked(s).*part; }; };
  using V = steady::Verification;
  constexpr char cycle_Hc[] = "relative change of Hc in the last cycle",
                 cycle_Hm[] = "relative change of Hm in the last cycle";
  return {
      number(id::residual, "-", "relative residual of the Reynolds equation", not_in_file, of(&V::residual)),
      number("largest_residual", "-", "at one node, relative to the wedge term like the residual",
             of(&V::largest_residual)),
      number("largest_residual_x", "a", "its position", json("largest_residual_X"), of(&V::largest_residual_X)),
      number("largest_residual_y", "a", "its position", json("largest_residual_Y"), of(&V::largest_residual_Y)),
      number("least_P", "p_h", "lowest pressure of all nodes", of(&V::least_P)),
      number("dry_violation", "-", "largest residual of a cavitated node that calls for pressure",
             of(&V::dry_violation)),
      number(id::load_error, "-", "relative error of the load", not_in_file, of(&V::load_error)),
      number("change_Hc", "-", cycle_Hc, of(&V::change_Hc)),
      number("change_Hm", "-", cycle_Hm, of(&V::change_Hm)),
      number("algebraic_error_Hc", "-", "estimate of what further cycles would change", of(&V::algebraic_error_Hc)),
      number("algebraic_error_Hm", "-", "estimate of what further cycles would change", of(&V::algebraic_error_Hm)),
      number(id::Hm, "a^2/R", "minimum film of all nodes", not_in_file, of(&V::Hm)),
      number(id::Hm_x, "a", "its position", json("Hm_X"), not_in_file, of(&V::Hm_X)),
      number(id::Hm_y, "a", "its position", json("Hm_Y"), not_in_file, of(&V::Hm_Y)),
      number("flow_through", {"rho0 u_m a^3/R", "rho0 u_m a^2/R"}, "mass flow through the contact at x = 0",
             meaning_here(through), of(&V::flow_through)),
      number("flow_imbalance", "-", "mass flow out of the contact less in, over flow_through", meaning_here(imbalance),
             of(&V::flow_imbalance)),
      number("flow_imbalance_whole", "-", "the same of all of the pressurised region", of(&V::flow_imbalance_whole)),
      number("least_content", "a^2/R", "lowest oil content of all nodes", only_if(counts_oil), of(&V::least_content))};
}

}  // namespace ehl::program::numbers
