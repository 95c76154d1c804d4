#include "case/map_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <vector>

#include "case/map_sur.hpp"
#include "case/map_text.hpp"
#include "deck/file.hpp"
#include "deck/text.hpp"
#include "results/matrix.hpp"
#include "surface/fill_missing.hpp"

namespace ehl::program {
namespace {

constexpr int fewest_points = 8;
constexpr std::uintmax_t largest_map = 4'000'000'000;  // bytes

// in: what a reader found in the file; where, for the message. out: the same with its missing points filled.
ReadHeights filled(ReadHeights read, const std::string& where) {
  auto* map = std::get_if<MapInFile>(&read);
  if (map == nullptr) return read;
  surface::Heights& z = map->heights;
  std::string wrong = too_few_points(z.nx, z.ny);
  if (wrong.empty()) wrong = surface::fill_missing(z, map->filled);
  if (!wrong.empty()) return where + ": " + wrong;
  return read;
}

ReadHeights read_hdf5(const std::string& path, const std::string& dataset) {
  results::Array array = results::read_matrix(path, dataset);
  for (std::size_t n = 0; n < array.values.size(); ++n)
    if (std::isinf(array.values[n]))
      return fmt::format("{}: {}: row {}, column {} is not a finite number; a missing point is NaN", path, dataset,
                         n / array.dims[1] + 1, n % array.dims[1] + 1);
  return MapInFile{
      .heights = {static_cast<int>(array.dims[1]), static_cast<int>(array.dims[0]), std::move(array.values)}};
}

}  // namespace

std::string too_few_points(int nx, int ny) {
  if (nx >= fewest_points && ny >= fewest_points) return {};
  return fmt::format("{} x {} points are too few: at least {} x {}", nx, ny, fewest_points, fewest_points);
}

ReadHeights read_heights(const std::string& path, const std::string& dataset, double dx_m) {
  std::string extension = std::filesystem::path(path).extension();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto is = [&](std::initializer_list<const char*> some) {
    return std::ranges::any_of(some, [&](const char* one) { return extension == one; });
  };
  if (is({".csv", ".txt", ".dat", ".asc", ".xyz", ".sdf"}))
    return filled(read_map_text(deck::content_of(path, largest_map), path, dx_m), path);
  if (is({".sur"})) return filled(read_map_sur(deck::content_of(path, largest_map), path), path);
  if (is({".h5", ".hdf5"})) return filled(read_hdf5(path, dataset), path + ": " + dataset);
  const std::string allowed = "must be a text file (.csv, .txt, .dat, .asc, .xyz, .sdf), a .sur or a .h5";
  if (is({".x3p", ".al3d", ".opd", ".plux", ".plu", ".vk4", ".vk6", ".mnt", ".gwy", ".spm", ".ibw", ".nms", ".opdx",
          ".asd", ".top", ".zmg", ".wyko", ".tif", ".tiff"}))
    return allowed + ", and " + extension + " is a binary format of an instrument: open it with Gwyddion and save it " +
           "as ASCII data matrix (.txt, with the heading) or as XYZ data";
  return allowed;
}

}  // namespace ehl::program
