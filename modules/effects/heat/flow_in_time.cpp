#include "effects/heat/flow_in_time.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/slopes.hpp"
#include "rheology/thinned_by_flow.hpp"

namespace ehl::heat {
namespace {

using core::Lanes;

// Film and flow at as many nodes as a register has lanes.
struct Batch {
  Lanes P{}, log_eta{}, H{}, P_X{}, P_Y{}, more_x{}, more_y{};
  rheology::FlowThinned before{};  ///< without the limit
};

std::span<double> flat(Lanes& lanes) { return {reinterpret_cast<double*>(&lanes), core::lanes}; }

struct Factors {
  Lanes more_x, more_y;
  rheology::FlowThinned by;
};

// The formulas of thermal/film_flow.cpp for a film at one temperature.
Factors factors_of(const FlowSetup& setup, double sliding, Batch& at) {
  rheology::log_viscosity(setup.viscosity, flat(at.P), flat(at.log_eta));
  Lanes fluidity{}, along{}, across{};
  for (int lane = 0; lane < core::lanes; ++lane) fluidity[lane] = std::exp(-at.log_eta[lane]);
  const rheology::ShearThinning by_sliding{setup.thinning.law, setup.thinning.k_m * sliding};
  rheology::film_fluidity(by_sliding, flat(at.H), flat(fluidity), flat(along), flat(across));
  // The film model has the limiting stress for the mean stress without this flow; the factors have the rest.
  const Lanes limit = core::max(setup.limit * at.P, core::broadcast(setup.stress_of_u / setup.thinning.k_m));
  const Lanes over = setup.stress_of_u * sliding / (at.H * across * limit), one = core::broadcast(1.0);
  const Lanes in_model = core::max(one, over);
  const Lanes driven = (at.P > 0.0 ? core::broadcast(-1.0) : Lanes{}) * at.H * at.H * in_model / setup.lambda;
  const Lanes flow_x = driven * at.more_x * along * at.P_X, flow_y = driven * at.more_y * across * at.P_Y;
  const rheology::FlowThinned by = rheology::thinned_by_flow({setup.thinning.law, setup.thinning.k_m, sliding},
                                                             at.H * fluidity, flow_x, flow_y, &at.before);
  const Lanes rest = core::max(one, by.stress * over) / in_model;
  return {rest * by.along, rest * by.across, by};
}

}  // namespace

FlowInTime::FlowInTime(const FlowSetup& setup, const transient::Conditions& conditions)
    : setup_(setup), conditions_(conditions) {}

transient::Coupling FlowInTime::coupling() {
  return {.settle = [this](const core::Patch& grid, const core::Field& P,
                           const core::Field& H) { return respond(0.0, grid, P, H); },
          .predict = [this](double) { return now_; },
          .respond = [this](double T, const core::Field& P, const core::Field& H) { return respond(T, grid_, P, H); },
          .accept = [] {},
          .restart = [] {},
          .in_cycles = true,
          .limit = std::isfinite(setup_.limit) ? std::optional(film::StressLimit{setup_.stress_of_u, setup_.limit})
                                               : std::nullopt};
}

// The nodes of a line contact, or all nodes of a point contact, one after another in the lanes.
transient::FilmFactors FlowInTime::respond(double T, const core::Patch& grid, const core::Field& P,
                                           const core::Field& H) {
  if (now_.stored.nodes_x() == 0) {
    grid_ = grid;
    now_ = {film::unit_factors(grid), core::Field(grid), core::Field(grid)};
    along_ = across_ = core::Field(grid);
    for (core::Field* field : {&now_.stored, &now_.stress, &along_, &across_}) field->fill(1.0);
  }
  const double sliding = std::abs(value(conditions_.u1, T) - value(conditions_.u2, T));
  const bool line = grid.domain.line;
  const int per_column = line ? 1 : grid.ny + 1, nodes = (grid.nx + 1) * per_column, count = setup_.threads;
  film::FactorFields& factors = now_.coefficients;
  const core::Field more_x = factors.mobility, more_y = factors.mobility_across;
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int first = 0; first < nodes; first += core::lanes) {
    Batch at;
    for (int lane = 0; lane < core::lanes; ++lane) {
      const int node = std::min(first + lane, nodes - 1), i = node / per_column, j = line ? 1 : node % per_column;
      at.P[lane] = P(i, j);
      at.H[lane] = std::max(H(i, j), rheology::least_film);
      at.P_X[lane] = core::slope_X(P, grid.nx, grid.hx(), i, j);
      at.P_Y[lane] = core::slope_Y(grid, P, i, j);
      at.more_x[lane] = more_x(i, j);
      at.more_y[lane] = more_y(i, j);
      at.before.along[lane] = along_(i, j);
      at.before.across[lane] = across_(i, j);
      at.before.stress[lane] = now_.stress(i, j);
    }
    const Factors made = factors_of(setup_, sliding, at);
    for (int lane = 0; lane < core::lanes && first + lane < nodes; ++lane) {
      const int node = first + lane, i = node / per_column, j = line ? 1 : node % per_column;
      const auto put = [&](core::Field& field, double value) {
        if (line)
          core::fill_lines(field.at_x(i), value);
        else
          field(i, j) = value;
      };
      put(factors.mobility, made.more_x[lane]);
      put(factors.mobility_across, made.more_y[lane]);
      put(along_, made.by.along[lane]);
      put(across_, made.by.across[lane]);
      put(now_.stress, made.by.stress[lane]);
    }
  }
  return now_;
}

}  // namespace ehl::heat
