#pragma once
namespace ehl::core {

/// XX X^2 + XY X Y + YY Y^2: a gap or the outline of an ellipse, in any direction.
struct QuadraticForm {
  double XX;
  double XY;
  double YY;

  bool round() const { return !oblique() && XX == YY; }
  bool oblique() const { return XY != 0.0; }
  /// False for a form that does not vary along Y.
  bool closed() const { return YY != 0.0; }
  double at(double X, double Y) const { return XX * X * X + (XY * X + YY * Y) * Y; }
  /// Minimum on the line X = 1: a region inside a contour reaches sqrt(contour/least_along_X()) along X.
  double least_along_X() const { return oblique() ? XX - 0.25 * XY * XY / YY : XX; }
};

}  // namespace ehl::core
