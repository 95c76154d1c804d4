#include "commands/page_figures.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <optional>
#include <set>

#include "base/machine.hpp"
#include "base/memory_file.hpp"
#include "base/signals.hpp"
#include "case/numbers/number.hpp"
#include "commands/figure_source.hpp"
#include "commands/gnuplot.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "page/frames.hpp"
#include "tables/children.hpp"
#include "tables/labels.hpp"
#include "tables/series.hpp"

namespace ehl::program {
namespace {

/// Points of a map along x: those of the screen.
constexpr char points_on_page[] = "240";
/// The least number of frames that one process of gnuplot draws: a process first reads what all frames need.
constexpr std::size_t fewest_frames = 15;
constexpr char figure_of_frames[] = "contact_in_time";
constexpr char figure_of_curves[] = "curves";

// One run of gnuplot.
struct Drawing {
  Figure figure{};
  std::vector<Setting> own{};
  std::optional<Curves> curves{};
};

// The films of a sweep as curves, and every quantity that the page shows as curves. The friction has its own figure if
// there is one.
void add_curves(const SweepData& table, const Figure& figure, const Arguments& arguments, std::vector<Drawing>& tasks) {
  if (longest_key(table).empty() || too_many_curves(table)) return;
  const auto is_traction = [](const Drawing& task) { return task.figure.name == "traction_curve"; };
  const bool has_friction = std::ranges::any_of(tasks, is_traction);
  CurvesWanted wanted = chosen_curves(table, arguments);
  const auto add = [&] {
    if (!has_points(table, wanted.y)) return;
    tasks.push_back({figure, {}, curves_of(table, wanted)});
    tasks.back().figure.title =
        words_of_all(table, wanted.y) + " against " + words_for(wanted.x) + ", with error bars and formulas";
  };
  add();
  for (const std::string& column : table.columns) {
    const numbers::Number* number = numbers::number_of_column(column);
    if (number == nullptr || number->of_sweep != numbers::OfSweep::as_curve || !table.is_numeric(column)) continue;
    if (has_friction && column == id::mu) continue;
    wanted.y = {column};
    add();
  }
}

void add_frames(const Figure& figure, std::size_t count, std::vector<Drawing>& tasks) {
  const std::vector<std::size_t> shown = frames_on_page(count);
  const auto cores = static_cast<std::size_t>(usable_cores());
  const std::size_t frames_at_once = std::max(fewest_frames, (shown.size() + cores - 1) / cores);
  for (std::size_t from = 0; from < shown.size(); from += frames_at_once) {
    std::string list;
    for (std::size_t k = from; k < std::min(from + frames_at_once, shown.size()); ++k)
      list += (list.empty() ? "" : " ") + std::to_string(shown[k]);
    tasks.push_back({figure, {{"shown_frames", list}}, {}});
  }
}

std::vector<Drawing> tasks_of(const FigureSource& source, const Arguments& arguments) {
  std::vector<Drawing> tasks;
  const std::vector<Figure> all = figures_in(folder_of_scripts());
  for (const Figure& figure : figures_of_page(all, source)) {
    if (figure.name == figure_of_frames) {
      const auto last = std::ranges::find(source.settings, "frame", &Setting::name);
      add_frames(figure, std::stoul(last->value) + 1, tasks);
    } else if (!figure.of_curves) {
      tasks.push_back({figure, {}, {}});
    } else if (figure.name != figure_of_curves && !films(*source.table).empty()) {
      const CurvesWanted wanted = curves_for(figure, *source.table, arguments);
      if (has_points(*source.table, wanted.y)) tasks.push_back({figure, {}, curves_of(*source.table, wanted)});
    }
  }
  const auto curves = std::ranges::find(all, figure_of_curves, &Figure::name);
  if (source.table != nullptr && curves != all.end()) add_curves(*source.table, *curves, arguments, tasks);
  return tasks;
}

// The SVG of each task; empty if gnuplot failed. in: in_si: the contact is in SI. out: the reasons.
std::set<std::string> draw(const Gnuplot& gnuplot, bool in_si, const std::vector<Drawing>& tasks,
                           std::vector<std::string>& drawn) {
  std::set<std::string> reasons;
  std::vector<std::size_t> all(tasks.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  ChildrenCalls calls;
  calls.stop = stop_requested;
  calls.task = [&](std::size_t k, const Say&) {
    std::vector<Setting> own{{"title", ""}, {"when", ""}, {"points", points_on_page, false}};
    if (in_si) own.push_back({"seconds", "1", false});  // the slider and the tables are in ms
    own.insert(own.end(), tasks[k].own.begin(), tasks[k].own.end());
    const MemoryFile picture;
    gnuplot.draw(tasks[k].figure, own, picture.name(), tasks[k].curves ? &*tasks[k].curves : nullptr);
    return picture.text();
  };
  calls.ended = [&](const ChildEnd& end) {
    if (end.complete)
      drawn[end.task] = end.text;
    else
      reasons.insert(end.reason);
  };
  if (!run_in_children(all, usable_cores(), calls)) throw core::Interrupted();
  return reasons;
}

// The pictures for the page, those of the frames as one figure. A picture that may not stand on a page becomes empty in
// `drawn`, with a reason.
DrawnFigures arranged(const std::vector<Drawing>& tasks, std::size_t number, std::vector<std::string>& drawn,
                      std::set<std::string>& reasons) {
  DrawnFigures made;
  for (std::size_t k = 0; k < tasks.size(); ++k) try {
      const Figure& figure = tasks[k].figure;
      const bool goes_on =
          figure.name == figure_of_frames && !made.list.empty() && made.list.back().name == figure_of_frames;
      const std::string mark = "f" + std::to_string(number) + "_" + std::to_string(k) + "_";
      DrawnFigure one{figure.name, figure.title, goes_on ? made.list.back().mark : mark, {}};
      for (const std::string& svg : documents_of(drawn[k])) one.svgs.push_back(embedded(svg, one));
      if (goes_on)
        made.list.back().svgs.insert(made.list.back().svgs.end(), one.svgs.begin(), one.svgs.end());
      else if (!one.svgs.empty())
        made.list.push_back(one);
    } catch (const core::FileError& error) {
      drawn[k].clear();
      reasons.insert(error.what());
    }
  return made;
}

}  // namespace

DrawnFigures figures_for_page(const std::string& path, std::size_t number, const Arguments& arguments) {
  const FigureSource source = source_of(path, arguments);
  const bool in_si = std::ranges::find(source.settings, "si", &Setting::name) != source.settings.end();
  DrawnFigures made;
  std::set<std::string> reasons, failed;
  try {
    const std::vector<Drawing> tasks = tasks_of(source, arguments);
    std::vector<std::string> drawn(tasks.size());
    reasons = draw(Gnuplot(path, source, "svg"), in_si, tasks, drawn);
    made = arranged(tasks, number, drawn, reasons);
    for (std::size_t k = 0; k < tasks.size(); ++k)
      if (drawn[k].empty()) failed.insert(tasks[k].figure.name);
  } catch (const core::FileError& error) {
    reasons.insert(error.what());
  }
  for (const std::string& reason : reasons)
    std::fprintf(stderr, "ehl: warning: %s: %s\n", path.c_str(), reason.c_str());
  if (reasons.contains(no_gnuplot) || (!reasons.empty() && failed.empty()))
    made.missing = "The figures need gnuplot and the scripts of ehl, which were not there when the page was written.";
  else if (!failed.empty())
    made.missing = "gnuplot could not draw " + deck::joined({failed.begin(), failed.end()}, ", ") + ".";
  else if (source.table != nullptr && too_many_curves(*source.table))
    made.missing = "More curves than a figure holds: `ehl plot --x KEY --by KEY` draws a choice of them.";
  return made;
}

}  // namespace ehl::program
