#include "newton/equations.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "film/half_points.hpp"
#include "reynolds/row.hpp"

namespace ehl::newton {

Equations::Equations(multigrid::Hierarchy& hierarchy, std::size_t l)
    : hierarchy_(hierarchy),
      level_(hierarchy.levels[l]),
      nodes_(static_cast<std::size_t>(level_.grid.nx - 1) * static_cast<std::size_t>(level_.grid.last_line())),
      threads_(hierarchy.threads_on(level_.grid)),
      scale_(nodes_, 1.0),
      wet_(nodes_, 0),
      along_{core::Field(level_.grid), core::Field(level_.grid), core::Field(level_.grid)},
      dq_dP_(level_.grid),
      local_{core::Field(level_.grid), core::Field(level_.grid), {}, {}, {}},
      dP_(level_.grid),
      dH_(level_.grid) {
  if (at_half_points()) {
    along_.dH00 = core::Field(level_.grid);
    local_.eps_behind = local_.eps_across_behind = core::Field(level_.grid);
  }
  if (switched()) dtheta_ = core::Field(level_.grid);
  if (touching()) {
    touch_.assign(nodes_, Touch::none);
    dtotal_ = core::Field(level_.grid);
  }
  if (!two_epsilons()) return;
  across_ = along_;
  local_.eps_across = core::Field(level_.grid);
}

void Equations::make_scale() {
  const reynolds::NodeRows rows = this->rows();
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j) {
      const double response = own_response(i, j);
      const double dq = response > 0.0 ? level_.rho_bar(i, j) * response : level_.drho_bar(i, j) * level_.H(i, j);
      scale_[index(i, j)] = 1.0 / reynolds::diagonal(rows.wedge(i), rows.faces(i, j), dq);
    }
}

void Equations::unknowns(std::span<double> u) {
  multigrid::update_residual(hierarchy_, level_);
  if (touching()) find_touching();
  make_scale();
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j) {
      const std::size_t k = index(i, j);
      const double P = level_.P(i, j);
      u[k] = P > 0.0 ? P : std::min(0.0, -scale_[k] * level_.r(i, j));
    }
  if (touching()) touching_unknowns(u);
  u.back() = hierarchy_.H00;
}

void Equations::set_state(std::span<const double> u) {
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j) level_.P(i, j) = std::max(u[index(i, j)], 0.0);
  core::fill_ghosts(grid(), level_.P);
  if (touching()) set_touching(u);
  hierarchy_.H00 = u.back();
  multigrid::update_film(hierarchy_, level_);
}

void Equations::residual(std::span<const double> u, std::span<double> F) {
  set_state(u);
  multigrid::update_residual(hierarchy_, level_);
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j) {
      const std::size_t k = index(i, j);
      F[k] = scale_[k] * level_.r(i, j) + std::min(u[k], 0.0);
    }
  if (touching()) touching_residual(u, F);
  F.back() = (multigrid::carried_load(level_) - multigrid::wanted_load(hierarchy_, level_)) / level_.load;
}

void Equations::linearize(std::span<const double> u) {
  const film::Model& model = hierarchy_.problem.film;
  film::Buffers buffers = film::make_buffers(model, grid().nodes_y());
  const auto none = std::span<double>{};
  for (int i = 0; i <= grid().nx; ++i) {
    const auto known = [i](const core::Field& field) {
      return field.nodes_x() > 0 ? field.station(i) : std::span<const double>{};
    };
    const film::Station station = multigrid::station_of(hierarchy_, level_, i, known(level_.P), known(level_.H));
    if (at_half_points())
      film::oil_slopes(model, station, buffers,
                       {along_.dP.station(i), along_.dH.station(i), anisotropic() ? across_.dP.station(i) : none,
                        anisotropic() ? across_.dH.station(i) : none});
    else
      film::slopes(model, station,
                   {known(level_.eps), known(level_.eps_across), known(level_.rho_bar), known(level_.drho_bar)},
                   buffers,
                   {along_.dP.station(i), along_.dH.station(i), anisotropic() ? across_.dP.station(i) : none,
                    anisotropic() ? across_.dH.station(i) : none});
    for (int j = 0; j <= grid().ny; ++j) {
      const double self = own_response(i, j);
      dq_dP_(i, j) = level_.drho_bar(i, j) * level_.H(i, j);
      local_.q(i, j) = dq_dP_(i, j) + self * level_.rho_bar(i, j);
      if (at_half_points()) continue;
      local_.eps(i, j) = along_.dP(i, j) + self * along_.dH(i, j);
      if (anisotropic()) local_.eps_across(i, j) = across_.dP(i, j) + self * across_.dH(i, j);
    }
  }
  if (at_half_points()) linearize_half_points();
  if (touching()) make_moved();
  for (std::size_t k = 0; k < nodes_; ++k) wet_[k] = u[k] > 0.0 ? 1 : 0;
  if (multigrid::conserves_mass(level_)) content_rows_.make(level_, transport());
}

template <class At>
double Equations::half_point_change(bool along_x, int i, int j, At at) const {
  const core::Patch& grid = level_.grid;
  const multigrid::OilFields& oil = level_.oil;
  const bool thinned = !along_x && anisotropic();
  const core::Field& fluidity = thinned ? oil.fluidity_across : oil.fluidity;
  const core::Field& log_viscosity = thinned ? oil.log_viscosity_across : oil.log_viscosity;
  const Epsilon& slopes = thinned ? across_ : along_;
  film::AroundHalfPoint<double> here{}, change{};
  const auto place = [&](int k) { return along_x ? std::pair(i + k, j) : std::pair(i, grid.holder(j + k)); };
  for (int k = 0; k < 2; ++k) {
    const auto [ki, kj] = place(k);
    const auto m = static_cast<std::size_t>(k);
    const NodeChange node = at(ki, kj);
    here.rho_bar[m] = level_.rho_bar(ki, kj);
    here.fluidity[m] = fluidity(ki, kj);
    here.log_viscosity[m] = log_viscosity(ki, kj);
    change.rho_bar[m] = level_.drho_bar(ki, kj) * node.dP;
    change.log_viscosity[m] = slopes.dP(ki, kj) * node.dP + slopes.dH(ki, kj) * node.dH;
  }
  const int last = along_x ? grid.nx : grid.domain.ny;
  const int first = along_x ? i : j;
  const auto beside = [&](int k) {
    const auto [ki, kj] = place(k);
    return std::pair(level_.H(ki, kj), at(ki, kj).dH);
  };
  for (int k = -1; k < 3; ++k) {
    const auto m = static_cast<std::size_t>(k + 1);
    if (first + k >= 0 && first + k <= last) {
      std::tie(here.H[m], change.H[m]) = beside(k);
    } else {
      const int inward = k < 0 ? 1 : -1;
      const auto [a, da] = beside(k + inward);
      const auto [b, db] = beside(k + 2 * inward);
      const auto [c, dc] = beside(k + 3 * inward);
      here.H[m] = film::beyond_boundary(a, b, c);
      change.H[m] = film::beyond_boundary(da, db, dc);
    }
  }
  return film::epsilon_change(here, change, multigrid::between(hierarchy_.problem));
}

void Equations::linearize_half_points() {
  const core::Patch& grid = level_.grid;
  const auto write = [&](bool along_x, int i, int j, core::Field& before, core::Field& behind, core::Field& dH00) {
    const auto alone = [&](int here_i, int here_j) {
      return [here_i, line = level_.grid.holder(here_j), self = own_response(here_i, here_j)](int ki, int kj) {
        return ki == here_i && kj == line ? NodeChange{1.0, self} : NodeChange{};
      };
    };
    before(i, j) = half_point_change(along_x, i, j, alone(i, j));
    behind(i, j) = half_point_change(along_x, i, j, along_x ? alone(i + 1, j) : alone(i, j + 1));
    dH00(i, j) = half_point_change(along_x, i, j, [this](int ki, int kj) { return NodeChange{0.0, moves(ki, kj)}; });
  };
  for (int i = 0; i <= grid.nx; ++i)
    for_lines([&](int j) {
      if (i < grid.nx) write(true, i, j, local_.eps, local_.eps_behind, along_.dH00);
      if (flows_across(j)) write(false, i, j, local_.eps_across, local_.eps_across_behind, across_.dH00);
    });
}

Equations::NodeEpsilon Equations::node_epsilon(int i, int j, NodeChange node) const {
  if (!at_half_points()) return {level_.eps(i, j), along_.dP(i, j) * node.dP + along_.dH(i, j) * node.dH};
  const double H = level_.H(i, j);
  if (H <= 0.0) return {};
  const double rho = level_.rho_bar(i, j);
  const double value = rho * H * H * H * level_.oil.fluidity(i, j) / hierarchy_.problem.film.lambda;
  const double relative =
      level_.drho_bar(i, j) / rho * node.dP + 3.0 / H * node.dH - along_.dP(i, j) * node.dP - along_.dH(i, j) * node.dH;
  return {value, value * relative};
}

template <class At>
void Equations::change_third_order(At at) {
  const core::Patch& grid = level_.grid;
  const reynolds::ThirdOrderShare share(transport(), grid.hx());
  for (int i = 1; i < grid.nx; ++i)
    for_lines([&](int j) {
      const NodeEpsilon before = node_epsilon(i, j, at(i, j));
      const NodeEpsilon behind = node_epsilon(i + 1, j, at(i + 1, j));
      dtheta_(i, j) = share.change(before.value, behind.value, before.change, behind.change);
    });
}

void Equations::change_of_residual(const core::Field& dP, core::Field& dH, std::span<double> dr) {
  const core::Patch& grid = level_.grid;
  const auto at = [&](int i, int j) { return NodeChange{dP(i, j), dH(i, j)}; };
  for (int i = 0; i <= grid.nx; ++i)
    for_lines([&](int j) {
      if (!at_half_points()) {
        along_.change(i, j) = along_.dP(i, j) * dP(i, j) + along_.dH(i, j) * dH(i, j);
        if (anisotropic()) across_.change(i, j) = across_.dP(i, j) * dP(i, j) + across_.dH(i, j) * dH(i, j);
        return;
      }
      if (i < grid.nx) along_.change(i, j) = half_point_change(true, i, j, at);
      if (flows_across(j)) across_.change(i, j) = half_point_change(false, i, j, at);
    });
  if (switched()) change_third_order(at);
  core::Field& dq = dH;  // dH is no longer needed: its storage holds d (rho_bar H)
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) dq(i, j) = dq_dP_(i, j) * dP(i, j) + level_.rho_bar(i, j) * dH(i, j);
  core::fill_ghosts(grid, along_.change);
  if (anisotropic() && !at_half_points()) core::fill_ghosts(grid, across_.change);
  const core::Field& deps = along_.change;
  const core::Field& deps_across = two_epsilons() ? across_.change : along_.change;
  const core::Field& P = level_.P;
  const reynolds::NodeRows rows = this->rows();
  const auto dpoiseuille = [&](int i, int j) {
    const auto de = reynolds::faces_at(face(), deps, deps_across, i, j, rows.half());
    return reynolds::poiseuille(de, reynolds::cross_at(P, i, j));
  };
  const reynolds::Transport transport = this->transport();
  if (multigrid::conserves_mass(level_)) {
    const auto d_inflow = [&](int i, int j) {
      return reynolds::poiseuille(rows.faces(i, j), reynolds::cross_at(dP, i, j)) + dpoiseuille(i, j);
    };
    content_rows_.change(level_, transport.speed / grid.hx(), dq, dtheta_, d_inflow,
                         [&](int i, int j, double change) { dr[index(i, j)] = change; });
    return;
  }
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) {
      const auto dQ = reynolds::columns_at(i, [&](int k) { return dq(k, j); });
      double& change = dr[index(i, j)];
      change = reynolds::residual(rows.weights(i, j), rows.faces(i, j), dQ, reynolds::cross_at(dP, i, j)) -
               dpoiseuille(i, j);
      if (switched()) {
        const auto dw =
            reynolds::third_order_weights<double>({}, transport, grid.hx(), {dtheta_(i - 1, j), dtheta_(i, j)});
        change += reynolds::transported(dw, rows.Q(i, j));
      }
    }
}

void Equations::deform(const core::Field& p, core::Field& w) {
  const core::ScopedTimer timer(hierarchy_.times, core::Part::deformation);
  level_.deformation.evaluate(p, w);
  ++level_.evaluations;
}

void Equations::jacobian(std::span<const double> v, std::span<double> Jv) {
  const core::Patch& grid = level_.grid;
  double dload = 0.0;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) {
      dP_(i, j) = wet_[index(i, j)] ? v[index(i, j)] : 0.0;
      dload += grid.lines(j) * dP_(i, j);
    }
  core::fill_ghosts(grid, dP_);
  if (touching()) dload += add_touching(v, dP_);
  deform(touching() ? dtotal_ : dP_, dH_);
  const double dH00 = v.back();
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) dH_(i, j) += dH00;
  if (touching()) touching_rows(v, dH_, Jv);
  change_of_residual(dP_, dH_, Jv);
  for (std::size_t k = 0; k < nodes_; ++k) Jv[k] = scale_[k] * Jv[k] + (wet_[k] ? 0.0 : v[k]);
  Jv.back() = grid.hx() * grid.hy() * dload / level_.load + load_by_H00() * dH00;
}

}  // namespace ehl::newton
