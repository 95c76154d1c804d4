#include "tables/warning_names.hpp"

#include <algorithm>

#include "deck/text.hpp"

namespace ehl::program {
namespace {

struct Name {
  const char* name;
  const char* part;  // a part of the sentence; the first entry whose part occurs in it is used
};

constexpr Name names[] = {
    {"film-negative", "film is negative between the nodes"},
    {"one-level", "rough error estimate"},
    {"mesh", "not resolved by the mesh"},
    {"domain", "starved by the domain"},
    {"supply-left", "supply is more than the contact lets through"},
    {"supply-left", "supply beyond what the domain takes"},
    {"meniscus-at-inlet", "the meniscus is within"},
    {"no-flooded-film", "flooded contact beside it did not converge"},
    {"starvation-above-1", "starvation factor is above 1"},
    {"edge-of-film", "at the edge of the film"},
    {"polish", "polish did not reach"},
    {"outlet", "outlet too short"},
    {"sides", "domain too narrow"},
    {"viscosity-range", "viscosity beyond its range"},
    {"viscosity-range", "viscosity extrapolated"},
    {"table-range", "was left: p_max"},
    {"density-range", "density extrapolated"},
    {"no-load", "L = 0 is the limit"},
    {"yield", "beyond steel"},
    {"yield", "beyond the yield of steel"},
    {"late-feature", "does not come to the contact"},
    {"coarse-feature", "are wanted of what moves"},
    {"map-lost", "of the variance of the map"},
    {"lambda", "lambda ratio"},
    {"backwards", "moves backwards"},
    {"roller-edge", "ends of the roller"},
    {"thick-oil", "thicker than an oil"},
    {"fast", "a surface moves with"},
    {"thin-film", "thinner than a molecule"},
    {"thick-film", "at the centre, above"},
    {"shear-stress", "friction: on"},
    {"hot-film", "thermal: the film reaches"},
    {"thermal-nodes", "nodes across the film"},
    {"at-rest", "stands still"},
    {"slow-surface", "is slow, u a"},
};

std::string name_of_warning(const std::string& sentence) {
  const auto found =
      std::ranges::find_if(names, [&](const Name& one) { return sentence.find(one.part) != std::string::npos; });
  return found == std::end(names) ? "other" : found->name;
}

}  // namespace

std::string names_of_warnings(const std::vector<std::string>& sentences) {
  std::vector<std::string> found;
  for (const std::string& sentence : sentences)
    if (const std::string name = name_of_warning(sentence); std::ranges::find(found, name) == found.end())
      found.push_back(name);
  return found.empty() ? "none" : deck::joined(found, " ");
}

std::string meaning_of_warnings() {
  return "warnings: names of what `ehl run` warns of in sentences, mesh: the film is not resolved; " +
         std::string(hardly_an_error) + ": the estimated error of Hc or Hm is 100 % or more; none";
}

}  // namespace ehl::program
