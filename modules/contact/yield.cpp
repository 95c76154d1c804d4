#include "contact/yield.hpp"

#include <cstdio>

namespace ehl::contact {
namespace {

std::string gigapascals(double p) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g GPa", 1e-9 * p);
  return buffer;
}

}  // namespace

std::optional<std::string> beyond_yield(double p_h) {
  constexpr double yields = first_yield * bearing_steel_yield;
  if (!(p_h > yields)) return std::nullopt;
  const std::string first = "hardened bearing steel first yields below its surface at about " + gigapascals(yields) +
                            " (1.6 times its yield stress of about " + gigapascals(bearing_steel_yield) + ")";
  const std::string iso = "ISO 76 permits balls " + gigapascals(iso76_ball_pressure) +
                          ", which leaves a permanent dent of 1e-4 of their diameter";
  if (p_h > iso76_ball_pressure)
    return "p_h = " + gigapascals(p_h) + " is beyond steel: " + iso + "; " + first +
           ": these elastic numbers belong to no real contact of steel";
  return "p_h = " + gigapascals(p_h) + " is beyond the yield of steel: " + first + "; " + iso;
}

}  // namespace ehl::contact
