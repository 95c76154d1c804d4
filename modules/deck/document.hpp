#pragma once
// A deck as written: its assignments in order, each with its place.
#include <string>
#include <vector>

namespace ehl::deck {

/// Place of assignments by --set and --unset.
inline constexpr char on_command_line[] = "command line";

/// One "name = value" line.
struct Assignment {
  std::string section{};
  std::string name{};
  std::string value{};   ///< without comment and surrounding blanks; may be empty
  std::string place{};   ///< "deck.ini:12" or on_command_line
  bool removes = false;  ///< removes the key from the deck
};

/// One "[section]" line.
struct Heading {
  std::string section{};
  std::string place{};
};

/// All assignments and headings of a deck, in order.
struct Document {
  std::string name{};  ///< name of the file, for messages
  std::vector<Heading> headings{};
  std::vector<Assignment> assignments{};
  std::vector<std::string> errors{};  ///< lines that are neither heading, assignment, comment nor blank
};

/// Text of a deck file. errors: core::InputError if it is missing, a directory, unreadable, empty, not text or larger
/// than a megabyte.
std::string load_text(const std::string& path);

/// Parses the text of a deck. Comments run from # to the end of the line; a line that starts with ; is also a comment.
/// in: text; name of the file for messages. errors: none thrown; all are listed in the document.
Document parse(const std::string& text, const std::string& name);

/// An assignment from the command line: "section.key=value", or "-section.key", which removes the key. errors:
/// core::InputError for any other form.
Assignment parse_override(const std::string& text);

}  // namespace ehl::deck
