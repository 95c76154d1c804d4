#pragma once
// The film model: the coefficients of the Reynolds equation from pressure and film thickness. The cycles, Newton's
// Jacobian, the transfers and the mass balance take their coefficients from here and nowhere else.
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "rheology/laws.hpp"
#include "rheology/shear.hpp"

namespace ehl::film {

/// Factors on the coefficients at the nodes of a grid, by heat and by thinning of the pressure flow. They are constant
/// while cycles run, so that a cycle has one operator.
struct FactorFields {
  core::Field fluidity;         ///< on 1/eta_bar before shear thinning
  core::Field mobility;         ///< further factor on epsilon along X
  core::Field mobility_across;  ///< further factor on epsilon along Y, if it differs
  core::Field carried;          ///< on Q, what the surfaces carry
};
inline constexpr auto factor_fields = {&FactorFields::fluidity, &FactorFields::mobility, &FactorFields::mobility_across,
                                       &FactorFields::carried};
/// Factors of 1.
FactorFields unit_factors(const core::Patch& grid);

/// A column: the nodes of a patch at one X. P and H have one value per line. With `along`, in a line contact: one value
/// per node along X, from node i on.
struct Station {
  const core::Patch& grid;
  int i;
  std::span<const double> P;
  std::span<const double> H;
  bool along = false;
  const FactorFields* factors = nullptr;  ///< of this grid, if the model has factors
  double sliding = 1.0;  ///< factor on k of the shear thinning: speed of sliding over that in the model
};

/// Limiting shear stress of sliding: where the film would carry more than share P, it flows in all directions with the
/// viscosity limit/rate.
struct StressLimit {
  double stress = 0.0;  ///< of the model's sliding over p_h, at H = 1 and eta_bar = 1
  double share = 0.0;   ///< Lambda > 0
};

/// eps = rho_bar H^3/(eta_bar lambda) (eq. 5), Q = rho_bar H.
struct Model {
  double lambda = 1.0;  ///< 6 eta0 u_s R_x^2/(a^3 p_h)
  rheology::ViscosityLaw viscosity;
  rheology::DensityLaw density;
  /// Shear thinning by sliding along X, which makes epsilon along X and along Y differ.
  std::optional<rheology::ShearThinning> thinning{};
  bool has_factors = false;            ///< the coefficients have factors, which come with each column
  std::optional<StressLimit> limit{};  ///< only with thinning and with factors, of which `fluidity` is 1
  /// If set, epsilon(X, Y) instead of the laws, with rho_bar = 1: the linear model problems of eqs. (9) and (19).
  std::function<double(double, double)> given_epsilon{};
};

/// True if epsilon along Y differs from epsilon along X.
inline bool anisotropic(const Model& model) { return model.thinning.has_value(); }

/// Work space of one thread for columns of up to this many nodes, or for the nodes of a line contact.
struct Buffers {
  std::vector<double> fluidity{}, along{}, across{}, slope{}, mobility{}, mobility_across{}, carried{};
};
Buffers make_buffers(const Model& model, int nodes);

/// Coefficients at the nodes of a column. dQ/dH = rho_bar, dQ/dP = drho_bar H.
template <class Number>
struct Coefficients {
  std::span<Number> eps;         ///< along X
  std::span<Number> eps_across;  ///< along Y if it differs; else empty
  std::span<Number> rho_bar;     ///< Q/H
  std::span<Number> drho_bar;    ///< d rho_bar/dP
};
/// The coefficients of a column from its P and H. out: spans of its length.
void coefficients(const Model& model, const Station& station, Buffers& buffers, const Coefficients<double>& out);

/// The nodal values from which epsilon at half points is computed (half_points.hpp): 1/eta_bar and ln eta_bar along X,
/// and along Y if these differ, else empty.
template <class Number>
struct Oil {
  std::span<Number> fluidity, log_viscosity;
  std::span<Number> fluidity_across, log_viscosity_across;
  std::span<Number> rho_bar, drho_bar;
};
/// These values from P and H of a column. out: spans of its length. limits: not with given_epsilon.
void oil(const Model& model, const Station& station, Buffers& buffers, const Oil<double>& out);

/// Derivatives of ln eta_bar along X by P and H, and of that along Y if it differs.
struct OilSlopes {
  std::span<double> log_viscosity_P, log_viscosity_H;
  std::span<double> log_viscosity_across_P, log_viscosity_across_H;
};
/// These derivatives at the P and H of a column. limits: not with given_epsilon.
void oil_slopes(const Model& model, const Station& station, Buffers& buffers, const OilSlopes& out);

/// Derivatives of epsilon with P and H as independent variables; the last two if epsilon along Y differs.
struct Slopes {
  std::span<double> eps_P, eps_H;
  std::span<double> eps_across_P, eps_across_H;
};
/// These derivatives for a column. in: the coefficients at the same P and H. limits: not with given_epsilon; d eps/dH
/// is 0 where H <= 0.
void slopes(const Model& model, const Station& station, const Coefficients<const double>& at, Buffers& buffers,
            const Slopes& out);

/// epsilon = rho_bar H^3 / (eta_bar lambda) (eq. 5). in: spans of one length; film thickness H, fluidity = 1/eta_bar.
/// limits: 0 where H < 0, a state that cycles may pass through before they converge.
void epsilon(std::span<const double> H, std::span<const double> rho_bar, std::span<const double> fluidity,
             double lambda, std::span<double> eps);

}  // namespace ehl::film
