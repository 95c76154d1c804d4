#pragma once
namespace ehl::core {

/// XX X^2 + XY X Y + YY Y^2: a gap or the outline of an ellipse, of any direction.
struct QuadraticForm {
  double XX;
  double XY;
  double YY;

  double at(double X, double Y) const { return XX * X * X + (XY * X + YY * Y) * Y; }
};

}  // namespace ehl::core
