#pragma once
// Columns of a film, batch by batch: the implementation of FilmTemperature, with the same functions
// (film_temperature.hpp).
#include <algorithm>
#include <optional>
#include <vector>

#include "core/field.hpp"
#include "thermal/column.hpp"
#include "thermal/film_in_time.hpp"
#include "thermal/film_temperature.hpp"
#include "thermal/lagged_source.hpp"

namespace ehl::thermal {

/// See FilmTemperature for the public functions.
class FilmColumns {
 public:
  explicit FilmColumns(const Setup& setup);

  void start_from(const FilmColumns& coarse, const FilmColumns* coarser = nullptr);

  void take(const core::Field& P, const core::Field& H, const core::Field* theta = nullptr);

  double sweep(bool back = true);

  void begin_in_time(double end);
  void begin_step(const TimeStep& step);
  void accept_step();
  void restart() { in_time_->length_before = 0.0; }

  bool flows_back() const { return back_to_ >= 0; }
  const core::Field& I0() const { return I0_; }
  const core::Field& M2() const { return M2_; }
  const core::Field& C() const { return C_; }
  const core::Field& rho() const { return rho_; }
  const core::Field& more_x() const { return more_x_; }
  const core::Field& more_y() const { return more_y_; }
  const core::Field& less_tau() const { return less_tau_; }
  const core::Field& tau_m() const { return tau_; }
  const core::Field& q_1() const { return q_1_; }
  const core::Field& q_2() const { return q_2_; }
  double theta(int i, int j, int k) const;
  double velocity(int i, int j, int k) const;
  Balance balance() const;
  std::size_t bytes() const;

 private:
  // One batch of columns, and density terms for convection and C.
  struct Worker {
    Columns at;
    Profile ratio, expansion;
    Lanes capacity;  // heat capacity of a column in the storage term, over the film
  };
  // Index of node k of the columns at position i, for a batch of grid lines. A batch is contiguous in memory; its lines
  // are adjacent.
  std::size_t index(int batch, int i, int k) const {
    return ((static_cast<std::size_t>(batch) * static_cast<std::size_t>(setup_.patch.nodes_x()) +
             static_cast<std::size_t>(i)) *
                static_cast<std::size_t>(nodes_.intervals + 1) +
            static_cast<std::size_t>(k)) *
           core::lanes;
  }
  // Index of node k of column (i, j). All lines of a line contact are equal and form one batch, even if there are fewer
  // lanes than lines.
  std::size_t place(int i, int j, int k) const {
    return index(std::min(j / core::lanes, batches_ - 1), i, k) + static_cast<std::size_t>(j % core::lanes);
  }
  double value(const std::vector<double>& f, int i, int j, int k) const { return f[place(i, j, k)]; }
  void load(int batch, int i, const std::vector<double>& theta, Columns& at) const;
  template <class Of, class ThetaOf>
  void load(Of of, ThetaOf theta_of, Columns& at) const;
  template <class Of, class ThetaOf, class Put, class PutNode>
  void flows(Of of, ThetaOf theta_of, Put put, PutNode put_node, Worker& worker);
  void make_flows();
  void fill(const core::Field* theta);
  int last_backflow() const;
  void carry(int batch, int i, bool downstream, Worker& worker) const;
  Lanes fresh_share(int batch) const;
  void add_change_of_speed(const std::vector<double>& passing, BodyInTime& body) const;
  void take_rate_of_pressure();
  void add_storage(int batch, int i, Worker& worker) const;
  Lanes stored(int batch, int i, const Worker& worker) const;
  double layer(std::size_t k) const {
    return k == 0 || k == static_cast<std::size_t>(nodes_.intervals) ? 0.5 * nodes_.step : nodes_.step;
  }
  void add_compression(int batch, int i, Worker& worker) const;
  void surfaces(int batch, int i, Columns& at) const;
  double marched(const std::vector<double>& weights, const std::vector<double>& upstream, int i) const;
  void keep_fluxes(int i);
  void store(int batch, int i, const Columns& at);
  void store_moments(int batch, int i, Worker& worker);
  double solve_batch(int batch, bool downstream, Worker& worker);
  double sweep_through(bool downstream);
  void apply_sources();
  Lanes south(const std::vector<double>& f, int batch, int i, int k, Lanes outside) const;
  Lanes north(const std::vector<double>& f, int batch, int i, int k, double mirrored, Lanes outside) const;

  Setup setup_;
  Nodes nodes_;
  ColumnLaws laws_;
  double u_1_, u_2_;
  int batches_;
  std::vector<double> theta_, before_;   // before_: of the previous sweep
  std::vector<double> flow_x_, flow_y_;  // rho_bar H u times the layer thickness of a node
  int back_to_ = -1;                     // last position with backflow
  core::Field filled_;                   // share of the width that is sheared
  core::Field oil_;                      // share of the gap that is filled with oil
  core::Field P_, H_, log_eta_, rho_bar_, k_bar_, P_X_, P_Y_, driven_x_, driven_y_;
  core::Field I0_, M2_, C_, rho_, more_x_, more_y_, less_tau_, tau_, q_1_, q_2_, heat_, carried_, stored_, clipped_,
      correction_1_, correction_2_;
  std::vector<double> line_1_, line_2_;
  std::vector<double> before_1_, before_2_;      // of a line contact: before_inlet(), per flux at the first node
  std::vector<double> upstream_1_, upstream_2_;  // q_1 and q_2 of a line contact, from the last node to the first
  std::optional<LaggedSource> source_1_, source_2_;
  std::optional<FilmInTime> in_time_;
  std::vector<Worker> workers_;
  std::vector<double> change_;  // per batch, so that the maximum does not depend on the threads
};

}  // namespace ehl::thermal
