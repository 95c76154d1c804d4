#include "needs.hpp"

#include <cmath>

#include "deck/text.hpp"
#include "machine.hpp"

namespace ehl::program {
namespace {

using deck::complain;

constexpr double giga = 1e9;

}  // namespace

Needs expected_needs(const steady::Scene& scene, const std::optional<TransientInput>& transient) {
  const double nodes = static_cast<double>(scene.grid.nodes_x()) * scene.grid.nodes_y();
  // Measured at 257 x 257 to 2049 x 2049 nodes; the time of one thread of a machine of the 2020s.
  constexpr double doubles_per_node = 24.0;
  constexpr double program_itself = 1.5e7;  // bytes
  constexpr double seconds_per_node_and_cycle = 1e-6;
  constexpr double more_cycles = 2.0;  // than planned: the checks on the finest grid ask for them
  constexpr double direct_pairs_per_second = 2e9;
  constexpr double evaluations_per_cycle = 8.0;
  constexpr double newton_bytes_per_node = 2400.0;  // the sparse factors
  constexpr double newton_seconds_per_node = 4e-5;
  const fmg::Parameters& multigrid = scene.multigrid;
  const double cycles = std::isnan(multigrid.tolerance) ? more_cycles * multigrid.cycles : 10.0;
  Needs needs;
  needs.bytes = nodes * doubles_per_node * sizeof(double) + program_itself;
  needs.seconds = 0.1 + cycles * nodes * seconds_per_node_and_cycle / std::sqrt(scene.threads);
  if (scene.polish == steady::Polish::always) {
    needs.bytes += nodes * newton_bytes_per_node;
    needs.seconds += nodes * newton_seconds_per_node;
  }
  if (scene.deformation.method == mlmi::Method::direct)
    needs.seconds += cycles * evaluations_per_cycle * nodes * nodes / direct_pairs_per_second / scene.threads;
  if (!transient) return needs;
  constexpr double doubles_of_history = 60.0;  // per node: IDA's vectors of P and Q
  constexpr double doubles_of_frame = 3.0;     // P, H and their place in the file
  constexpr double seconds_per_node_and_step = 2.5e-7;
  const transient::MarchParameters& march = transient->parameters;
  const double frames = std::isnan(march.output_interval) ? 2.0 : march.end / march.output_interval + 2.0;
  const double step =
      std::isnan(march.longest_step) ? transient::longest_step(transient->conditions, march.end) : march.longest_step;
  needs.bytes += nodes * sizeof(double) * (doubles_of_history + frames * doubles_of_frame);
  needs.seconds += nodes * seconds_per_node_and_step * march.end / step;
  return needs;
}

void check_memory(deck::Deck& deck, const steady::Scene& scene, const std::optional<TransientInput>& transient) {
  const double needed = expected_needs(scene, transient).bytes;
  const double available = usable_memory();
  if (needed <= available) return;
  const bool by_frames = transient && std::isfinite(transient->parameters.output_interval) &&
                         expected_needs(scene).bytes < 0.5 * available;
  if (by_frames) {
    complain(deck, "transient", "output_interval",
             "keeps so many fields that they need about " + deck::shortest(std::round(needed / giga)) +
                 " GB of memory, and the machine has " + deck::shortest(std::round(available / giga)) + ": take one " +
                 deck::shortest(std::ceil(needed / available)) + " times as long");
    return;
  }
  const double ratio = std::sqrt(needed / available);
  const double fitting = std::exp2(std::floor(std::log2(scene.grid.nx / ratio)));
  complain(deck, "grid", "cells",
           "needs about " + deck::shortest(std::round(needed / giga)) + " GB of memory and the machine has " +
               deck::shortest(std::round(available / giga)) + " GB: take at most " + deck::shortest(fitting));
}

}  // namespace ehl::program
