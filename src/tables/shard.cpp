#include "tables/shard.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <numeric>
#include <queue>
#include <random>
#include <tuple>
#include <utility>

#include "core/errors.hpp"

namespace ehl::program {
namespace {

constexpr int none = -1;

// The whole number in a text; `none` if the text is not a whole number.
int whole_number_in(const std::string& text) {
  int number = none;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stopped == end ? number : none;
}

}  // namespace

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  const int index = whole_number_in(text.substr(0, slash));
  const int count = slash == std::string::npos ? none : whole_number_in(text.substr(slash + 1));
  if (index < 1 || index > count)
    throw core::InputError("command line: --shard " + text + ": write i/N, part i of N, from 1/N to N/N");
  return {index, count};
}

std::optional<Shard> shard_of_array() {
  const char* id = std::getenv("SLURM_ARRAY_TASK_ID");
  const char* count = std::getenv("SLURM_ARRAY_TASK_COUNT");
  if (id == nullptr || count == nullptr) return std::nullopt;
  const char* first = std::getenv("SLURM_ARRAY_TASK_MIN");
  const char* step = std::getenv("SLURM_ARRAY_TASK_STEP");
  const auto number = [](const char* text, int otherwise) {
    return text == nullptr ? otherwise : whole_number_in(text);
  };
  const int steps = std::max(1, number(step, 1));
  const Shard shard{(number(id, 0) - number(first, 0)) / steps + 1, number(count, 1)};
  if (shard.index >= 1 && shard.index <= shard.count) return shard;
  throw core::InputError(
      fmt::format("SLURM_ARRAY_TASK_ID = {} of SLURM_ARRAY_TASK_COUNT = {} does not give a part of the sweep: give "
                  "--shard i/N, or an --array without gaps",
                  id, count));
}

std::string name_of_shard(const std::string& path, const Shard& shard) {
  if (shard.whole()) return path;
  const std::string ending = ".csv";
  const std::string stem = path.ends_with(ending) ? path.substr(0, path.size() - ending.size()) : path;
  return fmt::format("{}.{}of{}{}", stem, shard.index, shard.count, ending);
}

std::vector<double> foreseen_seconds(const std::vector<std::size_t>& values,
                                     const std::function<double(std::size_t)>& estimate) {
  std::size_t cases = 1, middle = 0;
  for (const std::size_t count : values) cases *= count;
  std::vector<double> seconds(cases, 1.0);
  if (cases <= most_estimates) {
    for (std::size_t k = 0; k < cases; ++k) seconds[k] = estimate(k);
    return seconds;
  }
  std::size_t stride = cases;
  for (const std::size_t count : values) middle += (stride /= count) * (count / 2);
  const double of_middle = estimate(middle);
  if (of_middle == 0.0) return seconds;
  stride = cases;
  for (const std::size_t count : values) {
    stride /= count;
    if (count > most_estimates) continue;
    std::vector<double> share(count);
    for (std::size_t one = 0; one < count; ++one)
      share[one] = estimate(middle + stride * one - stride * (count / 2)) / of_middle;
    for (std::size_t k = 0; k < cases; ++k) seconds[k] *= share[k / stride % count];
  }
  return seconds;
}

std::vector<std::size_t> cases_of_shard(const std::vector<double>& seconds, const Shard& shard) {
  std::vector<std::size_t> order(seconds.size()), own;
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (order.size() > most_estimates) {
    // The standard defines this engine exactly, so every machine finds the same order; std::shuffle would not.
    std::mt19937_64 engine;  // NOLINT: always the same seed
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[engine() % k]);
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return seconds[a] > seconds[b]; });
  // Seconds, number of cases and index of a shard; the queue returns the smallest first.
  using Load = std::tuple<double, std::size_t, int>;
  std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
  for (int k = 1; k <= shard.count; ++k) loads.push({0.0, 0, k});
  for (const std::size_t one : order) {
    const auto [load, cases, k] = loads.top();
    loads.pop();
    loads.push({load + seconds[one], cases + 1, k});
    if (k == shard.index) own.push_back(one);
  }
  std::ranges::sort(own);
  return own;
}

}  // namespace ehl::program
