#include "thermal/body_memory.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <utility>

namespace ehl::thermal {
namespace {

// Material nodes upstream of the first node of the patch, for the interpolation there.
constexpr int upstream = 2;

// Weights of cubic interpolation between four equidistant values, at the share s of the middle interval.
std::array<double, 4> cubic(double s) {
  return {-s * (s - 1.0) * (s - 2.0) / 6.0, (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0, -(s + 1.0) * s * (s - 2.0) / 2.0,
          (s + 1.0) * s * (s - 1.0) / 6.0};
}

// Weights of the old and the new flux in int_0^1 exp(-x t) q dt, t the time before the end of the step.
struct Weights {
  double before, now;
};
Weights weights_of(double x) {
  constexpr double small = 0.01;
  if (x < small)  // Taylor series, accurate to rounding
    return {0.5 - x / 3.0 + x * x / 8.0 - x * x * x / 30.0 + x * x * x * x / 144.0,
            0.5 - x / 6.0 + x * x / 24.0 - x * x * x / 120.0 + x * x * x * x / 720.0};
  const double e = std::exp(-x);
  return {(1.0 - e * (1.0 + x)) / (x * x), (e - 1.0 + x) / (x * x)};
}

}  // namespace

// Integrated by parts: w_m is the difference of the means of 2 sqrt(ago) over the cells next to node i - m.
std::vector<double> passing_weights(int n, double hx, const std::function<double(double)>& ago) {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  const auto g = [&](double d) { return 2.0 * std::sqrt(ago(d)); };
  std::vector<double> weights(static_cast<std::size_t>(n + 1));
  double before = 0.0;
  for (int m = 0; m <= n; ++m) {
    // In the first cell g starts as a root, and s^2 = d/hx makes it smooth.
    const double mean = m == 0 ? Gauss::integrate([&](double s) { return 2.0 * s * g(hx * s * s); }, 0.0, 1.0)
                               : Gauss::integrate([&](double s) { return g(hx * (m + s)); }, 0.0, 1.0);
    weights[static_cast<std::size_t>(m)] = mean - before;
    before = mean;
  }
  return weights;
}

BodyMemory::BodyMemory(const core::Patch& patch, double factor, ExponentialSum kernel, int threads)
    : patch_(patch),
      factor_(factor),
      kernel_(std::move(kernel)),
      threads_(threads),
      count_(patch.nodes_x() + upstream + 1),
      memory_(static_cast<std::size_t>(count_) * terms() * lines()),
      flux_(static_cast<std::size_t>(count_) * lines()),
      known_(flux_.size()) {}

void BodyMemory::look(double length, double moved, core::Field& history) {
  length_ = length;
  moved_ = moved;
  self_ = factor_ * 4.0 / 3.0 * std::sqrt(length);
  std::vector<double> decayed(terms());
  for (std::size_t k = 0; k < terms(); ++k) decayed[k] = kernel_.weight[k] * std::exp(-kernel_.rate[k] * length);
  const double of_flux = 2.0 / 3.0 * std::sqrt(length);
  // Node m of the material lies at m + offset_, m from -upstream, before the step.
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (int m = 0; m < count_; ++m) {
    double* known = &known_[static_cast<std::size_t>(m) * lines()];
    const std::size_t at = place(m);
    for (std::size_t j = 0; j < lines(); ++j) known[j] = of_flux * flux_[at * lines() + j];
    for (std::size_t k = 0; k < terms(); ++k) {
      const double* memory = &memory_[(at * terms() + k) * lines()];
      for (std::size_t j = 0; j < lines(); ++j) known[j] += decayed[k] * memory[j];
    }
  }
  const double displaced = offset_ + moved / patch_.hx();
  const int whole = static_cast<int>(std::floor(displaced));
  // Node i of the patch lies at the share 1 - rest between the material nodes i - 1 - whole and i - whole.
  const double rest = displaced - whole;
  const std::array<double, 4> weights = cubic(1.0 - rest);
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (int i = 0; i <= patch_.nx; ++i)
    for (std::size_t j = 0; j < lines(); ++j) {
      double sum = 0.0;
      for (int n = 0; n < 4; ++n) {
        const int m = i - 2 + n - whole + upstream;
        if (m >= 0 && m < count_)
          sum += weights[static_cast<std::size_t>(n)] * known_[static_cast<std::size_t>(m) * lines() + j];
      }
      history(i, static_cast<int>(j)) = factor_ * sum;
    }
}

void BodyMemory::accept(const core::Field& q) {
  const double displaced = offset_ + moved_ / patch_.hx();
  const int whole = static_cast<int>(std::floor(displaced));
  offset_ = displaced - whole;
  // The places of material that has left the domain belong to what enters, which has no history.
  const int entering = std::min(whole, count_);
  passed_ = (passed_ + whole) % count_;
  for (int m = 0; m < entering; ++m) {
    const std::size_t at = place(m);
    std::fill_n(&memory_[at * terms() * lines()], terms() * lines(), 0.0);
    std::fill_n(&flux_[at * lines()], lines(), 0.0);
  }
  const std::array<double, 4> weights = cubic(offset_);
  std::vector<double> decay(terms());
  std::vector<Weights> of_flux(terms());
  for (std::size_t k = 0; k < terms(); ++k) {
    decay[k] = std::exp(-kernel_.rate[k] * length_);
    of_flux[k] = weights_of(kernel_.rate[k] * length_);
  }
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (int m = 0; m < count_; ++m) {
    const std::size_t at = place(m);
    // Material node m lies at the share offset_ between the nodes m - upstream and m - upstream + 1 of the patch.
    for (std::size_t j = 0; j < lines(); ++j) {
      double now = 0.0;
      for (int n = 0; n < 4; ++n) {
        const int i = m - upstream - 1 + n;
        if (i >= 0 && i <= patch_.nx) now += weights[static_cast<std::size_t>(n)] * q(i, static_cast<int>(j));
      }
      known_[static_cast<std::size_t>(m) * lines() + j] = now;
    }
    double* before = &flux_[at * lines()];
    const double* now = &known_[static_cast<std::size_t>(m) * lines()];
    for (std::size_t k = 0; k < terms(); ++k) {
      double* memory = &memory_[(at * terms() + k) * lines()];
      const double of_before = length_ * of_flux[k].before, of_now = length_ * of_flux[k].now;
      for (std::size_t j = 0; j < lines(); ++j)
        memory[j] = decay[k] * memory[j] + of_before * before[j] + of_now * now[j];
    }
    std::copy_n(now, lines(), before);
  }
}

}  // namespace ehl::thermal
