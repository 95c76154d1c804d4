#include "asperities/rough_map.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "asperities/cell_flow.hpp"
#include "asperities/flow_factors.hpp"
#include "asperities/gauss_moments.hpp"
#include "core/constants.hpp"
#include "core/errors.hpp"

namespace ehl::asperities {
namespace {

// Mean pressures over (E'/2) slope: 2 p/(E* slope) is about the share in contact, from a few summits to half of all.
constexpr double lightest = 3e-4, heaviest = 0.5;
constexpr double most_of_hardness = 0.9;
// Wider gaps without contact, in heights of the highest point.
constexpr std::array<double, 3> open_gaps{1.25, 1.75, 2.5};
constexpr int fewest_points = 8;

// Means of block x block points; what is left over at the end, and an odd last point, are dropped.
surface::Heights averaged(const surface::Heights& z, int block) {
  const auto even = [](int n) { return n - n % 2; };
  surface::Heights mean{even(z.nx / block), even(z.ny / block), {}};
  for (int l = 0; l < mean.ny; ++l)
    for (int k = 0; k < mean.nx; ++k) {
      double sum = 0.0;
      for (int b = 0; b < block * block; ++b) sum += z(block * k + b % block, block * l + b / block);
      mean.values.push_back(sum / (block * block));
    }
  return mean;
}

RoughCell cell_of(const surface::Heights& heights, double dx, double dy, int block, const MapParameters& parameters) {
  surface::Heights z = averaged(heights, block);
  surface::level_mean(z);
  return {{z.nx, z.ny, block * dx, block * dy},
          std::move(z.values),
          parameters.E_prime,
          parameters.hardness,
          parameters.threads};
}

class Report {
 public:
  Report(const MapObserver& observe, double all) : observe_(observe), all_(all) {}
  void step(double work, const std::string& text) {
    done_ += work;
    if (observe_ && !observe_(done_ / all_, text)) throw core::Interrupted();
  }

 private:
  const MapObserver& observe_;
  double all_, done_ = 0.0;
};

// The gap that is open to oil.
std::vector<double> open_gap(const CellContact& contact) {
  std::vector<double> open(contact.gap);
  for (std::size_t n = 0; n < open.size(); ++n) open[n] = contact.p[n] > 0.0 ? 0.0 : std::max(0.0, open[n]);
  return open;
}

MapRow row_of(const CellContact& contact, double pressure) {
  MapRow row;
  row.gap = contact.separation;
  row.film = contact.film;
  row.pressure = pressure;
  row.area = contact.area;
  row.largest_pressure = *std::ranges::max_element(contact.p);
  row.yielded = contact.yielded;
  row.iterations = contact.iterations;
  row.converged = contact.converged;
  return row;
}

// The flow factors of all rows. The cases are independent of one another, so each thread takes whole cases, and the
// numbers do not depend on how many threads there are.
void add_flow(const Cell& cell, const std::vector<std::vector<double>>& gaps, int threads, std::vector<MapRow>& rows) {
  const int cases = 2 * static_cast<int>(rows.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) if (threads > 1)
  for (int k = 0; k < cases; ++k) {
    MapRow& row = rows[static_cast<std::size_t>(k / 2)];
    const std::vector<double>& gap = gaps[static_cast<std::size_t>(k / 2)];
    if (k % 2 == 0) row.phi_x = flow_through(cell, gap, row.gap, FlowAlong::x).factor;
    if (k % 2 == 1) row.phi_y = flow_through(cell, gap, row.gap, FlowAlong::y).factor;
  }
}

// in: mean pressures, decreasing; gaps without contact.
std::vector<MapRow> rows_of(const RoughCell& rough, const std::vector<double>& pressures,
                            const std::vector<double>& wide, const MapParameters& parameters, Report& report) {
  std::vector<MapRow> rows;
  std::vector<std::vector<double>> gaps;
  std::vector<double> start;
  for (const double pressure : pressures) {
    CellContact contact = solve(rough, pressure, start, parameters.tolerance, parameters.max_iterations);
    rows.push_back(row_of(contact, pressure));
    gaps.push_back(open_gap(contact));
    start = std::move(contact.p);
    report.step(static_cast<double>(rough.cell.points()),
                fmt::format("contact at {:.3g} MPa: {:.2g} % of the area, {} iterations", 1e-6 * pressure,
                            100.0 * rows.back().area, contact.iterations));
  }
  for (const double gap : wide) {
    gaps.emplace_back(rough.z);
    for (double& g : gaps.back()) g = gap - g;
    MapRow row;
    row.gap = row.film = gap;
    rows.push_back(row);
  }
  add_flow(rough.cell, gaps, parameters.threads, rows);
  report.step(static_cast<double>(rough.cell.points() * rows.size()) * 0.5, "flow through the gaps");
  return rows;
}

// Laws for Gaussian surfaces with the numbers of this one.
void add_laws(const RoughnessNumbers& roughness, double E_prime, std::vector<MapRow>& rows) {
  const double gamma = roughness.peklenik;
  const bool known = wrong_gamma(gamma).empty();
  const double sigma = roughness.summit_sigma;
  const double scale = 2.0 / 3.0 * E_prime * roughness.eta_beta_sigma * std::sqrt(roughness.sigma_over_beta);
  for (MapRow& row : rows) {
    row.pressure_gw =
        sigma > 0.0 ? scale * gauss_moment(1.5, (row.gap - roughness.summit_height) / sigma) : core::unknown;
    row.phi_x_pc = known ? pressure_factor({gamma}, row.gap / roughness.Sq) : core::unknown;
    row.phi_y_pc = known ? pressure_factor({1.0 / gamma}, row.gap / roughness.Sq) : core::unknown;
  }
}

std::vector<double> pressures_of(const RoughnessNumbers& roughness, const MapParameters& parameters) {
  std::vector<double> pressures;
  for (int k = 0; k < parameters.rows; ++k) {
    const double share = static_cast<double>(k) / std::max(1, parameters.rows - 1);
    const double relative = heaviest * std::pow(lightest / heaviest, share);
    const double p = relative * 0.5 * parameters.E_prime * roughness.slope;
    if (p < most_of_hardness * parameters.hardness) pressures.push_back(p);
  }
  return pressures;
}

}  // namespace

const std::vector<MapColumn>& map_columns() {
  static const std::vector<MapColumn> all{
      {"gap", "m", [](const MapRow& row) { return row.gap; }},
      {"pressure", "Pa", [](const MapRow& row) { return row.pressure; }},
      {"phi_x", "-", [](const MapRow& row) { return row.phi_x; }},
      {"phi_y", "-", [](const MapRow& row) { return row.phi_y; }},
      {"area", "-", [](const MapRow& row) { return row.area; }},
      {"film", "m", [](const MapRow& row) { return row.film; }},
      {"largest_pressure", "Pa", [](const MapRow& row) { return row.largest_pressure; }},
      {"yielded", "-", [](const MapRow& row) { return row.yielded; }},
      {"error_gap", "m", [](const MapRow& row) { return row.error_gap; }},
      {"error_phi_x", "-", [](const MapRow& row) { return row.error_phi_x; }},
      {"error_phi_y", "-", [](const MapRow& row) { return row.error_phi_y; }},
      {"pressure_gw", "Pa", [](const MapRow& row) { return row.pressure_gw; }},
      {"phi_x_pc", "-", [](const MapRow& row) { return row.phi_x_pc; }},
      {"phi_y_pc", "-", [](const MapRow& row) { return row.phi_y_pc; }}};
  return all;
}

MapResult compute(const surface::Heights& heights, double dx, double dy, const MapParameters& parameters,
                  const MapObserver& observe) {
  MapResult result;
  const int longest = std::max(heights.nx, heights.ny);
  result.block = (longest + parameters.most_points - 1) / parameters.most_points;
  result.Sq_map = surface::rms(heights);
  const RoughCell rough = cell_of(heights, dx, dy, result.block, parameters);
  result.cell = rough.cell;
  result.roughness = roughness_numbers(rough.cell, rough.z);
  const std::vector<double> pressures = pressures_of(result.roughness, parameters);
  std::vector<double> wide;
  for (const double heights_of_summit : open_gaps) wide.push_back(heights_of_summit * result.roughness.highest);

  const bool half = parameters.error && std::min(rough.cell.nx, rough.cell.ny) >= 2 * fewest_points;
  const double work = static_cast<double>(rough.cell.points()) *
                      (static_cast<double>(pressures.size()) + 0.5 * static_cast<double>(pressures.size() + 3));
  Report report(observe, half ? 1.25 * work : work);
  result.rows = rows_of(rough, pressures, wide, parameters, report);
  add_laws(result.roughness, parameters.E_prime, result.rows);
  if (half) {
    const RoughCell coarse = cell_of(heights, dx, dy, 2 * result.block, parameters);
    const std::vector<MapRow> rows = rows_of(coarse, pressures, wide, parameters, report);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      MapRow& row = result.rows[k];
      row.error_gap = std::abs(row.gap - rows[k].gap);
      row.error_phi_x = std::abs(row.phi_x - rows[k].phi_x);
      row.error_phi_y = std::abs(row.phi_y - rows[k].phi_y);
    }
  }
  // Where nearly all has yielded the mean planes may have passed each other; such a gap holds no oil.
  std::erase_if(result.rows, [](const MapRow& row) { return !(row.gap > 0.0); });
  std::ranges::sort(result.rows, {}, &MapRow::gap);
  return result;
}

}  // namespace ehl::asperities
