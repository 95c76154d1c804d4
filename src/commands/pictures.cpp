#include "commands/pictures.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "deck/text.hpp"

namespace ehl::program {
namespace {

namespace files = std::filesystem;

constexpr double least_mm = 40.0, most_mm = 600.0;     // letters must stay legible; the largest paper is A2
constexpr double least_px = 200.0, most_px = 10000.0;  // about the same on a screen

bool any_movie(const std::vector<Figure>& figures) { return std::ranges::any_of(figures, &Figure::movie); }

std::string chosen_format(const Arguments& arguments, const std::vector<Figure>& figures) {
  const bool movie = any_movie(figures);
  const std::string extension = files::path(arguments.value("output", "")).extension().string();
  const std::string ending = extension.empty() ? "" : extension.substr(1);
  const std::string format = arguments.value("format", movie || ending.empty() ? "png" : ending);
  const bool known = format == "png" || format == "svg" || format == "pdf";
  if (arguments.has("format") && movie)
    refuse("--format " + format + ": " + std::ranges::find_if(figures, &Figure::movie)->name +
           " is an animated GIF: leave out --format");
  if (!known && !arguments.has("format"))
    refuse("--output " + arguments.value("output", "") + ": the name of a picture must end with .png, .svg or .pdf");
  if (!known) refuse("--format " + format + ": must be png, svg or pdf");
  const std::string wanted = movie && figures.size() == 1 ? "gif" : format;
  if (!ending.empty() && ending != wanted)
    refuse("--output " + arguments.value("output", "") + ": the picture is a " + wanted +
           ", and its name must end with ." + wanted);
  return format;
}

// The size as settings: mm=85 or pixels=1200.
std::vector<Setting> size_settings(const Arguments& arguments, const std::string& format, bool movie) {
  if (!arguments.has("width")) return {};
  const std::string width = arguments.value("width", "");
  constexpr std::array<std::pair<const char*, const char*>, 3> columns{
      {{"single", "90mm"}, {"onehalf", "140mm"}, {"double", "190mm"}}};
  const auto column = std::ranges::find(columns, width, [](const auto& one) { return std::string(one.first); });
  const std::string size = column == columns.end() ? width : column->second;
  const bool in_mm = size.ends_with("mm");
  const deck::ReadNumber read = deck::read_number(size.substr(0, size.size() < 2 ? 0 : size.size() - 2));
  if ((!in_mm && !size.ends_with("px")) || read.status != deck::ReadNumber::Status::number)
    refuse("--width " + width + ": write 85mm, 1200px, single, onehalf or double");
  const double least = in_mm ? least_mm : least_px, most = in_mm ? most_mm : most_px;
  if (read.value < least || read.value > most)
    refuse("--width " + width + ": must be from " + deck::shortest(least) + " to " + deck::shortest(most) +
           (in_mm ? " mm" : " px"));
  if (!in_mm && format == "pdf") refuse("--width " + width + ": a PDF has no pixels: give the width in mm");
  if (in_mm && movie) refuse("--width " + width + ": the width of a movie is in pixels: give px");
  return {{in_mm ? "mm" : "pixels", deck::shortest(read.value), false}};
}

// "fig3.pdf" for one figure, "fig3_centre_lines.pdf" for one of several, "figs/ball_centre_lines.png" in a folder.
std::string picture_name(const Arguments& arguments, const Figure& figure, const std::string& format, bool several) {
  const files::path source(arguments.operands[0]);
  const std::string ending = figure.movie ? ".gif" : "." + format;
  const std::string own = source.stem().string() + "_" + figure.name + ending;
  if (!arguments.has("output")) return (source.parent_path() / own).string();
  const files::path wanted(arguments.value("output", ""));
  std::error_code error;
  if (const files::path folder = wanted.parent_path(); !folder.empty() && !files::is_directory(folder, error))
    refuse("--output " + deck::quotable(wanted.string()) + ": there is no folder " + deck::quotable(folder.string()));
  if (!wanted.has_filename() || files::is_directory(wanted, error)) return (wanted / own).string();
  files::path name = wanted;
  if (several) name.replace_filename(wanted.stem().string() + "_" + figure.name);
  return name.replace_extension(ending).string();
}

}  // namespace

Pictures pictures_of(const Arguments& arguments, const std::vector<Figure>& figures) {
  if (arguments.has("output") && arguments.value("output", "").empty()) refuse("--output: the name is missing");
  Pictures made{chosen_format(arguments, figures), {}, {}};
  made.settings = size_settings(arguments, made.format, any_movie(figures));
  for (const Figure& figure : figures)
    made.names.push_back(picture_name(arguments, figure, made.format, figures.size() > 1));
  return made;
}

}  // namespace ehl::program
