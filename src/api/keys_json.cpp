#include "api/keys_json.hpp"

#include "base/json.hpp"

namespace ehl::program {
namespace {

const char* name_of(deck::Type type) {
  switch (type) {
    case deck::Type::number: return "number";
    case deck::Type::integer: return "integer";
    case deck::Type::word: return "word";
    case deck::Type::words: return "words";
    case deck::Type::text: break;
  }
  return "text";
}

Json needed(const deck::Key& key) {
  if (key.needs.name.empty()) return nullptr;
  return {{"section", deck::section_needed(key)}, {"name", key.needs.name}, {"words", key.needs.words}};
}

}  // namespace

std::string keys_json(const deck::Catalogue& catalogue) {
  Json all{{"sections", Json::array()}, {"keys", Json::array()}};
  const auto listed = [&](const std::string& section) { return !deck::find_section(catalogue, section)->on_request; };
  for (const deck::Section& one : catalogue.sections)
    if (listed(one.name))
      all["sections"].push_back({{"name", one.name}, {"meaning", one.meaning}, {"effect", one.effect}});
  for (const deck::Key& one : catalogue.keys)
    if (listed(one.section))
      all["keys"].push_back({{"section", one.section},
                             {"name", one.name},
                             {"type", name_of(one.type)},
                             {"unit", one.unit},
                             {"default", one.default_text},
                             {"default_note", one.default_note},
                             {"allowed", deck::allowed(one)},
                             {"words", one.words},
                             {"needs", needed(one)},
                             {"meaning", one.meaning},
                             {"source", one.source},
                             {"example", one.example}});
  return line_of(all);
}

}  // namespace ehl::program
