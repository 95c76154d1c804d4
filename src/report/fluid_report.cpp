// The printed lines about the oil.
#include <fmt/core.h>

#include <cmath>

#include "core/constants.hpp"
#include "report/report.hpp"
#include "rheology/pressure_coefficient.hpp"

namespace ehl::program {
namespace {

std::string text(rheology::Isoviscous) { return "isoviscous"; }
std::string text(const rheology::Barus&) { return "Barus"; }
std::string text(const rheology::Roelands& law) { return fmt::format("Roelands, z = {:.4g}", law.z); }
std::string text(const rheology::Doolittle& law) {
  return fmt::format("Doolittle, B = {:.4g}, R0 = {:.4g} (Tait's volume)", law.B, law.R0);
}
std::string text(const rheology::Yasutomi& law) {
  return fmt::format("Yasutomi, {:.4g} K above the glass transition", law.x0);
}
std::string text(const rheology::TabulatedViscosity& law) {
  return fmt::format("table of {} viscosities", law.curve->x.size());
}

std::string text(rheology::Incompressible) { return "incompressible"; }
std::string text(const rheology::DowsonHigginson&) { return "Dowson-Higginson"; }
std::string text(const rheology::Tait& law) { return fmt::format("Tait, K0' = {:.4g}", law.K0_prime); }
std::string text(const rheology::Murnaghan& law) { return fmt::format("Murnaghan, K0' = {:.4g}", law.K0_prime); }
std::string text(const rheology::TabulatedDensity& law) {
  return fmt::format("table of {} densities", law.curve->x.size());
}

}  // namespace

std::string fluid_text(const Physics& physics) {
  const auto said = [](const auto& law) { return text(law); };
  std::string line = std::visit(said, physics.viscosity) + "; " + std::visit(said, physics.density);
  if (const auto& oil = physics.ambient)
    line += fmt::format("; at {:g} C {:.4g} mm^2/s, {:.4g} kg/m^3", oil->T, oil->nu, oil->rho);
  return line;
}

FilmCoefficients film_coefficients(const Physics& physics) {
  FilmCoefficients found{core::unknown, core::unknown, core::unknown, core::unknown};
  const double alpha_bar = physics.groups.alpha_bar;
  if (alpha_bar == 0.0) found.L_star = found.L_film = 0.0;
  if (!(alpha_bar > 0.0)) return found;
  const rheology::PressureCoefficients scaled = rheology::pressure_coefficients(physics.viscosity);
  if (!(scaled.alpha_star > 0.0)) return found;
  if (std::isfinite(physics.p_h)) {
    found.alpha_star = scaled.alpha_star / physics.p_h;
    found.alpha_film = scaled.alpha_film / physics.p_h;
  }
  found.L_star = physics.groups.L * scaled.alpha_star / alpha_bar;
  found.L_film = physics.groups.L * scaled.alpha_film / alpha_bar;
  return found;
}

std::string film_coefficients_line(const Physics& physics) {
  const FilmCoefficients found = film_coefficients(physics);
  if (std::isnan(found.alpha_star)) return {};
  return fmt::format("             alpha* = {:.4g} 1/Pa (L = {:.4g}), alpha_film = {:.4g} 1/Pa (L = {:.4g})\n",
                     found.alpha_star, found.L_star, found.alpha_film, found.L_film);
}

}  // namespace ehl::program
