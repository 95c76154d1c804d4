#include "contact/film_formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace ehl::contact {

using std::exp;
using std::pow;

namespace {

// Groups based on R_e instead of R_x; q = R_x/R_e.
struct Frame {
  double W, U, q, radius_ratio;
};
Frame frame_of(const Groups& groups) {
  const core::QuadraticForm H = gap(groups.shape);
  const double q = 2.0 * H.XX;
  return {groups.W * q * q, groups.U * q, q, H.YY / H.XX};
}

}  // namespace

bool along_smaller_radius(const Ellipse& shape) {
  const core::QuadraticForm H = gap(shape);
  return !H.oblique() && H.YY <= H.XX;
}

bool near_chittenden(const Ellipse& shape) {
  return along_smaller_radius(shape) || (shape.radius_ratio >= 0.5 && shape.radius_ratio <= 2.0);
}

FilmThickness hamrock_dowson(const Groups& groups) {
  const auto [W, U, q, ratio] = frame_of(groups);
  const double k = along_smaller_radius(groups.shape) ? std::max(groups.shape.kappa, 1.0 / groups.shape.kappa)
                                                      : 1.03 * pow(ratio, -0.64);
  const double G = groups.G;
  const double central = 2.69 * pow(U, 0.67) * pow(G, 0.53) * pow(W, -0.067) * (1.0 - 0.61 * exp(-0.73 * k));
  const double minimum = 3.63 * pow(U, 0.68) * pow(G, 0.49) * pow(W, -0.073) * (1.0 - exp(-0.68 * k));
  return {central / q, minimum / q};
}

FilmThickness chittenden(const Groups& groups) {
  const auto [W, U, q, ratio] = frame_of(groups);
  const double common = pow(U, 0.68) * pow(groups.G, 0.49) * pow(W, -0.073) / q;
  const double width = pow(ratio, -2.0 / 3.0);
  return {4.31 * common * (1.0 - exp(-1.23 * width)), 3.68 * common * (1.0 - exp(-0.67 * width))};
}

FilmThickness dowson_higginson(const Groups& groups) {
  const auto film = [&](double factor, double of_U, double of_G, double of_W) {
    return factor * pow(groups.U, of_U) * pow(groups.G, of_G) * pow(groups.W, of_W);
  };
  return {film(3.06, 0.69, 0.56, -0.10), film(2.65, 0.7, 0.54, -0.13)};
}

namespace {

Asymptotes asymptotes_of_line(double M, double L) {
  return {.rigid_isoviscous = 3.0 / M,
          .rigid_piezoviscous = 1.287 * pow(L, 2.0 / 3.0),
          .elastic_isoviscous = 2.621 * pow(M, -0.2),
          .elastic_piezoviscous = 1.311 * pow(M, -0.125) * pow(L, 0.75),
          .unloaded = std::numeric_limits<double>::infinity()};
}

double central_film_of_line(double M, double L) {
  const Asymptotes H = asymptotes_of_line(M, L);
  const double isoviscous = pow(H.rigid_isoviscous, 7.0 / 3.0) + pow(H.elastic_isoviscous, 7.0 / 3.0);
  if (L == 0.0) return pow(isoviscous, 3.0 / 7.0);
  const double s = (7.0 + 8.0 * exp(-2.0 * H.elastic_isoviscous / H.rigid_isoviscous)) / 5.0;
  const double piezoviscous = pow(H.rigid_piezoviscous, -3.5) + pow(H.elastic_piezoviscous, -3.5);
  return pow(pow(isoviscous, 3.0 * s / 7.0) + pow(piezoviscous, -2.0 * s / 7.0), 1.0 / s);
}

}  // namespace

// The sums are written such that a circle gives the digits of the fit: 1.691 is not the double nearest to 1 + 0.691.
Asymptotes asymptotes(double M, double L, double q) {
  if (q == 0.0) return asymptotes_of_line(M, L);
  const double elastic = 1.63 + 0.006 * std::log(q) + 0.63 * (pow(q, 4.0 / 7.0) - 1.0);
  Asymptotes H{};
  H.rigid_isoviscous = 145.0 * pow(1.796 + 0.796 * (pow(q, 14.0 / 15.0) - 1.0), -15.0 / 7.0) * pow(M, -2.0) / q;
  H.rigid_piezoviscous = 1.29 * pow(1.691 + 0.691 * (q - 1.0), -2.0 / 3.0) * pow(L, 2.0 / 3.0);
  H.elastic_isoviscous = 3.18 * pow(elastic, -14.0 / 25.0) * pow(M, -2.0 / 15.0) * pow(q, -1.0 / 15.0);
  H.elastic_piezoviscous = 1.48 * pow(elastic, -7.0 / 20.0) * pow(M, -1.0 / 12.0) * pow(L, 0.75) * pow(q, -1.0 / 24.0);
  H.unloaded = 1.8 / q;
  return H;
}

namespace {

// Central film in Moes' units based on R_e.
double central_film(const AlongEntrainment& contact) {
  const double L = contact.L;
  const Asymptotes H = asymptotes(contact.M, L, contact.radius_ratio);
  const double elastic = pow(pow(H.elastic_isoviscous, -4.0) + pow(H.unloaded, -4.0), -3.0 / 8.0);
  const double isoviscous = pow(H.rigid_isoviscous, 1.5) + elastic;
  if (L == 0.0) return pow(isoviscous, 2.0 / 3.0);
  const double s = 1.5 * (1.0 + exp(-1.2 * H.elastic_isoviscous / H.elastic_piezoviscous));
  const double piezoviscous = pow(H.rigid_piezoviscous, -8.0) + pow(H.elastic_piezoviscous, -8.0);
  return pow(pow(isoviscous, 2.0 * s / 3.0) + pow(piezoviscous, -s / 8.0), 1.0 / s);
}

struct Candidate {
  Regime regime;
  double H;
};

// The two competing pairs; within a pair first the asymptote that counts, then the one into which it passes.
struct Competition {
  std::array<Candidate, 2> governing;
  std::array<Candidate, 2> other;
};

Competition compete(const AlongEntrainment& contact) {
  const Asymptotes H = asymptotes(contact.M, contact.L, contact.radius_ratio);
  std::array<Candidate, 2> isoviscous = {Candidate{Regime::rigid_isoviscous, H.rigid_isoviscous},
                                         Candidate{Regime::elastic_isoviscous, H.elastic_isoviscous}};
  std::array<Candidate, 2> piezoviscous = {Candidate{Regime::rigid_piezoviscous, H.rigid_piezoviscous},
                                           Candidate{Regime::elastic_piezoviscous, H.elastic_piezoviscous}};
  if (isoviscous[0].H < isoviscous[1].H) std::swap(isoviscous[0], isoviscous[1]);
  if (piezoviscous[0].H > piezoviscous[1].H) std::swap(piezoviscous[0], piezoviscous[1]);
  if (isoviscous[0].H >= piezoviscous[0].H) return {isoviscous, piezoviscous};
  return {piezoviscous, isoviscous};
}

}  // namespace

double nijenbanning_venner_moes(double M, double L, const Ellipse& shape) {
  if (line(shape)) return central_film_of_line(M, L);
  const AlongEntrainment contact = along_entrainment(shape, M, L);
  return contact.film * central_film(contact);
}

Regime regime(double M, double L, const Ellipse& shape) {
  return compete(along_entrainment(shape, M, L)).governing[0].regime;
}

std::string regime_text(double M, double L, const Ellipse& shape) {
  const Competition competition = compete(along_entrainment(shape, M, L));
  const Candidate governing = competition.governing[0];
  const auto ratio = [&](const Candidate& rival) { return std::max(rival.H / governing.H, governing.H / rival.H); };
  const Candidate along = competition.governing[1], across = competition.other[0];
  const Candidate nearest = ratio(across) < ratio(along) ? across : along;
  std::string text = name(governing.regime);
  if (ratio(nearest) < 1.5) text += std::string(", passing into ") + name(nearest.regime);
  return text;
}

const char* name(Regime regime) {
  switch (regime) {
    case Regime::rigid_isoviscous: return "rigid isoviscous";
    case Regime::rigid_piezoviscous: return "rigid piezoviscous";
    case Regime::elastic_isoviscous: return "elastic isoviscous";
    case Regime::elastic_piezoviscous: return "elastic piezoviscous";
  }
  return "unknown";
}

}  // namespace ehl::contact
