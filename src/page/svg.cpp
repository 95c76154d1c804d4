#include "page/svg.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/errors.hpp"
#include "page/markup.hpp"

namespace ehl::program {
namespace {

constexpr std::array allowed{"svg",         "title",   "desc", "g",       "defs",     "rect",     "circle",
                             "path",        "use",     "text", "tspan",   "image",    "filter",   "feFlood",
                             "feComposite", "polygon", "line", "pattern", "polyline", "clipPath", "linearGradient",
                             "stop"};

[[noreturn]] void refuse_svg(const DrawnFigure& figure, const std::string& what) {
  throw core::FileError("the figure " + figure.name + " contains " + what.substr(0, 60) +
                        ", which no figure of a page may contain");
}

// The value of an attribute on the page. A reference points into the figure, or holds a picture itself.
std::string value_on_page(const DrawnFigure& figure, const std::string& name, std::string value) {
  if (name == "id") return figure.mark + value;
  if (name == "href") {
    if (value.starts_with("#")) return "#" + figure.mark + value.substr(1);
    if (!value.starts_with("data:image/png;base64,")) refuse_svg(figure, "the reference " + value);
  }
  for (std::size_t at = value.find("url("); at != std::string::npos; at = value.find("url(", at + 1)) {
    if (value.compare(at, 5, "url(#") != 0) refuse_svg(figure, value.substr(at));
    value.insert(at + 5, figure.mark);
  }
  return value;
}

// One tag, from its name to its end, without line breaks. in: what stands between < and >.
std::string tag_on_page(const DrawnFigure& figure, const std::string& tag) {
  const std::string blanks = " \t\r\n";
  const std::size_t name_at = tag.starts_with('/') ? 1 : 0;
  std::size_t at = std::min(tag.find_first_of(blanks + "/", name_at), tag.size());
  const std::string name = tag.substr(name_at, at - name_at);
  if (std::ranges::find(allowed, name) == allowed.end()) refuse_svg(figure, "<" + name);
  std::string made = "<" + tag.substr(0, at);
  if (tag.starts_with("svg")) made += " role=\"img\" aria-label=\"" + escaped(figure.title) + "\"";
  while ((at = tag.find_first_not_of(blanks, at)) < tag.size() && tag[at] != '/') {
    const std::size_t equals = tag.find('=', at);
    const std::size_t open = equals == std::string::npos ? equals : tag.find_first_of("'\"", equals);
    const std::size_t close = open == std::string::npos ? open : tag.find(tag[open], open + 1);
    if (close == std::string::npos) refuse_svg(figure, "<" + tag);
    std::string key = tag.substr(at, tag.find_last_not_of(blanks, equals - 1) + 1 - at);
    std::string small = key;  // a browser does not distinguish small and capital letters here
    std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (small == "href" || small == "xlink:href") key = "href";
    if (small.starts_with("on")) refuse_svg(figure, "the attribute " + key);
    std::string value = tag.substr(open + 1, close - open - 1);
    for (char& c : value) c = std::isspace(static_cast<unsigned char>(c)) != 0 ? ' ' : c;
    for (std::size_t k = value.find('"'); k != std::string::npos; k = value.find('"', k)) value.replace(k, 1, "&quot;");
    if (!key.starts_with("xmlns")) made += " " + key + "=\"" + value_on_page(figure, key, value) + "\"";
    at = close + 1;
  }
  return made + (tag.ends_with('/') ? "/>" : ">");
}

}  // namespace

std::string embedded(const std::string& svg, const DrawnFigure& figure) {
  std::string made;
  std::size_t group = std::string::npos;  // where a group begins that is still empty
  for (std::size_t at = 0; at < svg.size();) {
    const std::size_t open = std::min(svg.find('<', at), svg.size());
    const std::string text = svg.substr(at, open - at);
    if (text.find_first_not_of(" \t\r\n") != std::string::npos) {
      made += text;
      group = std::string::npos;
    }
    if (open == svg.size()) break;
    const std::size_t close = std::min(svg.find('>', open), svg.size());
    const std::string tag = svg.substr(open + 1, close - open - 1);
    at = std::min(close + 1, svg.size());
    if (tag.starts_with('?')) continue;
    // A browser shows titles as tips; those of gnuplot are names of its own.
    if (tag == "title" || tag == "desc" || tag.starts_with("title ")) {
      at = std::min(svg.find("</" + tag.substr(0, tag.find(' ')) + ">", at), svg.size());
      at = std::min(svg.find('>', at), svg.size() - 1) + 1;
      continue;
    }
    const std::string on_page = tag_on_page(figure, tag);
    if (on_page == "</g>" && group != std::string::npos) {
      made.erase(group);  // an empty group, which gnuplot writes only in the first of several pictures
      group = std::string::npos;
      continue;
    }
    group = tag.starts_with("g ") ? made.size() : std::string::npos;
    // A line break within a text would become a blank.
    made += (tag.starts_with('/') || tag.starts_with("tspan") ? "" : "\n") + on_page;
  }
  return made + "\n";
}

std::vector<std::string> documents_of(const std::string& text) {
  std::vector<std::string> documents;
  const std::string end = "</svg>";
  std::size_t from = 0;
  for (std::size_t at = text.find(end); at != std::string::npos; at = text.find(end, from)) {
    documents.push_back(text.substr(from, at + end.size() - from));
    from = at + end.size();
  }
  return documents;
}

std::string figures_markup(const DrawnFigures& figures) {
  constexpr double half_the_page = 420.0;  // px
  std::string text;
  for (const DrawnFigure& figure : figures.list) {
    if (figure.svgs.size() != 1) continue;
    const std::size_t width = figure.svgs[0].find("width=\"");
    const bool wide = width != std::string::npos && std::stod(figure.svgs[0].substr(width + 7)) > half_the_page;
    std::string title = figure.title;
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    text += std::string("<figure") + (wide ? " class=\"wide\"" : "") + ">" + figure.svgs[0] + "<figcaption>" +
            with_indices(title) + ".</figcaption>\n</figure>\n";
  }
  if (!text.empty()) text = "<div class=\"figures\">\n" + text + "</div>\n";
  return text + (figures.missing.empty() ? "" : "<p class=\"warning\">" + escaped(figures.missing) + "</p>\n");
}

}  // namespace ehl::program
