#include "case/transient_probes.hpp"

#include <sstream>

#include "deck/text.hpp"
#include "report/text_format.hpp"

namespace ehl::program {
namespace {

constexpr const char* section = "output";
constexpr const char* key = "probe";

// Two numbers and nothing else.
bool read_place(const std::string& text, transient::Place& place) {
  using Status = deck::ReadNumber::Status;
  const std::vector<std::string> words = deck::split_words(text);
  if (words.size() != 2) return false;
  const deck::ReadNumber X = deck::read_number(words[0]);
  const deck::ReadNumber Y = deck::read_number(words[1]);
  place = {X.value, Y.value};
  return X.status == Status::number && Y.status == Status::number;
}

}  // namespace

std::vector<transient::Place> probes_of(deck::Deck& deck, const core::Grid& grid) {
  std::vector<transient::Place> places;
  std::istringstream parts(deck::word(deck, section, key));
  for (std::string part; std::getline(parts, part, ',');) {
    transient::Place place;
    if (!read_place(part, place)) {
      deck::complain(deck, section, key,
                     deck::quoted(deck::trimmed(part)) + " is no point: write X Y, X Y, ... as in 0 0, 0.7 0.2");
      return {};
    }
    const bool inside = place.X >= grid.X_a && place.X <= grid.X_b && place.Y >= grid.Y_a && place.Y <= grid.Y_b;
    if (grid.ny > 0 && !inside)
      deck::complain(deck, section, key,
                     formatted("(%g, %g) is outside of the domain, %g <= X <= %g and |Y| <= %g", place.X, place.Y,
                               grid.X_a, grid.X_b, grid.Y_b));
    places.push_back(place);
  }
  return places;
}

std::string name_of_probe(const char* quantity, const transient::Place& place) {
  return formatted("%s at (%g, %g)", quantity, place.X, place.Y);
}

}  // namespace ehl::program
