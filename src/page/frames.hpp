#pragma once
// The frames of a run in time, with a slider.
#include "page/result_view.hpp"
#include "page/svg.hpp"

namespace ehl::program {

/// The frames that a page shows: all, or 60 at even intervals with the first and the last among them. in: the number of
/// frames in the file.
std::vector<std::size_t> frames_on_page(std::size_t count);

/// A figure with one picture per frame; a small script of the page shows one at a time. Empty if there are none.
std::string frames_of(const ResultView& view, const DrawnFigures& figures);

}  // namespace ehl::program
