#include "thermal/film_columns.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/errors.hpp"
#include "core/store_lines.hpp"
#include "thermal/before_inlet.hpp"

namespace ehl::thermal {
namespace {

using core::broadcast;

// For a body slower than this, the marched part is that of a line source at this speed, and the difference to its own
// source is lagged by one sweep. At rest the line source has no limit; at this speed it is comparable to a body at
// rest.
constexpr double slowest_line = 2.0;
// Tolerance on the change of theta in the last Newton step of a column. The remaining error is about its square and
// falls with every sweep; near convergence one step per sweep suffices. [bench: thermal_column_tolerance]
constexpr Steps steps_of_column{.most = 20, .tolerance = 1e-3};

// Response of a body: the part marched with the film, and the rest of its own source, which is lagged by one sweep.
struct Answer {
  std::vector<double> marched{};
  std::vector<double> before{};  // line contacts only (before_inlet.hpp)
  std::optional<LaggedSource> lagged{};
};

// Line contacts march the downstream part of the source itself. Slow bodies respond there to heat from far upstream,
// and with line sources the lagged rest would exceed the whole.
Answer answer_of(const Setup& setup, const Body& body) {
  if (body.resistance == 0.0) return {};
  const core::Grid& grid = setup.patch.domain;
  const bool infinite = grid.line;
  const bool strips = infinite && !setup.lines;
  Answer answer;
  if (!strips) {
    const double Pe = setup.lines ? body.Pe : std::max(body.Pe, slowest_line);
    answer.marched = line_weights(setup.patch.nx, setup.patch.hx(), Pe);
    for (double& w : answer.marched) w *= body.resistance;
  }
  const auto bring = [&] {
    if (!infinite || grid.X_a >= 0.0) return;
    answer.before = before_inlet(setup.patch, answer.marched, body.Pe, body.resistance);
  };
  if (setup.lines) {
    bring();
    return answer;
  }
  SourceTable table =
      moving_source_table(setup.patch.nx, strips ? 0 : grid.ny, grid.hx(), grid.between_lines(), body.Pe);
  for (double& G : table.G) G *= body.resistance;
  if (strips)
    answer.marched = take_downstream(table);
  else
    subtract_lines(answer.marched, table);
  bring();
  answer.lagged.emplace(make_source(setup.patch, table, setup.threads), setup.patch);
  return answer;
}

// Below an infinite strip the temperature of a body at rest grows without limit, as the logarithm of time.
bool warms_for_ever(const Setup& setup, const Body& body) {
  return setup.patch.domain.line && body.Pe == 0.0 && body.resistance > 0.0;
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

Setup cold_setup(const rheology::ViscosityLaw& viscosity, const rheology::DensityLaw& density) {
  constexpr double any = 1.0;  // no result depends on it
  return {.viscosity = viscosity,
          .thermal_viscosity = rheology::BarusOfT{any, rheology::Exponential{0.0}},
          .density = {any, density, rheology::Expansion{0.0}}};
}

FilmColumns::FilmColumns(const Setup& setup)
    : setup_(setup),
      nodes_(make_nodes(setup.intervals)),
      laws_(laws_of(setup)),
      u_1_(setup.speed + 0.5 * setup.srr),
      u_2_(setup.speed - 0.5 * setup.srr),
      batches_(setup.patch.domain.line ? 1 : (setup.patch.nodes_y() + core::lanes - 1) / core::lanes),
      workers_(static_cast<std::size_t>(setup.threads)),
      change_(static_cast<std::size_t>(batches_)) {
  if (!(u_1_ >= 0.0 && u_2_ >= 0.0 && setup.body_1.Pe >= 0.0 && setup.body_2.Pe >= 0.0))
    throw core::InputError("thermal: one surface moves against the rolling direction: -2 <= srr <= 2 is required");
  if (warms_for_ever(setup, setup.body_1) || warms_for_ever(setup, setup.body_2))
    throw core::InputError("thermal: in a line contact a surface that stands still has no steady temperature");
  const core::Patch& patch = setup_.patch;
  const std::size_t size = index(batches_, 0, 0);
  for (std::vector<double>* values : {&theta_, &flow_x_, &flow_y_}) values->assign(size, 0.0);
  const double difference = setup.body_1.theta - setup.body_2.theta;
  for (int j = 0; j < batches_ * core::lanes; ++j)
    for (int i = 0; i <= patch.nx; ++i)
      for (int k = 0; k <= nodes_.intervals; ++k)
        theta_[place(i, j, k)] = setup.body_2.theta + difference * nodes_.zeta[static_cast<std::size_t>(k)];
  before_ = theta_;
  for (core::Field* field :
       {&P_,        &H_,       &log_eta_, &rho_bar_, &k_bar_, &P_X_,          &P_Y_,         &driven_x_,
        &driven_y_, &I0_,      &M2_,      &C_,       &tau_,   &filled_,       &q_1_,         &q_2_,
        &heat_,     &carried_, &stored_,  &clipped_, &rho_,   &correction_1_, &correction_2_})
    *field = core::Field(patch);
  for (core::Field* field : {&more_x_, &more_y_, &less_tau_, &oil_}) {
    *field = core::Field(patch);
    field->fill(1.0);
  }
  if (patch.domain.line) upstream_1_ = upstream_2_ = std::vector<double>(static_cast<std::size_t>(patch.nodes_x()));
  const auto take = [](Answer answer, std::vector<double>& marched, std::vector<double>& before,
                       std::optional<LaggedSource>& lagged) {
    marched = std::move(answer.marched);
    before = std::move(answer.before);
    lagged = std::move(answer.lagged);
  };
  take(answer_of(setup, setup.body_1), line_1_, before_1_, source_1_);
  take(answer_of(setup, setup.body_2), line_2_, before_2_, source_2_);
}

void FilmColumns::start_from(const FilmColumns& coarse, const FilmColumns* coarser) {
  const core::Patch& patch = setup_.patch;
  const auto between = [&](int i, int j, int every, auto at) {
    const int every_line = patch.finer_line(1, every);
    const int west = i / every, south = j / every_line;
    const double x = static_cast<double>(i % every) / every, y = static_cast<double>(j % every_line) / every_line;
    const int east = west + (x > 0.0), north = south + (y > 0.0);
    return (1.0 - y) * ((1.0 - x) * at(west, south) + x * at(east, south)) +
           y * ((1.0 - x) * at(west, north) + x * at(east, north));
  };
  const auto start = [&](int i, int j, auto of) {
    const auto on = [&](const FilmColumns& film, int every) {
      return between(i, j, every, [&](int ci, int cj) { return of(film, ci, cj); });
    };
    return coarser == nullptr ? on(coarse, 2) : 1.25 * on(coarse, 2) - 0.25 * on(*coarser, 4);
  };
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) {
      for (int k = 0; k <= nodes_.intervals; ++k)
        theta_[place(i, j, k)] =
            start(i, j, [k](const FilmColumns& film, int ci, int cj) { return film.theta(ci, cj, k); });
      for (const auto field : {&FilmColumns::q_1_, &FilmColumns::q_2_, &FilmColumns::more_x_, &FilmColumns::more_y_,
                               &FilmColumns::less_tau_})
        (this->*field)(i, j) =
            start(i, j, [field](const FilmColumns& film, int ci, int cj) { return (film.*field)(ci, cj); });
    }
  for (int i = 0; i <= patch.nx; ++i) keep_fluxes(i);
  before_ = theta_;
  apply_sources();
}

void FilmColumns::apply_sources() {
  if (source_1_) source_1_->apply(q_1_, correction_1_);
  if (source_2_) source_2_->apply(q_2_, correction_2_);
}

double FilmColumns::velocity(int i, int j, int k) const {
  const double layer = (k == 0 || k == nodes_.intervals ? 0.5 : 1.0) * nodes_.step;
  return value(flow_x_, i, j, k) / (rho_bar_(i, j) * H_(i, j) * oil_(i, j) * layer);
}

void FilmColumns::store(int batch, int i, const Columns& at) {
  const int j = batch * core::lanes;
  for (int k = 0; k <= nodes_.intervals; ++k)
    core::store(&theta_[index(batch, i, k)], at.theta[static_cast<std::size_t>(k)]);
  core::store_lines(setup_.patch, q_1_, i, j, at.q_1);
  core::store_lines(setup_.patch, q_2_, i, j, at.q_2);
  keep_fluxes(i);
}

// Stores what the Reynolds equation and the report need of a column.
void FilmColumns::store_moments(int batch, int i, Worker& worker) {
  const int j = batch * core::lanes;
  const Columns& at = worker.at;
  const auto count = static_cast<std::size_t>((nodes_.intervals + 1) * core::lanes);
  const auto flat = [&](auto& profile) { return std::span(reinterpret_cast<double*>(profile.data()), count); };
  rheology::density_change(setup_.density, flat(worker.at.P_of_node), flat(worker.at.theta), flat(worker.ratio),
                           flat(worker.expansion));
  // C = int rho u_c dzeta, where int u_c is known exactly. phi is integrated by the trapezoidal rule and divided by its
  // own integral, so that the profile ends exactly at both surface velocities, whichever surface is surface 1.
  Lanes mean{}, excess{}, Phi{}, total{};
  for (std::size_t k = 1; k <= static_cast<std::size_t>(nodes_.intervals); ++k)
    total += (0.5 * nodes_.step) * (at.phi[k - 1] + at.phi[k]);
  const Lanes slope = (u_1_ - u_2_) / total;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes_.intervals); ++k) {
    if (k > 0) Phi += (0.5 * nodes_.step) * (at.phi[k - 1] + at.phi[k]);
    const Lanes change = nodes_.simpson[k] * (worker.ratio[k] - 1.0);
    mean += change;
    excess += change * (u_2_ + slope * Phi);
  }
  const auto put = [&](core::Field& field, Lanes value) { core::store_lines(setup_.patch, field, i, j, value); };
  put(I0_, at.I0);
  put(M2_, at.M2 * (1.0 + mean));
  put(C_, (u_2_ + (u_1_ - u_2_) * (1.0 - at.z_bar) + excess) / (0.5 * (u_1_ + u_2_)));
  put(rho_, 1.0 + mean);
  put(tau_, at.P > 0.0 ? at.tau_m : Lanes{});
  put(heat_, at.heat);
  const Lanes kept = in_time_ ? stored(batch, i, worker) : Lanes{};
  put(carried_, at.carried_off - kept);
  put(stored_, kept);
  put(clipped_, at.clipped ? broadcast(1.0) : Lanes{});
}

// Sweeps a batch of lines from one end of the domain to the other, or back from the last backflow. Other batches enter
// only with values of the previous sweep, so the batches may be swept in any order.
double FilmColumns::solve_batch(int batch, bool downstream, Worker& worker) {
  const core::Patch& patch = setup_.patch;
  Columns& at = worker.at;
  const int stations = downstream ? patch.nx : back_to_;
  const int lines = std::min(core::lanes, patch.nodes_y() - batch * core::lanes);
  double change = 0.0;
  for (int step = 0; step <= stations; ++step) {
    const int i = downstream ? step : stations - step;
    load(batch, i, before_, at);
    at.flow_x = core::load(driven_x_.at_x(i) + batch * core::lanes);
    at.flow_y = core::load(driven_y_.at_x(i) + batch * core::lanes);
    surfaces(batch, i, at);
    carry(batch, i, downstream, worker);
    solve(nodes_, laws_, at, steps_of_column);
    store(batch, i, at);
    if (downstream) store_moments(batch, i, worker);
    Lanes largest{};
    for (int k = 0; k <= nodes_.intervals; ++k)
      largest = core::max(largest,
                          core::abs(at.theta[static_cast<std::size_t>(k)] - core::load(&before_[index(batch, i, k)])));
    for (int lane = 0; lane < lines; ++lane) change = std::max(change, largest[lane]);
  }
  const auto end = static_cast<std::ptrdiff_t>(index(batch + 1, 0, 0));
  const auto done = static_cast<std::ptrdiff_t>(index(batch, stations + 1, 0));
  std::copy(before_.begin() + done, before_.begin() + end, theta_.begin() + done);
  return change;
}

double FilmColumns::sweep_through(bool downstream) {
  std::swap(theta_, before_);
  const int count = setup_.threads;
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int batch = 0; batch < batches_; ++batch)
    change_[static_cast<std::size_t>(batch)] =
        solve_batch(batch, downstream, workers_[static_cast<std::size_t>(omp_get_thread_num())]);
  return *std::ranges::max_element(change_);
}

double FilmColumns::sweep(bool back) {
  const double upstream = back && back_to_ >= 0 ? sweep_through(false) : 0.0;
  const double change = std::max(upstream, sweep_through(true));
  if (!in_time_) apply_sources();
  return change;
}

std::size_t FilmColumns::bytes() const {
  const std::size_t fields = 27 * static_cast<std::size_t>(P_.nodes_x()) * static_cast<std::size_t>(P_.stride());
  const auto of = [](const std::optional<LaggedSource>& source) { return source ? source->bytes() : 0; };
  return sizeof(double) * (fields + 4 * theta_.size()) + of(source_1_) + of(source_2_) +
         workers_.size() * sizeof(Worker) + (in_time_ ? in_time_->bytes() : 0);
}

}  // namespace ehl::thermal
