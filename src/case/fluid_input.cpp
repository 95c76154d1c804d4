#include "case/fluid_input.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "case/file_beside.hpp"
#include "case/fluid_table.hpp"
#include "deck/text.hpp"
#include "report/text_format.hpp"
#include "rheology/fluids.hpp"
#include "rheology/pressure_coefficient.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;
using Names = std::vector<std::string>;

const std::string section = "lubricant";
const Names constants{"viscosity", "eta0",        "alpha",        "z",           "p0",    "density", "K0",
                      "K0_prime",  "doolittle_B", "doolittle_R0", "temperature", "Tg0",   "A1",      "A2",
                      "b1",        "b2",          "C1",           "C2",          "eta_g", "table"};
const Names bulk_modulus{"K0", "K0_prime"};
const Names doolittle{"eta0", "doolittle_B", "doolittle_R0", "K0", "K0_prime"};
const Names yasutomi{"temperature", "Tg0", "A1", "A2", "b1", "b2", "C1", "C2", "eta_g"};

std::string word(const deck::Deck& deck, const char* name) { return deck::word(deck, section, name); }
double number(const deck::Deck& deck, const char* name) { return deck::number(deck, section, name); }
bool absent(const deck::Deck& deck, const std::string& name) {
  return deck::value(deck, section, name).origin == deck::Origin::absent;
}

// The value of a key follows from others. Repeated as it is, as in the deck that a result keeps, it may stand.
void settle(deck::Deck& deck, const std::string& name, double settled, const std::string& why) {
  if (given(deck, section, name)) {
    const double said = deck::number(deck, section, name);
    constexpr double rounding = 1e-12;
    if (std::isnan(said) || std::abs(said / settled - 1.0) < rounding) return;
    complain(deck, section, name, "is " + deck::shortest(settled) + " already, " + why + ": remove it");
    return;
  }
  deck::choose(deck, section, name, settled, why);
}

void settle_text(deck::Deck& deck, const std::string& name, const std::string& settled, const std::string& why) {
  if (given(deck, section, name)) {
    if (deck::word(deck, section, name) != settled)
      complain(deck, section, name, "is " + settled + " already, " + why + ": remove it");
    return;
  }
  deck::choose(deck, section, name, settled, why);
}

void choose_fluid(deck::Deck& deck) {
  const rheology::Fluid* fluid = rheology::find_fluid(word(deck, "fluid"));
  if (!fluid) return;  // none, or an unknown name that was complained about
  const std::string why = std::string("fluid = ").append(fluid->name);
  Names set;
  for (const rheology::FluidKey& key : fluid->keys) {
    if (key.name.empty()) break;
    const std::string name(key.name), text(key.value);
    const deck::ReadNumber read = deck::read_number(text);
    if (read.status == deck::ReadNumber::Status::number)
      settle(deck, name, read.value, why);
    else
      settle_text(deck, name, text, why);
    set.push_back(name);
  }
  if (word(deck, "viscosity") == "roelands") {
    settle(deck, "z", rheology::roelands_z(number(deck, "alpha"), number(deck, "p0"), number(deck, "eta0")), why);
    set.push_back("z");
  } else {
    set.push_back("alpha");  // settled by the law, like the rest of what follows
  }
  for (const std::string& name : constants)
    if (given(deck, section, name) && std::ranges::find(set, name) == set.end())
      complain(deck, section, name,
               "has no influence: " + why + " brings its laws and constants (" + deck::joined(set, ", ") +
                   "); remove it, or give the oil without fluid");
}

void demand(deck::Deck& deck, const Names& names, const std::string& law) {
  for (const std::string& name : names)
    if (absent(deck, name)) complain(deck, section, name, "is missing: " + law + " needs " + deck::joined(names, ", "));
}

// What the laws need, and what no law uses.
void check_constants(deck::Deck& deck, const std::string& viscosity, const std::string& density) {
  if (viscosity == "doolittle") demand(deck, doolittle, "viscosity = doolittle");
  if (viscosity == "yasutomi") demand(deck, yasutomi, "viscosity = yasutomi");
  const bool tait = density == "tait" || density == "murnaghan";
  if (tait) demand(deck, bulk_modulus, "density = " + density);
  const bool tabulated = viscosity == "table" || density == "table";
  if (tabulated) demand(deck, {"table"}, viscosity == "table" ? "viscosity = table" : "density = table");
  const std::string laws = "has no influence with viscosity = " + viscosity + " and density = " + density;
  for (const std::string& name : bulk_modulus)
    if (!tait && viscosity != "doolittle" && given(deck, section, name))
      complain(deck, section, name, laws + ": remove it, or set density = tait or murnaghan");
  if (!tabulated && given(deck, section, "table"))
    complain(deck, section, "table", laws + ": remove it, or set viscosity = table or density = table");
  if (viscosity == "yasutomi" && number(deck, "temperature") <= number(deck, "Tg0"))
    complain(deck, section, "temperature",
             "must be above the glass transition at ambient pressure, Tg0 = " + deck::shortest(number(deck, "Tg0")) +
                 " C: below it the oil is no liquid");
}

void add_table(deck::Deck& deck, bool viscosity, bool density, Liquid& liquid) {
  const ReadTable read = read_fluid_table(found_beside(deck, section, "table"), density);
  if (const auto* wrong = std::get_if<std::string>(&read)) {
    complain(deck, section, "table", *wrong);
    return;
  }
  const FluidTable& table = std::get<FluidTable>(read);
  liquid.table_end = table.p.back();
  if (density) liquid.density = rheology::make_tabulated_density(table.p, table.rho, 1.0);
  if (!viscosity) return;
  liquid.viscosity = rheology::make_tabulated_viscosity(table.p, table.eta, 1.0);
  settle(deck, "eta0", table.eta.front(), "the first row of the table");
}

rheology::YasutomiConstants yasutomi_constants(const deck::Deck& deck) {
  return {.T = number(deck, "temperature"),
          .Tg0 = number(deck, "Tg0"),
          .A1 = number(deck, "A1"),
          .A2 = number(deck, "A2"),
          .b1 = number(deck, "b1"),
          .b2 = number(deck, "b2"),
          .C1 = number(deck, "C1"),
          .C2 = number(deck, "C2"),
          .eta_g = number(deck, "eta_g")};
}

}  // namespace

bool brings_eta0(const deck::Deck& deck) {
  const std::string law = word(deck, "viscosity");
  return law == "yasutomi" || law == "table";
}

bool brings_alpha(const deck::Deck& deck) { return brings_eta0(deck) || word(deck, "viscosity") == "doolittle"; }

Liquid liquid_input(deck::Deck& deck) {
  Liquid liquid;
  choose_fluid(deck);
  const std::string viscosity = word(deck, "viscosity"), density = word(deck, "density");
  check_constants(deck, viscosity, density);
  if (!deck.errors.empty()) return liquid;

  constexpr double pascal = 1.0;
  const double K0 = number(deck, "K0"), K0_prime = number(deck, "K0_prime");
  if (density == "tait") liquid.density = rheology::make_tait(K0, K0_prime, pascal);
  if (density == "murnaghan") liquid.density = rheology::make_murnaghan(K0, K0_prime, pascal);
  if (viscosity == "doolittle")
    liquid.viscosity = rheology::make_doolittle(
        {number(deck, "doolittle_B"), number(deck, "doolittle_R0"), K0, K0_prime, number(deck, "eta0")}, pascal);
  if (viscosity == "yasutomi") {
    liquid.viscosity = rheology::make_yasutomi(yasutomi_constants(deck), pascal);
    settle(deck, "eta0", rheology::yasutomi_eta0(yasutomi_constants(deck)), "the law at ambient pressure");
  }
  if (viscosity == "table" || density == "table") add_table(deck, viscosity == "table", density == "table", liquid);
  if (liquid.viscosity && deck.errors.empty())
    settle(deck, "alpha", rheology::pressure_coefficients(*liquid.viscosity).alpha_star,
           "alpha* of the law, 1/int eta0/eta dp");
  return liquid;
}

double roelands_z(deck::Deck& deck, double alpha, double p0) {
  if (given(deck, section, "z")) return deck::number(deck, section, "z");
  const double eta0 = deck::number(deck, section, "eta0");
  if (std::isnan(eta0)) {
    deck::choose(deck, section, "z", 0.68, "a mineral oil; eta0 would tell it");
    return 0.68;
  }
  // alpha p0/z = ln eta0 + 9.67 (Roelands): all oils meet at one point of the (p, ln eta) plane.
  const double z = alpha * p0 / (std::log(eta0) + 9.67);
  const deck::Key& key = *deck::find_key(deck.catalogue, section, "z");
  if (!key.range.contains(z))
    complain(deck, section, "eta0",
             "with alpha and p0 it means z = alpha p0/(ln eta0 + 9.67) = " + formatted("%.4g", z) + ", which must be " +
                 deck::allowed(key) + ": give z, or check eta0 [Pa s] and alpha [1/Pa]");
  deck::choose(deck, section, "z", z, "from eta0");
  return z;
}

void check_reach(deck::Deck& deck, const Liquid& liquid, double p_h) {
  if (!(p_h > liquid.table_end)) return;
  complain(deck, section, "table",
           "ends at " + formatted("%.4g", liquid.table_end) + " Pa, below the Hertz pressure of this contact, " +
               formatted("%.4g", p_h) + " Pa: a table must cover the pressures");
}

}  // namespace ehl::program
