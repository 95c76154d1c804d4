#include "transient/periodic.hpp"

#include <algorithm>
#include <cmath>

#include "transient/march.hpp"

namespace ehl::transient {

// Lagrange's cubic through the two films on each side of T. The film never jumps.
Periodic::Film Periodic::at(double T) const {
  const auto after = std::ranges::lower_bound(films_, T, {}, &Film::T);
  const auto room = static_cast<std::ptrdiff_t>(films_.size()) - 4;
  const std::ptrdiff_t first =
      std::clamp(after - films_.begin() - 2, std::ptrdiff_t{0}, std::max(std::ptrdiff_t{0}, room));
  const std::ptrdiff_t last = std::min(first + 4, static_cast<std::ptrdiff_t>(films_.size()));
  Film between{T, 0.0, 0.0};
  for (std::ptrdiff_t k = first; k < last; ++k) {
    const Film& one = films_[static_cast<std::size_t>(k)];
    double weight = 1.0;
    for (std::ptrdiff_t l = first; l < last; ++l) {
      const double other = films_[static_cast<std::size_t>(l)].T;
      if (l != k) weight *= (T - other) / (one.T - other);
    }
    between.Hc += weight * one.Hc;
    between.Hm += weight * one.Hm;
  }
  return between;
}

bool Periodic::add(const StepRow& row) {
  if (std::isnan(period_)) return false;
  films_.push_back({row.T, row.Hc, row.Hm});
  constexpr double rounding = 1e-12;
  if (row.T < next_ * (1.0 - rounding)) return false;
  next_ += period_;
  ++periods_;
  const double begin = row.T - period_;
  const bool two = films_.front().T <= begin - period_ * (1.0 - rounding);
  if (two) {
    change_ = 0.0;
    for (const Film& film : films_) {
      if (film.T <= begin) continue;
      const Film before = at(film.T - period_);
      change_ = std::max({change_, std::abs(film.Hc / before.Hc - 1.0), std::abs(film.Hm / before.Hm - 1.0)});
    }
  }
  std::erase_if(films_, [&](const Film& film) { return film.T < begin; });
  return two;
}

}  // namespace ehl::transient
