// The film of a level, and its coefficients.
#include <omp.h>

#include <algorithm>
#include <array>
#include <utility>

#include "film/half_points.hpp"
#include "multigrid/hierarchy.hpp"
#include "multigrid/line_contact.hpp"
#include "multigrid/thread_work.hpp"
#include "reynolds/flux.hpp"

namespace ehl::multigrid {
namespace {

// One column (constant X): epsilon, rho_bar and its derivative from P and H.
void coefficients_of_station(const Hierarchy& hierarchy, Level& level, int i, ThreadWork& work) {
  auto followed = std::as_const(level.H).station(i);
  if (corrects_finer(level)) {
    const auto finer = std::as_const(level.finer->H).station(i);
    for (std::size_t j = 0; j < followed.size(); ++j)
      work.followed[j] = std::max(followed[j], level.finer->H_floor * finer[j]);
    followed = std::span<const double>(work.followed).first(followed.size());
  }
  const film::Model& model = hierarchy.problem.film;
  const bool anisotropic = film::anisotropic(model);
  film::coefficients(model, station_of(hierarchy, level, i, std::as_const(level.P).station(i), followed), work.film,
                     {.eps = level.eps.station(i),
                      .eps_across = anisotropic ? level.eps_across.station(i) : std::span<double>{},
                      .rho_bar = level.rho_bar.station(i),
                      .drho_bar = level.drho_bar.station(i)});
  core::fill_ghosts(level.grid, level.eps.at_x(i));
  if (anisotropic) core::fill_ghosts(level.grid, level.eps_across.at_x(i));
}

// One column with epsilon at half points: the nodal values from which that is computed.
void oil_of_station(const Hierarchy& hierarchy, Level& level, int i, ThreadWork& work) {
  OilFields& oil = level.oil;
  const auto of = [i](core::Field& field) { return field.nodes_x() > 0 ? field.station(i) : std::span<double>{}; };
  film::oil(hierarchy.problem.film,
            station_of(hierarchy, level, i, std::as_const(level.P).station(i), std::as_const(level.H).station(i)),
            work.film,
            {.fluidity = of(oil.fluidity),
             .log_viscosity = of(oil.log_viscosity),
             .fluidity_across = of(oil.fluidity_across),
             .log_viscosity_across = of(oil.log_viscosity_across),
             .rho_bar = level.rho_bar.station(i),
             .drho_bar = level.drho_bar.station(i)});
  for (core::Field* field : {&oil.fluidity, &oil.log_viscosity, &oil.fluidity_across, &oil.log_viscosity_across})
    if (field->nodes_x() > 0) core::fill_ghosts(level.grid, field->at_x(i));
}

// H of column k; outside the domain extrapolated from the boundary column `beside` and the inner columns from `behind`
// on.
std::span<const double> film_at(const Level& level, int k, int beside, int behind, ThreadWork& work) {
  if (k >= 0 && k <= level.grid.nx) return level.H.station(k);
  const double* at = level.H.at_x(beside);
  const double* next = level.H.at_x(behind);
  const double* third = level.H.at_x(2 * behind - beside);
  const auto nodes = static_cast<std::size_t>(level.grid.nodes_y());
  for (std::size_t j = 0; j < nodes; ++j) work.followed[j] = film::beyond_boundary(at[j], next[j], third[j]);
  return std::span<const double>(work.followed).first(nodes);
}

// epsilon between columns i and i + 1, from the nodes of the four columns around.
void epsilon_behind_station(const film::Between& how, Level& level, int i, ThreadWork& work) {
  const OilFields& oil = level.oil;
  const auto two = [i](const core::Field& field) { return std::array{field.station(i), field.station(i + 1)}; };
  film::epsilon_between_stations({{film_at(level, i - 1, i, i + 1, work), std::as_const(level.H).station(i),
                                   std::as_const(level.H).station(i + 1), film_at(level, i + 2, i + 1, i, work)},
                                  two(level.rho_bar),
                                  two(oil.fluidity),
                                  two(oil.log_viscosity)},
                                 how, level.eps.station(i));
  core::fill_ghosts(level.grid, level.eps.at_x(i));
}

// epsilon between the nodes of column i.
void epsilon_on_station(const film::Between& how, Level& level, int i, ThreadWork& work) {
  const core::Patch& grid = level.grid;
  const OilFields& oil = level.oil;
  const bool thinned = oil.fluidity_across.nodes_x() > 0;
  const double* H = level.H.at_x(i);
  const int last = grid.ny;
  work.followed.front() = film::beyond_boundary(H[0], H[1], H[2]);
  std::copy_n(H, grid.nodes_y(), work.followed.begin() + 1);
  work.followed.back() =
      grid.north == core::Edge::mirror ? H[last + 1] : film::beyond_boundary(H[last], H[last - 1], H[last - 2]);
  film::epsilon_between_nodes({.H = work.followed,
                               .rho_bar = std::as_const(level.rho_bar).station(i),
                               .fluidity = (thinned ? oil.fluidity_across : oil.fluidity).station(i),
                               .log_viscosity = (thinned ? oil.log_viscosity_across : oil.log_viscosity).station(i)},
                              how, level.eps_across.station(i));
  if (grid.north != core::Edge::mirror) return;
  double* eps = level.eps_across.at_x(i);
  for (int k = 0; k < core::ghost_lines; ++k) eps[last + k] = eps[last - 1 - k];
}

template <class Station>
void for_stations(Hierarchy& hierarchy, Level& level, Station station) {
  const int threads = hierarchy.threads_on(level.grid);
  const int last = level.grid.nx;
#pragma omp parallel num_threads(threads) if (threads > 1)
  {
    ThreadWork& work = level.thread_work[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(static)
    for (int i = 0; i <= last; ++i) station(i, work);
  }
}

void nodes_of_station(const Hierarchy& hierarchy, Level& level, int i, ThreadWork& work) {
  core::fill_ghosts(level.grid, level.H.at_x(i));
  if (at_half_points(level))
    oil_of_station(hierarchy, level, i, work);
  else
    coefficients_of_station(hierarchy, level, i, work);
}

// epsilon at the nodes of column i, whether level.eps holds nodes or half points.
std::span<const double> nodes_epsilon(double lambda, const Level& level, int i, std::vector<double>& work) {
  if (!at_half_points(level)) return level.eps.station(i);
  const auto nodes = static_cast<std::size_t>(level.grid.nodes_y());
  const std::span<double> eps = std::span<double>(work).first(nodes);
  film::epsilon(level.H.station(i), level.rho_bar.station(i), level.oil.fluidity.station(i), lambda, eps);
  return eps;
}

void third_order_behind_station(const reynolds::Transport& transport, double lambda, Level& level, int i,
                                ThreadWork& work) {
  const core::Patch& grid = level.grid;
  const auto theta = level.third_order.station(i);
  if (transport.wedge == reynolds::Wedge::upstream3_inlet) {
    std::ranges::fill(theta, reynolds::third_order_in_inlet(grid.X(i) + 0.5 * grid.hx()));
  } else {
    const reynolds::ThirdOrderShare share(transport, grid.hx());
    const auto before = nodes_epsilon(lambda, level, i, work.followed);
    const auto behind = nodes_epsilon(lambda, level, i + 1, work.followed_behind);
    for (std::size_t j = 0; j < theta.size(); ++j) theta[j] = share(before[j], behind[j]);
  }
  core::fill_ghosts(grid, level.third_order.at_x(i));
}

// The values of the faces, once all nodes have theirs.
void make_half_points(Hierarchy& hierarchy, Level& level) {
  const reynolds::Transport transport = transport_on(hierarchy, level);
  const bool third_order = reynolds::third_order(transport.wedge);
  if (!at_half_points(level) && !third_order) return;
  const film::Between how = between(hierarchy.problem);
  for_stations(hierarchy, level, [&](int i, ThreadWork& work) {
    // The first face lacks a third node.
    if (third_order && i > 0 && i < level.grid.nx) third_order_behind_station(transport, how.lambda, level, i, work);
    if (!at_half_points(level)) return;
    if (i < level.grid.nx) epsilon_behind_station(how, level, i, work);
    epsilon_on_station(how, level, i, work);
  });
}

// Touching::total of the present pressures.
void add_pressures(Level& level) {
  if (!level.touching) return;
  Touching& touching = *level.touching;
  for (int i = 0; i <= level.grid.nx; ++i)
    for (int j = 0; j <= level.grid.ny; ++j) touching.total(i, j) = level.P(i, j) + touching.P_c(i, j);
  core::fill_ghosts(level.grid, touching.total);
}

}  // namespace

void update_coefficients(Hierarchy& hierarchy, Level& level) {
  const core::ScopedTimer timer(hierarchy.times, core::Part::coefficients);
  if (along_one_line(hierarchy, level)) return coefficients_along_line(hierarchy, level);
  for_stations(hierarchy, level, [&](int i, ThreadWork& work) { nodes_of_station(hierarchy, level, i, work); });
  make_half_points(hierarchy, level);
}

void update_film(Hierarchy& hierarchy, Level& level) {
  ++level.evaluations;
  add_pressures(level);
  if (along_one_line(hierarchy, level)) return film_along_line(hierarchy, level);
  {
    const core::ScopedTimer timer(hierarchy.times, core::Part::deformation);
    level.deformation.evaluate(pressure_on_bodies(level), level.H);
  }
  const core::ScopedTimer timer(hierarchy.times, core::Part::coefficients);
  const core::Patch& grid = level.grid;
  for_stations(hierarchy, level, [&](int i, ThreadWork& work) {
    double* H = level.H.at_x(i);
    for (int j = 0; j <= grid.ny; ++j) H[j] += rigid_gap(hierarchy.problem.geometry, grid, hierarchy.H00, i, j);
    if (level.F.nodes_x() > 0) {
      const double* F = level.F.at_x(i);
      for (int j = 0; j <= grid.ny; ++j) H[j] += F[j];
    }
    if (level.touching && level.touching->yielded.nodes_x() > 0) {
      const double* yielded = level.touching->yielded.at_x(i);
      for (int j = 0; j <= grid.ny; ++j) H[j] += yielded[j];
    }
    nodes_of_station(hierarchy, level, i, work);
  });
  make_half_points(hierarchy, level);
}

}  // namespace ehl::multigrid
