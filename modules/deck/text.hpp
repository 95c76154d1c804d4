#pragma once
// Small helpers on text: trimming, joining, numbers to and from text, the nearest legal name.
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace ehl::deck {

/// Without blanks, tabs and carriage returns at both ends.
std::string trimmed(std::string_view text);

std::string joined(const std::vector<std::string>& parts, const std::string& separator);

/// Text from outside as a message may repeat it: control characters as \\x1b, which a terminal would obey or hide, and
/// of a long text the beginning and its length.
std::string quotable(const std::string& text);
/// The same between quotes.
std::string quoted(const std::string& text);

/// Parts between commas or blanks, empty ones left out.
std::vector<std::string> split_words(const std::string& text);

/// The shortest text that reads back as the same number.
std::string shortest(double value);

/// Fowler, Noll and Vo's 64-bit hash (FNV-1a): enough to notice that a text is another one. in: the hash of what stands
/// before it.
constexpr std::uint64_t hash_of_nothing = 14695981039346656037ULL;
std::uint64_t hash(std::string_view text, std::uint64_t before = hash_of_nothing);

/// True where every byte belongs to a character in UTF-8.
bool is_utf8(std::string_view text);

/// True where a byte is a control character: a line break in a name, a terminal's escape.
bool has_control_character(std::string_view text);

/// What a piece of text is, read as a number.
struct ReadNumber {
  enum class Status { number, not_finite, out_of_reach, trailing_text, not_a_number };
  Status status = Status::not_a_number;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN unless it is a number
  std::string trailing{};                                   ///< what follows the number ("N" in "15 N")
};

/// Reads a decimal number, independent of the locale. nan and inf are recognised and refused (not_finite);
/// 1e999 is out_of_reach of a double.
ReadNumber read_number(const std::string& text);

/// The least number of insertions, deletions, replacements and swaps of neighbours that turn a into b, letter case
/// ignored (optimal string alignment). cost: |a| |b|.
int edit_distance(const std::string& a, const std::string& b);

/// The candidate nearest to `name`; where none is near (more than a third of its letters wrong, and more than two), the
/// shortest one that contains its letters and digits, at least three: "VG 68" finds mineral-vg68. Empty otherwise.
std::string nearest(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace ehl::deck
