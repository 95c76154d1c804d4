// Reports on an artificial solution, of which every number is known.
#include "report/report.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "base/json.hpp"
#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "case/numbers/number.hpp"
#include "report/outcome.hpp"
#include "report/result_content.hpp"
#include "support/json.hpp"
#include "support/text.hpp"

using namespace ehl;

namespace {

const double unknown = std::nan("");

using support::contains;

// M = 2/3, so that H in Moes' units is H itself: (3M/2)^(2/3) = 1.
program::Case example_case() {
  program::Case input;
  input.title = "quote \" backslash \\ tab \t bad byte \xff";
  input.physics.groups = contact::from_moes(2.0 / 3.0, 5.0);
  input.fields = {"P", "H", "ln_eta_bar"};
  input.scene.viscosity = rheology::Barus{3.0};
  input.scene.density = rheology::Incompressible{};
  return input;
}

steady::Solution example_solution(bool converged) {
  steady::Solution solution;
  solution.grid = {4, 2, -2.0, 2.0, -1.0, 1.0};
  solution.P = core::Field(solution.grid);
  solution.H = core::Field(solution.grid);
  solution.P(2, 1) = 0.5;
  solution.H.fill(0.9);
  solution.H(3, 0) = 0.25;
  solution.converged = converged;
  solution.failed_check = converged ? "" : "level 2: residual 0.3";
  solution.levels.resize(2);
  solution.levels[0] = {.level = 1,
                        .nx = 2,
                        .ny = 1,
                        .Hc = 0.5,
                        .Hm = 0.3,
                        .mesh_error_Hc = unknown,
                        .mesh_error_Hm = unknown,
                        .order_Hc = unknown,
                        .residual = 1e-3,
                        .load_error = 1e-5,
                        .cycles = 2,
                        .work_units = 10.0,
                        .seconds = 0.5};
  solution.levels[1] = {.level = 2,
                        .nx = 4,
                        .ny = 2,
                        .Hc = 0.4,
                        .Hm = 0.25,
                        .mesh_error_Hc = 0.058,
                        .mesh_error_Hm = 0.062,
                        .order_Hc = 2.0,
                        .residual = 3e-4,
                        .load_error = 2e-6,
                        .cycles = 2,
                        .work_units = 11.2,
                        .seconds = 0.011};
  solution.verification.residual = 3e-4;
  solution.verification.largest_residual = 0.0123;
  solution.verification.largest_residual_X = 0.75;
  solution.verification.largest_residual_Y = -0.25;
  solution.verification.dry_violation = 4.5e-3;
  solution.verification.flow_imbalance = -6.7e-4;
  solution.verification.algebraic_error_Hm = 8.9e-5;
  return solution;
}

program::Computed computed_of(const program::Case& input, const steady::Solution& solution) {
  return {.solution = solution,
          .outcome = program::outcome_of(input, solution),
          .derived = program::derived_fields(input, solution)};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_report)

BOOST_AUTO_TEST_CASE(outcome_finds_values_and_places) {
  const program::Case input = example_case();
  const program::Outcome outcome = program::outcome_of(input, example_solution(true));
  BOOST_TEST(outcome.Hc == 0.4);
  BOOST_TEST(outcome.Hm.value == 0.25);
  BOOST_TEST(outcome.Hm.X == 1.0);
  BOOST_TEST(outcome.Hm.Y == -1.0);
  BOOST_TEST(outcome.P_max.value == 0.5);
  BOOST_TEST(outcome.P_max.X == 0.0);
  BOOST_TEST(outcome.Hc_moes == 0.4, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(std::isnan(outcome.hc));
}

BOOST_AUTO_TEST_CASE(table_has_a_row_per_level_and_no_nan) {
  const std::string table = program::level_table(example_case(), example_solution(true));
  for (const char* part : {"mesh_error_Hc", "work_units", "5 x 3", "5.80 %", "6.20 %", "3e-04", "11.2", "0.011"})
    BOOST_TEST(contains(table, part), part << " is missing in\n" << table);
  BOOST_TEST(!contains(table, "nan"));
}

BOOST_AUTO_TEST_CASE(a_number_that_did_not_converge_carries_the_mark) {
  const program::Case input = example_case();
  const auto text = [&](bool converged) {
    return program::summary(input, computed_of(input, example_solution(converged)));
  };
  BOOST_TEST(contains(text(false), "level 2: residual 0.3"));
  BOOST_TEST(contains(text(false), "(NOT CONVERGED)\n"));
  BOOST_TEST(!contains(text(true), "NOT CONVERGED"));
  BOOST_TEST(!contains(text(true), "nan"));
}

// The value with the narrowest error bar comes first, then that of the nodes; without adjoint
// errors the latter is alone.
BOOST_AUTO_TEST_CASE(the_closest_value_is_first) {
  const program::Case input = example_case();
  steady::Solution solution = example_solution(true);
  steady::ErrorBars& bars = solution.error_bars;
  bars.Hc = {0.02, 0.01};
  bars.Hc_best = {0.41, 0.004};
  bars.Hm = {0.05, 0.01};
  bars.Hm_best = {0.24, 0.008};
  bars.Hm_fitted_X = 0.9;
  bars.Hm_fitted_Y = -0.8;
  const std::string text = program::summary(input, computed_of(input, solution));
  std::size_t at = 0;
  for (const char* part : {"H_c = 0.41000 +- 0.40 %", "0.4100, at (0.000, 0.000) a\n", "H_c = 0.40000 +- 3.00 %\n",
                           "H_m = 0.24000 +- 0.80 %", "0.2400, at (0.900, -0.800) a\n", "H_m = 0.25000 +- 6.00 %\n"}) {
    BOOST_TEST(text.find(part, at) != std::string::npos, part << " is not in its place in\n" << text);
    at = text.find(part, at);
  }
  const std::string json = program::json_report(input, computed_of(input, solution));
  for (const char* part : {"\"Hc\":0.4,", "\"Hc_best\":0.41,", "\"error_Hc_best\":0.004,", "\"Hm_best\":0.24,"})
    BOOST_TEST(contains(json, part), part << " is missing in\n" << json);
}

BOOST_AUTO_TEST_CASE(json_has_what_was_promised) {
  const program::Case input = example_case();
  const std::string text = program::json_report(input, computed_of(input, example_solution(false)));
  BOOST_TEST(support::is_json(text), text);
  for (const char* name : {"converged",
                           "Hc",
                           "Hm",
                           "Hc_moes",
                           "Hm_moes",
                           "hc_m",
                           "hm_m",
                           "P_max",
                           "H00",
                           "residual",
                           "load_error",
                           "M",
                           "L",
                           "alpha_bar",
                           "lambda",
                           "wedge",
                           "deformation",
                           "seconds",
                           "threads",
                           "peak_memory_bytes",
                           "levels",
                           "level",
                           "nx",
                           "ny",
                           "error_Hc",
                           "error_Hm",
                           "cycles",
                           "work_units",
                           "continuation",
                           "effects",
                           "warnings",
                           "warning_names",
                           "verification",
                           "largest_residual",
                           "least_P",
                           "dry_violation",
                           "change_Hc",
                           "algebraic_error_Hm",
                           "flow_through",
                           "flow_imbalance"})
    BOOST_TEST(contains(text, std::string("\"") + name + "\":"), name);
  BOOST_TEST(contains(text, "\"converged\":false"));
  BOOST_TEST(contains(text, "\"hc_m\":null"));
  BOOST_TEST(support::is_json(program::json_failure(input, "why \"not\"")));
}

BOOST_AUTO_TEST_CASE(verification_is_shown_with_its_numbers) {
  const program::Case input = example_case();
  const program::Computed computed = computed_of(input, example_solution(true));
  const std::string text = program::summary(input, computed);
  for (const char* part : {"3.0e-04", "1.2e-02", "(0.750, -0.250) a", "6.7e-04", "4.5e-03", "8.9e-05"})
    BOOST_TEST(contains(text, part), part << " is missing in\n" << text);
  BOOST_TEST(contains(program::json_report(input, computed), "\"flow_imbalance\":-0.00067"));
  const results::Content content = program::result_content(input, computed);
  const auto value = [&](const std::string& name) {
    for (const results::Quantity& quantity : content.summary)
      if (quantity.name == name) return results::number(quantity.value);
    return unknown;
  };
  BOOST_TEST(value("flow_imbalance") == -6.7e-4);
  BOOST_TEST(value("largest_residual_x") == 0.75);
}

// The flow through a line contact is per length.
BOOST_AUTO_TEST_CASE(flow_through_has_the_unit_of_the_contact) {
  const auto unit = [](const contact::Ellipse& shape) {
    program::Case input = example_case();
    input.scene.contact = steady::scales_of(input.scene.contact.M, input.scene.contact.L, shape);
    input.scene.grid.line = contact::line(shape);
    const program::Computed computed = computed_of(input, example_solution(true));
    return program::numbers::quantity("flow_through", {input, computed}).unit;
  };
  BOOST_TEST(unit(contact::ellipse(1.0)) == "rho0 u_m a^3/R");
  BOOST_TEST(unit(contact::ellipse(0.2)) == "rho0 u_m a^3/R");
  BOOST_TEST(unit(contact::line_contact()) == "rho0 u_m a^2/R");
}

// P_max is 0.5: 2 GPa for a Hertz pressure of 4 GPa.
BOOST_AUTO_TEST_CASE(warnings_that_need_the_scale_of_pressure) {
  program::Case input = example_case();
  input.physics.viscosity = rheology::make_barus(2e-8, 0.9e9);
  input.physics.density = rheology::Incompressible{};
  const auto warnings = [&](double p_h) {
    input.physics.p_h = p_h;
    return program::outcome_of(input, example_solution(true)).warnings;
  };
  BOOST_TEST(warnings(0.9e9).empty());
  BOOST_TEST(warnings(1.1e9).size() == 1u);
  BOOST_TEST(contains(warnings(1.1e9).front().text, "p_max = 0.55 GPa"));
  BOOST_TEST(warnings(4e9).size() == 2u);
  BOOST_TEST(warnings(4e9).back().name == "yield");
}

BOOST_AUTO_TEST_CASE(json_texts) {
  BOOST_TEST(program::line_of("a\"b\\c\n") == "\"a\\\"b\\\\c\\n\"\n");
  BOOST_TEST(program::line_of("\xCE\xB1") == "\"\xCE\xB1\"\n");
  for (const char* bad : {"\xff", "\xc0\x80", "\xce", "\xed\xa0\x80", "\xf4\x90\x80\x80"})
    BOOST_TEST(contains(program::line_of(bad), "\xEF\xBF\xBD"));
  BOOST_TEST(program::line_of(unknown) == "null\n");
  BOOST_TEST(program::line_of(-INFINITY) == "null\n");
  BOOST_TEST(program::line_of(0.1) == "0.1\n");
  BOOST_TEST(support::is_json(program::line_of("\x01\x1f\x7f\"\\")));
  BOOST_TEST(!support::is_json("{\"a\": nan}"));
  BOOST_TEST(!support::is_json("[1,]"));
}

// ln eta_bar = alpha_bar P for Barus: 3 x 0.5 at the node with pressure.
BOOST_AUTO_TEST_CASE(result_content_keeps_what_the_deck_wants) {
  const program::Case input = example_case();
  const program::Computed computed = computed_of(input, example_solution(true));
  BOOST_TEST(computed.derived.ln_eta_bar(2, 1) == 1.5, boost::test_tools::tolerance(1e-14));
  const results::Content content = program::result_content(input, computed);
  BOOST_TEST(content.fields.size() == 3u);
  BOOST_TEST(content.tables.size() == 2u);
  BOOST_TEST(content.tables[0].columns[3].values[1] == 0.4);
}

BOOST_AUTO_TEST_CASE(numbers_for_people) {
  BOOST_TEST(program::length(212.44e-9) == "212.4 nm");
  BOOST_TEST(program::length(136.5e-6) == "136.5 um");
  BOOST_TEST(program::pressure(0.385e9) == "385 MPa");
  BOOST_TEST(program::percent(0.058) == "5.80 %");
  BOOST_TEST(program::percent(unknown) == "-");
  BOOST_TEST(program::about_seconds(18.2) == "20 s");
  BOOST_TEST(program::about_seconds(0.0449) == "0.04 s");
  BOOST_TEST(program::about_seconds(9.7) == "10 s");
  BOOST_TEST(program::about_seconds(0.0) == "0 s");
}

BOOST_AUTO_TEST_SUITE_END()
