#include "asperities/rough_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/constants.hpp"

namespace ehl::asperities {
namespace {

constexpr int most_fast_steps = 200;  // of conjugate gradients, if there is a hardness

// The iterate. A point is free if its pressure lies between the bounds.
class ContactIteration {
 public:
  ContactIteration(const RoughCell& rough, double mean, std::vector<double> start)
      : rough_(rough),
        mean_(mean),
        deformation_(rough.cell, rough.E_prime, rough.threads),
        p_(std::move(start)),
        gap_(p_.size()),
        direction_(p_.size()),
        change_(p_.size()),
        smoothed_(p_.size()) {
    scale();
    update_gap();
  }

  void step();
  /// One step of the accelerated projected gradient, which converges from any state.
  void slow_step();
  double error() const { return error_; }
  CellContact result() const;

 private:
  bool free(std::size_t n) const { return p_[n] > 0.0 && p_[n] < rough_.hardness; }
  double mean_over_free(const std::vector<double>& f) const {
    double sum = 0.0, count = 0.0;
    for (std::size_t n = 0; n < f.size(); ++n)
      if (free(n)) {
        sum += f[n];
        count += 1.0;
      }
    return count > 0.0 ? sum / count : 0.0;
  }
  void scale();
  void update_gap();
  double contact_area() const;

  const RoughCell& rough_;
  double mean_;
  CellDeformation deformation_;
  std::vector<double> p_, gap_, direction_, change_, smoothed_;
  std::vector<double> old_p_{}, old_gap_{};  // of the step before, for the accelerated gradient
  double momentum_ = 1.0;                    // its sequence t_k; 1: begins again
  double separation_ = 0.0, error_ = 0.0;
  double old_square_ = 1.0;  // sum of gap^2 over the free points, in the previous step
  bool conjugate_ = false;   // false: the set of free points has changed, so the next direction is the gradient
};

// Multiplies the pressure until its mean is that asked for. Points at the hardness stay there, unless they alone carry
// more.
void ContactIteration::scale() {
  const double wanted = mean_ * static_cast<double>(p_.size());
  for (int round = 0; round < 50; ++round) {
    double at_bound = 0.0, below = 0.0;
    for (const double p : p_) (p < rough_.hardness ? below : at_bound) += p;
    if (at_bound >= wanted) {
      for (double& p : p_) p *= wanted / (at_bound + below);
      return;
    }
    const double factor = (wanted - at_bound) / below;
    bool reached = false;
    for (double& p : p_)
      if (p < rough_.hardness) {
        p = std::max(0.0, p * factor);
        reached = reached || p >= rough_.hardness;
        p = std::min(p, rough_.hardness);
      }
    if (!reached) return;
  }
}

// The separation: the mean gap over the free points is zero. Without free points it may lie between bounds.
void ContactIteration::update_gap() {
  deformation_.evaluate(p_, gap_);
  bool any_free = false;
  double least_open = 1e300, most_yielded = -1e300;
  for (std::size_t n = 0; n < gap_.size(); ++n) {
    gap_[n] -= rough_.z[n];
    any_free = any_free || free(n);
    if (p_[n] == 0.0) least_open = std::min(least_open, gap_[n]);
    if (p_[n] > 0.0) most_yielded = std::max(most_yielded, gap_[n]);
  }
  separation_ = any_free ? -mean_over_free(gap_) : -0.5 * (least_open + most_yielded);
  double loaded = 0.0, overlap = 0.0, all = 0.0;
  for (std::size_t n = 0; n < gap_.size(); ++n) {
    gap_[n] += separation_;
    all += gap_[n];
    if (p_[n] > 0.0)
      loaded += p_[n] * (free(n) ? std::abs(gap_[n]) : std::max(0.0, gap_[n]));
    else
      overlap += std::max(0.0, -gap_[n]);
  }
  error_ = std::isfinite(all) ? (loaded / mean_ + overlap) / static_cast<double>(gap_.size()) : core::unknown;
}

// The residual is the gap at the free points; the preconditioner, which is exact in full contact, makes a pressure of
// it.
void ContactIteration::step() {
  for (std::size_t n = 0; n < p_.size(); ++n) change_[n] = free(n) ? gap_[n] : 0.0;
  deformation_.invert(change_, smoothed_);
  const double offset = mean_over_free(smoothed_);
  double square = 0.0, plain = 0.0;
  for (std::size_t n = 0; n < p_.size(); ++n)
    if (free(n)) {
      smoothed_[n] -= offset;
      square += gap_[n] * smoothed_[n];
      plain += gap_[n] * gap_[n];
    }
  const double share = conjugate_ ? square / old_square_ : 0.0;
  const double stiffness = plain > 0.0 ? square / plain : 0.0;  // pressure over gap, for points at a bound
  old_square_ = square;
  for (std::size_t n = 0; n < p_.size(); ++n) direction_[n] = free(n) ? smoothed_[n] + share * direction_[n] : 0.0;

  deformation_.evaluate(direction_, change_);
  const double mean = mean_over_free(change_);
  double along = 0.0, curvature = 0.0;
  for (std::size_t n = 0; n < p_.size(); ++n) {
    along += gap_[n] * direction_[n];
    curvature += (change_[n] - mean) * direction_[n];
  }
  const double length = curvature > 0.0 ? along / curvature : 0.0;

  bool released = false;
  for (std::size_t n = 0; n < p_.size(); ++n) {
    const bool wrong_at_bound = !free(n) && (p_[n] > 0.0 ? gap_[n] > 0.0 : gap_[n] < 0.0);
    released = released || wrong_at_bound;
    if (free(n))
      p_[n] = std::clamp(p_[n] - length * direction_[n], 0.0, rough_.hardness);
    else if (wrong_at_bound)
      p_[n] = std::clamp(p_[n] - length * stiffness * gap_[n], 0.0, rough_.hardness);
  }
  conjugate_ = !released;
  scale();
  update_gap();
}

// p = clip(y - step (gap(y) + shift)), y the pressure extrapolated from the last two, and the shift such that the mean
// is that asked for: Nesterov's acceleration, which begins again where it points uphill (O'Donoghue and Candes 2015).
void ContactIteration::slow_step() {
  const double longest = std::max(rough_.cell.length_x(), rough_.cell.length_y());
  const double step = rough_.E_prime * core::pi / (4.0 * longest);  // one over the largest response, 4/(E' q)
  if (old_p_.empty()) {
    old_p_ = p_;
    old_gap_ = gap_;
  }
  const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * momentum_ * momentum_)), beta = (momentum_ - 1.0) / next;
  momentum_ = next;
  std::vector<double>& target = direction_;
  for (std::size_t n = 0; n < p_.size(); ++n)
    target[n] = p_[n] + beta * (p_[n] - old_p_[n]) - step * (gap_[n] + beta * (gap_[n] - old_gap_[n]));
  std::swap(old_p_, p_);
  old_gap_ = gap_;
  double shift = 0.0, low = -*std::ranges::max_element(target),
         high = rough_.hardness - *std::ranges::min_element(target);
  for (int round = 0; round < 100; ++round) {
    double sum = 0.0, count = 0.0;
    for (std::size_t n = 0; n < p_.size(); ++n) {
      p_[n] = std::clamp(target[n] + shift, 0.0, rough_.hardness);
      sum += p_[n];
      if (free(n)) count += 1.0;
    }
    const double lack = mean_ * static_cast<double>(p_.size()) - sum;
    if (std::abs(lack) <= 1e-13 * std::abs(sum)) break;
    (lack > 0.0 ? low : high) = shift;
    const double newton = shift + lack / std::max(1.0, count);
    shift = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  double uphill = 0.0;
  for (std::size_t n = 0; n < p_.size(); ++n) uphill += (target[n] - p_[n]) * (p_[n] - old_p_[n]);
  if (uphill < 0.0) momentum_ = 1.0;
  scale();
  update_gap();
}

// Counted points overestimate an elastic area, because every point at the edge of a contact counts whole. The
// correction is proportional to the length of all edges. (Yastrebov, Anciaux and Molinari 2017, Tribol. Int. 114, 161)
double ContactIteration::contact_area() const {
  const double correction = (core::pi - 1.0 + std::log(2.0)) / 24.0;
  const auto nx = static_cast<std::size_t>(rough_.cell.nx), ny = static_cast<std::size_t>(rough_.cell.ny);
  double points = 0.0, edges = 0.0;
  const auto count_edge = [&](std::size_t n, std::size_t m) {
    if ((free(n) && p_[m] == 0.0) || (free(m) && p_[n] == 0.0)) edges += 1.0;
  };
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i) {
      points += p_[j * nx + i] > 0.0 ? 1.0 : 0.0;
      if (i + 1 < nx) count_edge(j * nx + i, j * nx + i + 1);
      if (j + 1 < ny) count_edge(j * nx + i, (j + 1) * nx + i);
    }
  return (points - correction * edges) / static_cast<double>(p_.size());
}

CellContact ContactIteration::result() const {
  CellContact contact{.p = p_, .gap = gap_, .separation = separation_};
  const double count = static_cast<double>(p_.size());
  contact.area = contact_area();
  for (std::size_t n = 0; n < p_.size(); ++n) {
    contact.film += std::max(0.0, p_[n] > 0.0 ? 0.0 : gap_[n]) / count;
    contact.yielded += (p_[n] >= rough_.hardness ? 1.0 : 0.0) / count;
  }
  return contact;
}

double rms_of(const std::vector<double>& z) {
  double sum = 0.0;
  for (const double height : z) sum += height * height;
  return std::sqrt(sum / static_cast<double>(z.size()));
}

}  // namespace

CellContact solve(const RoughCell& rough, double mean_pressure, const std::vector<double>& start, double tolerance,
                  int max_iterations) {
  const double allowed = tolerance * rms_of(rough.z);
  ContactIteration iteration(rough, mean_pressure,
                             start.empty() ? std::vector<double>(rough.cell.points(), mean_pressure) : start);
  int k = 0;
  for (; k < max_iterations && iteration.error() > allowed; ++k) {
    // Where nearly all contact has yielded, the conjugate gradients have few free points, and may cycle.
    if (std::isfinite(rough.hardness) && k >= most_fast_steps)
      iteration.slow_step();
    else
      iteration.step();
  }
  CellContact contact = iteration.result();
  contact.iterations = k;
  contact.converged = iteration.error() <= allowed;
  contact.error = iteration.error() / rms_of(rough.z);
  return contact;
}

}  // namespace ehl::asperities
