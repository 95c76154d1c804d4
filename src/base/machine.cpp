#include "base/machine.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace ehl::program {

int usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (::sched_getaffinity(0, sizeof set, &set) != 0) return 1;
  return std::max(1, CPU_COUNT(&set));
}

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double kilo = 1024.0;  // of Linux's kilobytes

// The number that a file holds; `otherwise` if it holds none ("max").
double number_in(const std::string& path, double otherwise) {
  double number = 0.0;
  return std::ifstream(path) >> number ? number : otherwise;
}

// The number that follows a word in a file, as in /proc/meminfo.
double number_after(const std::string& path, const std::string& word, double otherwise) {
  std::ifstream file(path);
  double number = 0.0;
  for (std::string found; file >> found;)
    if (found == word) return file >> number ? number : otherwise;
  return otherwise;
}

struct Memory {
  double limit = unlimited;
  double used = 0.0;
};

// The control groups of this process, from its own up to the root. Any of them may limit the memory of a job.
std::vector<Memory> control_groups() {
  const std::string root = "/sys/fs/cgroup", older = root + "/memory";
  std::vector<Memory> all{
      {number_in(older + "/memory.limit_in_bytes", unlimited), number_in(older + "/memory.usage_in_bytes", 0.0)}};
  std::ifstream own("/proc/self/cgroup");
  std::string path;
  for (std::string line; std::getline(own, line);)
    if (line.starts_with("0::/")) path = line.substr(3);
  for (std::filesystem::path group = path; !group.empty(); group = group.parent_path()) {
    const std::string folder = root + group.string();
    // The system frees its cache of inactive files when memory is needed, so they do not count as used.
    all.push_back(
        {number_in(folder + "/memory.max", unlimited),
         number_in(folder + "/memory.current", 0.0) - number_after(folder + "/memory.stat", "inactive_file", 0.0)});
    if (group == group.root_path()) break;
  }
  return all;
}

Memory address_space() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
  return {static_cast<double>(limit.rlim_cur), kilo * number_after("/proc/self/status", "VmSize:", 0.0)};
}

double installed_memory() {
  return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGE_SIZE));
}

}  // namespace

double usable_memory() {
  double bytes = std::min(installed_memory(), address_space().limit);
  for (const Memory& group : control_groups()) bytes = std::min(bytes, group.limit);
  return bytes;
}

double free_memory() {
  const Memory own = address_space();
  double bytes =
      std::min(kilo * number_after("/proc/meminfo", "MemAvailable:", installed_memory() / kilo), own.limit - own.used);
  for (const Memory& group : control_groups()) bytes = std::min(bytes, group.limit - group.used);
  return std::max(bytes, 0.0);
}

double peak_memory() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return kilo * static_cast<double>(usage.ru_maxrss);  // Linux counts it in kilobytes
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  return "unknown";
}

std::string utc_date() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

std::string program_path() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

}  // namespace ehl::program
