#pragma once
// Numbers as text for reports.
#include <string>
#include <vector>

#include "core/warning.hpp"

namespace ehl::program {

/// The number in the format given, such as "{:.4g}"; "-" if it is not known.
std::string known(const char* format, double value);

/// A length in a readable unit: "212.4 nm", "136.5 um".
std::string length(double metres);
/// A pressure: "1.385 GPa", "12.3 MPa".
std::string pressure(double pascal);
/// A pressure of a contact in SI: "0.385 GPa"; in MPa if the contact is very soft.
std::string pressure_in_GPa(double pascal);
/// Memory: "12 MB".
std::string memory(double bytes);
/// A predicted time with one digit: "0.04 s", "20 s".
std::string about_seconds(double seconds);
/// An estimated relative error: "0.58 %".
std::string percent(double fraction);

/// What stands behind every printed number of a solution that has not converged.
inline const char* convergence_mark(bool converged) { return converged ? "" : "  (NOT CONVERGED)"; }

/// "1 thread", "4 threads".
std::string threads_text(int threads);
/// One line "warning: text [name]" for each warning.
std::string warning_lines(const core::Warnings& warnings);

}  // namespace ehl::program
