#include "effects/heat/in_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "thermal/body_memory.hpp"

namespace ehl::heat {
namespace {

using transient::FilmFactors;

// The parts of the factors: fields, and whether they are averaged geometrically, as what must remain positive is.
template <class Factors>
auto parts(Factors& factors) {
  struct Part {
    decltype(&factors.stored) field;
    bool geometric;
  };
  auto& on = factors.coefficients;
  return std::array{Part{&on.fluidity, true}, Part{&on.mobility, true}, Part{&on.mobility_across, true},
                    Part{&on.carried, false}, Part{&factors.stored, false}};
}

// values(n) = combine(n, geometric) at all nodes of all parts.
template <class Combine>
void set_all(FilmFactors& values, Combine combine) {
  const auto all = parts(values);
  for (std::size_t part = 0; part < all.size(); ++part)
    for (int i = 0; i < all[part].field->nodes_x(); ++i)
      for (int j = 0; j < all[part].field->nodes_y(); ++j)
        (*all[part].field)(i, j) = combine(part, all[part].geometric, i, j);
}

// Rates of change, of the logarithms where the mean is geometric.
FilmFactors rates(const FilmFactors& before, const FilmFactors& last, double length) {
  FilmFactors made = last;
  const auto one = parts(before), other = parts(last);
  set_all(made, [&](std::size_t part, bool geometric, int i, int j) {
    const double a = (*one[part].field)(i, j), b = (*other[part].field)(i, j);
    return (geometric ? std::log(b / a) : b - a) / length;
  });
  return made;
}

// The smaller rate where both have one sign, else 0.
FilmFactors smaller(const FilmFactors& rate, const FilmFactors& other_rate) {
  FilmFactors made = rate;
  const auto one = parts(rate), other = parts(other_rate);
  set_all(made, [&](std::size_t part, bool, int i, int j) {
    const double a = (*one[part].field)(i, j), b = (*other[part].field)(i, j);
    return a * b <= 0.0 ? 0.0 : (std::abs(a) < std::abs(b) ? a : b);
  });
  return made;
}

FilmFactors moved(const FilmFactors& from, const FilmFactors& rate, double length) {
  FilmFactors made = from;
  const auto start = parts(from), slope = parts(rate);
  set_all(made, [&](std::size_t part, bool geometric, int i, int j) {
    const double a = (*start[part].field)(i, j), change = length * (*slope[part].field)(i, j);
    return geometric ? a * std::exp(change) : a + change;
  });
  return made;
}

FilmFactors none(const core::Patch& grid) {
  const core::Field zero(grid);
  return {{zero, zero, zero, zero}, zero};
}

FilmFactors factors_of(const core::Patch& grid, const thermal::FilmTemperature& film) {
  FilmFactors made{film::unit_factors(grid), film.rho()};
  core::set_nodes(grid, made.coefficients.fluidity, [&](int i, int j) { return film.I0()(i, j); });
  core::set_nodes(grid, made.coefficients.mobility, [&](int i, int j) { return film.M2()(i, j) / film.I0()(i, j); });
  made.coefficients.mobility_across = made.coefficients.mobility;
  core::set_nodes(grid, made.coefficients.carried, [&](int i, int j) { return film.C()(i, j); });
  return made;
}

Temperatures temperatures_of(const core::Patch& grid, const thermal::FilmTemperature& film, int intervals) {
  const core::Field none(grid);
  Temperatures made{none, none, none, none};
  const auto set = [&](core::Field& field, int k) {
    core::set_nodes(grid, field, [&](int i, int j) { return film.theta(i, j, k); });
  };
  set(made.mid, intervals / 2);
  set(made.surface_1, intervals);
  set(made.surface_2, 0);
  core::set_nodes(grid, made.largest, [&](int i, int j) {
    double most = film.theta(i, j, 0);
    for (int k = 1; k <= intervals; ++k) most = std::max(most, film.theta(i, j, k));
    return most;
  });
  return made;
}

// The time since the displacement was by d less than at T; before T = 0 the speed is that of T = 0.
double time_since(const transient::Schedule& u, double T, double d) {
  const double place = integral(u, T) - d;
  if (place <= 0.0) return T - place / value(u, 0.0);
  double from = 0.0, to = T, at = std::max(0.0, T - d / value(u, T));
  while (to - from > 1e-13 * T) {  // Newton's method between two bounds
    const double excess = integral(u, at) - place;
    (excess > 0.0 ? to : from) = at;
    const double next = at - excess / value(u, at);
    if (std::abs(next - at) <= 1e-13 * T) break;
    at = next > from && next < to ? next : 0.5 * (from + to);
  }
  return T - at;
}

std::vector<double> passing(const core::Patch& grid, const transient::Schedule& u, double T) {
  if (!u.wave && u.points.size() <= 1) return {};
  return thermal::passing_weights(grid.nx, grid.hx(), [&](double d) { return time_since(u, T, d); });
}

// The setup with the speeds of T = 0.
thermal::Setup at_start(thermal::Setup setup, const transient::Conditions& conditions, int threads) {
  const double u_1 = value(conditions.u1, 0.0), u_2 = value(conditions.u2, 0.0);
  setup.body_1.Pe *= u_1 / (setup.speed + 0.5 * setup.srr);
  setup.body_2.Pe *= u_2 / (setup.speed - 0.5 * setup.srr);
  setup.speed = 0.5 * (u_1 + u_2);
  setup.srr = u_1 - u_2;
  if (setup.thinning) setup.thinning->k = conditions.thinning_k * std::abs(u_1 - u_2);
  setup.threads = threads;
  return setup;
}

}  // namespace

InTime::InTime(const thermal::Setup& setup, const transient::Conditions& conditions, double end, int threads,
               const Tuning& tuning)
    : setup_(at_start(setup, conditions, threads)), conditions_(conditions), end_(end), zero_(tuning.zero) {}

transient::Coupling InTime::coupling() {
  return {.settle = [this](const core::Patch& grid, const core::Field& P,
                           const core::Field& H) { return settle(grid, P, H); },
          .predict = [this](double T) { return predict(T); },
          .respond = [this](double T, const core::Field& P, const core::Field& H) { return respond(T, P, H); },
          .accept = [this] { accept(); },
          .restart = [this] { restart(); }};
}

// Repeated sweeps, because flows follow the temperatures and heat returns upstream.
FilmFactors InTime::settle(const core::Patch& grid, const core::Field& P, const core::Field& H) {
  if (!film_) {
    setup_.patch = grid;
    film_.emplace(setup_);
  }
  double change = 1.0;
  for (int sweep = 0; sweep < grid.nodes_x() && change > zero_; ++sweep) {
    film_->take(P, H);
    change = film_->sweep();
  }
  balance_ = film_->balance();
  last_ = {0.0, factors_of(grid, *film_), temperatures_of(grid, *film_, setup_.intervals)};
  before_ = last_;
  rate_ = extrapolated_ = none(grid);
  return last_.factors;
}

FilmFactors InTime::predict(double T) const {
  const double length = T - last_.T;
  if (length == 0.0) return last_.factors;
  return moved(last_.factors, length > 0.0 ? extrapolated_ : rate_, length);
}

FilmFactors InTime::respond(double T, const core::Field& P, const core::Field& H) {
  if (!std::exchange(under_way_, true)) film_->begin_in_time(end_);
  const double u_1 = value(conditions_.u1, T), u_2 = value(conditions_.u2, T);
  if (T != now_.T) {
    const auto moved = [&](const transient::Schedule& u) { return integral(u, T) - integral(u, last_.T); };
    film_->begin_step({.length = T - last_.T,
                       .u_1 = u_1,
                       .u_2 = u_2,
                       .thinning_k = conditions_.thinning_k * std::abs(u_1 - u_2),
                       .moved_1 = moved(conditions_.u1),
                       .moved_2 = moved(conditions_.u2),
                       .passing_1 = passing(setup_.patch, conditions_.u1, T),
                       .passing_2 = passing(setup_.patch, conditions_.u2, T)});
    now_.T = T;
  }
  film_->take(P, H);
  film_->sweep();
  now_.factors = factors_of(setup_.patch, *film_);
  return now_.factors;
}

void InTime::accept() {
  film_->accept_step();
  balance_ = film_->balance();
  now_.temperatures = temperatures_of(setup_.patch, *film_, setup_.intervals);
  const FilmFactors earlier = std::exchange(rate_, rates(last_.factors, now_.factors, now_.T - last_.T));
  extrapolated_ = smaller(earlier, rate_);
  before_ = std::move(last_);
  last_ = State(now_);
}

void InTime::restart() {
  if (under_way_) film_->restart();
  rate_ = extrapolated_ = none(setup_.patch);
}

Temperatures InTime::temperatures(double T) const {
  Temperatures made = last_.temperatures;
  if (T >= last_.T) return made;
  const double share = (T - before_.T) / (last_.T - before_.T);
  for (const auto field :
       {&Temperatures::mid, &Temperatures::largest, &Temperatures::surface_1, &Temperatures::surface_2})
    for (int i = 0; i < made.mid.nodes_x(); ++i)
      for (int j = 0; j < made.mid.nodes_y(); ++j) {
        double& value = (made.*field)(i, j);
        value = share * value + (1.0 - share) * (before_.temperatures.*field)(i, j);
      }
  return made;
}

}  // namespace ehl::heat
