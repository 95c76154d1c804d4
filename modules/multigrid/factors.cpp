#include "multigrid/factors.hpp"

#include "transfer/transfer.hpp"

namespace ehl::multigrid {
namespace {

void restrict_to_corrector(Level& fine, Level& coarse) {
  for (const auto field :
       {&film::FactorFields::fluidity, &film::FactorFields::mobility, &film::FactorFields::mobility_across}) {
    core::fill_ghosts(fine.grid, *fine.factors.*field);
    transfer::restrict_full_weighting(coarse.grid, *fine.factors.*field, *coarse.factors.*field);
  }
  transfer::restrict_injection(fine.factors->carried, coarse.factors->carried);
}

}  // namespace

void restrict_factors(Hierarchy& hierarchy, std::size_t l) {
  Level* fine = &hierarchy.levels[l];
  while (Level* coarse = corrector_of(hierarchy, *fine)) {
    restrict_to_corrector(*fine, *coarse);
    fine = coarse;
  }
}

void set_factors(Hierarchy& hierarchy, std::size_t l, const film::FactorFields& factors) {
  *hierarchy.levels[l].factors = factors;
  restrict_factors(hierarchy, l);
}

}  // namespace ehl::multigrid
