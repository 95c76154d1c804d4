#pragma once
// What the columns of a film remember in a run in time (film_in_time.cpp).
#include <optional>
#include <vector>

#include "core/field.hpp"
#include "core/simd.hpp"
#include "thermal/body_memory.hpp"

namespace ehl::thermal {

/// A body in time: its steady temperature, and what the change of its heat flux since T = 0 adds.
struct BodyInTime {
  core::Field theta, q;              ///< of the steady surface at T = 0
  std::optional<BodyMemory> memory;  ///< of q less its steady value; none for a body of given temperature
  core::Field history;               ///< what earlier fluxes add at the end of the step
  double factor = 0.0;               ///< of the integral over the flux in time
  std::vector<double> passing{};     ///< passing_weights() at T = 0

  std::size_t bytes() const { return memory ? memory->bytes() : 0; }
};

/// The film in time: the ends of the last two steps, and the step under way.
struct FilmInTime {
  BodyInTime body_1, body_2;
  std::vector<double> last{}, before{};  ///< theta at the nodes of all columns
  core::Field P_last, P_before;
  double length_before = 0.0;                        ///< of the last step; 0: none, or before a jump
  double length = 0.0;                               ///< of the step under way
  double now = 0.0, of_last = 0.0, of_before = 0.0;  ///< weights of the values in d/dT
  core::Field P_T;

  /// Surface temperature of columns: theta = given + self q.
  static void surface(const BodyInTime& body, int i, int j, core::Lanes& given, core::Lanes& self) {
    self = core::broadcast(body.memory ? body.memory->self() : 0.0);
    given = core::load(body.theta.at_x(i) + j) + core::load(body.history.at_x(i) + j) -
            self * core::load(body.q.at_x(i) + j);
  }
  std::size_t bytes() const { return body_1.bytes() + body_2.bytes() + sizeof(double) * (last.size() + before.size()); }
};

}  // namespace ehl::thermal
