#include "multigrid/line_contact.hpp"

#include <algorithm>
#include <span>

#include "core/store_lines.hpp"
#include "film/half_points.hpp"
#include "multigrid/thread_work.hpp"
#include "reynolds/flux.hpp"

namespace ehl::multigrid {
namespace {

// The film in epsilon: on a correcting grid at least the share H_floor of the finer grid's.
void hold_film(const Level& level, std::vector<double>& H) {
  if (!corrects_finer(level)) return;
  for (std::size_t i = 0; i < H.size(); ++i)
    H[i] = std::max(H[i], level.finer->H_floor * level.finer->H(static_cast<int>(i), 1));
}

void epsilon_behind_nodes(const film::Between& how, LineNodes& nodes, std::span<double> eps) {
  const std::vector<double>& H = nodes.H;
  std::vector<double>& H_around = nodes.H_around;
  const std::size_t faces = H.size() - 1;
  H_around.front() = film::beyond_boundary(H[0], H[1], H[2]);
  std::ranges::copy(H, H_around.begin() + 1);
  H_around.back() = film::beyond_boundary(H[faces], H[faces - 1], H[faces - 2]);
  const auto from = [faces](const std::vector<double>& values, std::size_t first) {
    return std::span<const double>(values).subspan(first, faces);
  };
  const auto two = [&](const std::vector<double>& values) { return std::array{from(values, 0), from(values, 1)}; };
  film::epsilon_between_stations({{from(H_around, 0), from(H_around, 1), from(H_around, 2), from(H_around, 3)},
                                  two(nodes.rho_bar),
                                  two(nodes.fluidity),
                                  two(nodes.log_viscosity)},
                                 how, eps);
}

void third_order_behind_nodes(const reynolds::Transport& transport, std::span<const double> eps, Level& level) {
  const double hx = level.grid.hx();
  const reynolds::ThirdOrderShare share(transport, hx);
  // The first face lacks a third node.
  for (int i = 1; i < level.grid.nx; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double theta = transport.wedge == reynolds::Wedge::upstream3_inlet
                             ? reynolds::third_order_in_inlet(level.grid.X(i) + 0.5 * hx)
                             : share(eps[k], eps[k + 1]);
    core::fill_lines(level.third_order.at_x(i), theta);
  }
}

}  // namespace

LineNodes make_line_nodes(const core::Patch& grid, bool anisotropic) {
  const std::vector<double> zero(static_cast<std::size_t>(grid.nodes_x()));
  LineNodes nodes{zero, zero, zero, zero, zero, zero, zero, std::vector<double>(zero.size() + 2)};
  if (anisotropic) nodes.fluidity_across = nodes.log_viscosity_across = zero;
  return nodes;
}

bool along_one_line(const Hierarchy& hierarchy, const Level& level) {
  const film::Model& model = hierarchy.problem.film;
  return level.grid.domain.line && !model.given_epsilon;
}

namespace {

// in: P and H of the nodes. H may be replaced by the film in epsilon.
void coefficients_of_nodes(Hierarchy& hierarchy, Level& level) {
  const film::Model& model = hierarchy.problem.film;
  ThreadWork& work = level.thread_work.front();
  LineNodes& nodes = work.line_nodes;
  const bool half_points = at_half_points(level);
  const film::Station line = station_of(hierarchy, level, 0, nodes.P, nodes.H, true);
  if (half_points) {
    film::oil(model, line, work.film,
              {.fluidity = nodes.fluidity,
               .log_viscosity = nodes.log_viscosity,
               .fluidity_across = nodes.fluidity_across,
               .log_viscosity_across = nodes.log_viscosity_across,
               .rho_bar = nodes.rho_bar,
               .drho_bar = nodes.drho_bar});
    core::store_line(nodes.fluidity, level.oil.fluidity);
    core::store_line(nodes.log_viscosity, level.oil.log_viscosity);
  } else {
    hold_film(level, nodes.H);
    film::coefficients(
        model, line, work.film,
        {.eps = nodes.eps, .eps_across = nodes.fluidity_across, .rho_bar = nodes.rho_bar, .drho_bar = nodes.drho_bar});
    core::store_line(nodes.eps, level.eps);
  }
  core::store_line(nodes.rho_bar, level.rho_bar);
  core::store_line(nodes.drho_bar, level.drho_bar);
  const reynolds::Transport transport = transport_on(hierarchy, level);
  const film::Between how = between(hierarchy.problem);
  if (reynolds::third_order(transport.wedge)) {
    if (half_points) film::epsilon(nodes.H, nodes.rho_bar, nodes.fluidity, how.lambda, nodes.eps);
    third_order_behind_nodes(transport, nodes.eps, level);
  }
  if (!half_points) return;
  const std::span<double> faces = std::span<double>(nodes.eps).first(nodes.eps.size() - 1);
  epsilon_behind_nodes(how, nodes, faces);
  core::store_line(faces, level.eps);
}

}  // namespace

void coefficients_along_line(Hierarchy& hierarchy, Level& level) {
  LineNodes& nodes = level.thread_work.front().line_nodes;
  core::load_line(level.P, nodes.P);
  core::load_line(level.H, nodes.H);
  coefficients_of_nodes(hierarchy, level);
}

void film_along_line(Hierarchy& hierarchy, Level& level) {
  LineNodes& nodes = level.thread_work.front().line_nodes;
  core::load_line(pressure_on_bodies(level), nodes.P);
  {
    const core::ScopedTimer timer(hierarchy.times, core::Part::deformation);
    level.deformation.evaluate_along(nodes.P, nodes.H);
  }
  const core::ScopedTimer timer(hierarchy.times, core::Part::coefficients);
  const bool with_F = level.F.nodes_x() > 0;
  // rigid_gap() where Y = 0
  const double H00 = hierarchy.H00, XX = hierarchy.problem.geometry.gap.XX;
  const double X_a = level.grid.X(0), hx = level.grid.hx();
  double* H = nodes.H.data();
  for (int i = 0; i <= level.grid.nx; ++i) {
    const double X = X_a + i * hx;
    H[i] += H00 + XX * X * X;
  }
  if (with_F)
    for (int i = 0; i <= level.grid.nx; ++i) H[i] += level.F(i, 1);
  if (level.touching) {
    core::load_line(level.P, nodes.P);  // the coefficients are those of the fluid
    if (level.touching->yielded.nodes_x() > 0)
      for (int i = 0; i <= level.grid.nx; ++i) H[i] += level.touching->yielded(i, 1);
  }
  core::store_line(nodes.H, level.H);
  coefficients_of_nodes(hierarchy, level);
}

}  // namespace ehl::multigrid
