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

// Between commas or semicolons every cell counts, an empty one too; between blanks there are no empty cells.
std::vector<std::string> cells_of(const std::string& line) {
  const char separator = line.find(';') != std::string::npos ? ';' : line.find(',') != std::string::npos ? ',' : ' ';
  if (separator == ' ') return deck::split_words(line);
  std::vector<std::string> cells;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1) {
    end = line.find(separator, begin);
    cells.push_back(deck::trimmed(line.substr(begin, end == std::string::npos ? end : end - begin)));
  }
  return cells;
}

std::string what_is_wrong(const std::string& cell) {
  if (cell.empty()) return "is missing";
  const deck::ReadNumber read = deck::read_number(cell);
  if (read.status == deck::ReadNumber::Status::number) return {};
  return deck::quoted(cell) +
         (read.status == deck::ReadNumber::Status::not_a_number ? " is no number" : " is no finite number");
}

bool has_a_number(const std::vector<std::string>& cells) {
  for (const std::string& cell : cells)
    if (deck::read_number(cell).status != deck::ReadNumber::Status::not_a_number) return true;
  return false;
}

std::string too_few(int nx, int ny) {
  if (nx >= fewest_points && ny >= fewest_points) return {};
  return fmt::format("{} x {} points are too few: at least {} x {}", nx, ny, fewest_points, fewest_points);
}

ReadHeights read_csv(const std::string& path) {
  std::ifstream file = deck::opened(path);
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
    const std::vector<std::string> cells = cells_of(line);
    if (heading_allowed && !has_a_number(cells)) {
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
  }
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
