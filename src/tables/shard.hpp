#pragma once
// The part of a sweep that one job of many computes.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ehl::program {

/// Part `index` of `count`, 1 <= index <= count. The whole is part 1 of 1.
struct Shard {
  int index = 1;
  int count = 1;
  bool whole() const { return count == 1; }
};

/// Reads "3/10". errors: core::InputError: another form, an index beyond the count.
Shard parse_shard(const std::string& text);

/// That of a job of an array under Slurm, SLURM_ARRAY_TASK_ID and its fellows; none elsewhere.
/// errors: core::InputError where they contradict each other.
std::optional<Shard> shard_of_array();

/// "t.3of10.csv" for "t.csv"; of the whole the same name.
std::string name_of_shard(const std::string& path, const Shard& shard);

/// Seconds that each of the cases is foreseen to take. in: how many values each variation has, the first varies
/// slowest; the estimate of one case, 0 where it will be refused. Up to most_estimates cases each is estimated. Of
/// more, each value of a variation is, beside the middle values of the others, and a case takes the product of what its
/// values cost, over the middle's: exact where costs are products, and as many estimates as there are values. A
/// variation with more values than that, as the lines of a table, is taken to cost the same for each.
std::vector<double> foreseen_seconds(const std::vector<std::size_t>& values,
                                     const std::function<double(std::size_t)>& estimate);
constexpr std::size_t most_estimates = 1000;

/// The cases of a shard, ascending: the longest case left goes to the shard that has least to do, so that every job
/// finds the same parts. Of more than most_estimates cases those that take the same are dealt in an order without a
/// pattern, which what is not foreseen spreads evenly. in: seconds that each case is foreseen to take.
std::vector<std::size_t> cases_of_shard(const std::vector<double>& seconds, const Shard& shard);

}  // namespace ehl::program
