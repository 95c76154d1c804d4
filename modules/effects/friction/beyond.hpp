#pragma once
// Friction of the oil outside the domain, if the film has a closed far field.
#include <vector>

#include "core/quadratic_form.hpp"
#include "effects/friction/friction.hpp"
#include "reynolds/far_field.hpp"

namespace ehl::friction {

class PointQuadrature;

/// Far field of a solved contact, and its film.
struct Outside {
  const reynolds::FarField& field;
  core::QuadraticForm gap;     ///< of the undeformed bodies
  double deformation = 0.0;    ///< of a point contact far away, times 1/r; of a line contact times -ln|X|
  reynolds::FarState state{};  ///< of a line contact with its flow; its speed is below 1 if the inlet is warm
  const PointQuadrature* quadrature = nullptr;  ///< of a point contact; null: made for one integral
};

/// Integrals over the part outside the domain that is filled with oil, in units of p_h a^2 (line contact: p_h a).
struct Beyond {
  double sliding = 0.0;    ///< of tau_m
  double cavitated = 0.0;  ///< part of `sliding` where the film is cavitated
  double rolling = 0.0;    ///< of (h/2) dp/dx
};

/// Gauss quadrature, in ln r for point contacts because both integrands decay as 1/r^2. A line contact without a
/// meniscus is integrated to infinity with X = X_a/u. in: film_at_end per line of the domain, as in friction_of().
/// limits: a temperature change of the film at the boundary is assumed to decay as 1/r^2.
Beyond beyond(const Film& film, const Parameters& parameters, const std::vector<double>& film_at_end);

/// The points of the integrals outside the domain of a point contact, for films of one contact at many times. Polar
/// coordinates in which the undeformed gap is XX t^2: X = t cos(psi) - shear Y, Y = t scale sin(psi).
class PointQuadrature {
 public:
  /// in: the gap of the undeformed bodies; the distance of the meniscus, finite. The field must outlive this object.
  PointQuadrature(const reynolds::FarField& field, const core::QuadraticForm& gap, const core::Grid& domain,
                  double meniscus);
  Beyond integral(const Film& film, const Parameters& parameters, const std::vector<double>& film_at_end) const;

 private:
  struct Direction {
    double X, Y;  // at t = 1
  };
  struct Place {
    reynolds::FarPoint point{};
    double gap = 0.0, r = 1.0, coatings = 0.0;
  };
  struct Station {
    Place here{}, ahead{}, behind{};  ///< the last two by `step` along X, where the film is full
    double step = 1.0, weight = 0.0;
    double returned = 0.0;  ///< distance of the domain's boundary in this direction over that of the point
    int i = 0, j = 0;       ///< node of the boundary in this direction
    bool wet = false;
    bool inside = false;  ///< the film of this line, constant Y, ruptures inside the domain
    int line = 0;
    Place ruptured{};  ///< where it ruptures if that is outside
  };
  Direction direction(double psi) const;
  double boundary(const Direction& to) const;
  double rupture(double wet, double dry) const;
  std::vector<double> panels() const;
  int line_at(double Y) const;
  Place place(double X, double Y) const;
  void add(const Direction& to, double t, double nearest, bool wet, double weight);

  const reynolds::FarField& field_;
  core::QuadraticForm gap_;
  core::Grid grid_;
  double shear_ = 0.0, scale_ = 1.0;
  double rupture_[2] = {0.0, 0.0};  ///< the film is full for psi between these angles
  std::vector<Station> stations_{};
};

/// Share of the width that is filled with oil where P = 0. in: film_at_end, the film at the last node upstream with P >
/// 0 on the same line; 0 if there is none because the oil has not passed the contact.
double filled(Cavitated cavitated, double H, double film_at_end);

}  // namespace ehl::friction
