// Cost of each effect: a small deck with the overrides of the effect's example. Prints seconds, memory and datasets
// beyond those of the case without it, as a table in Markdown.
//   effects_cost [CELLS [RUNS]]
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "case/effects.hpp"
#include "results/read.hpp"
#include "support/json.hpp"
#include "support/program.hpp"

using namespace ehl;

namespace {

const std::string deck =
    "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\n[domain]\nx_inlet = -4.5\ny_half = 3\n";

struct Cost {
  double seconds = std::numeric_limits<double>::infinity();
  double bytes = std::numeric_limits<double>::infinity();
  std::vector<std::string> datasets{};
};

void list_datasets(const results::ResultFile& file, const std::string& group, std::vector<std::string>& list) {
  for (const std::string& name : file.names(group)) {
    const std::string path = (group == "/" ? "" : group) + "/" + name;
    if (file.kind(path) == results::ResultFile::Kind::group)
      list_datasets(file, path, list);
    else
      list.push_back(path);
  }
}

// Processor time of all child processes that have ended; it depends less on other work than wall-clock time.
double processor_seconds() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

Cost cost_of(const std::vector<std::string>& overrides, int cells, int runs) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  std::string line = "run d.ini --json --quiet --overwrite --threads 1 --set grid.cells=" + std::to_string(cells);
  for (const std::string& one : overrides) line += " --set '" + one + "'";
  Cost cost;
  for (int run = 0; run < runs; ++run) {
    const double before = processor_seconds();
    const support::Ended ended = support::ehl(folder, line);
    if (ended.status != 0) {
      std::fprintf(stderr, "effects_cost: ehl %s\n%s", line.c_str(), ended.err.c_str());
      std::exit(1);
    }
    cost.seconds = std::min(cost.seconds, processor_seconds() - before);
    cost.bytes = std::min(cost.bytes, support::number_at(support::parsed(ended.out), "/peak_memory_bytes"));
  }
  list_datasets(results::ResultFile(folder / "d.h5"), "/", cost.datasets);
  return cost;
}

const program::Effect* find(const std::vector<program::Effect>& all, const std::string& name) {
  for (const program::Effect& effect : all)
    if (effect.name == name) return &effect;
  return nullptr;
}

std::vector<std::string> needed_by(const std::vector<program::Effect>& all, const program::Effect& effect) {
  const program::Effect* upon = find(all, effect.upon);
  if (upon == nullptr) return {};
  std::vector<std::string> overrides = needed_by(all, *upon);
  overrides.insert(overrides.end(), upon->example.begin(), upon->example.end());
  return overrides;
}

}  // namespace

int main(int count, char** words) {
  const int cells = count > 1 ? std::atoi(words[1]) : 128;
  const int runs = count > 2 ? std::atoi(words[2]) : 3;
  const std::vector<program::Effect> all = program::effects();
  const Cost plain = cost_of({}, cells, runs);
  std::printf("| effect, on with | beside | seconds more | MB more | datasets more |\n|---|---|---|---|---|\n");
  std::printf("| none | | (%.3f) | (%.1f) | (%zu) |\n", plain.seconds, 1e-6 * plain.bytes, plain.datasets.size());
  for (const program::Effect& effect : all) {
    const std::vector<std::string> beside = needed_by(all, effect);
    std::vector<std::string> overrides = beside;
    overrides.insert(overrides.end(), effect.example.begin(), effect.example.end());
    const Cost off = beside.empty() ? plain : cost_of(beside, cells, runs);
    const Cost on = cost_of(overrides, cells, runs);
    std::printf("| %s, `[%s] %s` | %s | %.3f | %.1f | %zu |\n", effect.name.c_str(),
                effect.callers.front().section.c_str(), effect.callers.front().name.c_str(), effect.upon.c_str(),
                on.seconds - off.seconds, 1e-6 * (on.bytes - off.bytes), on.datasets.size() - off.datasets.size());
  }
}
