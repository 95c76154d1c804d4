#include "thermal/film_temperature.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "core/errors.hpp"

namespace ehl::thermal {
namespace {

using core::broadcast;

// A body slower than this has its history computed as one of this speed, and the difference to its own source, which is
// lagged. At rest the lines know no end; at Pe = 2 they are as hot as the body at rest, within half.
constexpr double slowest_line = 2.0;
// A change of theta within a column, in Newton's last step; what is left is its square.
constexpr Steps steps_of_column{.most = 20, .tolerance = 1e-6};

std::vector<double> weights_of(const Setup& setup, const Body& body) {
  std::vector<double> weights =
      line_weights(setup.patch.nx, setup.patch.hx(), setup.lines ? body.Pe : std::max(body.Pe, slowest_line));
  for (double& w : weights) w *= body.resistance;
  return weights;
}

// What the lines leave of the body's own source.
std::optional<SourceConvolution> rest_of(const Setup& setup, const Body& body, const std::vector<double>& lines) {
  if (setup.lines || body.resistance == 0.0) return std::nullopt;
  const core::Grid& grid = setup.patch.domain;
  SourceTable table = moving_source_table(setup.patch.nx, grid.ny, grid.hx(), grid.hy(), body.Pe);
  for (double& G : table.G) G *= body.resistance;
  subtract_lines(lines, table);
  return SourceConvolution(setup.patch, table, setup.threads);
}

ColumnLaws laws_of(const Setup& setup) {
  return {.viscosity = setup.thermal_viscosity,
          .thinning = setup.thinning.value_or(rheology::ShearThinning{rheology::Eyring{}, 0.0}),
          .sliding = setup.srr,
          .Br = setup.Br,
          .theta_least = setup.theta_least,
          .theta_most = setup.theta_most};
}

}  // namespace

FilmTemperature::FilmTemperature(const Setup& setup)
    : setup_(setup),
      nodes_(make_nodes(setup.intervals)),
      laws_(laws_of(setup)),
      u_1_(1.0 + 0.5 * setup.srr),
      u_2_(1.0 - 0.5 * setup.srr),
      batches_((setup.patch.nodes_y() + core::lanes - 1) / core::lanes),
      stride_(static_cast<std::size_t>((batches_ + 2) * core::lanes)),
      workers_(static_cast<std::size_t>(setup.threads)),
      change_(static_cast<std::size_t>(batches_)) {
  if (!(u_1_ >= 0.0 && u_2_ >= 0.0 && setup.body_1.Pe >= 0.0 && setup.body_2.Pe >= 0.0))
    throw core::InputError(
        "thermal: both surfaces must move along the entrainment or stand still, -2 <= srr <= 2: one moves against it");
  const core::Patch& patch = setup_.patch;
  const std::size_t size = index(patch.nx, nodes_.intervals) + stride_;
  theta_.assign(size, setup.theta_oil);
  flow_x_.assign(size, 0.0);
  flow_y_.assign(size, 0.0);
  for (int i = 0; i <= patch.nx; ++i)
    for (int k = 0; k <= nodes_.intervals; ++k)
      for (std::size_t j = 0; j < static_cast<std::size_t>(batches_ * core::lanes); ++j)
        theta_[index(i, k) + j] =
            setup.body_2.theta + (setup.body_1.theta - setup.body_2.theta) * nodes_.zeta[static_cast<std::size_t>(k)];
  before_ = theta_;
  for (core::Field* field : {&P_, &H_, &log_eta_, &rho_bar_, &k_bar_, &driven_x_, &driven_y_, &I0_, &M2_, &C_, &tau_,
                             &q_1_, &q_2_, &heat_, &carried_, &clipped_, &correction_1_, &correction_2_})
    *field = core::Field(patch);
  line_1_ = setup.body_1.resistance > 0.0 ? weights_of(setup, setup.body_1) : std::vector<double>{};
  line_2_ = setup.body_2.resistance > 0.0 ? weights_of(setup, setup.body_2) : std::vector<double>{};
  source_1_ = rest_of(setup, setup.body_1, line_1_);
  source_2_ = rest_of(setup, setup.body_2, line_2_);
}

// The surfaces of a batch: what flowed into them upstream, and their own share.
void FilmTemperature::surfaces(int i, int j, Columns& at) const {
  const auto surface = [&](const Body& body, const std::vector<double>& line, const core::Field& q,
                           const core::Field& correction, Lanes& given, Lanes& self) {
    given = body.theta + core::load(correction.at_x(i) + j);
    self = broadcast(line.empty() ? 0.0 : line[0]);
    if (line.empty()) return;
    for (int m = 1; m <= i; ++m) given += line[static_cast<std::size_t>(m)] * core::load(q.at_x(i - m) + j);
  };
  surface(setup_.body_1, line_1_, q_1_, correction_1_, at.given_1, at.self_1);
  surface(setup_.body_2, line_2_, q_2_, correction_2_, at.given_2, at.self_2);
}

// What the Reynolds side and the report take from a column.
void FilmTemperature::store(int i, int j, Worker& worker) {
  const Columns& at = worker.at;
  const auto count = static_cast<std::size_t>((nodes_.intervals + 1) * core::lanes);
  const auto flat = [&](auto& profile) { return std::span(reinterpret_cast<double*>(profile.data()), count); };
  rheology::density_change(setup_.density, flat(worker.at.P_of_node), flat(worker.at.theta), flat(worker.ratio),
                           flat(worker.expansion));
  // C = int rho u_c dzeta, of which int u_c is known exactly; phi by the trapezoidal rule.
  Lanes mean{}, excess{}, Phi{};
  const Lanes slope = (u_1_ - u_2_) / at.I0;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes_.intervals); ++k) {
    if (k > 0) Phi += (0.5 * nodes_.step) * (at.phi[k - 1] + at.phi[k]);
    const Lanes change = nodes_.simpson[k] * (worker.ratio[k] - 1.0);
    mean += change;
    excess += change * (u_2_ + slope * Phi);
    core::store(&theta_[index(i, static_cast<int>(k)) + static_cast<std::size_t>(j)], at.theta[k]);
  }
  const auto put = [&](core::Field& field, Lanes value) { core::store(field.at_x(i) + j, value); };
  put(I0_, at.I0);
  put(M2_, at.M2 * (1.0 + mean));
  put(C_, u_2_ + (u_1_ - u_2_) * (1.0 - at.z_bar) + excess);
  put(tau_, at.tau_m * at.heated);
  put(q_1_, at.q_1);
  put(q_2_, at.q_2);
  put(heat_, at.heat);
  put(carried_, at.carried_off);
  put(clipped_, at.clipped ? broadcast(1.0) : Lanes{});
}

// A batch of lines from one end of the domain to the other; nothing is asked of other batches but what the sweep before
// left, so that they may go in any order.
double FilmTemperature::solve_batch(int batch, bool downstream, Worker& worker) {
  const core::Patch& patch = setup_.patch;
  const int j = batch * core::lanes;
  Columns& at = worker.at;
  double change = 0.0;
  for (int step = 0; step <= patch.nx; ++step) {
    const int i = downstream ? step : patch.nx - step;
    load(i, j, before_, at);
    at.flow_x = core::load(driven_x_.at_x(i) + j);
    at.flow_y = core::load(driven_y_.at_x(i) + j);
    surfaces(i, j, at);
    carry(i, j, downstream, worker);
    solve(nodes_, laws_, at, steps_of_column);
    store(i, j, worker);
    for (int k = 0; k <= nodes_.intervals; ++k) {
      const std::size_t here = index(i, k) + static_cast<std::size_t>(j);
      for (int lane = 0; lane < core::lanes && j + lane < patch.nodes_y(); ++lane)
        change = std::max(change, std::abs(theta_[here + static_cast<std::size_t>(lane)] -
                                           before_[here + static_cast<std::size_t>(lane)]));
    }
  }
  return change;
}

double FilmTemperature::sweep_through(bool downstream) {
  std::swap(theta_, before_);
  const int count = setup_.threads;
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int batch = 0; batch < batches_; ++batch)
    change_[static_cast<std::size_t>(batch)] =
        solve_batch(batch, downstream, workers_[static_cast<std::size_t>(omp_get_thread_num())]);
  return *std::ranges::max_element(change_);
}

double FilmTemperature::sweep() {
  double change = sweep_through(true);
  if (flows_back_) change = std::max(change, sweep_through(false));
  if (source_1_) source_1_->apply(q_1_, correction_1_);
  if (source_2_) source_2_->apply(q_2_, correction_2_);
  return change;
}

Balance FilmTemperature::balance() const {
  const core::Patch& patch = setup_.patch;
  Balance sum;
  double load = 0.0;
  const auto compare = [](Extreme& most, double theta, int i, int j) {
    if (theta > most.theta) most = {theta, i, j};
  };
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) {
      const double lines = patch.lines(j), cell = lines * patch.hx() * patch.hy();
      load += lines * P_(i, j);
      sum.friction += lines * tau_(i, j);
      sum.heat += cell * heat_(i, j);
      sum.into_1 += cell * q_1_(i, j);
      sum.into_2 += cell * q_2_(i, j);
      sum.carried += cell * carried_(i, j);
      sum.clipped = sum.clipped || clipped_(i, j) > 0.0;
      for (int k = 0; k <= nodes_.intervals; ++k) compare(sum.film, theta(i, j, k), i, j);
      compare(sum.surface_1, theta(i, j, nodes_.intervals), i, j);
      compare(sum.surface_2, theta(i, j, 0), i, j);
    }
  sum.friction *= (setup_.srr < 0.0 ? -1.0 : 1.0) / (load * setup_.stress_of_P);
  sum.defect = sum.heat != 0.0 ? (sum.heat - sum.into_1 - sum.into_2 - sum.carried) / sum.heat : 0.0;
  return sum;
}

std::size_t FilmTemperature::bytes() const {
  const std::size_t fields = 18 * static_cast<std::size_t>(P_.nodes_x()) * static_cast<std::size_t>(P_.stride());
  return sizeof(double) * (fields + 4 * theta_.size()) + (source_1_ ? source_1_->bytes() : 0) +
         (source_2_ ? source_2_->bytes() : 0) + workers_.size() * sizeof(Worker);
}

}  // namespace ehl::thermal
