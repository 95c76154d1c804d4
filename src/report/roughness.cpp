#include "report/roughness.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/text_format.hpp"
#include "case/numbers/number.hpp"
#include "case/touching.hpp"
#include "core/constants.hpp"
#include "report/film_fit.hpp"
#include "report/outcome.hpp"

namespace ehl::program {
namespace {

/// Above this lambda ratio the asperities hardly touch. source: Tallian (1967), who counted asperity contacts.
constexpr double full_film = 3.0;
/// Below this lambda ratio the roughness exceeds the film.
constexpr double touching_film = 1.0;

std::string film(const Case& input, const Roughness& rough) {
  return numbers::symbol_of(id::hm) + " = " + height_text(input, rough.Hm) +
         (rough.from.empty() ? "" : " by " + rough.from + " for smooth surfaces");
}

// Sq in units of a^2/R; 0 if the surface is smooth or its roughness is not known.
double stated(double Sq, const SiInput& si) { return std::isnan(Sq) ? 0.0 : Sq / si.hertz.h_scale; }

}  // namespace

std::optional<Roughness> roughness_of(const Case& input, const std::vector<Formula>& formulas, double Hm) {
  Roughness rough{.Hm = core::unknown};
  if (input.physics.si)
    rough.Sq =
        std::hypot(stated(input.physics.si->Sq1, *input.physics.si), stated(input.physics.si->Sq2, *input.physics.si));
  const std::vector<const CarriedSurface*> shapes = carried(input.surfaces);
  rough.Sq = std::hypot(rough.Sq, measured_roughness(input));
  if (!(rough.Sq > 0.0)) return std::nullopt;
  // The fit to solutions of this program is preferred; it is more accurate than the published formulas.
  auto known = std::ranges::find(formulas, map_code, &Formula::code);
  if (known == formulas.end())
    known = std::ranges::find_if(formulas, [](const Formula& f) { return std::isfinite(f.Hm); });
  const bool traced = input.roller && input.roller->trace.rough > 0.0;
  if (shapes.empty() && !traced && std::isfinite(Hm)) {
    rough.Hm = Hm;
  } else if (known != formulas.end()) {
    rough.Hm = known->Hm;
    rough.from = known->name;
  }
  return rough;
}

std::string roughness_line(const Case& input, const std::optional<Roughness>& roughness) {
  if (!roughness) return {};
  const std::string text = "roughness    S_q = " + height_text(input, roughness->Sq) + " of both surfaces together";
  if (std::isnan(roughness->Hm)) return text + "; no formula gives the minimum film of smooth surfaces\n";
  return text + fmt::format("; {} = {:.3g} with {}\n", numbers::number_of(id::lambda_ratio).label,
                            roughness->lambda_ratio(), film(input, *roughness));
}

std::optional<core::Warning> roughness_warning(const Case& input, const std::optional<Roughness>& roughness) {
  if (!roughness || !(roughness->lambda_ratio() < full_film)) return std::nullopt;
  const bool mixed = input.scene.boundary_film.has_value();
  if (mixed && measured_roughness(input) > 0.0) return std::nullopt;  // the contact of the roughness is computed
  const bool touch = roughness->lambda_ratio() < touching_film;
  return core::Warning{
      "lambda",
      fmt::format(
          "lambda ratio {:.2g} is below {:g}: the film {} is too thin to separate surfaces of roughness S_q = {}; {}",
          roughness->lambda_ratio(), touch ? touching_film : full_film, film(input, *roughness),
          height_text(input, roughness->Sq),
          mixed   ? "[mixed] counts the contact of given shapes, not of a roughness that is known by S_q alone"
          : touch ? "they touch, and asperity contact is not computed"
                  : "mixed lubrication is likely")};
}

}  // namespace ehl::program
