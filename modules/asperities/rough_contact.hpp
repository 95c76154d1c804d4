#pragma once
// The dry contact of a rough cell with a smooth, rigid plane; all elasticity is in E'.
#include <vector>

#include "asperities/cosine_transform.hpp"

namespace ehl::asperities {

/// A rough surface on a cell. The heights have no mean.
struct RoughCell {
  Cell cell{};
  std::vector<double> z{};  ///< heights, positive towards the other surface [m]
  double E_prime = 0.0;     ///< [Pa]
  double hardness = 0.0;    ///< largest pressure [Pa]; infinity: elastic
  int threads = 1;
};

/// The contact under one mean pressure.
struct CellContact {
  std::vector<double> p{};    ///< [Pa]
  std::vector<double> gap{};  ///< [m]; zero in contact; negative by the depth of yielding where p is the hardness
  double separation = 0.0;    ///< distance of the mean planes of the deformed surfaces [m], the mean of `gap`
  double film = 0.0;          ///< mean of the open gap [m]; above the separation only where the surface has yielded
  double area = 0.0;          ///< share in contact, corrected for the size of the points
  double yielded = 0.0;       ///< share of the points whose pressure is the hardness
  double error = 0.0;         ///< how far the conditions below are violated, see solve()
  int iterations = 0;
  bool converged = false;
};

/// Solves, for a mean pressure,
///
///   gap = separation - z + u(p),   0 <= p <= hardness,   gap = 0 where 0 < p < hardness,
///   gap >= 0 where p = 0,  gap <= 0 where p = hardness
///
/// The error is the mean of |gap| in contact, weighted with the pressure, plus the mean overlap outside it, both over
/// the root mean square height. Method: conjugate gradients with projection, preconditioned by the response of the
/// whole cell, so that near full contact the number of iterations hardly grows with the range of scales. in: start: a
/// pressure to begin with; empty: the mean everywhere. limits: 0 < mean_pressure < hardness. cost: three cosine
/// transforms each way per iteration. source: Polonsky and Keer (1999), Wear 231, 206, with the mean pressure kept by
/// scaling; the hardness as a second bound is treated like the first one. What this has not solved in 200 iterations
/// because of the hardness is left to an accelerated projected gradient.
CellContact solve(const RoughCell& rough, double mean_pressure, const std::vector<double>& start, double tolerance,
                  int max_iterations);

}  // namespace ehl::asperities
