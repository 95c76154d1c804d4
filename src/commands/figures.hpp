#pragma once
// The figures that postprocess/ draws, as their scripts describe them.
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
  std::vector<std::string> needs{};  ///< datasets without which there is nothing to draw; or what it draws instead,
                                     ///< "sweep", "study" or "time_study", and columns without which there is nothing
  bool movie = false;                ///< a GIF whatever the format
  bool on_demand = false;            ///< only when asked for, as every movie
  bool of_curves = false;            ///< draws the rows of a sweep as curves
};

/// A need of figures of a sweep: a swept key of three numbers or more, and not too many curves over it.
constexpr char curves_need[] = "curves";

/// A need of figures of a result: a pressure that is not zero everywhere; bodies that are apart have none.
constexpr char pressure_need[] = "pressure";

/// Likewise: fields over the contact's plane; a line contact has one line, a roller too many.
constexpr char map_need[] = "map";

/// A variable that a script finds: a text, or a number as text.
struct Setting {
  std::string name{};
  std::string value{};
  bool is_text = true;
};

/// What there is to draw: what scripts are told about it, and whether it has what a figure needs.
struct FigureSource {
  std::vector<Setting> settings{};
  std::string kind{};  ///< "result", "sweep", "study", "time_study"
  std::function<bool(const std::string&)> has{};
  std::shared_ptr<const SweepData> table{};  ///< of a sweep
};

/// A script is a figure when its first line says "# figure: title"; "# needs: name..." may follow, and "# movie",
/// "# on demand" or "# curves". errors: core::FileError: no such folder, no figure in it.
std::vector<Figure> figures_in(const std::string& folder);

/// Where the scripts are: EHL_POSTPROCESS, beside an installed program, or in the source.
std::string folder_of_scripts();

/// The figures of these names, which must be some that draw this source; without names all that fit it and are not
/// drawn on demand only. errors: core::InputError.
std::vector<Figure> selected_figures(const std::vector<Figure>& all, const std::vector<std::string>& names,
                                     const FigureSource& source);

/// Every figure with what it shows and needs, for people.
std::string list_of_figures(const std::vector<Figure>& all);

}  // namespace ehl::program
