// Velocities across the film and flows from node to node.
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "core/slopes.hpp"
#include "rheology/elementary.hpp"
#include "rheology/thinned_by_flow.hpp"
#include "thermal/film_columns.hpp"

namespace ehl::thermal {
namespace {

using core::broadcast;

// Lower bound of the filled share of the gap, by which columns are divided.
constexpr double least_oil = 1e-4;

}  // namespace

// in: of(field), theta_of(k): values of these columns.
template <class Of, class ThetaOf>
void FilmColumns::load(Of of, ThetaOf theta_of, Columns& at) const {
  at.P = of(P_);
  at.H = of(H_);
  at.log_eta = of(log_eta_);
  at.fluidity = rheology::exp(-at.log_eta);
  at.k_bar = of(k_bar_);
  at.heated = of(filled_);
  at.limit = std::isfinite(setup_.limit) ? (setup_.limit * setup_.stress_of_P) * at.P : broadcast(1e300);
  at.more_x = of(more_x_);
  at.more_y = of(more_y_);
  at.less_tau = of(less_tau_);
  at.carries = false;
  for (int k = 0; k <= nodes_.intervals; ++k) at.theta[static_cast<std::size_t>(k)] = theta_of(k);
}

void FilmColumns::load(int batch, int i, const std::vector<double>& theta, Columns& at) const {
  load([&](const core::Field& field) { return core::load(field.at_x(i) + batch * core::lanes); },
       [&](int k) { return core::load(&theta[index(batch, i, k)]); }, at);
}

void FilmColumns::take(const core::Field& P, const core::Field& H, const core::Field* theta) {
  const core::Patch& patch = setup_.patch;
  const int count = setup_.threads;
  const bool line = patch.domain.line;
  // At the last X position of a line contact vector loads reach beyond the lines; at the others they reach into the
  // next position, which has its own values.
  const int widest = std::max(batches_ * core::lanes, patch.nodes_y());
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int i = 0; i <= patch.nx; ++i) {
    const int lines = line && i < patch.nx ? patch.nodes_y() : widest;
    for (int j = 0; j < lines; ++j) {
      const bool inside = j <= patch.ny;
      P_(i, j) = inside ? P(i, j) : 0.0;
      H_(i, j) = inside ? std::max(H(i, j), rheology::least_film) : 1.0;
    }
    if (line) {
      core::fill_ghosts(patch, P_.at_x(i));
      core::fill_ghosts(patch, H_.at_x(i));
    }
    const auto count_of_lines = static_cast<std::size_t>(lines);
    const std::span<const double> here{P_.at_x(i), count_of_lines};
    rheology::log_viscosity(setup_.viscosity, here, {log_eta_.at_x(i), count_of_lines});
    rheology::density(setup_.density.at_T0, here, {rho_bar_.at_x(i), count_of_lines});
    rheology::conductivity(setup_.heat, here, {k_bar_.at_x(i), count_of_lines});
    if (line)
      for (core::Field* field : {&log_eta_, &rho_bar_, &k_bar_}) core::fill_ghosts(patch, field->at_x(i));
  }
  fill(theta);
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int i = 0; i <= patch.nx; ++i) {
    for (int j = 0; j <= patch.ny; ++j) {
      P_X_(i, j) = core::slope_X(P_, patch.nx, patch.hx(), i, j);
      P_Y_(i, j) = core::slope_Y(patch, P_, i, j);
    }
  }
  if (in_time_) take_rate_of_pressure();
  make_flows();
  back_to_ = setup_.Pe > 0.0 ? last_backflow() : -1;
}

// Downstream of the film oil continues in streaks, which fill the share H_r/H of the width (H_r the film at its edge)
// and are heated by shear. Without that heat a node at the film edge would chatter: it would cool when cavitated,
// regain pressure, warm up and cavitate again. If theta is given, it is the width of the streaks.
void FilmColumns::fill(const core::Field* theta) {
  const core::Patch& patch = setup_.patch;
  for (int j = 0; j <= patch.ny; ++j) {
    double end = 0.0;
    for (int i = 0; i <= patch.nx; ++i) {
      const bool wet = P_(i, j) > 0.0;
      if (wet) end = H_(i, j);
      filled_(i, j) = wet ? 1.0 : std::min(1.0, end / H_(i, j));
      if (theta == nullptr) continue;
      oil_(i, j) = wet ? 1.0 : std::clamp((*theta)(i, j), least_oil, 1.0);
      filled_(i, j) = end > 0.0 ? oil_(i, j) : 0.0;
      k_bar_(i, j) *= oil_(i, j);
    }
  }
}

int FilmColumns::last_backflow() const {
  int last = -1;
  const core::Patch& patch = setup_.patch;
  for (int j = 0; j <= patch.ny; ++j)
    for (int i = patch.nx; i > last; --i)
      for (int k = 0; k <= nodes_.intervals; ++k)
        if (value(flow_x_, i, j, k) < 0.0) last = std::max(last, i);
  return last;
}

// Pressure flow as a mean velocity -(H^2/lambda) M2 F' P_X, and the velocities across the film at the present
// viscosities: u = u_2 + (u_1 - u_2) int_0^zeta phi/I0 + driven (shape of int_0^zeta s phi).
// in: of, put: read and write the values of these columns in a field; put_node: writes those of node k.
template <class Of, class ThetaOf, class Put, class PutNode>
void FilmColumns::flows(Of of, ThetaOf theta_of, Put put, PutNode put_node, Worker& worker) {
  Columns& at = worker.at;
  load(of, theta_of, at);
  at.flow_x = at.flow_y = Lanes{};
  at.given_1 = at.given_2 = at.self_1 = at.self_2 = Lanes{};
  evaluate(nodes_, laws_, at);
  const Lanes driven = setup_.pressure_flow ? (at.P > 0.0 ? broadcast(-1.0) : Lanes{}) : Lanes{};
  const Lanes mobility = driven * at.H * at.H * at.fluidity * at.M2 / setup_.lambda;
  const Lanes driven_x = mobility * at.mobility_x * of(P_X_);
  const Lanes driven_y = mobility * at.mobility_y * of(P_Y_);
  put(driven_x_, driven_x);
  put(driven_y_, driven_y);
  if (setup_.flow_thinning) {
    const rheology::FlowThinned by =
        rheology::thinned_by_flow(*setup_.flow_thinning, at.H * at.I0 * at.fluidity, driven_x, driven_y);
    // Where the limiting stress acts, the film flows with the viscosity limit/rate. Measured limits do not vanish with
    // the pressure: they are at least the stress at which thinning begins.
    const Lanes limit =
        core::max((setup_.limit * setup_.stress_of_P) * at.P, broadcast(1.0 / setup_.flow_thinning->k_m));
    const Lanes over = core::max(broadcast(1.0), at.unlimited / limit);
    put(more_x_, over * by.along);
    put(more_y_, over * by.across);
    put(less_tau_, by.stress);
  }
  if (setup_.Pe == 0.0 && setup_.compression == 0.0) return;

  // The trapezoidal rule, divided by its own mean: the profiles end at the surface velocities and have the right flow.
  const auto n = static_cast<std::size_t>(nodes_.intervals);
  const double half = 0.5 * nodes_.step;
  Lanes total{}, moment{};
  for (std::size_t k = 0; k <= n; ++k) {
    const double w = k == 0 || k == n ? half : nodes_.step;
    total += w * at.phi[k];
    moment += (w * nodes_.zeta[k]) * at.phi[k];
  }
  const Lanes z_bar = moment / total;
  Lanes sum{};
  Profile &couette = at.D, &shape = at.dD;
  couette[0] = shape[0] = Lanes{};
  for (std::size_t k = 1; k <= n; ++k) {
    couette[k] = couette[k - 1] + half * (at.phi[k - 1] + at.phi[k]) / total;
    shape[k] =
        shape[k - 1] + half * ((nodes_.zeta[k - 1] - z_bar) * at.phi[k - 1] + (nodes_.zeta[k] - z_bar) * at.phi[k]);
    sum += (k == n ? half : nodes_.step) * shape[k];
  }
  const Lanes carried = of(rho_bar_) * at.H * of(oil_);
  for (std::size_t k = 0; k <= n; ++k) {
    const Lanes layer = carried * (k == 0 || k == n ? half : nodes_.step);
    put_node(flow_x_, static_cast<int>(k), layer * (u_2_ + (u_1_ - u_2_) * couette[k] + driven_x * shape[k] / sum));
    put_node(flow_y_, static_cast<int>(k), layer * (driven_y * shape[k] / sum));
  }
}

// The flows of a line contact do not depend on each other, so the lanes hold successive positions along X.
void FilmColumns::make_flows() {
  const core::Patch& patch = setup_.patch;
  const int count = setup_.threads;
  const bool line = patch.domain.line;
  const int step = line ? core::lanes : 1;
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int i = 0; i <= patch.nx; i += step) {
    Worker& worker = workers_[static_cast<std::size_t>(omp_get_thread_num())];
    const int stations = std::min(core::lanes, patch.nx + 1 - i);
    const auto of_stations = [&](auto value_of) {
      Lanes values{};
      for (int lane = 0; lane < core::lanes; ++lane) values[lane] = value_of(i + std::min(lane, stations - 1));
      return values;
    };
    if (line)
      flows([&](const core::Field& field) { return of_stations([&](int s) { return field(s, 1); }); },
            [&](int k) { return of_stations([&](int s) { return value(theta_, s, 1, k); }); },
            [&](core::Field& field, Lanes values) {
              for (int lane = 0; lane < stations; ++lane) core::fill_lines(field.at_x(i + lane), values[lane]);
            },
            [&](std::vector<double>& nodes, int k, Lanes values) {
              for (int lane = 0; lane < stations; ++lane)
                core::store(&nodes[index(0, i + lane, k)], broadcast(values[lane]));
            },
            worker);
    else
      for (int batch = 0; batch < batches_; ++batch)
        flows([&](const core::Field& field) { return core::load(field.at_x(i) + batch * core::lanes); },
              [&](int k) { return core::load(&theta_[index(batch, i, k)]); },
              [&](core::Field& field, Lanes values) { core::store(field.at_x(i) + batch * core::lanes, values); },
              [&](std::vector<double>& nodes, int k, Lanes values) { core::store(&nodes[index(batch, i, k)], values); },
              worker);
  }
}

}  // namespace ehl::thermal
