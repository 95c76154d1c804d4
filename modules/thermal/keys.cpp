#include "thermal/keys.hpp"

#include "deck/record.hpp"
#include "rheology/solids.hpp"
#include "rheology/temperature.hpp"
#include "thermal/column_laws.hpp"

namespace ehl::thermal {
namespace {

deck::Records<Input> body_records(const std::string& number) {
  using namespace deck::record;
  const std::string solid_name = "solid" + number, k = "k" + number, c = "c" + number, rho = "rho" + number;
  const auto together = [](std::vector<std::string> others) {
    return deck::record::together(std::move(others), "k, c and rho of a body belong together");
  };
  deck::Key solid =
      key(solid_name, example("steel"), otherwise("none: " + k + ", " + c + ", " + rho),
          required("name the material of body " + number + ", or give " + k + ", " + c + " and " + rho),
          "Material of body " + number + ", for its thermal constants only; the elastic constants are in [contact].");
  for (const rheology::Solid& one : rheology::solids) {
    solid.words.emplace_back(one.name);
    if (number == "1")
      solid.source.append(solid.source.empty() ? "" : "; ").append(one.name).append(": ").append(one.source);
  }
  return {key("T_body" + number, unit("C"), Range{rheology::coldest_oil, rheology::hottest_oil}, example("40"),
              otherwise("T_oil"), "Temperature of body " + number + " far from the contact.",
              remedy("is it in kelvin or in degrees Fahrenheit?")),
          solid,
          key(k, instead_of({solid_name}), together({c, rho}), unit("W/(m K)"), Range{0.05, 3000.0}, example("46"),
              "Thermal conductivity of body " + number + ", instead of solid" + number + ".",
              remedy("bearing steel has 46 W/(m K), glass 1.1")),
          key(c, instead_of({solid_name}), together({k, rho}), unit("J/(kg K)"), Range{50.0, 5000.0}, example("470"),
              "Its heat capacity.", remedy("bearing steel has 470 J/(kg K)")),
          key(rho, instead_of({solid_name}), together({k, c}), unit("kg/m^3"), Range{500.0, 25000.0}, example("7850"),
              "Its density.", remedy("bearing steel has 7850 kg/m^3"))};
}

BodyInput read_body(const deck::Part& thermal, const std::string& number) {
  const std::string T = "T_body" + number;
  thermal.fill(T, thermal.number("T_oil"), "T_oil");
  const auto own = [&](const char* name) { return thermal.number(name + number); };
  const BodyInput body{thermal.number(T), own("k"), own("c"), own("rho")};
  const rheology::Solid* material = rheology::find_solid(thermal.word("solid" + number));
  return material ? BodyInput{body.T, material->k, material->c, material->rho} : body;
}

deck::Records<Input> method_records() {
  using namespace deck::record;
  return {
      key("nodes", odd(5, most_nodes), integer, by_default("17"), "Number of nodes across the film; it must be odd.",
          remedy("Simpson's rule takes pairs of intervals"), source("modules/thermal/README.md")),
      key("convection", &Input::convection, deck::on_off, own_default,
          "Whether the oil carries heat along with its flow."),
      key("compression", &Input::compression, deck::on_off, own_default,
          "Whether compression heats the oil and expansion cools it."),
      key("solids", &Input::lines, {{"full", false}, {"lines", true}}, own_default,
          "Model of the bodies. full: moving half-spaces, for any speed. lines: the one-dimensional model of Carslaw "
          "and Jaeger for fast bodies; the temperature rise is up to 10 % higher.",
          source("Carslaw and Jaeger 1959")),
      key("fields", &Input::fields, by_default("T_mid, T_max, T1, T2"),
          words({"T_mid", "T_max", "T1", "T2", "section"}),
          "Temperatures above T_oil to store. T_mid: in the middle of the film. T_max: largest value across the film. "
          "T1, T2: on surface 1 and 2. section: T(x, z) and u(x, z) in the plane y = 0.")};
}

deck::Records<Input> records() {
  return deck::together<deck::Record<Input>>({body_records("1"), body_records("2"), method_records()});
}

}  // namespace

std::vector<deck::Key> keys() { return deck::keys_of("thermal", records()); }

Input read(deck::Deck& deck) {
  const deck::Part thermal{deck, "thermal"};
  Input input = deck::read(thermal, records());
  input.body_1 = read_body(thermal, "1");
  input.body_2 = read_body(thermal, "2");
  input.intervals = thermal.integer("nodes", input.intervals + 1) - 1;
  return input;
}

}  // namespace ehl::thermal
