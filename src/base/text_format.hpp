#pragma once
// Numbers for people.
#include <string>
#include <vector>

namespace ehl::program {

/// The number as `format`, "{:.4g}", prints it; "-" where it is not known.
std::string known(const char* format, double value);

/// A length in the unit that leaves it readable: "212.4 nm", "136.5 um".
std::string length(double metres);
/// A pressure: "1.385 GPa", "12.3 MPa".
std::string pressure(double pascal);
/// A pressure of a contact in SI: "0.385 GPa", in MPa only where the contact is that soft.
std::string pressure_in_GPa(double pascal);
/// Memory: "12 MB".
std::string memory(double bytes);
/// A time that is foreseen, to one digit: "0.04 s", "20 s".
std::string about_seconds(double seconds);
/// An estimated share: "0.58 %".
std::string percent(double fraction);

/// "1 thread", "4 threads".
std::string threads_text(int threads);
/// "warning: ..." for each, on lines of their own.
std::string warning_lines(const std::vector<std::string>& warnings);

}  // namespace ehl::program
