#include "effects/subsurface/history.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace ehl::subsurface {
namespace {

constexpr std::array<const char*, met> names{"most_sigma_mises", "most_tau_max", "range_tau_xz"};
constexpr std::array<const char*, met> meanings{"largest von Mises stress that the material has met",
                                                "largest shear stress that the material has met",
                                                "range of tau_xz that the material has met"};

// Nodes first .. first + 3 and their weights in the cubic through them.
struct Cubic {
  int first = 0;
  std::array<double, 4> weights{};
};
Cubic cubic_at(double place, int last) {
  const int first = std::clamp(static_cast<int>(std::floor(place)) - 1, 0, last - 3);
  Cubic made{first, {}};
  for (int k = 0; k < 4; ++k) {
    double& weight = made.weights[static_cast<std::size_t>(k)] = 1.0;
    for (int other = 0; other < 4; ++other)
      if (other != k) weight *= (place - first - other) / (k - other);
  }
  return made;
}

double along(const core::Field& field, const Cubic& at, int j) {
  double sum = 0.0;
  for (int k = 0; k < 4; ++k) sum += at.weights[static_cast<std::size_t>(k)] * field(at.first + k, j);
  return sum;
}

const std::vector<core::Field>& planes_of(const StressField& stresses, Quantity quantity) {
  const auto found = std::ranges::find(stresses.kept, quantity, &Volume::quantity);
  if (found == stresses.kept.end()) throw std::logic_error(std::string("a history needs ") + name(quantity));
  return found->planes;
}

}  // namespace

const char* name(Met what) { return names[static_cast<std::size_t>(what)]; }
const char* meaning(Met what) { return meanings[static_cast<std::size_t>(what)]; }

History::History(const core::Grid& grid, const std::vector<double>& depths, double from, double to)
    : of_stresses_(grid), grid_(grid), depths_(depths) {
  const double h = grid.hx();
  const int before = static_cast<int>(std::ceil(to / h - 1e-9)), after = static_cast<int>(std::ceil(-from / h - 1e-9));
  grid_.nx = grid.nx + before + after;
  grid_.X_a = grid.X_a - before * h;
  grid_.X_b = grid.X_b + after * h;
  for (std::vector<core::Field>* list : {&mises_, &tau_, &high_, &low_})
    list->assign(depths.size(), core::Field(grid_));
}

void History::add(const StressField& stresses, double displacement, int threads) {
  const double h = of_stresses_.hx();
  if (begun_) longest_move_ = std::max(longest_move_, std::abs(displacement - last_) / h);
  begun_ = true;
  last_ = displacement;
  const std::vector<core::Field>& mises = planes_of(stresses, sigma_mises);
  const std::vector<core::Field>& tau = planes_of(stresses, tau_max);
  const std::vector<core::Field>& orthogonal = planes_of(stresses, tau_xz);
  const int planes = static_cast<int>(depths_.size());
#pragma omp parallel for num_threads(threads) if (threads > 1)
  for (int k = 0; k < planes; ++k) {
    const auto plane = static_cast<std::size_t>(k);
    for (int i = 0; i < grid_.nodes_x(); ++i) {
      const double place = (grid_.X(i) + displacement - of_stresses_.X_a) / h;
      constexpr double rounding = 1e-9;
      if (place < -rounding || place > of_stresses_.nx + rounding) continue;
      const Cubic at = cubic_at(place, of_stresses_.nx);
      for (int j = 0; j < grid_.nodes_y(); ++j) {
        mises_[plane](i, j) = std::max(mises_[plane](i, j), along(mises[plane], at, j));
        tau_[plane](i, j) = std::max(tau_[plane](i, j), along(tau[plane], at, j));
        const double sheared = along(orthogonal[plane], at, j);
        high_[plane](i, j) = std::max(high_[plane](i, j), sheared);
        low_[plane](i, j) = std::min(low_[plane](i, j), sheared);
      }
    }
  }
}

double History::value(Met what, std::size_t plane, int i, int j) const {
  if (what == largest_mises) return mises_[plane](i, j);
  if (what == largest_tau) return tau_[plane](i, j);
  return high_[plane](i, j) - low_[plane](i, j);
}

Maximum History::largest(Met what) const {
  Maximum most{.value = -1.0};
  for (std::size_t plane = 0; plane < depths_.size(); ++plane)
    for (int i = 0; i < grid_.nodes_x(); ++i)
      for (int j = 0; j < grid_.nodes_y(); ++j)
        if (const double here = value(what, plane, i, j); here > most.value)
          most = {here, grid_.X(i), grid_.Y(j), depths_[plane], here};
  return most;
}

core::Field History::section(Met what) const {
  const int line = grid_.line ? 1 : static_cast<int>(std::lround(-grid_.Y_a / grid_.hy()));
  core::Field made(grid_.nodes_x(), static_cast<int>(depths_.size()));
  for (std::size_t plane = 0; plane < depths_.size(); ++plane)
    for (int i = 0; i < grid_.nodes_x(); ++i) made(i, static_cast<int>(plane)) = value(what, plane, i, line);
  return made;
}

}  // namespace ehl::subsurface
