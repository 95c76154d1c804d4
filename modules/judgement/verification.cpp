#include "judgement/verification.hpp"

#include <cmath>

#include "judgement/stopping.hpp"

namespace ehl::judgement {

Verification verification_of(const Tuning& tuning, const LastCycle& cycle) {
  const Measures& now = cycle.after;
  const auto change = [](double before, double after) { return std::abs((after - before) / after); };
  return {now, change(cycle.before.Hc, now.Hc), change(cycle.before.Hm, now.Hm),
          predicted_error(tuning, cycle, &Measures::Hc), predicted_error(tuning, cycle, &Measures::Hm)};
}

}  // namespace ehl::judgement
