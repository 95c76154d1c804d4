// The surfaces of a column: what has flowed into the bodies upstream of it.
#include "thermal/film_columns.hpp"

namespace ehl::thermal {

using core::broadcast;

// Of a line contact sum_m weights_m q_{i-m}, m = 1..i. in: q from the last node to the first.
double FilmColumns::marched(const std::vector<double>& weights, const std::vector<double>& upstream, int i) const {
  const double* q = upstream.data() + (setup_.patch.nx - i);
  const double* w = weights.data();
  Lanes sums{};
  int m = 1;
  for (; m + core::lanes <= i + 1; m += core::lanes) sums += core::load(w + m) * core::load(q + m);
  double sum = 0.0;
  for (; m <= i; ++m) sum += w[m] * q[m];
  for (int lane = 0; lane < core::lanes; ++lane) sum += sums[lane];
  return sum;
}

// What flows into the surfaces of a line's station i, where marched() finds it.
void FilmColumns::keep_fluxes(int i) {
  const auto place = static_cast<std::size_t>(setup_.patch.nx - i);
  upstream_1_[place] = q_1_(i, 1);
  upstream_2_[place] = q_2_(i, 1);
}

// The surfaces of a batch: what flowed into them upstream, and their own share.
void FilmColumns::surfaces(int batch, int i, Columns& at) const {
  const int j = batch * core::lanes;
  const auto surface = [&](const Body& body, const std::vector<double>& line, const core::Field& q,
                           const std::vector<double>& upstream, const std::vector<double>& before,
                           const core::Field& correction, Lanes& given, Lanes& self) {
    given = body.theta + core::load(correction.at_x(i) + j);
    self = broadcast(line.empty() ? 0.0 : line[0]);
    if (line.empty()) return;
    if (!upstream.empty()) {
      given += marched(line, upstream, i);
      if (before.empty()) return;
      // The first node answers to what it says of the body before it: lagged, slow bodies would swing.
      if (i == 0)
        self += before[0];
      else
        given += before[static_cast<std::size_t>(i)] * q(0, 1);
      return;
    }
    for (int m = 1; m <= i; ++m) given += line[static_cast<std::size_t>(m)] * core::load(q.at_x(i - m) + j);
  };
  surface(setup_.body_1, line_1_, q_1_, upstream_1_, before_1_, correction_1_, at.given_1, at.self_1);
  surface(setup_.body_2, line_2_, q_2_, upstream_2_, before_2_, correction_2_, at.given_2, at.self_2);
}

}  // namespace ehl::thermal
