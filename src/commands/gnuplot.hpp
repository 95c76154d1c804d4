#pragma once
// Runs the scripts of postprocess/ by gnuplot, as a child process.
#include <string>
#include <vector>

#include "commands/curves.hpp"
#include "commands/figures.hpp"

namespace ehl::program {

/// The message if gnuplot is not installed.
constexpr char no_gnuplot[] = "gnuplot cannot be started: install it (Debian: gnuplot-nox)";

/// Any text as a string literal of gnuplot.
std::string gnuplot_literal(const std::string& text);

/// File names that are safe for gnuplot: it must not read them as a pipe ("| rm", "< cat") or as a home folder ("~"),
/// and its scripts may pass them to a shell in single quotes. A file with a quote in its name is reached by a link, in
/// a temporary folder that is removed with this object.
class PlainNames {
 public:
  PlainNames() = default;
  ~PlainNames();
  PlainNames(const PlainNames&) = delete;
  PlainNames& operator=(const PlainNames&) = delete;

  /// in: link: the name of the link if one is needed. errors: core::FileError if the link cannot be created.
  std::string of(const std::string& path, const std::string& link);

 private:
  std::string folder_{};
};

/// A name that gnuplot does not read as a pipe, for a file that only gnuplot writes; quotes are allowed.
std::string no_pipe(const std::string& path);

/// Draws the figures of one file.
class Gnuplot {
 public:
  /// in: path of the file; its source; png, svg or pdf. errors: core::FileError if a link is needed and fails.
  Gnuplot(const std::string& path, const FigureSource& source, const std::string& format);

  /// Runs the script of a figure to its end. in: own: further variables for the script, which replace those of the
  /// source; output: the name of the picture; curves: for a figure that draws curves.
  /// errors: core::FileError if gnuplot is not installed or failed; core::Interrupted after gnuplot was ended.
  void draw(const Figure& figure, std::vector<Setting> own, const std::string& output,
            const Curves* curves = nullptr) const;

 private:
  PlainNames names_{};
  std::string scripts_{};
  std::vector<Setting> settings_{};
};

}  // namespace ehl::program
