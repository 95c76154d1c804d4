// Key records: values reach their members, defaults come from the struct, and rules between keys hold.
#include "deck/record.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace ehl;

namespace {

enum class Shape { round, square };

struct Body {
  double length = 2.5;
  int teeth = 7;
  Shape shape = Shape::square;
  bool open = true;
  std::optional<int> turns{};
  std::string name{};
  std::vector<std::string> fields{};
  double gap = -1.0;  ///< without a default in the deck
};

const deck::Records<Body>& records() {
  using namespace deck::record;
  static const deck::Records<Body> all{
      key("length", &Body::length, positive, own_default, unit("m"), "Length."),
      key("teeth", &Body::teeth, odd(3, 99), own_default, "Teeth.", remedy("7 is usual")),
      key("shape", &Body::shape, {{"round", Shape::round}, {"square", Shape::square}}, own_default, "Shape."),
      key("open", &Body::open, deck::on_off, own_default, "Open."),
      key("turns", &Body::turns, Range{0, 9}, otherwise("chosen"), "Turns."),
      key("name", &Body::name, text, "Name."),
      key("fields", &Body::fields, words({"P", "H"}), by_default("P"), "Fields."),
      key("gap", &Body::gap, positive, "Gap."),
      key("width", positive, in_SI("_m", "m", "1e-3"), required("give it, or width_m"), "Width."),
      key("mass", required("give it, or weight"), positive, "Mass."),
      key("weight", instead_of({"mass"}), positive, "Weight."),
      key("k", together({"c"}, "k and c belong together"), "Conductivity."),
      key("c", together({"k"}, "k and c belong together"), "Capacity.")};
  return all;
}

deck::Deck given(const std::string& lines) {
  deck::Catalogue catalogue;
  catalogue.sections = {{"body", "The body."}};
  catalogue.keys = deck::keys_of("body", records());
  return deck::read_text("[body]\n" + lines, "d.ini", {}, catalogue);
}

// The errors of a deck that is complete but for `lines`.
std::vector<std::string> errors(const std::string& lines) {
  deck::Deck deck = given(lines);
  deck::check_influence(deck);
  deck::read(deck::Part{deck, "body"}, records());
  return deck.errors;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_deck_record)

BOOST_AUTO_TEST_CASE(values_reach_their_members) {
  deck::Deck deck = given(
      "length = 3\nteeth = 9\nshape = round\nopen = off\nturns = 4\nname = a b\nfields = P, H\nwidth = 1\nmass = 1\n");
  const Body body = deck::read(deck::Part{deck, "body"}, records());
  BOOST_TEST(deck.errors.empty());
  BOOST_TEST(body.length == 3.0);
  BOOST_TEST(body.teeth == 9);
  BOOST_TEST((body.shape == Shape::round));
  BOOST_TEST(!body.open);
  BOOST_TEST(body.turns.value() == 4);
  BOOST_TEST(body.name == "a b");
  BOOST_TEST(body.fields.size() == 2U);
}

BOOST_AUTO_TEST_CASE(absent_keys_leave_the_struct_as_it_is) {
  deck::Deck deck = given("width = 1\nmass = 1\n");
  const Body body = deck::read(deck::Part{deck, "body"}, records());
  BOOST_TEST(deck::value(deck, "body", "length").text == "2.5");
  BOOST_TEST(deck::value(deck, "body", "teeth").text == "7");
  BOOST_TEST(deck::value(deck, "body", "shape").text == "square");
  BOOST_TEST(deck::value(deck, "body", "open").text == "on");
  BOOST_TEST(body.length == 2.5);
  BOOST_TEST((body.shape == Shape::square));
  BOOST_TEST(!body.turns.has_value());
  BOOST_TEST(body.gap == -1.0);
  BOOST_TEST(body.fields.size() == 1U);
}

BOOST_AUTO_TEST_CASE(a_refused_number_is_not_a_number) {
  deck::Deck deck = given("length = -3\nwidth = 1\nmass = 1\n");
  BOOST_TEST(std::isnan(deck::read(deck::Part{deck, "body"}, records()).length));
  BOOST_TEST(deck.errors.size() == 1U);
}

BOOST_AUTO_TEST_CASE(rules_between_keys) {
  const auto refused = [](const std::string& lines, const std::vector<std::string>& wanted) {
    const std::vector<std::string> found = errors(lines);
    BOOST_TEST(found == wanted, boost::test_tools::per_element());
  };
  refused("width = 1\nmass = 1\n", {});
  refused("width_m = 1\nweight = 1\nk = 1\nc = 1\n", {});
  refused("width = 1\nmass = 1\nteeth = 8\n",
          {"d.ini:4: [body] teeth = 8: must be an odd number >= 3 and <= 99: 7 is usual"});
  refused("width = 1\n", {"d.ini: [body] mass: is missing: give it, or weight"});
  refused("mass = 1\n", {"d.ini: [body] width: is missing: give it, or width_m"});
  refused("width = 1\nmass = 1\nweight = 1\n", {"d.ini:4: [body] weight = 1: mass is given as well: keep one of them"});
  refused("width = 1\nwidth_m = 1\nmass = 1\n",
          {"d.ini:3: [body] width_m = 1: width is given as well: keep one of them"});
  refused("width = 1\nmass = 1\nk = 1\n", {"d.ini: [body] c: is missing: k and c belong together"});
}

BOOST_AUTO_TEST_SUITE_END()
