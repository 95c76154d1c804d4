#pragma once
// Viscosity and density from a table: a smooth monotone curve through its points.
#include <memory>
#include <span>
#include <vector>

namespace ehl::rheology {

/// A piecewise cubic y(x), x >= 0, with continuous slope; linear outside the points.
struct Curve {
  std::vector<double> x{};      ///< the points, increasing, the first at 0
  std::vector<double> y{};      ///< values there
  std::vector<double> slope{};  ///< dy/dx there
  std::vector<int> first{};     ///< search table: interval at the left end of each of equal boxes
  double boxes_per_x = 0.0;     ///< number of boxes per unit of x
};

/// ln eta_bar of a table against p [Pa].
struct TabulatedViscosity {
  std::shared_ptr<const Curve> curve;
  double p_h;  ///< [Pa]
};
/// rho_bar of a table against p [Pa].
struct TabulatedDensity {
  std::shared_ptr<const Curve> curve;
  double p_h;  ///< [Pa]
};

/// Monotone cubic interpolation (PCHIP): each interval stays between the values at its ends; exact for straight lines.
/// in: x increasing from 0, y increasing, of equal length >= 3. order: 3 inside, 2 near the ends.
/// source: Fritsch and Carlson (1980), with the slopes of Fritsch and Butland (1984).
Curve monotone_curve(std::span<const double> x, std::span<const double> y);

/// y and dy/dx at any x; NaN gives NaN.
double value(const Curve& curve, double x);
double slope(const Curve& curve, double x);

/// Laws for P = p/p_h. in: p [Pa], increasing from 0; eta [Pa s] > 0 or rho [kg/m^3] > 0, increasing; p_h [Pa] >= 0.
TabulatedViscosity make_tabulated_viscosity(std::span<const double> p, std::span<const double> eta, double p_h);
TabulatedDensity make_tabulated_density(std::span<const double> p, std::span<const double> rho, double p_h);

// Functions that laws.hpp visits. in: P; out: same length.
void log_eta(const TabulatedViscosity& law, std::span<const double> P, std::span<double> out);
void log_eta_slope(const TabulatedViscosity& law, std::span<const double> P, std::span<double> out);
void rho(const TabulatedDensity& law, std::span<const double> P, std::span<double> out);
void rho_slope(const TabulatedDensity& law, std::span<const double> P, std::span<double> out);

}  // namespace ehl::rheology
