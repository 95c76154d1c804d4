#include "effects/subsurface/stress.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/errors.hpp"
#include "core/timer.hpp"
#include "effects/subsurface/plane_sum.hpp"
#include "effects/subsurface/strip.hpp"
#include "transfer/transfer.hpp"

namespace ehl::subsurface {
namespace {

struct QuantityRecord {
  const char* name;
  const char* meaning;
};
constexpr QuantityRecord records[quantities] = {
    {"sigma_mises", "equivalent stress of von Mises"},
    {"tau_max", "largest shear stress of all planes, (sigma_1 - sigma_3)/2"},
    {"sigma_x", "normal stress along x, tension positive"},
    {"sigma_y", "normal stress along y, tension positive"},
    {"sigma_z", "normal stress along z, tension positive"},
    {"tau_xy", "shear stress"},
    {"tau_xz", "shear stress"},
    {"tau_yz", "shear stress"}};

// Exponent of the depths: planes are densest near the surface, where friction and pressure spikes act.
constexpr double grading = 1.5;

double value_of(Quantity quantity, const Stress& s) {
  switch (quantity) {
    case sigma_mises: return mises(s);
    case tau_max: return largest_shear(s);
    case sigma_x: return s[xx];
    case sigma_y: return s[yy];
    case sigma_z: return s[zz];
    case tau_xy: return s[xy];
    case tau_xz: return s[xz];
    case tau_yz: return s[yz];
  }
  return 0.0;
}

// Parabola through three values along an axis, of which the middle one is the largest.
struct Peak {
  double shift = 0.0;  // of the maximum from the middle node
  double rise = 0.0;   // of the maximum above the middle value
};
Peak parabola(double before, double after, double f_before, double f, double f_after) {
  const double a = f_before - f, b = f_after - f;  // at -before and +after
  const double curvature = (a / before + b / after) / (before + after);
  const double slope = (b * before / after - a * after / before) / (before + after);
  if (!(curvature < 0.0)) return {};
  const double shift = std::clamp(-0.5 * slope / curvature, -before, after);
  return {shift, slope * shift + curvature * shift * shift};
}

// The first node with the largest value.
struct Best {
  int plane = 0;
  int i = 0;
  int j = 0;
  double value = -1.0;
};

core::Field pressure_on(const core::Grid& coarse, const core::Grid& grid, const core::Field& P) {
  core::Field now = P;
  for (core::Grid step = grid; step.nx > coarse.nx;) {
    step = core::coarsened(step);
    core::Field next(step);
    transfer::restrict_full_weighting(step, now, next);
    now = std::move(next);
  }
  return now;
}

Stress stress_of(const StressFields& stress, int i, int j) {
  Stress s{};
  for (std::size_t k = 0; k < components; ++k) s[k] = stress[k](i, j);
  return s;
}

void take_plane(const StressFields& stress, const core::Grid& grid, Quantity quantity, core::Field& out) {
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j) out(i, j) = value_of(quantity, stress_of(stress, i, j));
}

// Depth in cells within which the single cells of pressure are visible below a spike: the largest stress grows with the
// mesh there, and parabolas overshoot. [bench: subsurface_felt]
constexpr double felt = 2.0;
double shallow(const core::Grid& grid) { return felt * grid.longest_step(); }

Maximum fitted(const StressField& field, const Best& best, const std::vector<core::Field>& planes) {
  const core::Grid& grid = field.grid;
  const std::size_t k = static_cast<std::size_t>(best.plane);
  const auto at = [&](std::size_t plane, int d_x, int d_y) { return planes[plane](best.i + d_x, best.j + d_y); };
  Maximum maximum{best.value, grid.X(best.i), grid.Y(best.j), field.depths[k], best.value};
  if (maximum.Z < shallow(grid)) return maximum;
  const auto add = [&](double& position, const Peak& peak) {
    position += peak.shift;
    maximum.value += peak.rise;
  };
  const double f = best.value, hx = grid.hx(), hy = grid.hy();
  if (best.i > 0 && best.i < grid.nx) add(maximum.X, parabola(hx, hx, at(k, -1, 0), f, at(k, 1, 0)));
  if (best.j > 0 && best.j < grid.ny) add(maximum.Y, parabola(hy, hy, at(k, 0, -1), f, at(k, 0, 1)));
  if (k > 0 && k + 1 < planes.size())
    add(maximum.Z, parabola(field.depths[k] - field.depths[k - 1], field.depths[k + 1] - field.depths[k],
                            at(k - 1, 0, 0), f, at(k + 1, 0, 0)));
  return maximum;
}

Best best_of(const core::Grid& grid, const std::vector<core::Field>& planes) {
  Best best;
  for (std::size_t k = 0; k < planes.size(); ++k)
    for (int i = 0; i < grid.nodes_x(); ++i)
      for (int j = 0; j < grid.nodes_y(); ++j)
        if (planes[k](i, j) > best.value) best = {static_cast<int>(k), i, j, planes[k](i, j)};
  return best;
}

// The two quantities whose maxima are reported, and the other ones to keep.
std::vector<Quantity> computed(const Parameters& parameters) {
  std::vector<Quantity> list{sigma_mises, tau_max};
  for (const Quantity quantity : parameters.kept)
    if (std::ranges::find(list, quantity) == list.end()) list.push_back(quantity);
  return list;
}

void warn(StressField& field) {
  const double depth = field.depths.back();
  for (const auto& [quantity, maximum] : {std::pair{sigma_mises, field.mises}, {tau_max, field.shear}}) {
    const std::string largest = std::string("subsurface: the largest ") + name(quantity);
    if (maximum.Z == depth)
      field.warnings.push_back(
          {"stress-depth", largest + " lies on the lowest plane: take a larger [subsurface] depth"});
    else if (maximum.Z < shallow(field.grid))
      field.warnings.push_back(
          {"stress-at-surface", largest +
                                    " lies within two cells of the surface and may belong to the mesh of the pressure: "
                                    "compare with more cells"});
  }
}

}  // namespace

const char* name(Quantity quantity) { return records[quantity].name; }
const char* meaning(Quantity quantity) { return records[quantity].meaning; }

std::vector<double> depths_of(const Parameters& parameters) {
  std::vector<double> depths;
  for (int k = 0; k < parameters.planes; ++k)
    depths.push_back(parameters.depth * std::pow(static_cast<double>(k) / (parameters.planes - 1), grading));
  return depths;
}

core::Grid stress_grid(const core::Patch& contact, const Parameters& parameters) {
  core::Grid grid = contact.domain;
  while (grid.nx > parameters.most_cells && grid.nx % 2 == 0 && grid.ny % 2 == 0) grid = core::coarsened(grid);
  return grid;
}

double expected_bytes(const core::Grid& contact, const Parameters& parameters, int threads) {
  const core::Grid grid = stress_grid(contact, parameters);
  const double nodes = static_cast<double>(grid.nodes_x()) * grid.nodes_y();
  const double per_thread = 4.0 + 2.0 * components + components;  // spectrum, kernels, one plane
  const double kept = static_cast<double>(computed(parameters).size() * static_cast<std::size_t>(parameters.planes));
  return sizeof(double) * nodes * (4.0 + kept + per_thread * std::min(threads, parameters.planes));
}

double bytes_of_kernels(const core::Grid& contact, const Parameters& parameters) {
  const core::Grid grid = stress_grid(contact, parameters);
  const double numbers = grid.line ? 6.0 * (2.0 * grid.nx + 1.0)
                                   : loads * static_cast<double>(components) * (Padding(grid).length_x / 2 + 1) *
                                         static_cast<double>(Padding(grid).stride / 2);
  return sizeof(double) * numbers * parameters.planes;
}

double expected_seconds(const core::Grid& contact, const Parameters& parameters) {
  const core::Grid grid = stress_grid(contact, parameters);
  constexpr double seconds_per_pair = 3e-9;  // of nodes, for a line contact
  if (grid.line) return seconds_per_pair * parameters.planes * std::pow(grid.nodes_x(), 2);
  constexpr double seconds_per_node_and_plane = 1.2e-6;  // one thread [bench: subsurface_seconds]
  return seconds_per_node_and_plane * parameters.planes * static_cast<double>(grid.nodes_x()) * grid.nodes_y();
}

namespace {

// Computes plane k on thread t. out: its stresses.
using Plane = std::function<void(std::size_t k, int t, StressFields& stress)>;

// All planes; each goes to the next free thread.
void compute(const Plane& evaluate, StressField& field, int line, int team, const Observer& observe) {
  const int planes = field.parameters.planes;
  int done = 0;
  bool stopped = false;
#pragma omp parallel num_threads(team) if (team > 1)
  {
    StressFields stress;
    for (core::Field& component : stress) component = core::Field(field.grid);
#pragma omp for schedule(dynamic, 1)
    for (int plane = 0; plane < planes; ++plane) {
      bool skip = false;
#pragma omp critical(ehl_subsurface_stop)
      skip = stopped;
      if (skip) continue;
      const auto k = static_cast<std::size_t>(plane);
      evaluate(k, omp_get_thread_num(), stress);
      for (Volume& volume : field.kept) {
        volume.planes[k] = core::Field(field.grid);
        take_plane(stress, field.grid, volume.quantity, volume.planes[k]);
      }
      for (int q = 0; q < quantities; ++q)
        for (int i = 0; i < field.grid.nodes_x(); ++i)
          field.section[static_cast<std::size_t>(q)](i, plane) =
              value_of(static_cast<Quantity>(q), stress_of(stress, i, line));
#pragma omp critical(ehl_subsurface_stop)
      if (++done; observe && !stopped) stopped = !observe(done);
    }
  }
  if (stopped) throw core::Interrupted();
}

// The kernel of plane k: that of `kept`, made if it is not there yet, or one made again in `own`.
template <class Kernel, class Make>
const Kernel& kernel_of(std::vector<std::optional<Kernel>>* kept, std::size_t k, std::optional<Kernel>& own,
                        const Make& make) {
  std::optional<Kernel>& place = kept != nullptr ? (*kept)[k] : own;
  if (kept == nullptr || !place) place.emplace(make());
  return *place;
}

void compute(const core::Field& P, const Parameters& parameters, StressField& field, int line, int threads,
             const Observer& observe, Kernels* kernels) {
  const core::Grid& grid = field.grid;
  const int team = std::min(threads, parameters.planes);
  if (kernels != nullptr) {
    kernels->planes.resize(field.depths.size());
    kernels->strips.resize(field.depths.size());
  }
  if (grid.line) {
    const Plane strips = [&](std::size_t k, int, StressFields& stress) {
      std::optional<StripKernel> own;
      const StripKernel& kernel = kernel_of(kernels != nullptr ? &kernels->strips : nullptr, k, own,
                                            [&] { return StripKernel(grid, parameters.nu, field.depths[k]); });
      stress_of_line(kernel, grid, P, parameters.friction, stress);
    };
    return compute(strips, field, line, team, observe);
  }
  const PlaneSum sum(grid, P);
  struct Work {
    PlaneKernel::Work kernel;
    PlaneSum::Work sum;
    std::optional<PlaneKernel> own{};
  };
  std::vector<Work> work;
  for (int t = 0; t < team; ++t) work.push_back({PlaneKernel::Work(grid), PlaneSum::Work(sum)});
  const bool with_shear = kernels != nullptr || parameters.friction != 0.0;
  const Plane by_transform = [&](std::size_t k, int t, StressFields& stress) {
    Work& mine = work[static_cast<std::size_t>(t)];
    const PlaneKernel& kernel = kernel_of(kernels != nullptr ? &kernels->planes : nullptr, k, mine.own, [&] {
      return PlaneKernel(grid, parameters.nu, field.depths[k], with_shear, mine.kernel);
    });
    sum.evaluate(kernel, parameters.friction, mine.sum, stress);
  };
  compute(by_transform, field, line, team, observe);
}

}  // namespace

StressField stress_below(const core::Grid& grid, const core::Field& P, const Parameters& parameters, int threads,
                         const Observer& observe, Kernels* kernels) {
  const double start = core::now();
  StressField field;
  field.parameters = parameters;
  field.grid = stress_grid(grid, parameters);
  field.depths = depths_of(parameters);
  for (const Quantity quantity : computed(parameters))
    field.kept.push_back({quantity, std::vector<core::Field>(static_cast<std::size_t>(parameters.planes))});
  field.section.assign(quantities, core::Field(field.grid.nodes_x(), parameters.planes));
  const int line = static_cast<int>(std::lround(-field.grid.Y_a / field.grid.hy()));
  field.section_Y = field.grid.Y(line);
  compute(pressure_on(field.grid, grid, P), parameters, field, line, threads, observe, kernels);
  field.mises = fitted(field, best_of(field.grid, field.kept[0].planes), field.kept[0].planes);
  field.shear = fitted(field, best_of(field.grid, field.kept[1].planes), field.kept[1].planes);
  std::erase_if(field.kept, [&](const Volume& volume) {
    return std::ranges::find(parameters.kept, volume.quantity) == parameters.kept.end();
  });
  warn(field);
  field.seconds = core::now() - start;
  return field;
}

}  // namespace ehl::subsurface
