#pragma once
// Scenes of the hard cases, and the comparison of two solutions that should be equal.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "convergence/circular_scene.hpp"
#include "core/norms.hpp"
#include "steady/solution.hpp"

namespace hard {

struct Load {
  double M, L;
};

/// The scene of the reference tables (same fluid and domains) at another load: Roelands z = 0.68, Dowson-Higginson; the
/// deformation is exact up to rounding; relative residual 1e-10.
inline ehl::steady::Scene scene(Load load, int n, ehl::reynolds::Wedge wedge = ehl::reynolds::Wedge::upstream2) {
  ehl::steady::Scene scene =
      ehl::test::scene_of({load.M, load.L, ehl::reference::Fluid::roelands_z068, wedge, n, 0.0, 0.0, 0.0, 0.0});
  scene.deformation.method = ehl::mlmi::Method::fft;
  scene.solver.tolerance = 1e-10;
  scene.threads = 2;
  return scene;
}

inline std::string name(const ehl::steady::Scene& scene) {
  std::ostringstream text;
  text << "(" << scene.contact.M << "," << scene.contact.L << ") "
       << (scene.wedge == ehl::reynolds::Wedge::upstream1 ? "upstream1 " : "upstream2 ") << scene.grid.nx << " x "
       << scene.grid.ny;
  return text.str();
}

inline double relative(double value, double reference) { return std::abs(value / reference - 1.0); }

/// The largest of: the relative differences of Hc and Hm, and the differences of H00 and of P at any node.
inline double difference(const ehl::steady::Solution& a, const ehl::steady::Solution& b) {
  return std::max({std::abs(a.H00 - b.H00), relative(a.levels.back().Hc, b.levels.back().Hc),
                   relative(a.levels.back().Hm, b.levels.back().Hm), ehl::core::max_abs_difference(a.P, b.P)});
}

}  // namespace hard
