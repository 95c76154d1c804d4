#pragma once
// A steel ball on a steel disc, 30 N, 2 m/s, an oil of 0.04 Pa s at 40 C with an Eyring stress of 5 MPa:
// inputs/friction/traction_eyring.ini with heat.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "thermal/film_temperature.hpp"

namespace support {

struct Steel {
  double k = 46, c = 470, rho = 7850;
};

struct BaseCase {
  double load = 30, R = 9.525e-3, E_prime = 226e9, u_m = 2, srr = 1, eta0 = 0.04, alpha = 20e-9, tau_0 = 5e6;
  double T0 = 313.15, beta = 0.042, k = 0.14, c = 2000, rho0 = 860, expansion = 6.5e-4;
  Steel body_1{}, body_2{};

  bool line = false;  // then the load is per length

  double a() const {
    return line ? std::sqrt(8 * load * R / (std::numbers::pi * E_prime)) : std::cbrt(3 * load * R / (2 * E_prime));
  }
  double p_h() const { return line ? E_prime * a() / (4 * R) : 3 * load / (2 * std::numbers::pi * a() * a()); }
  double H_of(double h) const { return h * R / (a() * a()); }

  ehl::thermal::Body body(const Steel& steel, double u) const {
    return {.Pe = u * a() * steel.rho * steel.c / steel.k, .resistance = k * R / (steel.k * a())};
  }
  /// All heat terms: conduction, convection, compression.
  ehl::thermal::Setup setup(const ehl::core::Patch& patch) const {
    namespace rheology = ehl::rheology;
    const double z = rheology::roelands_z(alpha, rheology::roelands_p0, eta0);
    const rheology::ViscosityLaw viscosity = rheology::make_roelands(alpha, rheology::roelands_p0, z, p_h());
    const double a3 = a() * a() * a();
    return {
        .patch = patch,
        .lambda = 12 * eta0 * u_m * R * R / (a3 * p_h()),
        .srr = srr,
        .stress_of_P = p_h() * a() * a() / (eta0 * u_m * R),
        .viscosity = viscosity,
        .thermal_viscosity = rheology::make_thermal_viscosity(viscosity, {T0, rheology::make_houpert(beta, eta0, T0)}),
        .thinning = rheology::ShearThinning{rheology::Eyring{}, eta0 * std::abs(srr) * u_m * R / (a() * a() * tau_0)},
        .density =
            rheology::make_thermal_density(rheology::make_dowson_higginson(p_h()), T0, rheology::Expansion{expansion}),
        .Br = eta0 * u_m * u_m / (k * T0),
        .Pe = rho0 * c * u_m * a3 / (k * R * R),
        .compression = p_h() * u_m * a3 / (k * T0 * R * R),
        .body_1 = body(body_1, u_m * (1 + srr / 2)),
        .body_2 = body(body_2, u_m * (1 - srr / 2))};
  }
};

inline ehl::core::Field filled(const ehl::core::Patch& patch, auto f) {
  ehl::core::Field field(patch);
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) field(i, j) = f(patch.X(i), patch.Y(j));
  return field;
}
inline double hertz(double x, double y) { return std::sqrt(std::max(0.0, 1 - x * x - y * y)); }

/// Repeats sweeps until theta changes by less than the tolerance. out: the number of sweeps.
inline int settle(ehl::thermal::FilmTemperature& film, double tolerance, int most = 200) {
  int sweeps = 1;
  while (film.sweep() > tolerance && sweeps < most) ++sweeps;
  return sweeps;
}

}  // namespace support
