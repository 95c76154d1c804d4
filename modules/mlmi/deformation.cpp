#include "mlmi/deformation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/errors.hpp"
#include "core/store_lines.hpp"
#include "mlmi/line_sum.hpp"
#include "mlmi/multilevel_sum.hpp"

namespace ehl::mlmi {
namespace {

// Below this number of cells a team of threads costs more than it saves.
constexpr int smallest_parallel = 256;

// Least number of cells after a coarsening: the interpolation must fit.
constexpr int fewest_cells = 8;
// Ten halvings in each direction, the most that 8192 cells allow. The deck's key has the same limit.
constexpr int coarsening_limit = 20;
// Largest radius of a patch, far above the defaults. The deck's keys have the same limit.
constexpr int largest_patch = 64;

bool leaves_enough(const core::Grid& grid, int coarsenings) {
  const int in_y = grid.finer_lines() == 1 ? 0 : coarsenings / 2, in_x = coarsenings - in_y;
  return coarsenings <= coarsening_limit && (in_x == 0 || grid.nx >> in_x >= fewest_cells) &&
         (in_y == 0 || grid.ny >> in_y >= fewest_cells);
}

// The cheapest choice whose error is below 10 % of the discretization error on every level, with a margin for pressures
// with sharper features than the measured one (tests/bench/deformation_defaults.csv, deformation_order.csv).
MultilevelChoice default_choice(const core::Grid& grid, bool coated) {
  const int n = std::max(grid.nx, grid.ny);
  MultilevelChoice choice{.order = 8, .patch_along = 9, .patch_across = 4, .coarsenings = 4};
  if (n < 384) choice.patch_across = 3;
  // Near a soft coating the kernel varies over its thickness as well. [bench: patch_of_coatings]
  if (coated) {
    choice.patch_along = 12;
    choice.patch_across = 5;
  }
  // On these grids the exact sum costs no more.
  if (n < 96 || grid.line) choice.coarsenings = 0;
  // Coarsenings alternate between X and Y, beginning with X: on stretched cells a patch would be hx/hy times as wide
  // along Y.
  if (core::stretched(grid)) choice.coarsenings = 0;
  choice.coarsenings = std::min(choice.coarsenings, most_coarsenings(grid));
  return choice;
}

MultilevelChoice chosen(const core::Grid& grid, const Parameters& parameters, bool coated) {
  MultilevelChoice choice = default_choice(grid, coated);
  if (parameters.order > 0) choice.order = parameters.order;
  if (parameters.patch_along > 0) choice.patch_along = parameters.patch_along;
  if (parameters.patch_across > 0) choice.patch_across = parameters.patch_across;
  if (parameters.coarsenings >= 0) choice.coarsenings = parameters.coarsenings;
  choice.coarsest_direct = parameters.coarsest_direct;
  return choice;
}

void check(const core::Grid& grid, const MultilevelChoice& choice) {
  std::vector<std::string> errors;
  if (choice.order != 4 && choice.order != 6 && choice.order != 8)
    errors.push_back("deformation: transfer order " + std::to_string(choice.order) + " given, 4, 6 or 8 allowed");
  if (choice.patch_along > largest_patch || choice.patch_across > largest_patch)
    errors.push_back("deformation: correction patch " + std::to_string(choice.patch_along) + " x " +
                     std::to_string(choice.patch_across) + " given, at most " + std::to_string(largest_patch) +
                     " points allowed");
  if (!leaves_enough(grid, choice.coarsenings))
    errors.push_back("deformation: " + std::to_string(choice.coarsenings) + " coarsenings given, but a grid of " +
                     std::to_string(grid.nx) + " x " + std::to_string(grid.ny) + " cells must keep at least " +
                     std::to_string(fewest_cells) + " cells in each direction that is coarsened");
  if (!errors.empty()) throw core::InputError(errors);
}

std::string describe(const MultilevelChoice& choice, const std::string& coarsest_points, bool line) {
  const std::string coarsest =
      (choice.coarsest_direct ? std::string("direct sum") : std::string("FFT")) + " on " + coarsest_points;
  std::string across;
  if (!line) across.append("x").append(std::to_string(choice.patch_across));
  if (choice.coarsenings == 0) return "mlmi, no coarsening, " + coarsest;
  return "mlmi, order " + std::to_string(choice.order) + ", patch " + std::to_string(choice.patch_along) + across +
         ", " + std::to_string(choice.coarsenings) + (choice.coarsenings == 1 ? " coarsening, " : " coarsenings, ") +
         coarsest;
}

}  // namespace

int most_coarsenings(const core::Grid& grid) {
  int most = 0;
  while (leaves_enough(grid, most + 1)) ++most;
  return most;
}

Parameters fitting(Parameters parameters, const core::Patch& coarser) {
  parameters.coarsenings = std::min(parameters.coarsenings, most_coarsenings(coarser.domain));
  return parameters;
}

struct Deformation::Implementation {
  std::string description;
  std::optional<MultilevelSum> sum;
  std::optional<LineSum> line_sum;  // line contacts use this one instead
  double of_unit = 0.0;             // what the unit of length of a line contact adds, per sum of P
  core::Patch grid;
  // For sums that do not use the symmetry.
  core::Field whole_P, whole_w;
  std::vector<double> along_P, along_w;  // line contacts only
};

Deformation::Deformation(const core::Patch& grid, const Parameters& parameters, int threads,
                         const kernel::Kernel& kernel) {
  const int team = std::max(grid.nx, grid.domain.ny) < smallest_parallel ? 1 : std::max(1, threads);
  const core::Grid& whole = grid.domain;
  // The direct sum and the plain FFT are the multilevel sum without coarsening.
  MultilevelChoice choice{.coarsenings = 0, .coarsest_direct = parameters.method == Method::direct};
  if (parameters.method == Method::mlmi) {
    choice = chosen(whole, parameters, !kernel.coatings.empty());
    check(whole, choice);
  }
  implementation_ = std::make_unique<Implementation>();
  Implementation& own = *implementation_;
  own.grid = grid;
  switch (parameters.method) {
    case Method::mlmi: break;
    case Method::fft: own.description = std::string("FFT (") + fourier_library() + ")"; break;
    case Method::direct: own.description = "direct sum"; break;
  }
  const Axis x{0, grid.nx, 1, grid.hx()};
  if (kernel.plane) {
    own.line_sum.emplace(x, choice, kernel);
    own.along_P = own.along_w = std::vector<double>(static_cast<std::size_t>(grid.nodes_x()));
    own.of_unit = -kernel.factor * grid.hx() * kernel::at_distance(kernel, parameters.line_unit);
    choice.coarsest_direct = own.line_sum->coarsest_direct();
    if (parameters.method == Method::mlmi)
      own.description = describe(choice, std::to_string(own.line_sum->coarsest_points()), true);
    return;
  }
  Axis y{0, grid.ny, 1, grid.hy(), grid.north};
  const bool on_whole = y.end == core::Edge::mirror && !holds_mirror(y, choice);
  if (on_whole) y = {0, whole.ny, 1, whole.hy()};
  own.sum.emplace(x, y, choice, kernel, team);
  if (on_whole) own.whole_P = own.whole_w = core::Field(whole);
  if (parameters.method == Method::mlmi)
    own.description = describe(
        choice, std::to_string(own.sum->coarsest_rows()) + "x" + std::to_string(own.sum->coarsest_columns()), false);
}
Deformation::~Deformation() = default;
Deformation::Deformation(Deformation&&) noexcept = default;
Deformation& Deformation::operator=(Deformation&&) noexcept = default;

void Deformation::evaluate_along(std::span<const double> P, std::span<double> w) {
  Implementation& own = *implementation_;
  double more = 0.0;
  if (own.of_unit != 0.0)
    for (const double pressure : P) more += own.of_unit * pressure;
  own.line_sum->apply([&](int i) { return P[static_cast<std::size_t>(i)]; },
                      [&](int i, double value) { w[static_cast<std::size_t>(i)] = value + more; });
}

void Deformation::evaluate(const core::Field& P, core::Field& w) {
  Implementation& own = *implementation_;
  if (own.line_sum) {
    core::load_line(P, own.along_P);
    evaluate_along(own.along_P, own.along_w);
    core::store_line(own.along_w, w);
    return;
  }
  if (own.whole_P.nodes_x() == 0) {
    own.sum->apply(P.at_x(0), P.stride(), w.at_x(0), w.stride());
    return;
  }
  core::copy_to_domain(own.grid, P, own.whole_P);
  own.sum->apply(own.whole_P.at_x(0), own.whole_P.stride(), own.whole_w.at_x(0), own.whole_w.stride());
  core::copy_to_patch(own.grid, own.whole_w, w);
}

std::string Deformation::description() const { return implementation_->description; }
std::size_t Deformation::bytes() const {
  return implementation_->sum ? implementation_->sum->bytes() : implementation_->line_sum->bytes();
}

}  // namespace ehl::mlmi
