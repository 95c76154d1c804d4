#include "core/timer.hpp"

namespace ehl::core {

const char* name(Part part) {
  switch (part) {
    case Part::deformation: return "elastic deformation";
    case Part::coefficients: return "viscosity, density, epsilon";
    case Part::residual: return "residual";
    case Part::line_solve: return "line relaxation";
    case Part::transfer: return "grid transfer";
    case Part::coarsest: return "coarsest grid";
    case Part::heat: return "temperature";
    case Part::checks: return "checks";
    case Part::errors: return "adjoint error estimate";
    case Part::setup: return "set-up";
    case Part::count: break;
  }
  return "?";
}

void add(const PartTimes& more, PartTimes& what) {
  for (std::size_t k = 0; k < what.seconds.size(); ++k) what.seconds[k] += more.seconds[k];
}

}  // namespace ehl::core
