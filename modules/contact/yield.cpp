#include "contact/yield.hpp"

#include <fmt/format.h>

namespace ehl::contact {
namespace {

std::string gigapascals(double p) { return fmt::format("{:.3g} GPa", 1e-9 * p); }

}  // namespace

std::optional<core::Warning> beyond_yield(double p_h) {
  constexpr double yields = first_yield * bearing_steel_yield;
  if (!(p_h > yields)) return std::nullopt;
  const std::string first = fmt::format(
      "hardened bearing steel first yields below its surface at about {} (1.6 times its yield stress of about {})",
      gigapascals(yields), gigapascals(bearing_steel_yield));
  const std::string iso =
      fmt::format("ISO 76 permits {} for balls, which leaves a permanent dent of 1e-4 of their diameter",
                  gigapascals(iso76_ball_pressure));
  if (p_h > iso76_ball_pressure)
    return core::Warning{
        "yield",
        fmt::format(
            "p_h = {} is far beyond what steel can carry: {}; {}. Check the load, the radii and the elastic data",
            gigapascals(p_h), iso, first)};
  return core::Warning{
      "yield", fmt::format("p_h = {} exceeds the yield limit of steel: {}; {}. The bodies are computed as elastic",
                           gigapascals(p_h), first, iso)};
}

}  // namespace ehl::contact
