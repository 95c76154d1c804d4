#pragma once
// Heat in a run in time: the temperatures at every step, and the factors by which they change the coefficients.
#include <optional>

#include "effects/heat/tuning.hpp"
#include "thermal/film_temperature.hpp"
#include "transient/conditions.hpp"
#include "transient/coupling.hpp"

namespace ehl::heat {

/// Temperatures above T0 at one time, on the computed patch.
struct Temperatures {
  core::Field mid, largest, surface_1, surface_2;  ///< theta
};

/// The film temperature in time (thermal/film_temperature.hpp) as an effect on the coefficients
/// (transient/coupling.hpp). limits: no oil content, no thinning by the pressure flow; both surfaces move.
class InTime {
 public:
  /// in: setup, complete except for patch, threads, speeds and Peclet numbers of T = 0; the conditions, which must
  /// outlive this object; the largest time.
  InTime(const thermal::Setup& setup, const transient::Conditions& conditions, double end, int threads,
         const Tuning& tuning);

  /// The functions of the coupling, which refer to this object.
  transient::Coupling coupling();

  /// Forces and heat at the end of the last accepted step, or of the steady state at T = 0.
  const thermal::Balance& balance() const { return balance_; }
  /// Temperatures between the ends of the last two accepted steps, by linear interpolation.
  Temperatures temperatures(double T) const;

 private:
  /// The end of an accepted step, or a step under way.
  struct State {
    double T = 0.0;
    transient::FilmFactors factors{};
    Temperatures temperatures{};
  };

  transient::FilmFactors settle(const core::Patch& grid, const core::Field& P, const core::Field& H);
  transient::FilmFactors predict(double T) const;
  transient::FilmFactors respond(double T, const core::Field& P, const core::Field& H);
  void accept();
  void restart();

  thermal::Setup setup_;
  const transient::Conditions& conditions_;
  double end_;
  double zero_;  ///< change of theta that a sweep of the steady state may leave
  std::optional<thermal::FilmTemperature> film_{};
  bool under_way_ = false;  ///< the run in time has begun
  State before_{}, last_{}, now_{};
  /// Rates of change of the factors: in the last step; and for the extrapolation. The latter is the smaller rate of the
  /// last two steps, and 0 where they differ in sign: an error whose sign changes from step to step would else grow.
  transient::FilmFactors rate_{}, extrapolated_{};
  thermal::Balance balance_{};
};

}  // namespace ehl::heat
