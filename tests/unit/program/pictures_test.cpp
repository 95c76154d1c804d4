// The data of pictures: fields between their nodes, and the rows of a sweep as curves.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <sstream>

#include "commands/commands.hpp"
#include "commands/curves.hpp"
#include "core/errors.hpp"
#include "report/field_on_grid.hpp"
#include "support/temporary_folder.hpp"
#include "support/text.hpp"
#include "tables/sweep_table.hpp"

using namespace ehl;
using program::FieldOnGrid;
using support::contains;

namespace {

using Function = std::function<double(double, double)>;

// A field on lines with increasing distances.
FieldOnGrid field_of(int nodes, const Function& function) {
  FieldOnGrid field;
  for (int i = 0; i < nodes; ++i) {
    const double t = static_cast<double>(i) / (nodes - 1);
    field.x.values.push_back(-1.0 + 2.0 * t + 0.2 * t * (1.0 - t));
    field.y.values.push_back(t + 0.1 * t * t);
  }
  for (const double y : field.y.values)
    for (const double x : field.x.values) field.field.values.push_back(function(x, y));
  field.field.dims = {field.y.values.size(), field.x.values.size()};
  return field;
}

double worst(int nodes, const Function& function) {
  std::vector<double> xs, ys;
  for (int k = 0; k <= 50; ++k) {
    xs.push_back(-1.0 + 2.0 * k / 50);
    ys.push_back(1.1 * k / 50);
  }
  const FieldOnGrid fine = program::on_lines(field_of(nodes, function), xs, ys);
  double largest = 0.0;
  for (std::size_t j = 0; j < ys.size(); ++j)
    for (std::size_t i = 0; i < xs.size(); ++i)
      largest = std::max(largest, std::abs(fine.at(i, j) - function(xs[i], ys[j])));
  return largest;
}

program::Arguments plotted(const std::vector<std::string>& words) {
  std::vector<std::string> all{"plot", "t.csv"};
  all.insert(all.end(), words.begin(), words.end());
  return program::parse_arguments(all, program::commands());
}

// The rows are unordered, and one has no solution.
const std::string table = std::string(program::sweep_mark) +
                          "\n# vary: motion.u_m = 0.1,0.2,0.4\n# units: h_c_nm [nm], h_m_nm [nm]\n"
                          "motion.u_m,contact.load,status,h_c_nm,h_c_error_nm,h_m_nm,hd_h_c_nm,Sq_nm,reason\n"
                          "0.2,20,converged,20,0.5,11,21,10,\"\"\n0.1,20,converged,10,0.25,5,12,10,\"\"\n"
                          "0.4,20,not-converged,NaN,NaN,NaN,39,10,\"no, it\"\n"
                          "0.1,50,converged,8,0.125,4,9,10.000000000000002,\"\"\n";

program::SweepData read(const std::string& text) {
  const support::TemporaryFolder folder;
  return program::read_sweep(folder.write("t.csv", text));
}

std::string setting(const program::Curves& curves, const std::string& name) {
  for (const program::Setting& one : curves.settings)
    if (one.name == name) return one.value;
  return "(none)";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_pictures)

BOOST_AUTO_TEST_CASE(cubics_are_exact_between_the_nodes) {
  const double error =
      worst(9, [](double x, double y) { return 20 + x * x * x - 2 * x * y * y + 3 * y * y * y - x * y; });
  BOOST_TEST_MESSAGE("cubic: largest error " << error << " (1e-12: rounding of sums of about 20)");
  BOOST_TEST(error < 1e-12);
}

BOOST_AUTO_TEST_CASE(the_order_is_four) {
  const auto smooth = [](double x, double y) { return std::exp(1.5 * x + y); };
  const double errors[] = {worst(33, smooth), worst(65, smooth), worst(129, smooth)};
  for (int k = 0; k < 2; ++k) {
    const double order = std::log2(errors[k] / errors[k + 1]);
    BOOST_TEST_MESSAGE("errors " << errors[k] << ", " << errors[k + 1] << ": order " << order << " (4 within 0.5)");
    BOOST_TEST(std::abs(order - 4.0) < 0.5);
  }
}

BOOST_AUTO_TEST_CASE(nothing_falls_below_the_least_node) {
  const FieldOnGrid step = field_of(9, [](double x, double) { return x > 0 ? 1.0 : 0.0; });
  const FieldOnGrid fine = program::on_lines(step, {-0.3, -0.2, -0.1, 0.0, 0.1}, {0.5});
  for (const double value : fine.field.values) BOOST_TEST(value >= 0.0);
}

BOOST_AUTO_TEST_CASE(a_sweep_becomes_curves_in_order_with_bars_and_formulas) {
  const program::SweepData data = read(table);
  BOOST_TEST((data.varied == std::vector<std::string>{"motion.u_m", "contact.load"}));
  BOOST_TEST(program::makes_curves(data));
  const program::CurvesWanted wanted = program::chosen_curves(data, plotted({}));
  BOOST_TEST(wanted.x == "motion.u_m");
  BOOST_TEST((wanted.y == std::vector<std::string>{"h_c_nm", "h_m_nm"}));
  BOOST_TEST((wanted.by == std::vector<std::string>{"contact.load"}));
  const program::Curves curves = program::curves_of(data, wanted);
  BOOST_TEST(curves.data ==
             "0.1 10 0.25 12 nan nan\n0.2 20 0.5 21 nan nan\n\n\n0.1 8 0.125 9 nan nan\n\n\n"
             "0.1 5 0 nan nan nan\n0.2 11 0 nan nan nan\n\n\n0.1 4 0 nan nan nan\n\n\n");
  BOOST_TEST(setting(curves, "curve_2") == "F = 50 N");
  BOOST_TEST(setting(curves, "x_words") == "entrainment speed u_m [m/s]");
  BOOST_TEST(setting(curves, "formula_1") == "Hamrock, Dowson 1977");
  BOOST_TEST(setting(curves, "formula_2") == "");
  BOOST_TEST(setting(curves, "roughness") == "10");
  BOOST_TEST(setting(curves, "lost") == "1");
}

BOOST_AUTO_TEST_CASE(wrong_axes_are_refused) {
  const program::SweepData data = read(table);
  const auto refused = [&](const std::vector<std::string>& words) {
    return support::refusal<core::InputError>([&] { program::chosen_curves(data, plotted(words)); });
  };
  BOOST_TEST(refused({"--y", "h_c_n"}) != "(none)");
  BOOST_TEST(refused({"--x", "status"}) != "(none)");
  BOOST_TEST(refused({"--by", "load"}) != "(none)");
  BOOST_TEST(refused({"--axes", "square"}) != "(none)");
  std::string many = table;
  for (int k = 0; k < 20; ++k) many += "0.1," + std::to_string(60 + k) + ",converged,1,0,1,1,10,\"\"\n";
  BOOST_TEST(contains(support::refusal<core::InputError>([&] {
                        program::chosen_curves(read(many), plotted({"--x", "motion.u_m"}));
                      }),
                      "22 curves"));
}

BOOST_AUTO_TEST_SUITE_END()
