#pragma once
// The part of a sweep that one job of an array of jobs computes.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ehl::program {

/// Part `index` of `count`, 1 <= index <= count. A whole sweep is part 1 of 1.
struct Shard {
  int index = 1;
  int count = 1;
  bool whole() const { return count == 1; }
};

/// Reads "3/10". errors: core::InputError for another form or an index above the count.
Shard parse_shard(const std::string& text);

/// The shard of a job in a Slurm array, from SLURM_ARRAY_TASK_ID and the related variables; empty outside such a job.
/// errors: core::InputError if the variables contradict each other.
std::optional<Shard> shard_of_array();

/// The name of the table of a shard, "t.3of10.csv" for "t.csv"; unchanged for a whole sweep.
std::string name_of_shard(const std::string& path, const Shard& shard);

/// Predicted seconds of each case. in: values: the number of values of each variation, of which the first changes
/// slowest; estimate: the time of one case, 0 if the case will be refused.
/// Up to most_estimates cases, every case is estimated. Beyond that, each value of a variation is estimated together
/// with the middle values of the other variations, and a case takes the product of the ratios to the middle case. This
/// is exact if the cost is a product of factors. A variation with more than most_estimates values (a table of cases) is
/// assumed to cost the same for each value.
std::vector<double> foreseen_seconds(const std::vector<std::size_t>& values,
                                     const std::function<double(std::size_t)>& estimate);
constexpr std::size_t most_estimates = 1000;

/// The cases of a shard, ascending. The longest remaining case is given to the shard with the least work, so that every
/// job computes the same distribution. Beyond most_estimates cases, cases of equal time are dealt in a pseudo-random
/// order, which spreads errors of the prediction evenly. in: predicted seconds of each case.
std::vector<std::size_t> cases_of_shard(const std::vector<double>& seconds, const Shard& shard);

}  // namespace ehl::program
