// The page around its sections: heading, comparison table, style, and the script of the sliders.
#include <fmt/core.h>

#include <filesystem>

#include "base/machine.hpp"
#include "case/numbers/number.hpp"
#include "page/markup.hpp"
#include "page/section.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

// The browser must not load anything from elsewhere, whatever text a result file contains.
constexpr char policy[] =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'; base-uri 'none'; "
    "form-action 'none'";

constexpr char style[] = R"css(
:root { color-scheme: light; }
body { font: 15px/1.45 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; color: #1c1c1c; background: #fff;
  max-width: 1040px; margin: 1.5em auto; padding: 0 1em; }
h1 { font-size: 1.6em; margin: 0 0 .2em; }
h2 { font-size: 1.25em; margin: 2em 0 .3em; border-bottom: 2px solid #2166ac; padding-bottom: .15em; }
h1, h2, td { overflow-wrap: anywhere; }
.facts { margin: .3em 0; } .small, figcaption, caption { font-size: .85em; color: #444; }
.fine { color: #1b7837; margin: .4em 0; }
.warning { background: #fff6e0; border-left: 4px solid #e08214; padding: .35em .7em; margin: .4em 0; }
.alarm { background: #fde8e8; border-left: 4px solid #b2182b; padding: .35em .7em; margin: .4em 0; }
.bad { color: #b2182b; font-weight: 600; } .none { color: #777; font-size: .9em; }
.scroll { overflow-x: auto; margin: .8em 0; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
caption { text-align: left; padding-bottom: .25em; }
th, td { padding: .18em .75em .18em 0; text-align: left; vertical-align: top; border-bottom: 1px solid #e3e3e3; }
th { font-weight: 600; border-bottom: 1px solid #888; }
table.numbers { font-size: .88em; } table.numbers th, table.numbers td { text-align: right; padding: .18em .5em; } table.numbers td { white-space: nowrap; } table.numbers td.words { text-align: left; }
table.numbers th { vertical-align: bottom; }
table.numbers td:first-child, table.numbers th:first-child { text-align: left; padding-left: 0; }
table.main td:nth-child(2) { white-space: nowrap; }
table.main tbody tr td:first-child { padding-right: 1.6em; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(480px, 1fr)); gap: .6em 1.2em; align-items: start; }
figure { margin: .5em 0; break-inside: avoid; } figure.wide { grid-column: 1 / -1; }
figure svg { width: 100%; max-width: 430px; height: auto; display: block; } figure.wide svg { max-width: 820px; }
figcaption { margin-left: 4.5em; }
details { margin: .5em 0; } summary { cursor: pointer; color: #2166ac; }
pre { background: #f6f6f6; padding: .7em; overflow-x: auto; font-size: .85em; }
.slider { position: sticky; top: 0; background: #fff; padding: .4em 0; z-index: 1; }
.slider input { width: 55%; vertical-align: middle; } .slider output { font-variant-numeric: tabular-nums; }
footer { margin-top: 2.5em; border-top: 1px solid #ccc; }
@media print {
  @page { margin: 15mm; } body { font-size: 10pt; max-width: none; margin: 0; padding: 0; }
  .slider input, .slider button { display: none; } .slider { position: static; }
  .figures { grid-template-columns: 1fr 1fr; } .scroll { overflow: visible; } h2, caption { break-after: avoid; }
  tr { break-inside: avoid; } * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
@media (max-width: 540px) { .figures { grid-template-columns: 1fr; } }
)css";

constexpr char script[] = R"js(
"use strict";
for (const box of document.querySelectorAll(".frames")) {
  const data = JSON.parse(box.querySelector("script").textContent);
  const slider = box.querySelector("input"), said = box.querySelector("output"), button = box.querySelector("button");
  const moving = box.querySelector(".moving");
  const show = () => {
    const k = Number(slider.value);
    said.textContent = data.times[k];
    const [count, ...changed] = data.changes[k], lines = data.first.slice();
    for (const [n, text] of changed) lines[n] = text;
    moving.innerHTML = lines.slice(0, count).join("\n");
  };
  let clock = null;
  const stop = () => { clearInterval(clock); clock = null; button.textContent = "Play"; };
  slider.addEventListener("input", () => { stop(); show(); });
  button.addEventListener("click", () => {
    if (clock) return stop();
    button.textContent = "Stop";
    clock = setInterval(() => { slider.value = (Number(slider.value) + 1) % data.times.length; show(); }, 150);
  });
  show();
}
addEventListener("beforeprint", () => { for (const one of document.querySelectorAll("details")) one.open = true; });
)js";

std::string name_of(const PageSection& section) {
  return section.title.empty() || section.title == "untitled" ? std::filesystem::path(section.path).filename().string()
                                                              : section.title;
}

std::string comparison(const std::vector<PageSection>& sections) {
  HtmlTable table{"Comparison: value ± error bar", {"file", "kind"}, {}, "numbers"};
  bool results = false;
  for (const PageSection& one : sections) results = results || one.compared.kind.find("run") == 0;
  for (const char* column : compared_columns) {
    const std::string& label = numbers::number_of(column).label;
    table.head.push_back(with_indices(label.empty() ? column : label));
  }
  for (std::size_t k = 0; k < sections.size(); ++k) {
    std::vector<std::string> row{fmt::format("<a href=\"#part{}\">", k + 1) +
                                     escaped(std::filesystem::path(sections[k].path).filename().string()) + "</a>",
                                 escaped(sections[k].compared.kind)};
    row.insert(row.end(), sections[k].compared.cells.begin(), sections[k].compared.cells.end());
    table.rows.push_back(row);
  }
  return table.text();
}

}  // namespace

std::string page_of(const std::string& heading, const std::vector<PageSection>& sections) {
  const std::string own =
      sections.size() == 1 ? name_of(sections.front()) : fmt::format("{} results of ehl", sections.size());
  const std::string title = escaped(heading.empty() ? own : heading);
  std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  text += std::string("<meta http-equiv=\"Content-Security-Policy\" content=\"") + policy + "\">\n";
  text += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" + title + "</title>\n";
  text += std::string("<style>") + style + "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n";
  if (sections.size() > 1) text += comparison(sections);
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const PageSection& one = sections[k];
    text += fmt::format("<section id=\"part{}\">\n", k + 1);
    if (sections.size() > 1 || !heading.empty()) text += "<h2>" + escaped(name_of(one)) + "</h2>\n";
    text += "<p class=\"small\">" + escaped(one.compared.kind) + ", " +
            escaped(std::filesystem::path(one.path).filename().string()) + "</p>\n";
    text += one.markup + "</section>\n";
  }
  text += "<footer class=\"small\"><p>Page written by " + escaped(this_program()) + ", " + escaped(utc_date()) +
          ".</p></footer>\n";
  return text + "<script>" + script + "</script>\n</body>\n</html>\n";
}

}  // namespace ehl::program
