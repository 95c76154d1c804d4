#include "surface/feature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/constants.hpp"

namespace ehl::surface {
namespace {

using core::pi;

/// Time steps per width of a feature, and per wave length: a quarter of a wave has as many steps as a width.
/// [bench: surface_parts_of_a_width]
constexpr double parts_of_a_width = 4.0;
constexpr double parts_of_a_wave = 16.0;
/// Mourier's formula contains 1.2 times the radius of the cavity.
constexpr double cavity_stretch = 1.2;
/// A line whose angle has a smaller cosine is parallel to X, up to rounding.
constexpr double along_X = 1e-12;
/// Largest width of a part of a cell in the quadrature with two Gauss points, in feature widths. The error of the mean
/// is part^4 f''''/4320. most_parts suffices for a cell of 16 widths.
constexpr double widest_part = 0.25;
constexpr double widest_part_of_a_wave = 0.125;
constexpr int most_parts = 64;

double squared(double x) { return x * x; }

bool has_a_line(Feature::Shape shape) {
  using Shape = Feature::Shape;
  return shape == Shape::ridge || shape == Shape::groove || shape == Shape::waviness;
}

// The first crest of the gap is at the centre of the feature; ahead of it, along X, the waves fade.
double waves(const Feature& feature, double across, double dX) {
  const double ahead = dX / feature.width;
  const double wave = feature.height * std::cos(2.0 * pi * across / feature.width);
  return feature.front && ahead > 0.0 ? wave * std::pow(10.0, -10.0 * ahead * ahead) : wave;
}

// Gauss points on a cell of length h, measured from its centre.
std::vector<double> gauss_points(double h, double widest) {
  const int parts = std::clamp(static_cast<int>(std::ceil(h / widest)), 1, most_parts);
  const double part = h / parts;
  const double beside = 0.5 * part / std::numbers::sqrt3;
  std::vector<double> points;
  for (int k = 0; k < parts; ++k) {
    const double middle = (k + 0.5) * part - 0.5 * h;
    points.insert(points.end(), {middle - beside, middle + beside});
  }
  return points;
}

}  // namespace

double gap_of(const Feature& feature, double dX, double dY) {
  using Shape = Feature::Shape;
  const double r2 = dX * dX + dY * dY;
  const double across = dX * std::cos(feature.angle) + dY * std::sin(feature.angle);
  switch (feature.shape) {
    case Shape::dimple: return feature.height * std::exp(-r2 / squared(feature.width));
    case Shape::bump: return -feature.height * std::exp(-r2 / squared(feature.width));
    case Shape::groove: return feature.height * std::exp(-squared(across / feature.width));
    case Shape::ridge: return -feature.height * std::exp(-squared(across / feature.width));
    case Shape::waviness: return waves(feature, across, dX);
    case Shape::cavity: {
      const double s2 = r2 / squared(cavity_stretch * feature.width);
      return feature.height * std::cos(0.5 * pi * std::sqrt(s2)) * std::exp(-2.0 * s2);
    }
  }
  return 0.0;
}

void add_gap(const Feature& feature, const core::Patch& grid, double distance, core::Field& S) {
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j)
      S(i, j) += gap_of(feature, grid.X(i) - feature.X - distance, grid.Y(j) - feature.Y);
}

void add_cell_average(const Feature& feature, const core::Patch& grid, core::Field& S) {
  const bool wave = feature.shape == Feature::Shape::waviness;
  const double widest = feature.width * (wave ? widest_part_of_a_wave : widest_part);
  const std::vector<double> along = gauss_points(grid.hx(), widest);
  const std::vector<double> across = gauss_points(grid.hy(), widest);
  const double weight = 1.0 / static_cast<double>(along.size() * across.size());
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) {
      const double dX = grid.X(i) - feature.X;
      const double dY = grid.Y(j) - feature.Y;
      double sum = 0.0;
      for (const double x : along)
        for (const double y : across) sum += gap_of(feature, dX + x, dY + y);
      S(i, j) += weight * sum;
    }
}

bool symmetric(const Feature& feature) {
  const bool transverse = has_a_line(feature.shape) && feature.angle == 0.0;
  const bool longitudinal = std::abs(std::cos(feature.angle)) < along_X;
  return transverse || (feature.Y == 0.0 && (longitudinal || !has_a_line(feature.shape)));
}

double resolving_distance(const Feature& feature) {
  if (!has_a_line(feature.shape)) return feature.width / parts_of_a_width;
  const double along = std::abs(std::cos(feature.angle));
  if (along < along_X) return std::numeric_limits<double>::infinity();
  return feature.width / along / (feature.shape == Feature::Shape::waviness ? parts_of_a_wave : parts_of_a_width);
}

}  // namespace ehl::surface
