// Tables in the formats of common programs: every format gives the same numbers, or is refused.
#include "deck/text_table.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <string>

#include "core/errors.hpp"
#include "deck/units.hpp"
#include "support/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(test_deck_text_table)

using namespace ehl;

namespace {

const std::vector<deck::Column> of_oil{
    {{"p", "pressure"}, "Pa"}, {{"eta", "viscosity"}, "Pa s"}, {{"rho", "density"}, "kg/m^3", false}};

struct Folder {
  support::TemporaryFolder folder{};
  deck::ReadColumns read(const std::string& text, const std::vector<deck::Column>& columns = of_oil) const {
    folder.write("t.csv", text);
    return deck::read_columns(folder / "t.csv", columns);
  }
  std::string wrong(const std::string& text) const {
    try {
      const deck::ReadColumns found = read(text);
      const auto* what = std::get_if<std::string>(&found);
      return what != nullptr ? *what : "";
    } catch (const core::FileError& error) {
      return error.what();
    }
  }
};

bool contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return true;
  BOOST_TEST_MESSAGE("'" << part << "' is not in: " << text);
  return false;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_way_of_writing_gives_the_same_numbers) {
  const Folder folder;
  const char* const ways[] = {
      "0,0.04,870\n1e8,0.25,912\n4e8,20,985\n",
      "p [Pa],eta [Pa s],rho [kg/m^3]\n0,0.04,870\n1e8,0.25,912\n4e8,20,985\n",
      "p [Pa],eta [mPa s],rho [kg/m3]\n0,40,870\n1e8,250,912\n4e8,20000,985\n",
      "p [Pa],rho [kg/m^3],eta [Pa s]\n0,870,0.04\n1e8,912,0.25\n4e8,985,20\n",
      "p [MPa];eta [mPa s];rho [g/cm3]\n0;40;0,870\n100;250;0,912\n400;20000;0,985\n",
      "\xEF\xBB\xBFp (MPa)\teta (cP)\trho (g/cm\u00b3)\r\n0\t40\t0,870\r\n100\t250\t0,912\r\n400\t2e4\t0,985\r\n",
      "Pressure / GPa, Viscosity / mPa\u00b7s, Density / kg m^-3\r0,40,870\r0.1,250,912\r0.4,2e4,985\r",
      "\"p\",\"eta\",\"rho\"\n\"0\",\"0.04\",\"870\"\n\"1e8\",\"0.25\",\"912\"\n\"4e8\",\"20\",\"985\"\n",
      "p,eta,rho\n[bar],[mPa s],[kg/m^3]\n0,40,870\n1000,250,912\n4000,20000,985\n",
      "# an oil, measured twice\n# p [MPa], eta [mPa s], rho [kg/m^3]\n0,40,870\n100,250,912\n400,20000,985\n",
      "p_MPa,eta_cP,rho,\n0,40,870,\n100,250,912,\n400,20000,985,\n",
      "0 0,04 870\n1e8 0,25 912\n4e8 20,0 985\n"};
  const double right[3][3] = {{0.0, 0.04, 870.0}, {1e8, 0.25, 912.0}, {4e8, 20.0, 985.0}};
  for (const char* text : ways) {
    const deck::ReadColumns read = folder.read(text);
    BOOST_TEST_INFO_SCOPE(text);
    const auto* table = std::get_if<deck::ColumnTable>(&read);
    BOOST_TEST_REQUIRE(table != nullptr, folder.wrong(text));
    BOOST_TEST_REQUIRE(table->rows.size() == 3u);
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t k = 0; k < 3; ++k)
        BOOST_TEST(std::abs(table->rows[row].values[k] - right[row][k]) <= 1e-12 * right[row][k]);
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_read_is_refused_once_with_its_place) {
  const Folder folder;
  BOOST_TEST(contains(folder.wrong("p [Pa],eta [mm2/s]\n0,40\n"),
                      "t.csv:1: the column 'eta [mm2/s]': the unit 'mm2/s' "
                      "must be one of Pa s, mPa s, cP, P"));
  BOOST_TEST(contains(folder.wrong("p,T,eta\n0,40,1\n"), "t.csv:1: the column 'T' is none of p [Pa], eta [Pa s]"));
  BOOST_TEST(contains(folder.wrong("p,rho\n0,870\n"), "the column 'eta' is missing"));
  BOOST_TEST(contains(folder.wrong("p,p,eta\n0,0,1\n"), "'p' is named twice"));
  BOOST_TEST(contains(folder.wrong("p [psia],eta\n0,1\n"), "the unit 'psia' must be one of Pa, kPa, MPa"));
  BOOST_TEST(contains(folder.wrong("p;eta\n0;1,5\n1e8;2.5\n"), "decimal comma"));
  BOOST_TEST(contains(folder.wrong("p,eta\n0,1\n1e8\n"), "t.csv:3: 1 columns instead of 2"));
  BOOST_TEST(contains(folder.wrong("p,eta\n0,\n1e8,2\n"), "t.csv:2: eta is missing"));
  BOOST_TEST(contains(folder.wrong("p,eta\n0,x1\n"), "eta = 'x1' is not a number"));
  BOOST_TEST(contains(folder.wrong("p;eta\n0;1.234,5\n"), "is not a number"));
  BOOST_TEST(contains(folder.wrong("p;eta\n0;1,234\n"),
                      "t.csv:2: '1,234' may be 1.234 or 1234, and no other number of the file decides it"));
  BOOST_TEST(contains(folder.wrong("p;eta\n0;1,234\n1e8;2.5\n"), "decimal comma"));
  BOOST_TEST(contains(folder.wrong("p;eta\n0;1,234\n1e8;1,234,567\n"), "t.csv:3: '1,234,567': write numbers without"));
  BOOST_TEST(contains(folder.wrong("p;eta\n0;1,234.5\n"), "t.csv:2: '1,234.5': write numbers without"));
  BOOST_TEST(contains(folder.wrong(std::string("p,eta\n0,\0001\n", 10)), "NUL"));
  BOOST_TEST(contains(folder.wrong(""), "the table has no row"));
  BOOST_TEST(contains(folder.wrong("p,eta\n"), "the table has no row"));
}

// The other numbers of the file tell that its comma is a decimal one.
BOOST_AUTO_TEST_CASE(a_comma_before_three_digits_is_decided_by_the_rest) {
  const Folder folder;
  for (const char* other : {"0,5", "12,50", "1234,567", "1,5e3", "0,123", "-0,25"}) {
    const deck::ReadColumns read = folder.read(std::string("p;eta\n0;1,234\n1e8;") + other + "\n");
    const auto* table = std::get_if<deck::ColumnTable>(&read);
    BOOST_TEST_REQUIRE(table != nullptr, other);
    BOOST_TEST(table->rows[0].values[1] == 1.234, other);
  }
}

BOOST_AUTO_TEST_CASE(units) {
  const auto factor = [](const char* text, const char* si) {
    const deck::Unit* unit = deck::find_unit(text);
    return unit != nullptr && unit->si == si ? unit->factor : std::nan("");
  };
  BOOST_TEST(factor("MPa", "Pa") == 1e6);
  BOOST_TEST(factor("mPa.s", "Pa s") == 1e-3);
  BOOST_TEST(factor("\u00b5m", "m") == 1e-6);
  BOOST_TEST(factor("mm s^-1", "m/s") == 1e-3);
  BOOST_TEST(factor("N*mm-2", "Pa") == 1e6);
  BOOST_TEST(factor("%", "-") == 1e-2);
  for (const char* none : {"mpa", "", "Pa/s", "x", "mm/h"}) BOOST_TEST((deck::find_unit(none) == nullptr), none);
  const deck::Conversion kelvin = deck::conversion("K", "C"), fahrenheit = deck::conversion("\u00b0F", "C");
  BOOST_TEST(std::abs(kelvin.factor * 313.15 + kelvin.offset - 40.0) < 1e-12);
  BOOST_TEST(std::abs(fahrenheit.factor * 104.0 + fahrenheit.offset - 40.0) < 1e-12);
}

// Damaged files are read, or refused with the name of the file.
BOOST_AUTO_TEST_CASE(damaged_files) {
  const Folder folder;
  const std::string sound = "p [MPa];eta [mPa s];rho [g/cm3]\n0;40;0,870\n100;250;0,912\n200;1200;0,941\n";
  std::mt19937 draw(51);
  int refused = 0;
  for (int n = 0; n < 400; ++n) {
    std::string text = sound;
    for (unsigned k = 0; k <= draw() % 4; ++k) {
      const std::size_t at = draw() % text.size();
      switch (draw() % 5) {
        case 0: text[at] = static_cast<char>(draw() % 256); break;
        case 1: text.erase(at, 1 + draw() % 9); break;
        case 2: text.insert(at, 1, ";,\t\"\r\n#[](%"[draw() % 11]); break;
        case 3: text.resize(at + 1); break;
        default: text.insert(at, text.substr(0, draw() % 20)); break;
      }
    }
    const std::string wrong = folder.wrong(text);
    if (!wrong.empty()) BOOST_TEST(contains(wrong, "t.csv"));
    refused += wrong.empty() ? 0 : 1;
  }
  BOOST_TEST_MESSAGE("of 400 damaged tables " << refused << " are refused, the others read");
  BOOST_TEST(refused > 100);
}

BOOST_AUTO_TEST_SUITE_END()
