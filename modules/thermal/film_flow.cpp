// What the film carries: velocities across it, flows from node to node, and the heat that goes with them.
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "rheology/elementary.hpp"
#include "thermal/film_temperature.hpp"

namespace ehl::thermal {
namespace {

using core::broadcast;

// A film that counts as none: behind it nothing is sheared, and what is divided by it stays finite.
constexpr double least_film = 1e-6;
// Likewise a share of the gap: its columns are divided by it.
constexpr double least_oil = 1e-4;

// d/dX or d/dY between the neighbours that there are.
double slope(const core::Patch& patch, const core::Field& P, int i, int j, bool along) {
  if (along) {
    const int west = std::max(i - 1, 0), east = std::min(i + 1, patch.nx);
    return (P(east, j) - P(west, j)) / ((east - west) * patch.hx());
  }
  const bool mirror = patch.north == core::Edge::mirror && j == patch.ny;
  if (mirror) return 0.0;
  const int south = std::max(j - 1, 0), north = std::min(j + 1, patch.ny);
  return (P(i, north) - P(i, south)) / ((north - south) * patch.hy());
}

// v[1], v[2], .., after[0].
Lanes moved_down(Lanes v, Lanes after) {
  return __builtin_shuffle(v, after, core::lanes_by([](int k) { return k + 1; }));
}

Lanes positive(Lanes a) { return core::max(a, Lanes{}); }

}  // namespace

void FilmTemperature::load(int batch, int i, const std::vector<double>& theta, Columns& at) const {
  const int j = batch * core::lanes;
  at.P = core::load(P_.at_x(i) + j);
  at.H = core::load(H_.at_x(i) + j);
  at.log_eta = core::load(log_eta_.at_x(i) + j);
  at.fluidity = rheology::exp(-at.log_eta);
  at.k_bar = core::load(k_bar_.at_x(i) + j);
  at.heated = core::load(filled_.at_x(i) + j);
  at.limit = std::isfinite(setup_.limit) ? (setup_.limit * setup_.stress_of_P) * at.P : broadcast(1e300);
  at.more_x = core::load(more_x_.at_x(i) + j);
  at.more_y = core::load(more_y_.at_x(i) + j);
  at.less_tau = core::load(less_tau_.at_x(i) + j);
  at.carries = false;
  for (int k = 0; k <= nodes_.intervals; ++k)
    at.theta[static_cast<std::size_t>(k)] = core::load(&theta[index(batch, i, k)]);
}

void FilmTemperature::take(const core::Field& P, const core::Field& H, const core::Field* theta) {
  const core::Patch& patch = setup_.patch;
  const int count = setup_.threads;
  const auto lines = static_cast<std::size_t>(batches_ * core::lanes);
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int i = 0; i <= patch.nx; ++i) {
    for (int j = 0; j < batches_ * core::lanes; ++j) {
      const bool inside = j <= patch.ny;
      P_(i, j) = inside ? P(i, j) : 0.0;
      H_(i, j) = inside ? std::max(H(i, j), least_film) : 1.0;
    }
    if (patch.domain.line) {
      core::fill_ghosts(patch, P_.at_x(i));
      core::fill_ghosts(patch, H_.at_x(i));
    }
    const std::span<const double> here{P_.at_x(i), lines};
    rheology::log_viscosity(setup_.viscosity, here, {log_eta_.at_x(i), lines});
    rheology::density(setup_.density.at_T0, here, {rho_bar_.at_x(i), lines});
    rheology::conductivity(setup_.heat, here, {k_bar_.at_x(i), lines});
  }
  fill(theta);
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int i = 0; i <= patch.nx; ++i) {
    for (int j = 0; j <= patch.ny; ++j) {
      P_X_(i, j) = slope(patch, P_, i, j, true);
      P_Y_(i, j) = slope(patch, P_, i, j, false);
    }
    Worker& worker = workers_[static_cast<std::size_t>(omp_get_thread_num())];
    for (int batch = 0; batch < batches_; ++batch) flows(batch, i, worker);
  }
  back_to_ = setup_.Pe > 0.0 ? last_backflow() : -1;
}

// Behind the film's end the oil goes on in streaks, as wide as it was thick there: shear heats them. A node at the end
// that changes between wet and dry changes little of its heat; without the streaks it would cool down, get pressure,
// warm up, and lose it again, from pass to pass. With theta given that is the width of the streaks.
void FilmTemperature::fill(const core::Field* theta) {
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

int FilmTemperature::last_backflow() const {
  int last = -1;
  const core::Patch& patch = setup_.patch;
  for (int j = 0; j <= patch.ny; ++j)
    for (int i = patch.nx; i > last; --i)
      for (int k = 0; k <= nodes_.intervals; ++k)
        if (value(flow_x_, i, j, k) < 0.0) last = std::max(last, i);
  return last;
}

// The flow that pressure drives, as a mean velocity -(H^2/lambda) M2 F' P_X, and the velocities across the film that go
// with it at the viscosities of now: u = u_2 + (u_1 - u_2) int_0^zeta phi/I0 + driven (shape of int_0^zeta s phi).
void FilmTemperature::flows(int batch, int i, Worker& worker) {
  const int j = batch * core::lanes;
  Columns& at = worker.at;
  load(batch, i, theta_, at);
  at.flow_x = at.flow_y = Lanes{};
  at.given_1 = at.given_2 = at.self_1 = at.self_2 = Lanes{};
  evaluate(nodes_, laws_, at);
  const Lanes driven = setup_.pressure_flow ? (at.P > 0.0 ? broadcast(-1.0) : Lanes{}) : Lanes{};
  const Lanes mobility = driven * at.H * at.H * at.fluidity * at.M2 / setup_.lambda;
  const Lanes driven_x = mobility * at.mobility_x * core::load(P_X_.at_x(i) + j);
  const Lanes driven_y = mobility * at.mobility_y * core::load(P_Y_.at_x(i) + j);
  core::store(driven_x_.at_x(i) + j, driven_x);
  core::store(driven_y_.at_x(i) + j, driven_y);
  if (setup_.flow_thinning) {
    const rheology::FlowThinned by =
        rheology::thinned_by_flow(*setup_.flow_thinning, at.H * at.I0 * at.fluidity, driven_x, driven_y);
    // Where the limit acts the film flows at the viscosity limit/rate. Below this pressure the limit counts as that of
    // it: measured ones do not vanish with p.
    constexpr double least_P = 1e-3;
    const Lanes limit = (setup_.limit * setup_.stress_of_P) * core::max(at.P, broadcast(least_P));
    const Lanes over = core::max(broadcast(1.0), at.unlimited / limit);
    core::store(more_x_.at_x(i) + j, over * by.along);
    core::store(more_y_.at_x(i) + j, over * by.across);
    core::store(less_tau_.at_x(i) + j, by.stress);
  }
  if (setup_.Pe == 0.0 && setup_.compression == 0.0) return;

  // By the trapezoidal rule, with its own mean, so that the shapes end at the surfaces and carry what they must.
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
  const Lanes carried = core::load(rho_bar_.at_x(i) + j) * at.H * core::load(oil_.at_x(i) + j);
  for (std::size_t k = 0; k <= n; ++k) {
    const Lanes layer = carried * (k == 0 || k == n ? half : nodes_.step);
    const std::size_t here = index(batch, i, static_cast<int>(k));
    core::store(&flow_x_[here], layer * (u_2_ + (u_1_ - u_2_) * couette[k] + driven_x * shape[k] / sum));
    core::store(&flow_y_[here], layer * (driven_y * shape[k] / sum));
  }
}

// The values at the lines before those of a batch.
Lanes FilmTemperature::south(const std::vector<double>& f, int batch, int i, int k, Lanes outside) const {
  const Lanes own = core::load(&f[index(batch, i, k)]);
  return core::moved_up(batch > 0 ? broadcast(f[index(batch - 1, i, k) + core::lanes - 1]) : outside, own);
}

// The values at the lines behind; beyond the last one `mirrored` times the image, or `outside`.
Lanes FilmTemperature::north(const std::vector<double>& f, int batch, int i, int k, double mirrored,
                             Lanes outside) const {
  const core::Patch& patch = setup_.patch;
  const Lanes own = core::load(&f[index(batch, i, k)]);
  Lanes next = moved_down(own, batch + 1 < batches_ ? broadcast(f[index(batch + 1, i, k)]) : own);
  const int last = patch.ny - batch * core::lanes;
  if (last < core::lanes)
    next[last] = patch.north == core::Edge::mirror ? mirrored * value(f, i, patch.ny - 1, k) : outside[last];
  return next;
}

// Upwind finite volumes around the nodes of the columns: what flows in brings the temperature of where it comes from.
// The flow between two layers follows from continuity; what the columns' own flows lack of it is spread over the film.
void FilmTemperature::carry(int batch, int i, bool downstream, Worker& worker) const {
  const int j = batch * core::lanes;
  Columns& at = worker.at;
  at.carries = setup_.Pe > 0.0 || setup_.compression > 0.0;
  if (!at.carries) return;
  const core::Patch& patch = setup_.patch;
  const auto n = static_cast<std::size_t>(nodes_.intervals);
  Lanes rho_c{};
  const auto lane_span = [](const Lanes& v) { return std::span(reinterpret_cast<const double*>(&v), core::lanes); };
  rheology::heat_capacity(setup_.heat, lane_span(at.P), lane_span(at.theta[n / 2]),
                          {reinterpret_cast<double*>(&rho_c), core::lanes});
  const Lanes scale = setup_.Pe * at.H * rho_c / core::load(rho_bar_.at_x(i) + j);
  const double hx = 1.0 / patch.hx(), hy = 1.0 / patch.hy();
  const int west_i = std::max(i - 1, 0), east_i = std::min(i + 1, patch.nx);
  const std::vector<double>& from_west = downstream ? theta_ : before_;
  const std::vector<double>& from_east = downstream ? before_ : theta_;
  Convection& by = at.convection;
  const Lanes oil = broadcast(setup_.theta_oil);
  Lanes defect{};
  for (std::size_t k = 0; k <= n; ++k) {
    const int node = static_cast<int>(k);
    const auto flow_at = [&](int station) { return core::load(&flow_x_[index(batch, station, node)]); };
    const Lanes own = flow_at(i), own_across = core::load(&flow_y_[index(batch, i, node)]);
    const Lanes west = (0.5 * hx) * (flow_at(west_i) + own), east = (0.5 * hx) * (own + flow_at(east_i));
    const Lanes to_south = (0.5 * hy) * (south(flow_y_, batch, i, node, own_across) + own_across);
    const Lanes to_north = (0.5 * hy) * (own_across + north(flow_y_, batch, i, node, -1.0, own_across));
    const Lanes theta_west = i > 0 ? core::load(&from_west[index(batch, west_i, node)]) : oil;
    const Lanes theta_east = i < patch.nx ? core::load(&from_east[index(batch, east_i, node)]) : oil;
    const Lanes theta_south = south(before_, batch, i, node, oil),
                theta_north = north(before_, batch, i, node, 1.0, oil);
    const Lanes in_west = positive(west), in_east = positive(-east), in_south = positive(to_south),
                in_north = positive(-to_north);
    by.side[k] = scale * (in_west + in_east + in_south + in_north);
    by.carried[k] =
        scale * (in_west * theta_west + in_east * theta_east + in_south * theta_south + in_north * theta_north);
    by.below[k] = east - west + to_north - to_south;  // what leaves the layer, for the flow between layers
    by.compression[k] = Lanes{};
    defect += by.below[k];
  }
  Lanes up{};
  for (std::size_t k = 0; k <= n; ++k) {
    const Lanes from_below = up;
    up += defect * (k == 0 || k == n ? 0.5 * nodes_.step : nodes_.step) - by.below[k];
    by.below[k] = scale * positive(from_below);
    by.above[k] = scale * positive(-up);
  }
  if (setup_.compression > 0.0) add_compression(batch, i, worker);
}

// compression e T0 H^2 (u P_X + v P_Y), e of the middle of the film.
void FilmTemperature::add_compression(int batch, int i, Worker& worker) const {
  const int j = batch * core::lanes;
  Columns& at = worker.at;
  const auto n = static_cast<std::size_t>(nodes_.intervals);
  const Lanes P_X = core::load(P_X_.at_x(i) + j), P_Y = core::load(P_Y_.at_x(i) + j);
  Lanes ratio{}, expansion{};
  const auto in = [](const Lanes& v) { return std::span(reinterpret_cast<const double*>(&v), core::lanes); };
  const auto out = [](Lanes& v) { return std::span(reinterpret_cast<double*>(&v), core::lanes); };
  rheology::density_change(setup_.density, in(at.P), in(at.theta[n / 2]), out(ratio), out(expansion));
  const Lanes scale = setup_.compression * expansion * at.H / core::load(rho_bar_.at_x(i) + j);
  for (std::size_t k = 0; k <= n; ++k) {
    const double layer = k == 0 || k == n ? 0.5 * nodes_.step : nodes_.step;
    const std::size_t here = index(batch, i, static_cast<int>(k));
    at.convection.compression[k] =
        scale / layer * (core::load(&flow_x_[here]) * P_X + core::load(&flow_y_[here]) * P_Y);
  }
}

}  // namespace ehl::thermal
