#include "steady/domain_error.hpp"

#include <algorithm>
#include <cmath>

#include "contact/film_formulas.hpp"
#include "contact/groups.hpp"
#include "core/constants.hpp"
#include "core/errors.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/resolution.hpp"

namespace ehl::steady {
namespace {

double central_film(const Scene& scene) {
  const Start start{.cells = scene.grid.nx, .sweeps = 20, .cycles = 2, .coarsest = scene.tuning.domain_fewest_cells};
  Scene only_film = scene;
  only_film.adjoint_errors = false;
  only_film.observer = {};
  only_film.boundary_film.reset();
  const Solution solution = solve_by_multigrid(only_film, start, {});
  return solution.converged ? solution.levels.back().Hc : core::unknown;
}

/// The film of a line contact grows with this power of alpha (Grubin 1949). A pressure that is missing at the inlet
/// reduces the film by this multiple of its ratio to 1/alpha_bar, the pressure at which the oil becomes stiff.
constexpr double grubin = 8.0 / 11.0;

/// Pressure that builds up upstream of X_a in a line contact, over lambda: the integral of dP/dX = lambda/H^2 at small
/// pressure, with H the gap of the dry contact. With s = 1/|X| the integrand 1/(s H)^2 is smooth down to s = 0, where
/// it is 0, so Simpson's rule applies. in: X_a < -1.
double pressure_before(double X_a) {
  constexpr int parts = 32;
  const double step = 1.0 / (-X_a * parts);
  double sum = 0.0;
  for (int k = 1; k <= parts; ++k) {
    const double X = 1.0 / (k * step);
    const double root = std::sqrt(X * X - 1.0);
    const double H = 0.5 * (X * root - std::log(X + root));
    sum += (k == parts ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) * X * X / (H * H);
  }
  return sum * step / 3.0;
}

/// The losses of a finite domain as relative changes of Hc.
struct RoughError {
  double inlet;
  double load;
};

RoughError rough_error(const ContactScales& scales, double X_a, double y_half) {
  const contact::Ellipse& shape = scales.shape;
  const contact::Groups groups = contact::from_moes(scales.M, scales.L, shape);
  const double length = std::abs(X_a);
  const core::QuadraticForm gap = contact::gap(shape);
  const contact::AlongEntrainment along = contact::along_entrainment(shape, scales.M, scales.L);
  const double rigid = along.film * contact::asymptotes(along.M, along.L, along.radius_ratio).rigid_isoviscous;
  const double power = 2.0 * std::min(1.0, rigid / contact::nijenbanning_venner_moes(scales.M, scales.L, shape));
  const double flatter = 0.25 / (gap.XX * gap.XX);
  const double alpha_bar = std::max(groups.alpha_bar, 10.0);
  // For a line contact dP/dX = lambda/H^2, and far away P = (4/3) lambda/|X|^3.
  if (contact::line(shape))
    return {length > 1.0 ? grubin * alpha_bar * groups.lambda * pressure_before(X_a) : 1.0,
            0.5 * power * 2.0 / 3.0 * groups.lambda / (length * length) / contact::load(contact::line_contact())};
  const double at_inlet = 0.5 * alpha_bar * 4.0 / 3.0 * groups.lambda / (length * length * length) * flatter;
  // The far field (4/5) lambda cos(theta)/r^3 integrated outside the boundary: from x = X_a within the angle of the
  // corner, from y = +-y_half beyond it. For an ellipse Y is scaled so that the undeformed gap is round.
  const double roundness = gap.YY / gap.XX;
  const double round_half = y_half * std::sqrt(roundness);
  const double corner = std::atan2(round_half, length);
  const double outside =
      (corner + std::sin(corner) * std::cos(corner)) / length + std::cos(corner) * std::cos(corner) / round_half;
  const double strength = 5.0 / (3.0 + 2.0 * roundness) * flatter / std::sqrt(roundness);
  const double share = 0.8 * groups.lambda * strength * outside / contact::load(shape);
  return {at_inlet, power * share};
}

RoughError rough_error(const Scene& scene) {
  return rough_error(scene.contact, scene.grid.X_a, std::min(-scene.grid.Y_a, scene.grid.Y_b));
}

}  // namespace

double closed_reach(const Tuning& tuning, const ContactScales& scales, double error) {
  const contact::Ellipse& shape = scales.shape;
  const double film = scales.film;
  const double lambda = contact::from_moes(scales.M, scales.L, shape).lambda;
  // The closed form of a line contact neglects that the load upstream of the inlet deforms the bodies.
  if (contact::line(shape)) return std::cbrt(tuning.closed_reach_of_line * lambda / (film * error));
  const core::QuadraticForm gap = contact::gap(shape);
  double elastic;
  if (!gap.oblique()) {
    // The far pressure beside an ellipse along the entrainment is smaller, as in rough_error().
    const double roundness = gap.YY / gap.XX;
    const double strength = std::min(1.0, 5.0 / (3.0 + 2.0 * roundness) / std::sqrt(roundness));
    elastic = contact::extent(shape).X * std::pow(strength * lambda / (film * error), 0.2);
  } else {
    // Across the longer axis: the reach of an ellipse across the entrainment with this axis's radius, and a multiple
    // of its error, so that the error bar of the domain holds. Along the longer axis: to where the undeformed gap is as
    // wide. [bench: closed_reach_of_oblique_contacts]
    const double shorter = contact::extent(shape).shorter;
    const double sharper = std::max(1.0, shape.radius_ratio);  // R_x over the smaller radius
    const double across =
        shorter * std::pow(tuning.closed_reach_of_oblique * lambda / (film * sharper * shorter * error), 0.2);
    elastic = across * std::sqrt(0.5 * sharper / gap.least_along_X());
  }
  // An elastic film does not rupture far away, where the closed form has straight lines of rupture.
  const double rigid_film = std::max(0.0, film - 0.5 * shape.approach);
  const double rigid =
      tuning.reach_of_thick_film * std::sqrt(rigid_film / gap.least_along_X()) * std::pow(5e-5 / error, 0.2);
  return std::max(elastic, rigid);
}

double rough_domain_error(const Scene& scene) {
  if (scene.far_field) {
    if (contact::line(scene.contact.shape))
      return std::pow(closed_reach(scene.tuning, scene.contact, 1.0) / -scene.grid.X_a, 3.0);
    // The sides are measured in a scale in which the undeformed gap is round.
    const core::QuadraticForm gap = contact::gap(scene.contact.shape);
    const double half_width = std::sqrt(gap.YY / gap.XX) * std::min(-scene.grid.Y_a, scene.grid.Y_b);
    const double reach = std::min(-scene.grid.X_a, 1.5 * half_width);
    return std::pow(closed_reach(scene.tuning, scene.contact, 1.0) / reach, 5.0);
  }
  const RoughError error = rough_error(scene);
  return error.inlet + error.load;
}

double chosen_outlet(const Tuning& tuning, const ContactScales& scales, std::optional<double> far_field_error) {
  const contact::Ellipse& shape = scales.shape;
  if (contact::line(shape)) return 1.5 * scales.size;
  const bool thick = scales.film / shape.approach > tuning.thick_film;
  if (far_field_error && thick) return 0.5 * closed_reach(tuning, scales, *far_field_error);
  return (thick ? 3.0 : 1.5) * contact::extent(shape).X;
}

double chosen_half_width(const Tuning& tuning, double X_a, double X_b, const contact::Ellipse& shape,
                         bool far_field_closed) {
  const double half_length = 0.5 * (X_b - X_a);
  // Stretched cells fit finer parts of the length and are not widened. [bench: wider_stretched_domain]
  const bool stretched = cell_aspect(tuning, shape) < 1.0;
  const double wider = far_field_closed && !stretched ? tuning.wider_closed_domain : 1.0;
  if (contact::circular(shape)) return wider * half_length;
  const double parts = stretched ? 64.0 : 16.0;
  const core::QuadraticForm gap = contact::gap(shape);
  const double wanted = wider * half_length * std::sqrt(gap.XX / gap.YY);
  return half_length * std::ceil(wanted / half_length * parts - 1e-9) / parts;
}

double chosen_inlet(const Tuning& tuning, const ContactScales& scales, double X_b,
                    std::optional<double> far_field_error) {
  const contact::Ellipse& shape = scales.shape;
  const double most_at_inlet = contact::line(shape) ? tuning.most_at_inlet_of_line : tuning.most_at_inlet;
  const double longest = tuning.longest_domain * contact::extent(shape).X;
  double X_a = 0.0;
  // m of `parts` parts lie upstream of 0.
  const auto enough = [&](int m, int parts) {
    const double next = -X_b * m / (parts - m);
    if (X_a < 0.0 && next < -longest) return true;
    X_a = next;
    if (far_field_error) return -X_a >= closed_reach(tuning, scales, *far_field_error);
    const double half_width = contact::line(shape) ? 1.0 : chosen_half_width(tuning, X_a, X_b, shape);
    const RoughError error = rough_error(scales, X_a, half_width);
    return error.inlet <= most_at_inlet && error.load <= tuning.most_of_load;
  };
  for (int m = 20; m < 32; ++m)
    if (enough(m, 32)) return X_a;
  for (const int parts : {64, 128})
    if (enough(parts - 1, parts)) return X_a;
  return X_a;
}

double estimate_domain_error(const Scene& scene) {
  // Lightly loaded contacts need domains that are too long for coarse grids, and there the rough estimate is better.
  const RoughError rough = rough_error(scene);
  if (!scene.far_field && rough.load > rough.inlet) return 0.5 * rough.load;
  Scene coarse = scene;
  const int least =
      static_cast<int>(scene.tuning.domain_fewest_cells * scene.contact.slenderness / core::stretch(scene.grid));
  while (coarse.grid.nx >= 2 * least && coarse.grid.nx % 2 == 0 && coarse.grid.ny % 2 == 0)
    coarse.grid = core::coarsened(coarse.grid);
  coarse.deformation = {};
  coarse.solver = {};
  coarse.solver.tuning = scene.solver.tuning;
  coarse.solver.judgement = scene.solver.judgement;
  coarse.solver.tolerance = scene.solver.judgement.default_tolerance;
  Scene longer = coarse;
  longer.grid.X_a -= scene.grid.X_b - scene.grid.X_a;
  longer.grid.nx *= 2;
  if (!contact::line(scene.contact.shape)) longer.grid.Y_a *= 2.0, longer.grid.Y_b *= 2.0, longer.grid.ny *= 2;
  double estimate = core::unknown;
  try {
    estimate = central_film(longer) / central_film(coarse) - 1.0;
  } catch (const core::SolverError&) {
    // A domain that ends at the contact may have no solution on coarse grids; then the rough estimate is used.
  }
  return std::isfinite(estimate) ? estimate : rough_domain_error(scene);
}

}  // namespace ehl::steady
