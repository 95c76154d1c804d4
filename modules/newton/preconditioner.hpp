#pragma once
// The preconditioner of Newton's linear systems: a sparse LU of the Jacobian without the far reach of the elastic
// deformation.
#include <cstddef>
#include <limits>
#include <memory>
#include <span>

#include "newton/equations.hpp"
#include "newton/slopes.hpp"

namespace ehl::newton {

/// Solves J~ x = v, where J~ is the Jacobian with K cut to its self term K_00, bordered by H00 and the load row. Of a
/// line contact of a few hundred nodes it is the Jacobian itself: the logarithm has no near part.
class Preconditioner {
 public:
  /// The numbers of a line contact's dense factors: of single precision they cost half, and leave 1e-4 of the residual
  /// or less.
  enum class Precision { twice, single };
  /// The Jacobian of a line contact is made and factored as a whole up to so many unknowns, in a second; a caller whose
  /// factors serve many systems takes any number.
  static constexpr std::size_t most_dense = 600;
  static constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max();
  explicit Preconditioner(Equations& equations, Precision of_dense = Precision::twice,
                          std::size_t dense_up_to = most_dense);
  ~Preconditioner();

  /// Factors J~ at the equations' point of linearization. false: singular.
  bool factor();
  /// The same, the slopes there already made.
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
