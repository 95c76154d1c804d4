#pragma once
// gnuplot as a child: what its scripts are told, and how it ends.
#include <string>

namespace ehl::program {

/// A text as a literal of gnuplot, whatever it holds.
std::string gnuplot_literal(const std::string& text);

/// Names of files that gnuplot takes for no pipe ("| rm", "< cat") and no home ("~"), and that its scripts may hand to
/// a shell between single quotes: a name with a quote is reached through a link in a folder that goes with this object.
class PlainNames {
 public:
  PlainNames() = default;
  ~PlainNames();
  PlainNames(const PlainNames&) = delete;
  PlainNames& operator=(const PlainNames&) = delete;

  /// in: what the link is called where there must be one. errors: core::FileError where it cannot be made.
  std::string of(const std::string& path, const std::string& link);

 private:
  std::string folder_{};
};

/// The same for a file that gnuplot alone writes: no quote is in its way.
std::string no_pipe(const std::string& path);

/// Runs a script to its end. in: settings, gnuplot commands; script; name of the figure, for messages.
/// errors: core::FileError: gnuplot is not there, or failed; core::Interrupted, and then gnuplot has ended too.
void run_gnuplot(const std::string& settings, const std::string& script, const std::string& figure);

}  // namespace ehl::program
