#include "contact/film_formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ehl::contact {

using std::exp;
using std::pow;

FilmThickness hamrock_dowson(const Groups& groups) {
  constexpr double k = 1.0;
  const double W = groups.W, U = groups.U, G = groups.G;
  const double central = 2.69 * pow(U, 0.67) * pow(G, 0.53) * pow(W, -0.067) * (1.0 - 0.61 * exp(-0.73 * k));
  const double minimum = 3.63 * pow(U, 0.68) * pow(G, 0.49) * pow(W, -0.073) * (1.0 - exp(-0.68 * k));
  return {central, minimum};
}

Asymptotes asymptotes(double M, double L) {
  Asymptotes H{};
  H.rigid_isoviscous = 145.0 * pow(1.796, -15.0 / 7.0) * pow(M, -2.0);
  H.rigid_piezoviscous = 1.29 * pow(1.691, -2.0 / 3.0) * pow(L, 2.0 / 3.0);
  H.elastic_isoviscous = 3.18 * pow(1.63, -14.0 / 25.0) * pow(M, -2.0 / 15.0);
  H.elastic_piezoviscous = 1.48 * pow(1.63, -7.0 / 20.0) * pow(M, -1.0 / 12.0) * pow(L, 0.75);
  H.unloaded = 1.8;
  return H;
}

double nijenbanning_venner_moes(double M, double L) {
  const Asymptotes H = asymptotes(M, L);
  const double elastic = pow(pow(H.elastic_isoviscous, -4.0) + pow(H.unloaded, -4.0), -3.0 / 8.0);
  const double isoviscous = pow(H.rigid_isoviscous, 1.5) + elastic;
  if (L == 0.0) return pow(isoviscous, 2.0 / 3.0);
  const double s = 1.5 * (1.0 + exp(-1.2 * H.elastic_isoviscous / H.elastic_piezoviscous));
  const double piezoviscous = pow(H.rigid_piezoviscous, -8.0) + pow(H.elastic_piezoviscous, -8.0);
  return pow(pow(isoviscous, 2.0 * s / 3.0) + pow(piezoviscous, -s / 8.0), 1.0 / s);
}

namespace {

struct Candidate {
  Regime regime;
  double H;
};

// Two pairs compete: within a pair first the one that counts, then the one it passes into.
struct Competition {
  std::array<Candidate, 2> governing;
  std::array<Candidate, 2> other;
};

Competition compete(double M, double L) {
  const Asymptotes H = asymptotes(M, L);
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

Regime regime(double M, double L) { return compete(M, L).governing[0].regime; }

std::string regime_text(double M, double L) {
  const Competition competition = compete(M, L);
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
