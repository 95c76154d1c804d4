// The figures of gnuplot within a page: names that no other figure has, and nothing that runs or refers elsewhere.
#include <boost/test/unit_test.hpp>
#include <regex>
#include <set>

#include "core/errors.hpp"
#include "page/svg.hpp"

using namespace ehl;
using program::DrawnFigure;

namespace {

const std::string head =
    "<?xml version=\"1.0\"?>\n<svg \n width=\"340\" height=\"227\"\n xmlns=\"http://www.w3.org/2000/svg\">\n"
    "<title>Gnuplot</title>\n<desc>Produced by GNUPLOT </desc>\n";
const std::string shapes =
    "<defs><circle id='gpDot' r='0.5'/><filter id=\"box\" x=\"0\"><feFlood result=\"bg\"/></filter></defs>\n"
    "<g fill=\"none\">\n</g>\n<g id=\"plot_1\" ><title>curve</title><path d='M0,0\n L1,1'/></g>\n"
    "<use xlink:href='#gpDot'/><text filter=\"url(#box)\">a &lt; b<tspan dy=\"2\">c</tspan></text>\n"
    "<image xlink:href='data:image/png;base64,AAAA'/>\n</svg>\n";

std::string on_page(const std::string& body, const std::string& mark = "f1_") {
  return program::embedded(head + body, {"curves", "film & speed", mark, {}});
}

std::set<std::string> all_of(const std::string& text, const std::string& pattern) {
  const std::regex wanted(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator one(text.begin(), text.end(), wanted), end; one != end; ++one) found.insert((*one)[1]);
  return found;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_page_svg)

BOOST_AUTO_TEST_CASE(names_belong_to_one_figure_and_references_stay_inside) {
  const std::string first = on_page(shapes), second = on_page(shapes, "f2_");
  const std::set<std::string> names = all_of(first, " id=\"([^\"]*)\"");
  BOOST_TEST_MESSAGE("names: " << names.size() << " (3)");
  BOOST_TEST(names == (std::set<std::string>{"f1_gpDot", "f1_box", "f1_plot_1"}), boost::test_tools::per_element());
  for (const std::string& name : all_of(second, " id=\"([^\"]*)\"")) BOOST_TEST(!names.contains(name), name);
  for (const std::string& name : all_of(first, "(?:href=\"#|url\\(#)([^\")]*)")) BOOST_TEST(names.contains(name), name);
  BOOST_TEST(first.find("http") == std::string::npos);
  BOOST_TEST(first.find("Gnuplot") == std::string::npos);
  BOOST_TEST(first.find("film &amp; speed") != std::string::npos);
  BOOST_TEST(first.find("a &lt; b<tspan dy=\"2\">c</tspan></text>") != std::string::npos);
  BOOST_TEST(first.find("d=\"M0,0  L1,1\"") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_runs_or_refers_elsewhere_is_refused) {
  for (const char* bad :
       {"<script>alert(1)</script></svg>", "<g onload=\"alert(1)\"></g></svg>", "<g OnLoad='alert(1)'/></svg>",
        "<image XLINK:HREF='http://a.b/c.png'/></svg>", "<foreignObject/></svg>",
        "<image href='http://a.b/c.png'/></svg>", "<use xlink:href='file:///etc/passwd#a'/></svg>",
        "<image href=\"data:text/html;base64,AA\"/></svg>", "<rect fill='url(http://a.b)'/></svg>", "<!-- --></svg>",
        "<a href='#x'>y</a></svg>", "<rect x=1/></svg>", "<rect x='1"})
    BOOST_CHECK_THROW(on_page(bad), core::FileError);
}

// An empty group stands only in the first of several pictures; without it, the lines of all pictures correspond.
BOOST_AUTO_TEST_CASE(several_pictures_have_the_same_lines) {
  const std::string other = shapes.substr(0, shapes.find("<g fill")) + shapes.substr(shapes.find("<g id"));
  const std::vector<std::string> documents = program::documents_of(head + shapes + "\n" + head + other + "\n");
  BOOST_REQUIRE(documents.size() == 2U);
  const DrawnFigure figure{"frames", "frames", "f1_", {}};
  BOOST_TEST(program::embedded(documents[0], figure) == program::embedded(documents[1], figure));
}

BOOST_AUTO_TEST_SUITE_END()
