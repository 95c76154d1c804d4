// Surface temperatures of a column, from the heat that has entered the bodies upstream.
#include "thermal/film_columns.hpp"

namespace ehl::thermal {

using core::broadcast;

// sum_m weights_m q_{i-m}, m = 1..i, of a line contact. in: q from the last node to the first.
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

// Stores the fluxes into the surfaces at position i of a line contact for marched().
void FilmColumns::keep_fluxes(int i) {
  if (upstream_1_.empty()) return;
  const auto place = static_cast<std::size_t>(setup_.patch.nx - i);
  upstream_1_[place] = q_1_(i, 1);
  upstream_2_[place] = q_2_(i, 1);
}

// Surface conditions of a batch: temperature from the heat that entered upstream, and response to the own flux.
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
      // At the first node the heat from upstream responds to the node's own flux implicitly: lagged, slow bodies would
      // oscillate.
      if (i == 0)
        self += before[0];
      else
        given += before[static_cast<std::size_t>(i)] * q(0, 1);
      return;
    }
    for (int m = 1; m <= i; ++m) given += line[static_cast<std::size_t>(m)] * core::load(q.at_x(i - m) + j);
  };
  if (in_time_) {
    in_time_->surface(in_time_->body_1, i, j, at.given_1, at.self_1);
    in_time_->surface(in_time_->body_2, i, j, at.given_2, at.self_2);
    return;
  }
  surface(setup_.body_1, line_1_, q_1_, upstream_1_, before_1_, correction_1_, at.given_1, at.self_1);
  surface(setup_.body_2, line_2_, q_2_, upstream_2_, before_2_, correction_2_, at.given_2, at.self_2);
}

}  // namespace ehl::thermal
