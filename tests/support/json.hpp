#pragma once
// Is this text one JSON value (RFC 8259), and nothing else?
#include <cctype>
#include <string>

namespace support {

class JsonReader {
 public:
  explicit JsonReader(const std::string& text) : text_(text) {}

  bool reads_all() {
    const bool good = value();
    blanks();
    return good && at_ == text_.size();
  }

 private:
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  void blanks() {
    while (next() == ' ' || next() == '\n' || next() == '\t' || next() == '\r') ++at_;
  }
  bool word(const std::string& expected) {
    if (text_.compare(at_, expected.size(), expected) != 0) return false;
    at_ += expected.size();
    return true;
  }
  bool digits() {
    const std::size_t start = at_;
    while (std::isdigit(static_cast<unsigned char>(next())) != 0) ++at_;
    return at_ > start;
  }
  bool number() {
    take('-');
    if (!digits()) return false;
    if (take('.') && !digits()) return false;
    if (next() == 'e' || next() == 'E') {
      ++at_;
      if (!take('+')) take('-');
      return digits();
    }
    return true;
  }
  bool string() {
    if (!take('"')) return false;
    while (at_ < text_.size() && next() != '"') {
      if (static_cast<unsigned char>(next()) < 0x20) return false;
      if (take('\\')) {
        if (std::string("\"\\/bfnrtu").find(next()) == std::string::npos) return false;
        if (next() == 'u')
          for (int k = 0; k < 4; ++k)
            if (std::isxdigit(static_cast<unsigned char>(text_[++at_])) == 0) return false;
      }
      ++at_;
    }
    return take('"');
  }
  bool members(char close, bool named) {
    blanks();
    if (take(close)) return true;
    do {
      blanks();
      if (named) {
        if (!string()) return false;
        blanks();
        if (!take(':')) return false;
      }
      if (!value()) return false;
      blanks();
    } while (take(','));
    return take(close);
  }
  bool value() {
    blanks();
    if (take('{')) return members('}', true);
    if (take('[')) return members(']', false);
    if (next() == '"') return string();
    return word("true") || word("false") || word("null") || number();
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

inline bool is_json(const std::string& text) { return JsonReader(text).reads_all(); }

}  // namespace support
