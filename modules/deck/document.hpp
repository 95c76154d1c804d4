#pragma once
// A deck as it was written: its assignments in order, each with the place where it stands.
#include <string>
#include <vector>

namespace ehl::deck {

/// The place of what --set and --unset say.
inline constexpr char on_command_line[] = "command line";

/// One "name = value" line.
struct Assignment {
  std::string section{};
  std::string name{};
  std::string value{};   ///< without comment and surrounding blanks; may be empty
  std::string place{};   ///< "deck.ini:12" or on_command_line
  bool removes = false;  ///< takes the key out of the deck instead
};

/// One "[section]" line.
struct Heading {
  std::string section{};
  std::string place{};
};

struct Document {
  std::string name{};  ///< the file's name, for messages
  std::vector<Heading> headings{};
  std::vector<Assignment> assignments{};
  std::vector<std::string> errors{};  ///< lines that are neither heading, assignment, comment nor blank
};

/// The text of a deck file. errors: core::InputError when it is missing, a directory, unreadable, empty, not text or
/// larger than a megabyte.
std::string load_text(const std::string& path);

/// Reads the text of a deck. Comments run from # to the end of the line; a line that starts with ; is a comment too.
/// in: text; name of the file for messages. errors: none thrown, all listed in the document.
Document parse(const std::string& text, const std::string& name);

/// An assignment from the command line, "section.key=value", or "-section.key", which takes it out. errors:
/// core::InputError when it has another form.
Assignment parse_override(const std::string& text);

}  // namespace ehl::deck
