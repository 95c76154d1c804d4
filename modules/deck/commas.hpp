#pragma once
// Commas in the numbers of tables: decimal ones, or separators of thousands.
#include <string>

namespace ehl::deck {

/// What the commas of a number are: none are there; a decimal comma, "0,5", "12,50"; separators of thousands,
/// "1,234,567", "1,234.5"; or either of both, "1,234". other: the text is no number with commas.
enum class Commas { none, decimal, thousands, either, other };
Commas commas_of(const std::string& number);
/// What is wrong with "1,234" if no other number of its file says what its comma is.
std::string two_meanings(const std::string& number);

}  // namespace ehl::deck
