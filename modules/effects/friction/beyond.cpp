#include "effects/friction/beyond.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "reynolds/gauss_points.hpp"

namespace ehl::friction {
namespace {

using std::numbers::pi;

double oil_fluidity(const Film& film, double P) {
  double fluidity = 1.0;
  rheology::fluidity(film.viscosity, {&P, 1}, {&fluidity, 1});
  return fluidity;
}

// Stress of sliding. in: warmth, the fluidity over that at the supply temperature.
double sliding_stress(const Film& film, const Parameters& parameters, double P, double H, double warmth) {
  if (parameters.stress == 0.0) return 0.0;
  double fluidity = oil_fluidity(film, P) * warmth;
  if (film.thinning) {
    double along = 0.0, across = 0.0;
    rheology::film_fluidity(*film.thinning, {&H, 1}, {&fluidity, 1}, {&along, 1}, {&across, 1});
    fluidity = across;
  }
  const double tau = parameters.stress / (H * fluidity);
  return P > 0.0 ? rheology::limited(tau, parameters.limit * P) : tau;
}

Beyond beyond_line(const Film& film, const Parameters& parameters, double film_at_end) {
  static const auto rule = reynolds::gauss_points<20>();
  const core::Grid& grid = film.grid;
  const Outside& outside = *film.outside;
  const double slower = std::log(outside.state.speed);
  const double warm_inlet = film.I0 ? std::log((*film.I0)(0, 1)) : 0.0;
  const double warm_outlet = film.I0 ? (*film.I0)(grid.nx, 1) : 1.0;
  Beyond sum;
  // Substitution X = boundary/u on both sides: u = 1 at the boundary, boundary/meniscus at the meniscus (0 if none).
  const auto integrate = [&](int i, const auto& part) {
    const double boundary = grid.X(i), ends = std::min(1.0, std::abs(boundary) / parameters.meniscus);
    for (const auto& [share, weight] : rule) {
      const double u = ends + (1.0 - ends) * share, X = boundary / u;
      const double H = film.H(i, 1) + outside.gap.XX * (X * X - boundary * boundary) +
                       outside.deformation * std::log(u) + outside.field.by_coatings(std::abs(X)) -
                       outside.field.by_coatings(std::abs(boundary));
      part(X, H, u, (1.0 - ends) * weight * std::abs(boundary) / (u * u));
    }
  };
  integrate(0, [&](double X, double H, double u, double weight) {
    const double P = outside.field.P(outside.field.at(X, 0.0), H, outside.state);
    sum.sliding += weight * sliding_stress(film, parameters, P, H, std::exp(warm_inlet * u * u));
    const double eta_bar = 1.0 / oil_fluidity(film, P), speed = std::exp(slower * u * u / reynolds::share_upstream);
    sum.rolling += weight * 0.5 * parameters.slope * film.lambda * speed * eta_bar * (H - outside.state.flow) / (H * H);
  });
  integrate(grid.nx, [&](double, double H, double, double weight) {
    sum.cavitated +=
        weight * filled(parameters.cavitated, H, film_at_end) * sliding_stress(film, parameters, 0.0, H, warm_outlet);
  });
  sum.sliding += sum.cavitated;
  return sum;
}

}  // namespace

PointQuadrature::PointQuadrature(const reynolds::FarField& field, const core::QuadraticForm& gap,
                                 const core::Grid& domain, double meniscus)
    : field_(field), gap_(gap), grid_(domain) {
  shear_ = 0.5 * gap.XY / gap.XX;
  scale_ = std::sqrt(gap.XX / (gap.YY - 0.25 * gap.XY * gap.XY / gap.XX));
  rupture_[0] = rupture(pi, 0.0);
  rupture_[1] = rupture(pi, 2.0 * pi);
  static const auto around = reynolds::gauss_points<10>();
  static const auto along = reynolds::gauss_points<10>();
  const std::vector<double> ends = panels();
  for (std::size_t k = 1; k < ends.size(); ++k)
    for (const auto& [part, angle_weight] : around) {
      const double width = ends[k] - ends[k - 1], psi = ends[k - 1] + width * part;
      const Direction to = direction(psi);
      const double nearest = boundary(to), length = std::log(meniscus / nearest);
      if (length <= 0.0) continue;
      const bool wet = psi > rupture_[0] && psi < rupture_[1];
      for (const auto& [share, weight] : along) {
        const double t = nearest * std::exp(length * share);
        add(to, t, nearest, wet, width * angle_weight * length * weight * t * t * scale_);
      }
    }
}

Beyond PointQuadrature::integral(const Film& film, const Parameters& parameters,
                                 const std::vector<double>& film_at_end) const {
  const Outside& outside = *film.outside;
  const auto gap = [&](const Place& at) {
    return outside.state.H00 + at.gap + outside.deformation / at.r + outside.state.load * at.coatings;
  };
  const auto pressure = [&](const Place& at) { return field_.P(at.point, gap(at), outside.state); };
  Beyond sum;
  for (const Station& one : stations_) {
    const double H = gap(one.here);
    const double warmth = film.I0 ? std::exp(std::log((*film.I0)(one.i, one.j)) * one.returned * one.returned) : 1.0;
    if (!one.wet) {
      const double end = one.inside ? film_at_end[static_cast<std::size_t>(one.line)] : gap(one.ruptured);
      const double share = filled(parameters.cavitated, H, end);
      if (share > 0.0) sum.cavitated += one.weight * share * sliding_stress(film, parameters, 0.0, H, warmth);
      continue;
    }
    sum.sliding += one.weight * sliding_stress(film, parameters, pressure(one.here), H, warmth);
    sum.rolling +=
        one.weight * 0.5 * parameters.slope * H * (pressure(one.ahead) - pressure(one.behind)) / (2.0 * one.step);
  }
  sum.sliding += sum.cavitated;
  return sum;
}

PointQuadrature::Direction PointQuadrature::direction(double psi) const {
  const double Y = scale_ * std::sin(psi);
  return {std::cos(psi) - shear_ * Y, Y};
}

double PointQuadrature::boundary(const Direction& to) const {
  const double to_x = (to.X > 0.0 ? grid_.X_b : grid_.X_a) / to.X;
  const double to_y = (to.Y > 0.0 ? grid_.Y_b : grid_.Y_a) / to.Y;
  return std::min(to_x, to_y);
}

// Angle of rupture between a direction with a full film and a cavitated one, by bisection.
double PointQuadrature::rupture(double wet, double dry) const {
  for (int round = 0; round < 50; ++round) {
    const double between = 0.5 * (wet + dry);
    const Direction to = direction(between);
    (field_.at(to.X, to.Y).wedge > 0.0 ? wet : dry) = between;
  }
  return 0.5 * (wet + dry);
}

// Ends of the angular panels: corners of the domain, where the distance to the boundary has a kink, the axes and the
// angles of rupture. Each panel is then halved.
std::vector<double> PointQuadrature::panels() const {
  std::vector<double> ends{0.0, 2.0 * pi, rupture_[0], rupture_[1]};
  for (int k = 1; k < 4; ++k) ends.push_back(0.5 * k * pi);
  for (const double X : {grid_.X_a, grid_.X_b})
    for (const double Y : {grid_.Y_a, grid_.Y_b}) {
      const double psi = std::atan2(Y / scale_, X + shear_ * Y);
      ends.push_back(psi < 0.0 ? psi + 2.0 * pi : psi);
    }
  std::ranges::sort(ends);
  for (std::size_t k = ends.size(); --k > 0;)
    ends.insert(ends.begin() + static_cast<std::ptrdiff_t>(k), 0.5 * (ends[k - 1] + ends[k]));
  return ends;
}

int PointQuadrature::line_at(double Y) const {
  return std::clamp(static_cast<int>(std::lround((Y - grid_.Y_a) / grid_.hy())), 0, grid_.ny);
}

PointQuadrature::Place PointQuadrature::place(double X, double Y) const {
  const double r = std::hypot(X, Y);
  return {field_.at(X, Y), gap_.at(X, Y), r, field_.by_coatings(r)};
}

// in: wet, true if the film of a steady contact is full in this direction; weight, the area.
void PointQuadrature::add(const Direction& to, double t, double nearest, bool wet, double weight) {
  const double X = t * to.X, Y = t * to.Y;
  Station one{.here = place(X, Y), .weight = weight, .returned = nearest / t, .wet = wet};
  one.i = std::clamp(static_cast<int>(std::lround((nearest * to.X - grid_.X_a) / grid_.hx())), 0, grid_.nx);
  one.j = line_at(nearest * to.Y);
  if (wet) {
    one.step = 1e-4 * std::hypot(X, Y);
    one.ahead = place(X + one.step, Y);
    one.behind = place(X - one.step, Y);
  } else {
    const Direction ruptured = direction(rupture_[Y > 0.0 ? 0 : 1]);
    const double X_ruptured = ruptured.X * Y / ruptured.Y;
    one.inside = X_ruptured > grid_.X_a && X_ruptured < grid_.X_b && Y > grid_.Y_a && Y < grid_.Y_b;
    one.line = line_at(Y);
    one.ruptured = place(X_ruptured, Y);
  }
  stations_.push_back(one);
}

double filled(Cavitated cavitated, double H, double film_at_end) {
  if (cavitated == Cavitated::none) return 0.0;
  if (cavitated == Cavitated::full || film_at_end == 0.0) return 1.0;
  return std::min(1.0, film_at_end / H);
}

Beyond beyond(const Film& film, const Parameters& parameters, const std::vector<double>& film_at_end) {
  if (film.grid.line) return beyond_line(film, parameters, film_at_end[1]);
  if (film.outside->quadrature) return film.outside->quadrature->integral(film, parameters, film_at_end);
  const Outside& outside = *film.outside;
  return PointQuadrature(outside.field, outside.gap, film.grid, parameters.meniscus)
      .integral(film, parameters, film_at_end);
}

}  // namespace ehl::friction
