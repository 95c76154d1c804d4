#include "thermal/keys.hpp"

#include "rheology/solids.hpp"
#include "rheology/temperature.hpp"
#include "thermal/column_laws.hpp"

namespace ehl::thermal {
namespace {

using deck::Key;

std::vector<Key> body_keys(const std::string& number) {
  Key solid{.name = "solid" + number,
            .default_note = "none: k" + number + ", c" + number + ", rho" + number,
            .meaning = "Material of body " + number +
                       ", for its thermal constants only; the elastic constants are in [contact].",
            .example = "steel"};
  for (const rheology::Solid& one : rheology::solids) {
    solid.words.emplace_back(one.name);
    if (number == "1")
      solid.source.append(solid.source.empty() ? "" : "; ").append(one.name).append(": ").append(one.source);
  }
  return {{.name = "T_body" + number,
           .default_note = "T_oil",
           .unit = "C",
           .range = {rheology::coldest_oil, rheology::hottest_oil},
           .remedy = "is it in kelvin or in degrees Fahrenheit?",
           .meaning = "Temperature of body " + number + " far from the contact.",
           .example = "40"},
          solid,
          {.name = "k" + number,
           .unit = "W/(m K)",
           .range = {0.05, 3000.0},
           .remedy = "bearing steel has 46 W/(m K), glass 1.1",
           .meaning = "Thermal conductivity of body " + number + ", instead of solid" + number + ".",
           .example = "46"},
          {.name = "c" + number,
           .unit = "J/(kg K)",
           .range = {50.0, 5000.0},
           .remedy = "bearing steel has 470 J/(kg K)",
           .meaning = "Its heat capacity.",
           .example = "470"},
          {.name = "rho" + number,
           .unit = "kg/m^3",
           .range = {500.0, 25000.0},
           .remedy = "bearing steel has 7850 kg/m^3",
           .meaning = "Its density.",
           .example = "7850"}};
}

BodyInput read_body(const deck::Part& thermal, const std::string& number) {
  const std::string own[] = {"k" + number, "c" + number, "rho" + number};
  const std::string solid = "solid" + number, T = "T_body" + number;
  thermal.fill(T, thermal.number("T_oil"), "T_oil");
  BodyInput body{thermal.number(T), thermal.number(own[0]), thermal.number(own[1]), thermal.number(own[2])};
  const std::vector<std::string> names(std::begin(own), std::end(own));
  if (!thermal.given(solid)) {
    const std::vector<std::string> given = thermal.given_of(names);
    if (given.empty())
      thermal.complain(
          solid,
          "is missing: name the material of body " + number + ", or give " + own[0] + ", " + own[1] + " and " + own[2],
          deck::Cause::missing);
    else if (given.size() < names.size())
      thermal.demand(names, "k, c and rho of a body belong together");
    return body;
  }
  thermal.refuse(names, solid + " is given as well: keep one of them");
  if (const rheology::Solid* material = rheology::find_solid(thermal.word(solid)))
    body = {body.T, material->k, material->c, material->rho};
  return body;
}

}  // namespace

std::vector<Key> keys() {
  std::vector<Key> of_1 = body_keys("1"), of_2 = body_keys("2");
  const std::vector<std::string> on_off{"on", "off"};
  const std::vector<Key> rest{
      {.name = "nodes",
       .type = deck::Type::integer,
       .default_text = "17",
       .range = {5, most_nodes},
       .meaning = "Number of nodes across the film; it must be odd.",
       .source = "modules/thermal/README.md"},
      {.name = "convection",
       .default_text = "on",
       .words = on_off,
       .meaning = "Whether the oil carries heat along with its flow."},
      {.name = "compression",
       .default_text = "on",
       .words = on_off,
       .meaning = "Whether compression heats the oil and expansion cools it."},
      {.name = "solids",
       .default_text = "full",
       .words = {"full", "lines"},
       .meaning = "Model of the bodies. full: moving half-spaces, for any speed. lines: the one-dimensional model of "
                  "Carslaw and Jaeger for fast bodies; the temperature rise is up to 10 % higher.",
       .source = "Carslaw and Jaeger 1959"},
      {.name = "fields",
       .type = deck::Type::words,
       .default_text = "T_mid, T_max, T1, T2",
       .words = {"T_mid", "T_max", "T1", "T2", "section"},
       .meaning = "Temperatures above T_oil to store. T_mid: in the middle of the film. T_max: largest value across "
                  "the film. T1, T2: on surface 1 and 2. section: T(x, z) and u(x, z) in the plane y = 0."}};
  return deck::in_section("thermal", deck::together({of_1, of_2, rest}));
}

Input read(deck::Deck& deck) {
  const deck::Part thermal{deck, "thermal"};
  Input input;
  input.body_1 = read_body(thermal, "1");
  input.body_2 = read_body(thermal, "2");
  const int nodes = thermal.integer("nodes", input.intervals + 1);
  if (nodes % 2 == 0) thermal.complain("nodes", "must be odd: Simpson's rule takes pairs of intervals");
  input.intervals = nodes - 1;
  input.convection = thermal.word("convection") == "on";
  input.compression = thermal.word("compression") == "on";
  input.lines = thermal.word("solids") == "lines";
  input.fields = thermal.words("fields");
  return input;
}

}  // namespace ehl::thermal
