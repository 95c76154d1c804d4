#include "film/model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "rheology/thinned_by_flow.hpp"

namespace ehl::film {
namespace {

// The part of a buffer that a column uses. The buffers of a line contact hold all of its nodes, its columns one node
// and two copies.
std::span<double> part(const Station& station, std::vector<double>& buffer) {
  return std::span<double>(buffer).first(std::min(buffer.size(), station.P.size()));
}

// Multiplies the fluidity by its factor, and copies the other factors into the buffers.
void apply_factors(const Station& station, std::span<double> fluidity, Buffers& buffers) {
  if (station.factors == nullptr) return;
  const std::ptrdiff_t next = station.along ? station.factors->fluidity.stride() : 1;
  const auto first = [&](const core::Field& field) { return field.at_x(station.i) + (station.along ? 1 : 0); };
  const double* factor = first(station.factors->fluidity);
  for (double& value : fluidity) {
    value *= *factor;
    factor += next;
  }
  const auto copy = [&](const core::Field& field, std::vector<double>& to) {
    const double* from = first(field);
    for (double& value : part(station, to)) {
      value = *from;
      from += next;
    }
  };
  copy(station.factors->mobility, buffers.mobility);
  copy(station.factors->mobility_across, buffers.mobility_across);
  copy(station.factors->carried, buffers.carried);
}

rheology::ShearThinning thinning(const Model& model, const Station& station) {
  return {model.thinning->law, station.sliding * model.thinning->k};
}

void multiply(std::span<double> values, const std::vector<double>& by) {
  for (std::size_t k = 0; k < values.size(); ++k) values[k] *= by[k];
}

// The limiting stress is at least the one at which thinning begins. out: over p_h.
double least_limit(const Model& model) { return model.limit->stress / model.thinning->k; }

// Stress of sliding over its limit. in: fluidity across the direction of sliding, which gives the mean stress.
double over_limit(const Model& model, const Station& station, std::size_t k, double across) {
  const double H = std::max(station.H[k], rheology::least_film);
  const double limit = std::max(model.limit->share * station.P[k], least_limit(model));
  return model.limit->stress * station.sliding / (H * across * limit);
}

// Multiplies the mobilities by over_limit() where that is above 1.
void apply_limit(const Model& model, const Station& station, std::span<double> along, std::span<double> across) {
  for (std::size_t k = 0; k < along.size(); ++k) {
    const double over = over_limit(model, station, k, across[k]);
    if (!(over > 1.0)) continue;
    along[k] *= over;
    across[k] *= over;
  }
}

// d ln(over_limit)/dP and /dH, 0 below the limit. in: a model with a limit; fluidity before thinning, d ln(across)/d
// ln(fluidity), d ln eta_bar/dP.
struct LimitSlopes {
  double by_P = 0.0, by_H = 0.0;
};
std::vector<LimitSlopes> limit_slopes(const Model& model, const Station& station, std::span<const double> fluidity,
                                      const std::vector<double>& theta_across, const std::vector<double>& slope) {
  std::vector<LimitSlopes> all(station.P.size());
  std::vector<double> along(all.size()), across(all.size());
  rheology::film_fluidity(thinning(model, station), station.H, fluidity, along, across);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!(over_limit(model, station, k, across[k]) > 1.0)) continue;
    const double P = station.P[k], H = station.H[k];
    all[k] = {theta_across[k] * slope[k] - (model.limit->share * P > least_limit(model) ? 1.0 / P : 0.0),
              H > rheology::least_film ? -theta_across[k] / H : 0.0};
  }
  return all;
}

// eps = rho_bar H^3 phi/lambda with d ln phi = -theta d ln eta_bar + (theta - 1) dH/H; theta = 1 without thinning.
void epsilon_slopes(const Station& station, const Coefficients<const double>& at, std::span<const double> eps,
                    const std::vector<double>& theta, const std::vector<double>& log_viscosity_slope,
                    std::span<double> eps_P, std::span<double> eps_H) {
  for (std::size_t k = 0; k < eps.size(); ++k) {
    const double H = station.H[k];
    eps_P[k] = eps[k] * (at.drho_bar[k] / at.rho_bar[k] - theta[k] * log_viscosity_slope[k]);
    eps_H[k] = H > 0.0 ? (2.0 + theta[k]) * eps[k] / H : 0.0;
  }
}

}  // namespace

FactorFields unit_factors(const core::Patch& grid) {
  const core::Field zero(grid);
  FactorFields factors{zero, zero, zero, zero};
  for (const auto field : factor_fields) (factors.*field).fill(1.0);
  return factors;
}

Buffers make_buffers(const Model& model, int nodes) {
  const auto size = static_cast<std::size_t>(nodes);
  Buffers buffers{.fluidity = std::vector<double>(size)};
  if (anisotropic(model)) buffers.along = buffers.across = buffers.fluidity;
  if (model.has_factors)
    buffers.along = buffers.mobility = buffers.mobility_across = buffers.carried = buffers.fluidity;
  return buffers;
}

void coefficients(const Model& model, const Station& station, Buffers& buffers, const Coefficients<double>& out) {
  if (model.given_epsilon) {
    const core::Patch& grid = station.grid;
    for (int j = 0; j <= grid.ny; ++j)
      out.eps[static_cast<std::size_t>(j)] = model.given_epsilon(grid.X(station.i), grid.Y(j));
    std::ranges::fill(out.rho_bar, 1.0);
    return;
  }
  const std::span<double> fluidity = part(station, buffers.fluidity);
  rheology::film_properties(model.viscosity, model.density, station.P, fluidity, out.rho_bar);
  rheology::density_slope(model.density, station.P, out.drho_bar);
  apply_factors(station, fluidity, buffers);
  if (anisotropic(model)) {
    const std::span<double> along = part(station, buffers.along), across = part(station, buffers.across);
    rheology::film_fluidity(thinning(model, station), station.H, fluidity, along, across);
    if (model.limit) apply_limit(model, station, along, across);
    epsilon(station.H, out.rho_bar, along, model.lambda, out.eps);
    epsilon(station.H, out.rho_bar, across, model.lambda, out.eps_across);
  } else {
    epsilon(station.H, out.rho_bar, fluidity, model.lambda, out.eps);
  }
  if (station.factors == nullptr) return;
  multiply(out.eps, buffers.mobility);
  multiply(out.eps_across, buffers.mobility_across);
  multiply(out.rho_bar, buffers.carried);
  multiply(out.drho_bar, buffers.carried);
}

void oil(const Model& model, const Station& station, Buffers& buffers, const Oil<double>& out) {
  const bool thins = anisotropic(model);
  const std::span<double> fluidity = thins ? part(station, buffers.fluidity) : out.fluidity;
  rheology::film_properties(model.viscosity, model.density, station.P, out.log_viscosity, fluidity, out.rho_bar);
  rheology::density_slope(model.density, station.P, out.drho_bar);
  if (station.factors != nullptr) {
    std::ranges::copy(fluidity, buffers.along.begin());
    apply_factors(station, fluidity, buffers);
    rheology::thin_log_viscosity(part(station, buffers.along), fluidity, out.log_viscosity);
  }
  if (thins) {
    rheology::film_fluidity(thinning(model, station), station.H, fluidity, out.fluidity, out.fluidity_across);
    if (model.limit) apply_limit(model, station, out.fluidity, out.fluidity_across);
    std::ranges::copy(out.log_viscosity, out.log_viscosity_across.begin());
    rheology::thin_log_viscosity(fluidity, out.fluidity, out.log_viscosity);
    rheology::thin_log_viscosity(fluidity, out.fluidity_across, out.log_viscosity_across);
  }
  if (station.factors == nullptr) return;
  // Half points compute epsilon with rho_bar = Q/H, which contains the factor `carried`; so the fluidity is divided by
  // it.
  const auto move = [&](const std::vector<double>& mobility, std::span<double> phi, std::span<double> log_eta) {
    for (std::size_t k = 0; k < phi.size(); ++k) {
      const double factor = mobility[k] / buffers.carried[k];
      phi[k] *= factor;
      log_eta[k] -= std::log(factor);
    }
  };
  move(buffers.mobility, out.fluidity, out.log_viscosity);
  if (thins) move(buffers.mobility_across, out.fluidity_across, out.log_viscosity_across);
  multiply(out.rho_bar, buffers.carried);
  multiply(out.drho_bar, buffers.carried);
}

void oil_slopes(const Model& model, const Station& station, Buffers& buffers, const OilSlopes& out) {
  buffers.slope.resize(station.P.size());
  buffers.along.assign(station.P.size(), 1.0);
  rheology::log_viscosity_slope(model.viscosity, station.P, buffers.slope);
  const auto write = [&](const std::vector<double>& theta, std::span<double> by_P, std::span<double> by_H) {
    for (std::size_t k = 0; k < by_P.size(); ++k) {
      by_P[k] = theta[k] * buffers.slope[k];
      by_H[k] = station.H[k] > 0.0 ? (1.0 - theta[k]) / station.H[k] : 0.0;
    }
  };
  if (anisotropic(model)) {
    const std::span<double> fluidity = part(station, buffers.fluidity);
    rheology::fluidity(model.viscosity, station.P, fluidity);
    apply_factors(station, fluidity, buffers);
    rheology::film_fluidity_slopes(thinning(model, station), station.H, fluidity, buffers.along, buffers.across);
    write(buffers.across, out.log_viscosity_across_P, out.log_viscosity_across_H);
  }
  write(buffers.along, out.log_viscosity_P, out.log_viscosity_H);
  if (!model.limit) return;
  const auto limits = limit_slopes(model, station, part(station, buffers.fluidity), buffers.across, buffers.slope);
  for (const auto& by_P : {out.log_viscosity_P, out.log_viscosity_across_P})
    for (std::size_t k = 0; k < by_P.size(); ++k) by_P[k] -= limits[k].by_P;
  for (const auto& by_H : {out.log_viscosity_H, out.log_viscosity_across_H})
    for (std::size_t k = 0; k < by_H.size(); ++k) by_H[k] -= limits[k].by_H;
}

void slopes(const Model& model, const Station& station, const Coefficients<const double>& at, Buffers& buffers,
            const Slopes& out) {
  buffers.slope.resize(station.P.size());
  buffers.along.assign(station.P.size(), 1.0);
  rheology::log_viscosity_slope(model.viscosity, station.P, buffers.slope);
  if (anisotropic(model)) {
    const std::span<double> fluidity = part(station, buffers.fluidity);
    rheology::fluidity(model.viscosity, station.P, fluidity);
    apply_factors(station, fluidity, buffers);
    rheology::film_fluidity_slopes(thinning(model, station), station.H, fluidity, buffers.along, buffers.across);
    epsilon_slopes(station, at, at.eps_across, buffers.across, buffers.slope, out.eps_across_P, out.eps_across_H);
  }
  epsilon_slopes(station, at, at.eps, buffers.along, buffers.slope, out.eps_P, out.eps_H);
  if (!model.limit) return;
  const auto limits = limit_slopes(model, station, part(station, buffers.fluidity), buffers.across, buffers.slope);
  const auto add = [&](std::span<const double> eps, std::span<double> by_P, std::span<double> by_H) {
    for (std::size_t k = 0; k < eps.size(); ++k) {
      by_P[k] += eps[k] * limits[k].by_P;
      by_H[k] += eps[k] * limits[k].by_H;
    }
  };
  add(at.eps, out.eps_P, out.eps_H);
  add(at.eps_across, out.eps_across_P, out.eps_across_H);
}

void epsilon(std::span<const double> H, std::span<const double> rho_bar, std::span<const double> fluidity,
             double lambda, std::span<double> eps) {
  const double inverse = 1.0 / lambda;
  for (std::size_t k = 0; k < eps.size(); ++k) {
    const double film = H[k] < 0.0 ? 0.0 : H[k];
    eps[k] = rho_bar[k] * fluidity[k] * (film * film * film) * inverse;
  }
}

}  // namespace ehl::film
