#pragma once
// How far many cases have come: a line per case on stderr, and on a terminal a bar below them.
#include <cstddef>
#include <string>

namespace ehl::program {

class CaseProgress {
 public:
  CaseProgress(bool quiet, std::size_t cases);

  /// A case has ended. in: its name; how it ended.
  void show(const std::string& name, const std::string& status);

  /// Takes the bar away.
  void close() const;

 private:
  bool quiet_;
  bool terminal_;
  std::size_t cases_;
  std::size_t done_ = 0;
};

}  // namespace ehl::program
