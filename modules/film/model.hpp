#pragma once
// The film model: what the oil makes of pressure and film thickness. The cycles, Newton's Jacobian, the transfers and
// the balance of mass take their coefficients from here and nowhere else.
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/grid.hpp"
#include "rheology/laws.hpp"
#include "rheology/shear.hpp"

namespace ehl::film {

/// The nodes of a patch at one X. P and H of one length, one value per line. With `along`, of a line contact: one value
/// per station, from station i on.
struct Station {
  const core::Patch& grid;
  int i;
  std::span<const double> P;
  std::span<const double> H;
  bool along = false;
};

/// What an effect at the stage of the coefficients changes of a station's nodes.
struct Factors {
  std::span<double> fluidity;         ///< 1/eta_bar itself: what shear thins and pressure moves
  std::span<double> mobility;         ///< of epsilon along X: what pressure moves beyond that
  std::span<double> mobility_across;  ///< of epsilon along Y, where that is another one
  std::span<double> carried;          ///< of Q: what the surfaces carry
};
using CoefficientEffect = std::function<void(const Station& station, const Factors& factors)>;

/// eps = rho_bar H^3/(eta_bar lambda) (eq. 5), Q = rho_bar H.
struct Model {
  double lambda = 1.0;  ///< 6 eta0 u_s R_x^2/(a^3 p_h)
  rheology::ViscosityLaw viscosity;
  rheology::DensityLaw density;
  /// Sliding along X that thins the oil: epsilon along X is another one than along Y.
  std::optional<rheology::ShearThinning> thinning{};
  std::vector<CoefficientEffect> effects{};
  /// epsilon(X, Y) instead, with rho_bar = 1: the linear model problems of eqs. (9) and (19).
  std::function<double(double, double)> given_epsilon{};
};

/// True where epsilon along Y is another one than along X.
inline bool anisotropic(const Model& model) { return model.thinning.has_value(); }

/// Work space of one thread for stations of this many nodes.
struct Buffers {
  std::vector<double> fluidity{}, along{}, across{}, slope{}, mobility{}, mobility_across{}, carried{};
};
Buffers make_buffers(const Model& model, int nodes);

/// Of the nodes of a station. dQ/dH = rho_bar, dQ/dP = drho_bar H.
template <class Number>
struct Coefficients {
  std::span<Number> eps;         ///< along X
  std::span<Number> eps_across;  ///< along Y where that is another one; else empty
  std::span<Number> rho_bar;     ///< Q/H
  std::span<Number> drho_bar;    ///< d rho_bar/dP
};
void coefficients(const Model& model, const Station& station, Buffers& buffers, const Coefficients<double>& out);

/// What the effects make of epsilon along X at the first node of a station, as a factor. cost: allocates.
double mobility_by_effects(const Model& model, const Station& station);

/// Of the nodes of a station, what epsilon at half points is made of (half_points.hpp): 1/eta_bar and ln eta_bar along
/// X, and along Y where these are others, else empty.
template <class Number>
struct Oil {
  std::span<Number> fluidity, log_viscosity;
  std::span<Number> fluidity_across, log_viscosity_across;
  std::span<Number> rho_bar, drho_bar;
};
/// limits: not with given_epsilon.
void oil(const Model& model, const Station& station, Buffers& buffers, const Oil<double>& out);

/// Derivatives of these logarithms, likewise.
struct OilSlopes {
  std::span<double> log_viscosity_P, log_viscosity_H;
  std::span<double> log_viscosity_across_P, log_viscosity_across_H;
};
void oil_slopes(const Model& model, const Station& station, Buffers& buffers, const OilSlopes& out);

/// Derivatives of epsilon, P and H as independent variables; the last two where epsilon along Y is another one.
struct Slopes {
  std::span<double> eps_P, eps_H;
  std::span<double> eps_across_P, eps_across_H;
};
/// in: the coefficients at the same P and H. limits: not with given_epsilon; d eps/dH is 0 where H <= 0.
void slopes(const Model& model, const Station& station, const Coefficients<const double>& at, Buffers& buffers,
            const Slopes& out);

/// epsilon = rho_bar H^3 / (eta_bar lambda) (eq. 5). in: spans of one length; film thickness H, fluidity = 1/eta_bar.
/// limits: 0 where H < 0, a state that cycles can pass through on the way to a solution but that is none.
void epsilon(std::span<const double> H, std::span<const double> rho_bar, std::span<const double> fluidity,
             double lambda, std::span<double> eps);

}  // namespace ehl::film
