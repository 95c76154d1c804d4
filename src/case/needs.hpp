#pragma once
// What a case will need of the machine.
#include "case/scene.hpp"

namespace ehl::program {

/// What the case will need, nearly: for `check`, and to refuse what cannot fit.
struct Needs {
  double bytes = 0.0;
  double seconds = 0.0;
};

/// Of the basic model alone, and with the effects that the case calls for.
Needs basic_needs(const steady::Scene& scene);
Needs expected_needs(const Case& input);

/// Complains in the case's deck where the machine has not the memory for it.
void check_memory(Case& input);

}  // namespace ehl::program
