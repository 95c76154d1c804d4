// Records the cost of a solution, one row per case: seconds, work units, memory, threads, and the ratio to reference
// workloads measured in the same run, so that rows of different machines can be compared.
//   bench_record [--runs N] [--most-cells N] [--into FILE.csv]
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "bench/yardsticks.hpp"
#include "contact/groups.hpp"
#include "core/process.hpp"
#include "steady/solve.hpp"

using namespace ehl;

namespace {

struct Contact {
  const char* name;
  double M, L, alpha, z;
  double X_a, y_half;
};
constexpr Contact contacts[] = {{"Venner and ten Napel (50,10)", 50, 10, 1.7e-8, 0.6, -4.5, 3.0},
                                {"(200,10)", 200, 10, 2.2e-8, 0.68, -2.5, 2.0}};
constexpr double X_b = 1.5;

steady::Scene scene_of(const Contact& contact, int cells, int threads) {
  const contact::Groups groups = contact::from_moes(contact.M, contact.L);
  const double p_h = groups.alpha_bar / contact.alpha;
  steady::Scene scene;
  scene.contact = steady::scales_of(contact.M, contact.L);
  scene.lambda = groups.lambda;
  scene.viscosity = rheology::make_roelands(contact.alpha, rheology::roelands_p0, contact.z, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  scene.grid = {cells, cells, contact.X_a, X_b, -contact.y_half, contact.y_half};
  scene.threads = threads;
  return scene;
}

/// The numbers of a series of runs, as they pass through the pipe from the process of a run.
struct Series {
  double least = 1e9;     ///< seconds, including set-up
  double greatest = 0.0;  ///< seconds of the slowest run
  double work_units = 0.0;
  double all_work_units = 0.0;  ///< of all levels, in units of the finest
  double Hc = 0.0, error_Hc = 0.0, algebraic = 0.0;
  double megabytes = 0.0;
  bool converged = false;
};

void add_run(const Contact& contact, int cells, int threads, Series& series) {
  const double began = core::now();
  const steady::Solution solution = steady::solve(scene_of(contact, cells, threads));
  const double seconds = core::now() - began;
  series.least = std::min(series.least, seconds);
  series.greatest = std::max(series.greatest, seconds);
  const steady::LevelRow& last = solution.levels.back();
  series.work_units = last.work_units;
  series.all_work_units = 0.0;
  for (const steady::LevelRow& row : solution.levels)
    series.all_work_units += row.work_units * (row.nx + 1.0) * (row.ny + 1.0) / ((last.nx + 1.0) * (last.ny + 1.0));
  series.Hc = last.Hc;
  series.error_Hc = last.mesh_error_Hc;
  series.algebraic = solution.verification.algebraic_error_Hc;
  series.converged = solution.converged;
}

/// Each run has a process of its own, which allocates its memory afresh, so that the peak memory is that of this case.
void add_run_in_own_process(const Contact& contact, int cells, int threads, Series& series) {
  int ends[2];
  if (::pipe(ends) != 0) std::exit(1);
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child < 0) std::exit(1);
  if (child == 0) {
    add_run(contact, cells, threads, series);
    const bool sent = ::write(ends[1], &series, sizeof series) == static_cast<ssize_t>(sizeof series);
    ::_exit(sent ? 0 : 1);
  }
  ::close(ends[1]);
  const bool received = ::read(ends[0], &series, sizeof series) == static_cast<ssize_t>(sizeof series);
  ::close(ends[0]);
  rusage usage{};
  int status = 0;
  ::wait4(child, &status, 0, &usage);
  if (!received || status != 0) {
    std::fprintf(stderr, "bench_record: the run of %s on %d cells failed\n", contact.name, cells);
    std::exit(1);
  }
  series.megabytes = std::max(series.megabytes, static_cast<double>(usage.ru_maxrss) / 1024.0);
}

std::string first_line(const std::string& command) {
  std::string line;
  if (FILE* pipe = ::popen(command.c_str(), "r")) {
    std::array<char, 200> text{};
    if (std::fgets(text.data(), text.size(), pipe)) line = text.data();
    ::pclose(pipe);
  }
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
  return line;
}

std::string commit() {
  const std::string git = "git -C '" EHL_SOURCE_FOLDER "' ";
  const std::string hash = first_line(git + "rev-parse --short HEAD 2>/dev/null");
  if (hash.empty()) return "unknown";
  return first_line(git + "status --porcelain -uno 2>/dev/null").empty() ? hash : hash + "+";
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) {
      std::string name = line.substr(std::min(line.size(), line.find(':') + 2));
      std::replace(name.begin(), name.end(), ',', ' ');
      return name;
    }
  return "unknown";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", std::gmtime(&now));
  return text.data();
}

constexpr const char* header =
    "date,commit,compiler,processor,M,L,cells,threads,seconds,slowest,work_units,all_work_units,"
    "fft_seconds,seconds_over_fft,copy_GB_per_s,ns_per_node,megabytes,Hc,error_Hc,algebraic_error_Hc\n";

void append(const std::string& path, const std::string& rows) {
  const bool fresh = !std::ifstream(path).good();
  std::ofstream file(path, std::ios::app);
  if (fresh) file << header;
  file << rows;
  if (!file.flush()) {
    std::fprintf(stderr, "bench_record: cannot write %s\n", path.c_str());
    std::exit(1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  core::prepare_process(argv);
  int runs = 5;
  int most_cells = 1024;
  std::string into;
  for (int k = 1; k + 1 < argc; k += 2) {
    if (!std::strcmp(argv[k], "--runs")) runs = std::max(1, std::atoi(argv[k + 1]));
    if (!std::strcmp(argv[k], "--most-cells")) most_cells = std::atoi(argv[k + 1]);
    if (!std::strcmp(argv[k], "--into")) into = argv[k + 1];
  }
  const tests::Yardsticks yard = tests::measure_yardsticks(runs);
  std::printf("yardsticks: forward and inverse real FFT of the padded 513 x 513 grid %.4f s, memory copy %.1f GB/s\n\n",
              yard.fft_seconds, yard.copy_GB_per_s);
  std::puts("Seconds of a whole solution, set-up included: the least of the runs and the spread up to the slowest\n");
  std::puts(
      "| contact | nodes | threads | seconds | spread | per coarser | 1 thread / 2 | FFTs | ns/node | work units on "
      "the finest / all | memory [MB] | error of Hc | algebraic |");
  std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  const std::string origin = today() + "," + commit() + "," + "g++ " __VERSION__ + "," + processor();
  std::string rows;
  for (const Contact& contact : contacts) {
    double before[2] = {0.0, 0.0};
    for (int cells = 128; cells <= most_cells; cells *= 2) {
      // The two alternate, so that disturbances of the machine affect both.
      std::array<Series, 2> series;
      for (int run = 0; run < (cells > 1024 ? std::min(runs, 3) : runs); ++run)
        for (const int threads : {1, 2})
          add_run_in_own_process(contact, cells, threads, series[static_cast<std::size_t>(threads - 1)]);
      const double one = series[0].least;
      for (const int threads : {1, 2}) {
        const Series& s = series[static_cast<std::size_t>(threads - 1)];
        const double nodes = (cells + 1.0) * (cells + 1.0);
        double& coarser = before[threads - 1];
        char ratio[16] = "-", speedup[16] = "-", row[400];
        if (coarser > 0.0) std::snprintf(ratio, sizeof ratio, "%.2f", s.least / coarser);
        if (threads == 2) std::snprintf(speedup, sizeof speedup, "%.2f", one / s.least);
        coarser = s.least;
        std::printf(
            "| %s | %d x %d | %d | %.4f | %.0f %% | %s | %s | %.1f | %.0f | %.1f / %.1f | %.0f | %.1e | %.1e |%s\n",
            contact.name, cells + 1, cells + 1, threads, s.least, 100.0 * (s.greatest / s.least - 1.0), ratio, speedup,
            s.least / yard.fft_seconds, 1e9 * s.least / nodes, s.work_units, s.all_work_units, s.megabytes, s.error_Hc,
            s.algebraic, s.converged ? "" : " not converged");
        std::snprintf(row, sizeof row, ",%g,%g,%d,%d,%.5f,%.5f,%.2f,%.2f,%.5f,%.2f,%.2f,%.1f,%.1f,%.8f,%.2e,%.2e\n",
                      contact.M, contact.L, cells, threads, s.least, s.greatest, s.work_units, s.all_work_units,
                      yard.fft_seconds, s.least / yard.fft_seconds, yard.copy_GB_per_s, 1e9 * s.least / nodes,
                      s.megabytes, s.Hc, s.error_Hc, s.algebraic);
        rows += origin + row;
      }
    }
  }
  if (!into.empty()) append(into, rows);
  return 0;
}
