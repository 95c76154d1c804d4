#include "case/map_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "deck/file.hpp"
#include "deck/text.hpp"
#include "results/matrix.hpp"

namespace ehl::program {
namespace {

using surface::Heights;

constexpr int fewest_points = 8;
constexpr std::uintmax_t largest_map = 4'000'000'000;  // bytes
constexpr std::size_t most_heights = 100'000'000;      // as of a map in HDF5

std::string what_is_wrong(const std::string& cell) {
  if (cell.empty()) return "is missing";
  const deck::ReadNumber read = deck::read_number(cell);
  if (read.status == deck::ReadNumber::Status::number) return {};
  return deck::quoted(cell) +
         (read.status == deck::ReadNumber::Status::not_a_number ? " is no number" : " is no finite number");
}

std::string too_few(int nx, int ny) {
  if (nx >= fewest_points && ny >= fewest_points) return {};
  return fmt::format("{} x {} points are too few: at least {} x {}", nx, ny, fewest_points, fewest_points);
}

ReadHeights read_csv(const std::string& path) {
  std::ifstream file = deck::opened(path, largest_map);
  Heights heights;
  int number = 0;
  bool heading_allowed = true;
  int blank = 0;  // line of the first blank one behind the heights
  for (std::string line; std::getline(file, line);) {
    ++number;
    const std::string where = fmt::format("{}:{}: ", path, number);
    const bool comment = line.find('#') != std::string::npos;
    line = deck::trimmed(line.substr(0, line.find('#')));
    if (line.empty()) {
      if (!comment && blank == 0 && heights.ny > 0) blank = number;
      continue;
    }
    const std::vector<std::string> cells = deck::cells_of(line);
    if (heading_allowed && deck::is_heading(cells)) {
      heading_allowed = false;
      continue;
    }
    heading_allowed = false;
    if (blank > 0) return path + ":" + std::to_string(blank) + ": a line without heights between others: a gap";
    if (heights.ny > 0 && static_cast<int>(cells.size()) != heights.nx)
      return fmt::format("{}{} heights in this line and {} in those before", where, cells.size(), heights.nx);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (const std::string wrong = what_is_wrong(cells[k]); !wrong.empty())
        return fmt::format("{}height number {} {}: a map must have no gaps", where, k + 1, wrong);
      heights.values.push_back(deck::read_number(cells[k]).value);
    }
    heights.nx = static_cast<int>(cells.size());
    ++heights.ny;
    if (heights.values.size() > most_heights) return where + "more than 10^8 heights";
  }
  deck::check_read(file, path);
  if (const std::string few = too_few(heights.nx, heights.ny); !few.empty()) return path + ": " + few;
  return heights;
}

ReadHeights read_hdf5(const std::string& path, const std::string& dataset) {
  results::Array array = results::read_matrix(path, dataset);
  const std::string where = path + ": " + dataset + ": ";
  for (std::size_t n = 0; n < array.values.size(); ++n)
    if (!std::isfinite(array.values[n]))
      return fmt::format("{}row {}, column {} is no finite number: a map must have no gaps", where,
                         n / array.dims[1] + 1, n % array.dims[1] + 1);
  Heights heights{static_cast<int>(array.dims[1]), static_cast<int>(array.dims[0]), std::move(array.values)};
  if (const std::string few = too_few(heights.nx, heights.ny); !few.empty()) return where + few;
  return heights;
}

}  // namespace

ReadHeights read_heights(const std::string& path, const std::string& dataset) {
  const std::string extension = std::filesystem::path(path).extension();
  if (extension == ".csv") return read_csv(path);
  if (extension == ".h5" || extension == ".hdf5") return read_hdf5(path, dataset);
  return "must be a .csv or a .h5";
}

}  // namespace ehl::program
