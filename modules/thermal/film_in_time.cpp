// Storage of heat in the film, and bodies with a memory.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/errors.hpp"
#include "core/store_lines.hpp"
#include "thermal/film_columns.hpp"

namespace ehl::thermal {
namespace {

// Steps shorter than this are rare; for them the kernel of the bodies is bounded (exponential_sum.hpp).
constexpr double shortest_step = 1e-7;

core::Field less(const core::Patch& patch, const core::Field& a, const core::Field& b) {
  core::Field difference(patch);
  core::set_nodes(patch, difference, [&](int i, int j) { return a(i, j) - b(i, j); });
  return difference;
}

}  // namespace

void FilmColumns::begin_in_time(double end) {
  const core::Patch& patch = setup_.patch;
  const auto begin = [&](const Body& body, double u, const core::Field& q, int k) {
    BodyInTime made{.theta = core::Field(patch), .q = q, .memory = {}, .history = core::Field(patch)};
    core::set_nodes(patch, made.theta, [&](int i, int j) { return theta(i, j, k); });
    if (body.resistance == 0.0) return made;
    // Line sources in time, dX' = u dT'.
    made.factor = body.resistance / std::sqrt(std::numbers::pi * body.Pe / u);
    made.passing = passing_weights(patch.nx, patch.hx(), [u](double d) { return d / u; });
    made.memory.emplace(patch, made.factor, inverse_root(shortest_step, std::max(1.0, end)), setup_.threads);
    return made;
  };
  in_time_.emplace(FilmInTime{.body_1 = begin(setup_.body_1, u_1_, q_1_, nodes_.intervals),
                              .body_2 = begin(setup_.body_2, u_2_, q_2_, 0),
                              .last = theta_,
                              .before = theta_,
                              .P_last = P_,
                              .P_before = P_,
                              .P_T = core::Field(patch)});
}

// Adds what the steady flux of T = 0 causes at other speeds than those of T = 0. in: passing_weights().
void FilmColumns::add_change_of_speed(const std::vector<double>& passing, BodyInTime& body) const {
  if (passing.empty() || !body.memory) return;
  std::vector<double> change(passing.size());
  for (std::size_t m = 0; m < passing.size(); ++m) change[m] = body.factor * (passing[m] - body.passing[m]);
  for (int i = 0; i <= setup_.patch.nx; ++i)
    for (int m = 0; m <= i; ++m)
      for (int j = 0; j < setup_.patch.nodes_y(); ++j)
        body.history(i, j) += change[static_cast<std::size_t>(m)] * body.q(i - m, j);
}

void FilmColumns::begin_step(const TimeStep& step) {
  if (!(step.u_1 > 0.0 && step.u_2 > 0.0))
    throw core::InputError("thermal: in time both surfaces must move with the entrainment");
  FilmInTime& time = *in_time_;
  u_1_ = step.u_1;
  u_2_ = step.u_2;
  laws_.sliding = step.u_1 - step.u_2;
  laws_.thinning.k = step.thinning_k;
  time.length = step.length;
  const double ratio = time.length_before > 0.0 ? step.length / time.length_before : 0.0;
  time.of_before = ratio * ratio / (1.0 + ratio) / step.length;
  time.of_last = -(1.0 + ratio) / step.length;
  time.now = -time.of_last - time.of_before;
  for (std::size_t k = 0; k < theta_.size(); ++k) theta_[k] = time.last[k] + ratio * (time.last[k] - time.before[k]);
  if (time.body_1.memory) time.body_1.memory->look(step.length, step.moved_1, time.body_1.history);
  if (time.body_2.memory) time.body_2.memory->look(step.length, step.moved_2, time.body_2.history);
  add_change_of_speed(step.passing_1, time.body_1);
  add_change_of_speed(step.passing_2, time.body_2);
}

void FilmColumns::accept_step() {
  FilmInTime& time = *in_time_;
  const core::Patch& patch = setup_.patch;
  if (time.body_1.memory) time.body_1.memory->accept(less(patch, q_1_, time.body_1.q));
  if (time.body_2.memory) time.body_2.memory->accept(less(patch, q_2_, time.body_2.q));
  std::swap(time.before, time.last);
  time.last = theta_;
  std::swap(time.P_before, time.P_last);
  time.P_last = P_;
  time.length_before = time.length;
}

void FilmColumns::take_rate_of_pressure() {
  FilmInTime& time = *in_time_;
  if (time.length == 0.0) return;  // still at the start
  core::set_nodes(setup_.patch, time.P_T, [&](int i, int j) {
    return time.now * P_(i, j) + time.of_last * time.P_last(i, j) + time.of_before * time.P_before(i, j);
  });
}

// The storage term is a neighbour in time: what the column had at the ends of the last two steps.
void FilmColumns::add_storage(int batch, int i, Worker& worker) const {
  const FilmInTime& time = *in_time_;
  Convection& by = worker.at.convection;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes_.intervals); ++k) {
    const std::size_t here = index(batch, i, static_cast<int>(k));
    const Lanes capacity = layer(k) * worker.capacity;
    by.side[k] += capacity * time.now;
    by.carried[k] -=
        capacity * (time.of_last * core::load(&time.last[here]) + time.of_before * core::load(&time.before[here]));
  }
}

// Heat that the columns store per time, in k0 T0 R/a^2.
Lanes FilmColumns::stored(int batch, int i, const Worker& worker) const {
  const FilmInTime& time = *in_time_;
  if (!worker.at.carries) return Lanes{};
  Lanes sum{};
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes_.intervals); ++k) {
    const std::size_t here = index(batch, i, static_cast<int>(k));
    sum += layer(k) * (time.now * worker.at.theta[k] + time.of_last * core::load(&time.last[here]) +
                       time.of_before * core::load(&time.before[here]));
  }
  return sum * worker.capacity / worker.at.H;
}

}  // namespace ehl::thermal
