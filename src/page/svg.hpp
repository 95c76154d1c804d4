#pragma once
// Figures drawn by gnuplot as SVG, embedded in a page.
#include <string>
#include <vector>

namespace ehl::program {

struct DrawnFigure {
  std::string name{};   ///< the name of its script
  std::string title{};  ///< a sentence without its point; may contain indices (markup.hpp)
  std::string mark{};   ///< the beginning of its names (attribute id), which no other figure of the page has
  std::vector<std::string> svgs{};  ///< embedded pictures: one; several are the frames of a run in time
};

/// The figures of one file, and why some are missing, as a sentence; empty if none is.
struct DrawnFigures {
  std::vector<DrawnFigure> list{};
  std::string missing{};
};

/// An SVG as a part of a page: without its declaration, one element a line, with names that begin with the figure's
/// mark. The SVG may contain only shapes, text and PNG pictures, and refer only to itself.
/// errors: core::FileError if it does not.
std::string embedded(const std::string& svg, const DrawnFigure& figure);

/// The SVG documents that a file contains one after another.
std::vector<std::string> documents_of(const std::string& text);

/// The figures with their titles below them, and what is missing.
std::string figures_markup(const DrawnFigures& figures);

}  // namespace ehl::program
