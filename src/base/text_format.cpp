#include "base/text_format.hpp"

#include <fmt/core.h>

#include <cmath>

namespace ehl::program {

std::string known(const char* format, double value) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

std::string length(double metres) {
  if (!std::isfinite(metres)) return "-";
  const double size = std::abs(metres);
  if (size < 1e-6) return fmt::format("{:.1f} nm", metres * 1e9);
  if (size < 1e-3) return fmt::format("{:.4g} um", metres * 1e6);
  return fmt::format("{:.4g} mm", metres * 1e3);
}

std::string pressure(double pascal) {
  if (!std::isfinite(pascal)) return "-";
  return std::abs(pascal) < 1e9 ? fmt::format("{:.4g} MPa", pascal * 1e-6) : fmt::format("{:.4g} GPa", pascal * 1e-9);
}

std::string pressure_in_GPa(double pascal) {
  constexpr double soft = 0.01e9;  // Pa; rubber and plastics lie below it, steel and glass more than ten times above it
  return std::abs(pascal) < soft ? pressure(pascal) : fmt::format("{:.4g} GPa", pascal * 1e-9);
}

std::string memory(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes * 1e-6) : fmt::format("{:.1f} GB", bytes * 1e-9);
}

std::string about_seconds(double seconds) {
  if (!(seconds > 0.0)) return "0 s";
  const double digit = std::pow(10.0, std::floor(std::log10(seconds)));
  return fmt::format("{:g} s", std::round(seconds / digit) * digit);
}

std::string percent(double fraction) {
  if (!std::isfinite(fraction)) return "-";
  return fmt::format("{:.{}f} %", 100.0 * fraction, std::abs(fraction) < 0.001 ? 3 : 2);
}

std::string threads_text(int threads) { return fmt::format("{} thread{}", threads, threads == 1 ? "" : "s"); }

std::string warning_lines(const core::Warnings& warnings) {
  std::string text;
  for (const core::Warning& warning : warnings) text += "warning: " + with_name(warning) + "\n";
  return text;
}

}  // namespace ehl::program
