#include "effects/heat/report.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "judgement/error_estimate.hpp"
#include "rheology/thermal_properties.hpp"

namespace ehl::heat {
namespace {

// Relative error of a temperature. With two grids no order can be measured, and errors of opposite sign may cancel by
// chance.
double error_of(const Tuning& tuning, const judgement::Tuning& judged, const std::vector<Row>& rows,
                double Row::*value) {
  std::vector<double> sequence;
  for (const Row& row : rows) sequence.push_back(row.*value);
  const double order = sequence.size() < 3 ? tuning.order_of_two_grids : tuning.order;
  const double estimated = tuning.wider * judgement::estimate_error(judged, sequence, order).relative_error;
  return std::isnan(estimated) ? estimated : std::max(estimated, tuning.least_error);
}

// Temperature that a spike may reach on finer grids; NaN if it cannot be estimated.
double foreseen(const Tuning& tuning, const std::vector<Row>& rows, double Row::*behind) {
  if (rows.size() < 2) return NAN;
  const double last = rows.back().*behind, before = rows[rows.size() - 2].*behind;
  return last + tuning.grows_on * std::max(0.0, last - before);
}

// Relative error of a temperature. If the film is hardly sheared, a pressure spike becomes the hottest place once a
// grid resolves it. On coarser grids it is not yet the largest value, and the sequence of largest values hides its
// growth.
double error_of(const Tuning& tuning, const judgement::Tuning& judged, const std::vector<Row>& rows, double Row::*value,
                double Row::*behind) {
  const double estimated = error_of(tuning, judged, rows, value), under_spike = foreseen(tuning, rows, behind);
  return std::isnan(under_spike) ? estimated : std::max(estimated, under_spike / (rows.back().*value) - 1.0);
}

Hottest hottest(const core::Patch& patch, const thermal::Extreme& extreme, double error) {
  return {extreme.theta, patch.X(extreme.i), patch.Y(extreme.j), error};
}

// Grid line at Y = 0.
int middle_line(const core::Patch& patch) {
  const auto line = static_cast<int>(std::lround((0.0 - patch.domain.Y_a) / patch.hy()));
  return std::clamp(line, 0, patch.ny);
}

template <class At>
core::Field made(const core::Patch& patch, At at) {
  core::Field field(patch);
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) field(i, j) = at(i, j);
  return core::on_domain(patch, field);
}

Fields fields_of(const thermal::FilmTemperature& film, const core::Patch& patch, const thermal::Setup& setup) {
  const double T0 = setup.density.T0;
  const int n = setup.intervals, line = middle_line(patch);
  const auto layer = [&](int k) { return made(patch, [&, k](int i, int j) { return T0 * film.theta(i, j, k); }); };
  Fields fields{.I0 = core::on_domain(patch, film.I0()),
                .less_tau = core::on_domain(patch, film.less_tau()),
                .mid = layer(n / 2),
                .largest = made(patch,
                                [&](int i, int j) {
                                  double most = film.theta(i, j, 0);
                                  for (int k = 1; k <= n; ++k) most = std::max(most, film.theta(i, j, k));
                                  return T0 * most;
                                }),
                .surface_1 = layer(n),
                .surface_2 = layer(0),
                .section_T = core::Field(patch.nodes_x(), n + 1),
                .section_u = core::Field(patch.nodes_x(), n + 1)};
  const bool flows = setup.Pe > 0.0 || setup.compression > 0.0;
  for (int i = 0; i <= patch.nx; ++i)
    for (int k = 0; k <= n; ++k) {
      fields.section_T(i, k) = T0 * film.theta(i, line, k);
      fields.section_u(i, k) = flows ? film.velocity(i, line, k) : NAN;
    }
  return fields;
}

// Largest beta tau_m |u1 - u2| h/k, with beta at the local pressure and mid-film temperature.
double nahme_of(const thermal::FilmTemperature& film, const core::Patch& patch, const core::Field& P,
                const core::Field& H, const thermal::Setup& setup) {
  const auto nodes = static_cast<std::size_t>(patch.nodes_y());
  std::vector<double> log_eta(nodes), theta(nodes), D(nodes), slope(nodes), k_bar(nodes);
  double largest = 0.0;
  for (int i = 0; i <= patch.nx; ++i) {
    rheology::log_viscosity(setup.viscosity, P.station(i), log_eta);
    rheology::conductivity(setup.heat, P.station(i), k_bar);
    for (std::size_t j = 0; j < nodes; ++j) theta[j] = film.theta(i, static_cast<int>(j), setup.intervals / 2);
    rheology::log_viscosity_change(setup.thermal_viscosity, P.station(i), log_eta, theta, D, slope);
    for (std::size_t j = 0; j < nodes; ++j)
      if (const int line = static_cast<int>(j); P(i, line) > 0.0)
        largest = std::max(largest,
                           -slope[j] * setup.Br * film.tau_m()(i, line) * std::abs(setup.srr) * H(i, line) / k_bar[j]);
  }
  return largest;
}

// Mid-film temperature averaged with the pressure as weight.
double mean_of(const thermal::FilmTemperature& film, const core::Patch& patch, const core::Field& P, int middle) {
  double sum = 0.0, load = 0.0;
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) {
      sum += patch.lines(j) * P(i, j) * film.theta(i, j, middle);
      load += patch.lines(j) * P(i, j);
    }
  return sum / load;
}

}  // namespace

Solution report(const Tuning& tuning, const judgement::Tuning& judged, const Finest& finest,
                const thermal::Balance& balance, std::vector<Row> rows) {
  const auto& [film, patch, P, H, setup] = finest;
  const auto error = [&](double Row::*value, double Row::*behind) {
    return error_of(tuning, judged, rows, value, behind);
  };
  const int edge = std::clamp(static_cast<int>(std::lround((-1.0 - patch.domain.X_a) / patch.hx())), 0, patch.nx);
  const int centre = std::clamp(static_cast<int>(std::lround(-patch.domain.X_a / patch.hx())), 0, patch.nx);
  const int middle = setup.intervals / 2;
  return {.film = {},
          .balance = balance,
          .in_film = hottest(patch, balance.film, error(&Row::film, &Row::film_behind)),
          .on_1 = hottest(patch, balance.surface_1, error(&Row::surface_1, &Row::surface_1_behind)),
          .on_2 = hottest(patch, balance.surface_2, error(&Row::surface_2, &Row::surface_2_behind)),
          .mean = mean_of(film, patch, P, middle),
          .C = film.C()(centre, middle_line(patch)),
          .inlet = film.theta(edge, middle_line(patch), middle),
          .nahme = nahme_of(film, patch, P, H, setup),
          .fields = fields_of(film, patch, setup),
          .rows = std::move(rows),
          .bytes = film.bytes()};
}

}  // namespace ehl::heat
