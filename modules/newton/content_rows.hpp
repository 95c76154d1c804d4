#pragma once
// Rows of the mass conserving cavitation model, with the oil content of dry (cavitated) nodes eliminated line by line:
// the flux downstream of a dry node equals the flux into it, and the next row contains that flux instead of the node's
// own film.
#include <array>
#include <vector>

#include "multigrid/hierarchy.hpp"
#include "reynolds/row.hpp"

namespace ehl::newton {

/// The coefficients of a node's row.
struct ContentRow {
  std::array<double, 4> weights;  ///< weights of rho_bar H at i, i-1, i-2, i+1
  std::array<double, 3> behind;   ///< weights of rho_bar H at i, i-1, i+1 in the flux downstream of a full node, over U
  reynolds::ThirdOrder<double> theta;
  bool dry;         ///< true if the node is not full
  bool behind_dry;  ///< true if its upstream neighbour is not full
};

/// The rows of a level for the oil content after its last residual evaluation.
class ContentRows {
 public:
  void make(const multigrid::Level& level, const reynolds::Transport& transport);
  const ContentRow& at(int i, int j) const {
    return rows_[static_cast<std::size_t>(i) * stride_ + static_cast<std::size_t>(j)];
  }

  /// Computes the change dr of the residual at all nodes. in: changes of rho_bar H and, with upstream3, of theta, else
  /// empty; d_inflow(i, j), the change of the inflow by pressure. out: take(i, j, dr).
  template <class Inflow, class Take>
  void change(const multigrid::Level& level, double per_step, const core::Field& dq, const core::Field& dtheta,
              Inflow d_inflow, Take take) const {
    const auto q = [&](int i, int j) { return level.rho_bar(i, j) * level.H(i, j); };
    for (int j = 1; j <= level.grid.last_line(); ++j) {
      double flux = 0.0;   // change of the flux downstream of i-1, over U, if that node is dry
      double third = 0.0;  // change of its third-order part if that node is full
      for (int i = 1; i < level.grid.nx; ++i) {
        const ContentRow& row = at(i, j);
        double third_here = 0.0;
        if (dtheta.nodes_x() > 0 && row.theta.east > 0.0)
          third_here = reynolds::third_order_part(dtheta(i, j), q(i - 1, j), q(i, j), q(i + 1, j));
        double dr = reynolds::transported(row.weights, reynolds::columns_at(i, [&](int k) { return dq(k, j); })) +
                    per_step * (third_here - (row.behind_dry ? flux : third)) - d_inflow(i, j);
        take(i, j, dr);
        const double behind =
            row.behind[0] * dq(i, j) + row.behind[1] * dq(i - 1, j) + row.behind[2] * dq(i + 1, j) + third_here;
        flux = row.dry ? behind - dr / per_step : 0.0;
        third = row.dry ? 0.0 : third_here;
      }
    }
  }

 private:
  std::vector<ContentRow> rows_;
  std::size_t stride_ = 0;
};

}  // namespace ehl::newton
