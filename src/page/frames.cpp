#include "page/frames.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "base/json.hpp"

namespace ehl::program {
namespace {

constexpr std::size_t most_frames = 60;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
  return lines;
}

// The lines of a picture that differ from those of the first: the axes are the same, so only fields and curves are
// stored again. Each as [number, text]; the number of lines comes first.
Json changes_from(const std::vector<std::string>& first, const std::vector<std::string>& lines) {
  Json changes = Json::array();
  changes.push_back(lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (k >= first.size() || lines[k] != first[k]) changes.push_back({k, lines[k]});
  return changes;
}

// JSON within a page: no text ends its element.
std::string json_on_page(const Json& data) {
  std::string text;
  for (const char c : data.dump()) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

}  // namespace

std::vector<std::size_t> frames_on_page(std::size_t count) {
  std::vector<std::size_t> list;
  const std::size_t shown = std::min(count, most_frames);
  for (std::size_t k = 0; k < shown; ++k) list.push_back(shown < 2 ? 0 : k * (count - 1) / (shown - 1));
  return list;
}

std::string frames_of(const ResultView& view, const DrawnFigures& figures) {
  const auto figure = std::ranges::find_if(figures.list, [](const DrawnFigure& one) { return one.svgs.size() > 1; });
  if (figure == figures.list.end()) return "";
  const std::vector<double> times = view.source.numbers("/transient/frames/time").values;
  const std::string unit = view.source.si ? " ms" : " a/u<sub>m</sub>";
  const std::vector<std::size_t> shown = frames_on_page(times.size());
  Json data;
  const std::vector<std::string> first = lines_of(figure->svgs[0]);
  data["first"] = first;
  for (std::size_t k = 0; k < std::min(shown.size(), figure->svgs.size()); ++k) {
    data["times"].push_back(fmt::format("{:.4g}", times[shown[k]]));
    data["changes"].push_back(changes_from(first, lines_of(figure->svgs[k])));
  }
  const std::size_t last = data["times"].size() - 1;
  std::string text = "<div class=\"frames\">\n<p class=\"slider\"><button type=\"button\">Play</button> ";
  text +=
      fmt::format("<input type=\"range\" min=\"0\" max=\"{}\" value=\"0\" aria-label=\"time\"> t = <output>", last) +
      data["times"][0].get<std::string>() + "</output>" + unit + "</p>\n";
  if (times.size() > last + 1)
    text += fmt::format("<p class=\"small\">{} of {} frames of the file.</p>\n", last + 1, times.size());
  return text + "<figure class=\"wide\"><div class=\"moving\">" + figure->svgs[0] +
         "</div><figcaption>Film and pressure over the contact and along y = 0 (grey: the first frame); the course of "
         "the run.</figcaption></figure>\n<script type=\"application/json\">" +
         json_on_page(data) + "</script>\n</div>\n";
}

}  // namespace ehl::program
