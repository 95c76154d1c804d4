// Deliberate damage: typing errors of users, and accidents that happen to files.
#include <algorithm>
#include <utility>

#include "hard/random_deck.hpp"

namespace hard {
namespace {

std::size_t place(Random& random, std::size_t size) {
  return static_cast<std::size_t>(whole(random, 0, static_cast<int>(size) - 1));
}

char any_byte(Random& random) { return static_cast<char>(whole(random, 1, 255)); }

// One typing error.
void mistype(std::string& text, Random& random) {
  if (text.empty()) return;
  const std::size_t at = place(random, text.size());
  switch (whole(random, 0, 4)) {
    case 0: text.erase(at, 1); break;
    case 1: text.insert(at, 1, text[at]); break;
    case 2: std::swap(text[at], text[(at + 1) % text.size()]); break;
    case 3: text[at] = static_cast<char>(whole(random, 'a', 'z')); break;
    default: text[at] = any_byte(random); break;
  }
}

std::vector<std::string> impossible_values() {
  return {"nan",      "NaN",         "inf",
          "-inf",     "1e999",       "-1e999",
          "1e-999",   "0",           "-1",
          "-0",       "1e308",       "5e-324",
          "1e-30",    "1e30",        "15 N",
          "1.5mm",    "3,5",         "0x10",
          "",         "true",        "1e",
          "--5",      "1_000",       "50%",
          "=",        "= 3",         "[grid]",
          "\"3\"",    "a b",         "9999999999999999999",
          "1..2",     "2147483648",  "1e6",
          "99999",    "-2147483649", "1/3",
          "5;",       "\x1b[31m7",   "roelands,barus",
          "upstream3"};
}

std::string extreme_value(Random& random) {
  const double size = log_between(random, 1e-40, 1e40);
  return written(random, random.chance(0.3) ? -size : size);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

std::string joined_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string sixteen_bits(const std::string& text) {
  std::string wide = "\xFF\xFE";
  for (const char c : text) {
    wide += c;
    wide += '\0';
  }
  return wide;
}

std::string damage_characters(std::string& text, Random& random) {
  const int slips = whole(random, 1, 12);
  for (int k = 0; k < slips && !text.empty(); ++k) mistype(text, random);
  return std::to_string(slips) + " characters mistyped";
}

std::string damage_lines(std::string& text, Random& random) {
  std::vector<std::string> lines = lines_of(text);
  const std::size_t at = place(random, lines.size());
  const std::size_t other = place(random, lines.size());
  std::string what;
  switch (whole(random, 0, 4)) {
    case 0:
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at));
      what = "a line lost";
      break;
    case 1:
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), lines[other]);
      what = "a line doubled";
      break;
    case 2:
      std::swap(lines[at], lines[other]);
      what = "two lines swapped";
      break;
    case 3:
      lines[at] += lines[other];
      what = "two lines joined";
      break;
    default:
      lines[at] = pick<std::string>(random, {"[contact", "contact]", "[[contact]]", "[]", "[ ]", "= 5", "M", "[a] b",
                                             "[contact]]", "[thermal]", "[gird]", "[Grid]", "[grid.cells]", "{M: 3}"});
      what = "a line replaced by " + lines[at];
      break;
  }
  text = joined_lines(lines);
  return what;
}

std::string damage_file(std::string& text, Random& random) {
  const std::size_t at = place(random, text.size());
  const auto long_size = [&] { return static_cast<std::size_t>(log_between(random, 1e3, 2e6)); };
  switch (whole(random, 0, 8)) {
    case 0: text.resize(at); return "cut off";
    case 1: text.insert(at, 1, '\0'); return "a NUL byte";
    case 2: text = sixteen_bits(text); return "16-bit characters";
    case 3: std::replace(text.begin(), text.end(), '\n', '\r'); return "carriage returns alone";
    case 4: text.insert(at, long_size(), 'x'); return "a very long word";
    case 5: text.insert(at, "\n#" + std::string(long_size(), '=') + "\n"); return "a very long remark";
    case 6: text += text; return "the deck twice";
    case 7: text.insert(at, "\nM = " + std::string(long_size(), '9') + "\n"); return "a very long number";
    default: break;
  }
  const int size = whole(random, 1, 3000);
  std::string noise;
  for (int k = 0; k < size; ++k) noise += any_byte(random);
  if (random.chance(0.5))
    text = noise;
  else
    text.insert(at, noise);
  return "binary noise";
}

}  // namespace

void damage_entries(std::vector<Entry>& entries, const std::vector<KnownKey>& keys, Random& random,
                    std::vector<std::string>& done) {
  for (int slips = random.chance(0.6) ? 1 : whole(random, 2, 4); slips > 0 && !entries.empty(); --slips) {
    const std::size_t at = place(random, entries.size());
    Entry& entry = entries[at];
    const std::string name = entry.section + "." + entry.name;
    switch (whole(random, 0, 8)) {
      case 0:
        done.push_back(name + " misspelt");
        mistype(entry.name, random);
        break;
      case 1:
        done.push_back("section of " + name + " misspelt");
        mistype(entry.section, random);
        break;
      case 2:
      case 3:
        entry.value = random.chance(0.7) ? pick(random, impossible_values()) : extreme_value(random);
        done.push_back(name + " = " + entry.value);
        break;
      case 4:
        done.push_back(name + " lost");
        entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(at));
        break;
      case 5:
        done.push_back(name + " twice");
        entries.push_back({entry.section, entry.name, random.chance(0.5) ? entry.value : "3"});
        break;
      case 6:
        done.push_back(name + " in another section");
        entry.section = entries[place(random, entries.size())].section;
        break;
      default:
        if (keys.empty()) break;
        const KnownKey& key = keys[place(random, keys.size())];
        const std::string value = random.chance(0.5) ? extreme_value(random) : written(random, random.between(0, 9));
        done.push_back(key.section + "." + key.name + " = " + value + " added");
        entries.push_back({key.section, key.name, value});
        break;
    }
  }
}

void damage_text(std::string& text, Random& random, std::vector<std::string>& done) {
  for (int accidents = random.chance(0.7) ? 1 : 2; accidents > 0 && !text.empty(); --accidents) {
    const int kind = whole(random, 0, 2);
    done.push_back(kind == 0   ? damage_characters(text, random)
                   : kind == 1 ? damage_lines(text, random)
                               : damage_file(text, random));
  }
}

void damage_cells(std::string& text, Random& random, std::vector<std::string>& done) {
  const std::string ends = ",; \t\n";
  for (int cells = random.chance(0.7) ? 1 : whole(random, 2, 4); cells > 0; --cells) {
    const std::size_t within = text.find_first_not_of(ends, place(random, text.size()));
    if (within == std::string::npos) continue;
    const std::size_t begin = text.find_last_of(ends, within) + 1;  // npos + 1 = 0: the first cell
    const std::size_t end = std::min(text.find_first_of(ends, begin), text.size());
    const std::string value = random.chance(0.3)   ? pick(random, impossible_values())
                              : random.chance(0.3) ? extreme_value(random)
                                                   : written(random, random.between(0.0, 3.0));
    done.push_back("cell " + text.substr(begin, end - begin) + " -> " + value);
    text.replace(begin, end - begin, value);
  }
  if (done.empty()) done.emplace_back("nothing");
}

void damage_bytes(std::string& bytes, Random& random, std::vector<std::string>& done) {
  constexpr std::size_t head = 4096;
  const std::size_t at = place(random, random.chance(0.5) ? std::min(bytes.size(), head) : bytes.size());
  const std::size_t size =
      std::min<std::size_t>(static_cast<std::size_t>(log_between(random, 1.0, 1e3)), bytes.size() - at);
  const std::string where = " of byte " + std::to_string(at);
  switch (whole(random, 0, 3)) {
    case 0:
      bytes.resize(at);
      done.push_back("cut off" + where);
      break;
    case 1:
      bytes.erase(at, size);
      done.push_back(std::to_string(size) + " bytes lost" + where);
      break;
    case 2:
      bytes.replace(at, size, size, '\0');
      done.push_back(std::to_string(size) + " bytes zero" + where);
      break;
    default:
      for (int k = whole(random, 1, 20); k > 0; --k)
        bytes[place(random, random.chance(0.5) ? std::min(bytes.size(), head) : bytes.size())] = any_byte(random);
      done.push_back("bytes changed");
      break;
  }
}

}  // namespace hard
