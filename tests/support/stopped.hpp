#pragma once
// Stops the program while it works.
#include <sstream>
#include <string>

#include "support/program.hpp"

namespace support {

/// Starts the program and sends the signal after this number of seconds.
inline Ended stopped(const TemporaryFolder& folder, const std::string& words, const std::string& signal,
                     double seconds) {
  std::ostringstream line;
  line << "'" << EHL_PROGRAM << "' " << words << " & p=$!; sleep " << seconds << "; kill -" << signal
       << " $p 2>/dev/null; wait $p";
  return shell(folder, line.str());
}

enum class Came { too_soon, in_time, too_late };

inline Came before_the_first_step(const Ended& ended) {
  if (ended.says({"before the first step"})) return Came::in_time;
  return ended.says({"nothing was written"}) ? Came::too_soon : Came::too_late;
}

inline Came between_two_steps(const Ended& ended) {
  if (ended.says({"before the first step"}) || ended.says({"nothing was written"})) return Came::too_soon;
  return ended.status == 130 ? Came::in_time : Came::too_late;
}

/// Stops the program at the wanted stage. On a busy machine its speed varies, so the signal is sent later if it came
/// too early, and earlier if it came too late.
inline Ended stopped_where(const TemporaryFolder& folder, const std::string& words,
                           Came (*judged)(const Ended& ended)) {
  constexpr int most_tries = 60;
  constexpr double later = 1.5, earlier = 0.8;
  Ended ended;
  double seconds = 0.3;
  for (int tries = 0; tries < most_tries; ++tries) {
    ended = stopped(folder, words + " --overwrite", "INT", seconds);
    const Came came = judged(ended);
    if (came == Came::in_time) break;
    seconds *= came == Came::too_soon ? later : earlier;
  }
  return ended;
}

}  // namespace support
