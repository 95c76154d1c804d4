// The groups of the contact, its scales, its grid, and what a bearing or gears say about it.
#include <algorithm>
#include <cmath>

#include "case/numbers/records.hpp"

namespace ehl::program::numbers {
namespace {

const contact::Groups& groups(Of s) { return s.input.physics.groups; }
const SiInput& si(Of s) { return *s.input.physics.si; }

bool has_oil(Of s) { return !s.input.dry; }
bool moves(Of s) { return has_oil(s) && in_SI(s); }
bool elliptic(Of s) { return has_oil(s) && !contact::circular(groups(s).shape) && !contact::line(groups(s).shape); }
bool elliptic_in_SI(Of s) { return elliptic(s) && in_SI(s); }
bool rolls(Of s) { return has_oil(s) && contact::roller(groups(s).shape); }
bool at_temperature(Of s) { return moves(s) && s.input.physics.ambient; }
bool in_seconds(Of s) { return s.input.transient && std::isfinite(s.input.transient->second); }

std::string meaning_of_load(Of s) {
  return has_oil(s) && contact::line(groups(s).shape) ? "normal load per length" : "normal load";
}

}  // namespace

std::vector<Number> similarity_numbers() {
  return {number(id::M, "-", "Moes load number", only_if(has_oil), column(201), [](Of s) { return groups(s).M; }),
          number(id::L, "-", "Moes material number", only_if(has_oil), column(202), [](Of s) { return groups(s).L; }),
          number("W", "-", "Hamrock-Dowson load number", only_if(has_oil), [](Of s) { return groups(s).W; }),
          number("U", "-", "Hamrock-Dowson speed number", only_if(has_oil), [](Of s) { return groups(s).U; }),
          number("G", "-", "Hamrock-Dowson material number", only_if(has_oil), [](Of s) { return groups(s).G; }),
          number("lambda", "-", "6 eta0 u_s R^2/(a^3 p_h)", only_if(has_oil), [](Of s) { return groups(s).lambda; }),
          number("alpha_bar", "-", "alpha p_h", only_if(has_oil), [](Of s) { return groups(s).alpha_bar; }),
          number(id::p_h, "Pa", "Hertz pressure, the scale of P", json("p_h_Pa"), column(203), in_si(130, "p_h", "GPa"),
                 [](Of s) { return s.input.physics.p_h; }),
          number("H_moes", "-", "film in Moes units over H", only_if(has_oil),
                 [](Of s) { return contact::H_to_moes_units(1.0, groups(s).M, groups(s).shape); })};
}

std::vector<Number> scale_numbers() {
  return {
      number(id::radius_ratio, "-", "R_x/R_y", only_if(elliptic), [](Of s) { return groups(s).shape.radius_ratio; }),
      number(id::angle, "degrees", "from the direction of R_x to the entrainment", only_if(elliptic),
             [](Of s) { return groups(s).shape.angle; }),
      number(id::kappa, "-", "b/a, the semi-axes along R_y and R_x", only_if(elliptic),
             [](Of s) { return groups(s).shape.kappa; }),
      number(id::kappa, "-", "half of the roller's length over a", only_if(rolls),
             [](Of s) { return groups(s).shape.kappa; }),
      number(id::a, "m", "Hertz radius, the scale of X and Y", only_if(in_SI), json("a_m"), in_si(131, "a", "um"),
             [](Of s) { return si(s).hertz.a; }),
      number(id::h, "m", "a^2/R, the scale of H", only_if(in_SI), not_json, [](Of s) { return si(s).hertz.h_scale; }),
      number(id::load, {"N", "N/m", true}, "normal load", only_if(in_SI), meaning_here(meaning_of_load), not_json,
             in_si(133, "load", ""), [](Of s) { return si(s).contact.load; }),
      number(id::R, "m", "reduced radius", only_if(in_SI), json("R_m"), [](Of s) { return si(s).contact.radius; }),
      number("E_prime", "Pa", "reduced modulus", only_if(in_SI), not_json, in_si(132, "E_prime", "GPa"),
             [](Of s) { return si(s).contact.E_prime; }),
      number("u1", "m/s", "speed of surface 1", only_if(moves), not_json, [](Of s) { return si(s).u1; }),
      number("u2", "m/s", "speed of surface 2", only_if(moves), not_json, [](Of s) { return si(s).u2; }),
      number(id::u_s, "m/s", "u1 + u2", only_if(moves), not_json, [](Of s) { return si(s).contact.u_s; }),
      number("u_m", "m/s", "mean of the surface speeds", only_if(moves), not_json, not_in_file, column_only_si(134),
             [](Of s) { return 0.5 * si(s).contact.u_s; }),
      number("eta0", "Pa s", "viscosity at ambient pressure", only_if(moves), not_json, in_si(135, "eta0", "mPa s"),
             [](Of s) { return si(s).contact.eta0; }),
      number("alpha", "1/Pa", "pressure coefficient of the viscosity", only_if(moves), only_column,
             in_si(136, "alpha", "1/GPa"), [](Of s) { return si(s).contact.alpha; }),
      number("temperature", "C", "temperature of oil and bodies", only_if(at_temperature),
             [](Of s) { return s.input.physics.ambient->T; }),
      number("rho0", "kg/m^3", "density of the oil at ambient pressure", only_if(at_temperature),
             [](Of s) { return s.input.physics.ambient->rho; }),
      number("b", "m", "semi-axis along R_y", only_if(elliptic_in_SI), not_json, [](Of s) { return si(s).hertz.b; }),
      number("R_y", "m", "reduced radius across R_x", only_if(elliptic_in_SI), not_json,
             [](Of s) { return si(s).contact.radius / si(s).contact.shape.radius_ratio; }),
      number(id::time, "s", "a/u_m, the scale of time", only_if(in_seconds), not_json,
             [](Of s) { return 1.0 / s.input.transient->second; })};
}

std::vector<Number> grid_numbers() {
  const auto cells = [](int steady::LevelRow::*of_level, int core::Grid::*of_grid) {
    return [=](Of s) {
      return solution(s).levels.empty() ? s.input.scene.grid.*of_grid : solution(s).levels.back().*of_level;
    };
  };
  return {
      number(id::nx, "-", "cells along x", only_column, column(204, 0), cells(&steady::LevelRow::nx, &core::Grid::nx)),
      number(id::ny, "-", "cells along y", only_column, column(205, 0), cells(&steady::LevelRow::ny, &core::Grid::ny))};
}

std::vector<Number> machine_numbers(const machines::Contact& machine) {
  std::vector<Number> list;
  for (const machines::Number& one : machine.numbers) {
    list.push_back(number(machine.section + "_" + one.name, one.unit.c_str(), one.formula,
                          json(machine.section + "/" + one.name), column(801), [name = one.name](Of s) {
                            const auto& known = s.input.machine->numbers;
                            const auto found = std::ranges::find(known, name, &machines::Number::name);
                            return found == known.end() ? core::unknown : found->value;
                          }));
  }
  return list;
}

std::vector<Number> row_numbers() {
  return {number(id::status, "",
                 "converged, not-converged (films, P_max and errors are NaN), refused (error in the deck of this "
                 "case), failed (the program)",
                 only_column, column(1, "failed")),
          number(id::exit_status, "", "exit status of `ehl run`", only_column, column(2, 0)),
          number(id::warnings, "", "names of the warnings", only_column, column(901, "none")),
          number(id::reason, "", "why there is no solution", only_column, column(902, ""))};
}

std::vector<Number> timing_numbers() {
  return {number(id::seconds, "s", "the whole case, one thread", only_column, column(301)),
          number(id::peak_memory, "bytes", "peak memory of the process", only_column, column(302))};
}

}  // namespace ehl::program::numbers
