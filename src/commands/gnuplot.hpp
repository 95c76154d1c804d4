#pragma once
// Runs gnuplot as a child process with the settings of a script.
#include <string>

namespace ehl::program {

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

/// Runs a script to its end. in: settings as gnuplot commands; the script; the name of the figure for messages.
/// errors: core::FileError if gnuplot is not installed or failed; core::Interrupted after gnuplot was ended.
void run_gnuplot(const std::string& settings, const std::string& script, const std::string& figure);

}  // namespace ehl::program
