#include "page/result_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/numbers/number.hpp"
#include "core/errors.hpp"

namespace ehl::program {
namespace {

using Kind = results::ResultFile::Kind;

}  // namespace

ResultView::ResultView(const std::string& path) : source(open_result(path)) {
  source.si = scales_of(source.file);
  in_time = has("/transient/frames/time") && source.file.dims("/transient/frames/time").at(0) > 0;
  dry = has("/fields/gap");
  converged = value(numbers::path_of(id::converged)) == 1.0;
  line = source.numbers("/grid/y").values.size() < 2;
}

bool ResultView::has(const std::string& name) const { return source.file.kind(name) != Kind::missing; }

results::Array ResultView::number(const std::string& name) const {
  // In older files error_Hc is the error of the mesh alone.
  for (const char* error : {id::error_Hc, id::error_Hm})
    if (const std::string older = "/summary/total_" + std::string(error); name == numbers::path_of(error) && has(older))
      return number(older);
  if (source.file.kind(name) == Kind::numbers && source.file.dims(name).empty()) return source.numbers(name);
  return {{}, {std::nan("")}, "-", ""};
}

std::string ResultView::text(const std::string& name) const {
  return source.file.kind(name) == Kind::text ? source.file.text(name) : "";
}

std::string ResultView::places(const std::string& letter) const {
  if (source.si) return letter + " [µm]";
  return (letter == "x" ? "X" : letter == "y" ? "Y" : "Z") + (" = " + letter) + "/a";
}

double ResultView::reach_y() const {
  const double kappa = value(numbers::path_of(id::kappa));
  return std::isfinite(kappa) ? kappa : 1.0;
}

Window contact_window(const ResultView& view, const FieldOnGrid& field) {
  const double a = view.radius();
  const double angle = view.value(numbers::path_of(id::angle));
  const bool turned = std::isfinite(angle) && angle != 0.0;
  const double reach_x = turned ? std::max(1.0, view.reach_y()) : 1.0;
  const double reach_y = turned ? reach_x : view.reach_y();
  const std::vector<double>&x = field.x.values, &y = field.y.values;
  return {std::max(-1.8 * a * reach_x, x.front()), std::min(1.4 * a * reach_x, x.back()),
          std::max(-1.35 * a * reach_y, y.front()), std::min(1.35 * a * reach_y, y.back())};
}

Axis film_scale(const ResultView& view, const std::vector<FieldOnGrid>& films) {
  // The scale follows the film inside the contact: within half a Hertz radius of the centre, and at the minimum.
  const double a = view.radius(), b = a * view.reach_y();  // read from the file once, not for every node
  std::vector<double> inside;
  double least = std::numeric_limits<double>::infinity();
  for (const FieldOnGrid& film : films)
    for (std::size_t j = 0; j < film.y.values.size(); ++j)
      for (std::size_t i = 0; i < film.x.values.size(); ++i) {
        if (!std::isfinite(film.at(i, j))) continue;
        least = std::min(least, film.at(i, j));
        const double X = film.x.values[i] / a, Y = film.y.values[j] / b;
        if (X * X + Y * Y < 0.8) inside.push_back(film.at(i, j));
      }
  if (inside.empty()) return {0.0, 1.0, false, view.film_words()};
  std::ranges::sort(inside);
  const double middle = inside[inside.size() / 2], most = inside[inside.size() * 99 / 100];
  if (middle > 0.0 && least > 0.0 && most > 12.0 * least) return {0.8 * least, 1.5 * most, true, view.film_words()};
  return {0.0, std::max(1.8 * middle, 1.15 * most), false, view.film_words()};
}

std::string map_svg(const ResultView& view, const FieldOnGrid& drawn, const Window& window, const Axis& scale,
                    Colours colours, const std::string& label, const std::string& mark) {
  const double width = 360.0;
  const double height = width * static_cast<double>(drawn.y.values.size()) / static_cast<double>(drawn.x.values.size());
  const bool section = drawn.rows == "z";
  const bool share = section && drawn.y.unit == "-";
  Drawing map({window.left, window.right, false, view.places("x")},
              {window.bottom, window.top, false,
               share     ? "height z/h above surface 2"
               : section ? "depth " + view.places("z")
                         : view.places("y")},
              width, height);
  map.picture(png_uri(coloured(drawn, scale, colours, mark.empty() ? lines_of(scale) : std::vector<double>{})), mark);
  map.colour_bar(png_uri(colour_scale(colours)), scale);
  return map.svg(label);
}

}  // namespace ehl::program
