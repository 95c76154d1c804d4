#include "rheology/shear.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "rheology/elementary.hpp"

namespace ehl::rheology {
namespace {

/// Below this asinh(s)/s is 1 - s^2/6 to the last bit.
constexpr double small_s = 1e-4;
/// Lower bound of H that keeps the fluidities finite; H^3 times them is negligible.
constexpr double least_film = 1e-30;

struct Two {
  Lanes along, across;
};

// B = H fluidity and m = sqrt(B^2 + k^2), so that s = k/B is never formed: B may be zero.
Two fluidities(Eyring, double k, Lanes B, Lanes m) {
  // asinh(k/B) = ln[(k + m)/B] as log1p of the argument less 1, with m - B = k^2/(m + B).
  const Lanes stress = log1p(k * (1.0 + k / (m + B)) / B);
  return {m, stress > 0.0 ? k / stress : B};
}
Two fluidities(const Carreau& law, double k, Lanes B, Lanes m) {
  // (1 + s^2)^((1-n)/2) B = m (m/B)^-n, and m/B = 1 + k^2/[B (m + B)].
  const Lanes across = m * exp(-law.n * log1p(k * (k / (m + B)) / B));
  return {across * ((m / (B * B + law.n * k * k)) * m), across};
}

Two slopes(Eyring law, double k, Lanes B, Lanes m) { return {(B / m) * (B / m), fluidities(law, k, B, m).across / m}; }
Two slopes(const Carreau& law, double k, Lanes B, Lanes m) {
  const Lanes share = (B / m) * (B / m);
  const Lanes across = law.n + (1.0 - law.n) * share;
  return {across + 2.0 * share - 2.0 * (B * B / (B * B + law.n * k * k)), across};
}

// f(B, m) for one register at a time; the remainder uses padded copies.
template <class Function>
void for_lanes(double k, std::span<const double> H, std::span<const double> fluidity, std::span<double> along,
               std::span<double> across, Function f) {
  constexpr std::size_t width = core::lanes;
  for (std::size_t first = 0; first < H.size(); first += width) {
    const std::size_t count = std::min(width, H.size() - first);
    std::array<double, width> film, oil, x, y;
    film.fill(1.0);
    oil.fill(1.0);
    std::copy_n(&H[first], count, film.data());
    std::copy_n(&fluidity[first], count, oil.data());
    Lanes h = core::load(film.data());
    h = h < least_film ? broadcast(least_film) : h;
    const Lanes B = h * core::load(oil.data());
    const Two result = f(h, B, square_root(B * B + k * k));
    core::store(x.data(), result.along);
    core::store(y.data(), result.across);
    std::copy_n(x.data(), count, &along[first]);
    std::copy_n(y.data(), count, &across[first]);
  }
}

}  // namespace

Thinned thinned(const ShearLaw& law, double s) {
  const double root = std::hypot(1.0, s);
  if (const auto* carreau = std::get_if<Carreau>(&law)) {
    const double across = std::pow(root, carreau->n - 1.0);
    const double share = (s / root) * (s / root);
    return {across * (1.0 + (carreau->n - 1.0) * share), across};
  }
  return {1.0 / root, s < small_s ? 1.0 - s * s / 6.0 : std::asinh(s) / s};
}

double limited(double tau, double limit) { return std::clamp(tau, -limit, limit); }

void film_fluidity(const ShearThinning& thinning, std::span<const double> H, std::span<const double> fluidity,
                   std::span<double> along, std::span<double> across) {
  const double k = thinning.k;
  if (k == 0.0) {
    std::ranges::copy(fluidity, along.begin());
    std::ranges::copy(fluidity, across.begin());
    return;
  }
  std::visit(
      [&](const auto& law) {
        for_lanes(k, H, fluidity, along, across, [&](Lanes h, Lanes B, Lanes m) {
          const Two B_thinned = fluidities(law, k, B, m);
          return Two{B_thinned.along / h, B_thinned.across / h};
        });
      },
      thinning.law);
}

void film_fluidity_slopes(const ShearThinning& thinning, std::span<const double> H, std::span<const double> fluidity,
                          std::span<double> along, std::span<double> across) {
  const double k = thinning.k;
  std::visit(
      [&](const auto& law) {
        for_lanes(k, H, fluidity, along, across, [&](Lanes, Lanes B, Lanes m) { return slopes(law, k, B, m); });
      },
      thinning.law);
}

ShearThinning rescaled(const ShearThinning& thinning, double factor) {
  return {thinning.law, thinning.k / (factor * factor)};
}

}  // namespace ehl::rheology
