#pragma once
// The figures that `ehl report` puts on a page.
#include <string>

#include "commands/arguments.hpp"
#include "page/svg.hpp"

namespace ehl::program {

/// Draws the figures of a result or a table by gnuplot, several at a time. in: the file; number: that of the file on
/// the page; arguments of `ehl report`. out: what could be drawn; without gnuplot nothing.
/// errors: core::FileError for a damaged or foreign file; core::Interrupted.
DrawnFigures figures_for_page(const std::string& path, std::size_t number, const Arguments& arguments);

}  // namespace ehl::program
