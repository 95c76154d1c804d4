#pragma once
// Text functions: trimming, joining, numbers to and from text, nearest legal name.
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace ehl::deck {

/// Text without blanks, tabs and carriage returns at both ends.
std::string trimmed(std::string_view text);

/// The parts with the separator between them.
std::string joined(const std::vector<std::string>& parts, const std::string& separator);

/// Text from outside, made safe for messages: control characters as \\x1b, because a terminal would obey or hide them,
/// and of a long text only its beginning and length.
std::string quotable(const std::string& text);
/// quotable() in quotation marks.
std::string quoted(const std::string& text);

/// Parts between commas or blanks, without empty ones.
std::vector<std::string> split_words(const std::string& text);

/// Shortest text that reads back as the same number.
std::string shortest(double value);

/// 64-bit hash of Fowler, Noll and Vo (FNV-1a), to notice that a text has changed. in: before, the hash of the text so
/// far.
constexpr std::uint64_t hash_of_nothing = 14695981039346656037ULL;
std::uint64_t hash(std::string_view text, std::uint64_t before = hash_of_nothing);

/// True if the text is valid UTF-8.
bool is_utf8(std::string_view text);

/// True if a byte is a control character, such as a line break or a terminal escape.
bool has_control_character(std::string_view text);

/// Result of reading a text as a number.
struct ReadNumber {
  enum class Status { number, not_finite, out_of_reach, trailing_text, not_a_number };
  Status status = Status::not_a_number;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN unless it is a number
  std::string trailing{};                                   ///< what follows the number ("N" in "15 N")
};

/// Reads a decimal number, independent of the locale. nan and inf are recognised and refused (not_finite); 1e999
/// exceeds the range of a double (out_of_reach).
ReadNumber read_number(const std::string& text);

/// Smallest number of insertions, deletions, replacements and swaps of neighbours that turn a into b, ignoring letter
/// case (optimal string alignment). cost: |a| |b|.
int edit_distance(const std::string& a, const std::string& b);

/// The candidate nearest to `name`. If none is near (more than a third of its letters and more than two differ), the
/// shortest one that contains its letters and digits, at least three: "VG 68" finds mineral-vg68. Otherwise empty.
std::string nearest(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace ehl::deck
