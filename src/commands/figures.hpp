#pragma once
// The figures that postprocess/ can draw, as described by the headings of their scripts.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tables/sweep_data.hpp"

namespace ehl::program {

struct Figure {
  std::string name{};
  std::string title{};
  std::string script{};
  std::vector<std::string> needs{};  ///< the datasets that the figure needs; or the kind of table, "sweep", "study",
                                     ///< "time_study" or "asperities", followed by the columns that it needs
  bool movie = false;                ///< the output is a GIF, whatever the format
  bool on_demand = false;            ///< `ehl plot` draws it only if asked for by name, as every movie
  bool on_page = true;               ///< `ehl report` draws it
  bool of_curves = false;            ///< draws the rows of a sweep as curves
};

/// A need of a figure of a sweep: a varied key with at least three numbers, and not too many curves.
constexpr char curves_need[] = "curves";

/// A need of a figure of a result: a pressure that is not zero everywhere. It is zero if the bodies are separated.
constexpr char pressure_need[] = "pressure";

/// A need of a figure of a result: fields over the contact plane. A line contact has none, and a roller is too long.
constexpr char map_need[] = "map";

/// A variable for a script: a text, or a number as text.
struct Setting {
  std::string name{};
  std::string value{};
  bool is_text = true;
};

/// The data of the figures: the variables for the scripts, and the needs that the data meet.
struct FigureSource {
  std::vector<Setting> settings{};
  std::string kind{};  ///< "result", "sweep", "study", "time_study", "asperities"
  std::function<bool(const std::string&)> has{};
  std::shared_ptr<const SweepData> table{};  ///< set for a sweep
};

/// A script is a figure if its first line is "# figure: title". A line "# needs: name..." follows, and one of: "#
/// movie"; "# curves";
/// "# on demand", by `ehl plot` alone; "# on the page", by `ehl report` and otherwise on demand; "# not on the page".
/// errors: core::FileError if the folder does not exist or contains no figure.
std::vector<Figure> figures_in(const std::string& folder);

/// The folder of the scripts: EHL_POSTPROCESS, or the folder next to an installed program, or that of the source.
std::string folder_of_scripts();

/// The figures with these names, which must draw this source. Without names: all figures that fit the source and are
/// not drawn on demand only. errors: core::InputError.
std::vector<Figure> selected_figures(const std::vector<Figure>& all, const std::vector<std::string>& names,
                                     const FigureSource& source);

/// The figures of this source that stand on its page: those of `ehl plot`, and those that only the page shows. A run in
/// time has those of its course; the frames show its fields.
std::vector<Figure> figures_of_page(const std::vector<Figure>& all, const FigureSource& source);

/// A printed list of all figures with their contents and needs.
std::string list_of_figures(const std::vector<Figure>& all);

}  // namespace ehl::program
