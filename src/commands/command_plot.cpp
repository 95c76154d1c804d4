// ehl plot: runs the gnuplot scripts of postprocess/ with a result or with a table.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/exit_status.hpp"
#include "base/memory_file.hpp"
#include "commands/commands.hpp"
#include "commands/figure_source.hpp"
#include "commands/gnuplot.hpp"
#include "commands/pictures.hpp"
#include "core/errors.hpp"
#include "results/outputs.hpp"
#include "tables/measured.hpp"

namespace ehl::program {
namespace {

namespace files = std::filesystem;

// Measured points as rows for gnuplot.
std::string measured_rows(const std::string& path) {
  std::string text;
  for (const MeasuredPoint& point : read_measured(path))
    text += fmt::format("{:.9g} {:.9g} {:.9g}\n", point.srr, point.mu, point.sigma);
  return text;
}

std::vector<std::string> wanted_figures(const Arguments& arguments, bool is_sweep) {
  std::vector<std::string> names = arguments.values("figure");
  if (!names_axes(arguments)) return names;
  if (!is_sweep) refuse("--x, --y and --by need the table of a sweep");
  if (names.empty()) names = {"curves"};
  if (names != std::vector<std::string>{"curves"}) refuse("--x, --y and --by need --figure curves");
  return names;
}

}  // namespace

int plot(const Arguments& arguments) {
  const std::string& path = arguments.operands[0];
  const FigureSource source = source_of(path, arguments);
  const std::vector<Figure> chosen =
      selected_figures(figures_in(folder_of_scripts()), wanted_figures(arguments, source.table != nullptr), source);
  if (chosen.empty() && source.table == nullptr) refuse(path + ": no figure can draw its content");
  if (chosen.empty())
    refuse(path +
           ": no figure draws this table automatically, because no key has three values or more; --x KEY draws curves "
           "over a key with fewer (`ehl help plot` lists the figures)");
  const Pictures pictures = pictures_of(arguments, chosen);
  std::vector<std::string> inputs{path};
  if (arguments.has("measured")) inputs.push_back(arguments.value("measured", ""));
  std::vector<results::Output> outputs;
  for (const std::string& name : pictures.names) outputs.push_back({name, results::FileKind::picture, true});
  results::check_files(inputs, outputs);
  const Gnuplot gnuplot(path, source, pictures.format);
  std::vector<Setting> settings = pictures.settings;
  if (arguments.has("title")) settings.push_back({"title", arguments.value("title", "")});
  const MemoryFile measured;
  if (arguments.has("measured")) {
    if (std::ranges::find(chosen, "traction_curve", &Figure::name) == chosen.end())
      refuse("--measured: no figure of this file is a traction curve");
    measured.hold(measured_rows(arguments.value("measured", "")));
    settings.push_back({"measured", measured.name()});
  }
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    std::optional<Curves> curves;
    if (chosen[k].of_curves) curves = curves_of(*source.table, curves_for(chosen[k], *source.table, arguments));
    gnuplot.draw(chosen[k], settings, no_pipe(pictures.names[k]), curves ? &*curves : nullptr);
    std::error_code error;
    if (files::file_size(pictures.names[k], error) == 0 || error)
      throw core::FileError(pictures.names[k] + ": gnuplot could not write the picture");
    print(pictures.names[k] + "\n");
  }
  return solved;
}

}  // namespace ehl::program
