#pragma once
// The preconditioner of Newton's linear systems: a sparse LU of the Jacobian without the long-range elastic
// deformation.
#include <cstddef>
#include <limits>
#include <memory>
#include <span>

#include "newton/equations.hpp"
#include "newton/slopes.hpp"

namespace ehl::newton {

/// Solves J~ x = v, where J~ is the Jacobian with K reduced to its self term K_00, bordered by H00 and the load row.
/// For a line contact of a few hundred nodes J~ is the exact Jacobian, because its logarithmic kernel has no dominant
/// near part.
class Preconditioner {
 public:
  /// Precision of the dense factors of a line contact; single precision halves their cost.
  /// [bench: precision_of_line_factors]
  enum class Precision { twice, single };
  /// Most unknowns for which the Jacobian of a line contact is built and factored as a whole. any_size serves callers
  /// that reuse the factors for many systems. [bench: most_dense]
  static constexpr std::size_t most_dense = 600;
  static constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max();
  explicit Preconditioner(Equations& equations, Precision of_dense = Precision::twice,
                          std::size_t dense_up_to = most_dense);
  ~Preconditioner();

  /// Factors J~ at the equations' point of linearization. out: false if it is singular.
  bool factor();
  /// Factors J~ from derivatives that are known already.
  bool factor(const Slopes& by_P, const Slopes& by_H);
  /// v <- J~^-1 v.
  void solve(std::span<double> v);
  /// v <- J~^-T v.
  void solve_transposed(std::span<double> v);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ehl::newton
