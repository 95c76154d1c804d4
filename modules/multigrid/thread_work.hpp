#pragma once
// Work space of one thread. The level owns it, so that no cycle allocates.
#include <variant>
#include <vector>

#include "core/grid.hpp"
#include "core/simd.hpp"
#include "film/model.hpp"
#include "line_solvers/decimation.hpp"
#include "line_solvers/elimination.hpp"
#include "line_solvers/two_ended.hpp"
#include "multigrid/parameters.hpp"
#include "reynolds/cavitation.hpp"
#include "reynolds/row.hpp"

namespace ehl::multigrid {

template <int reach>
using EliminationFactors = std::vector<typename line_solvers::Elimination<reach>::Factors>;

/// The nodes of a line contact as contiguous arrays (line_contact.cpp); else empty.
struct LineNodes {
  std::vector<double> P, H, fluidity, log_viscosity, rho_bar, drho_bar, eps;
  std::vector<double> H_around;                                   ///< H, with one value beyond each boundary
  std::vector<double> fluidity_across{}, log_viscosity_across{};  ///< shear thinning: output of the laws, not used
};
LineNodes make_line_nodes(const core::Patch& grid, bool anisotropic);

template <int reach>
using OneLineFactors = std::vector<typename line_solvers::TwoEnded<reach>::Factors>;

/// The line system of a line contact, one value per node (line_relaxation.cpp); else empty.
struct LineSystem {
  using Values = std::vector<double>;
  /// Rows that are assembled together, the same number on every processor: the result depends on where the two ends of
  /// the elimination meet.
  static constexpr int block = 8;
  static_assert(block % core::lanes == 0);
  /// Entries before the first node and after the last, as far as the rows of the last block read.
  static constexpr int margin = block + line_solvers::max_reach + 2;

  Values P, rho_bar, rho_H, slope_H, eps, third_order, f, fluidity,
      log_viscosity;                    ///< at nodes; slope_H = drho_bar/dP H
  Values west;                          ///< epsilon/h^2 at the half point west of a node
  Values answer_before, answer_behind;  ///< derivatives of the viscosity there (film::answers)
  Values distributive, far_squeeze;     ///< as in ThreadWork
  Values delta, distributed;
  std::variant<OneLineFactors<1>, OneLineFactors<2>, OneLineFactors<3>> factors;
};
LineSystem make_line_system(const core::Patch& grid, int reach);

/// A row of the Y sweep's system of a column (across_relaxation.cpp). A node with weight 0 keeps its pressure.
struct RowAcross {
  double south = 0.0, own = 1.0, north = 0.0;  ///< d r/dP
  double r = 0.0;
  double weight = 0.0;
};

struct ThreadWork {
  film::Buffers film;
  LineNodes line_nodes;
  LineSystem line_system;
  /// One value per node of a column and one at each end: the film in epsilon on a coarse grid, or that of half points.
  std::vector<double> followed;
  std::vector<double> followed_behind;
  std::vector<RowAcross> rows_across;  ///< of the nodes of a column
  /// Derivatives of epsilon by P and H at the nodes of a column; with _across those of epsilon along Y if it differs.
  std::vector<double> eps_P, eps_H, eps_across_P, eps_across_H;

  // For the line systems of a batch; empty if line_system is used:
  /// Entries of `distributive` before and after the points of a line.
  static constexpr int margin = line_solvers::max_reach + 2;

  bool flows_aside = true;  ///< oil flows through the faces along Y
  double stretch = 1.0;     ///< hx/hy of stretched cells
  /// epsilon/h^2 at the half point west of point i, i = 1..nx, and south and north of point i.
  std::vector<core::Lanes> west, south, north;
  /// Epsilon at half points: the terms in the row of point i that arise because the viscosity follows the pressure.
  std::vector<reynolds::PressureRow<core::Lanes>> answers;
  /// The part of answers[i].own that comes from the face to the west.
  std::vector<core::Lanes> answers_west;
  /// Least and largest epsilon/(hx hy) at the half points around point i; a line contact has none along Y. Divided so,
  /// one epsilon gives the same number at every face of a stretched cell, hx = stretch hy.
  struct Range {
    core::Lanes low, high;
  };
  Range range_of(std::size_t i) const {
    const core::Lanes low = stretch * core::min(west[i], west[i + 1]);
    const core::Lanes high = stretch * core::max(west[i], west[i + 1]);
    if (!flows_aside) return {low, high};
    const double across = 1.0 / stretch;
    return {core::min(low, across * core::min(south[i], north[i])),
            core::max(high, across * core::max(south[i], north[i]))};
  }
  /// 1 where point i distributes its change; zero outside the line.
  std::vector<core::Lanes> distributive;
  /// How much single changes around point i squeeze out of its film, per change of its own and per density.
  std::vector<core::Lanes> far_squeeze;
  /// Storage of the chosen line solver: factors of the elimination, or blocks of the decimation.
  std::variant<EliminationFactors<1>, EliminationFactors<2>, EliminationFactors<3>, line_solvers::Decimation<1>,
               line_solvers::Decimation<2>, line_solvers::Decimation<3>>
      solver;
};

/// Work space for one grid. in: parameters.reach 1, 2 or 3.
ThreadWork make_thread_work(const core::Patch& grid, const film::Model& film, const RelaxationParameters& parameters,
                            reynolds::Cavitation cavitation = reynolds::Cavitation::nonnegative_pressure);

}  // namespace ehl::multigrid
