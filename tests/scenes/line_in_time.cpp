// Line contacts in time through the program, compared with steady line contacts.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "support/columns.hpp"
#include "support/program.hpp"

using namespace support;

namespace {

enum Column { T, Hc, Hm, Hm_x, Hm_y, P_max, H00, load, speed, load_error };

std::string contact(double M, double inlet, double outlet) {
  return "[contact]\nkind = line\nM = " + std::to_string(M) +
         "\nL = 5\n[lubricant]\nviscosity = roelands\nalpha = 2.2e-8\nz = 0.68\ndensity = dowson-higginson\n[domain]\n"
         "far_field = zero\nx_inlet = " +
         std::to_string(inlet) + "\nx_outlet = " + std::to_string(outlet) + "\n[grid]\ncells = 512\n";
}

nlohmann::json steady(const TemporaryFolder& folder, const std::string& deck) {
  folder.write("steady.ini", deck + "[multigrid]\ntolerance = 1e-9\n");
  const Ended run = ehl(folder, "run steady.ini --json --quiet --overwrite");
  BOOST_TEST_REQUIRE(run.status == 0, run.err);
  return nlohmann::json::parse(run.out);
}

struct InTime {
  nlohmann::json json;
  std::vector<std::vector<double>> rows;
};

InTime in_time(const TemporaryFolder& folder, const std::string& deck, const std::string& transient) {
  folder.write("time.ini", deck + "[transient]\n" + transient);
  const Ended run = ehl(folder, "run time.ini --json --quiet --overwrite");
  BOOST_TEST_REQUIRE(run.status == 0, run.err);
  return {nlohmann::json::parse(run.out), rows_of(ehl(folder, "extract time.h5 /transient").out)};
}

void check_same(const std::vector<double>& row, const nlohmann::json& film, double factor, double allowed) {
  for (const auto& [column, name] : {std::pair{Hc, "Hc"}, std::pair{Hm, "Hm"}}) {
    const double error = factor * row[column] / film[name].get<double>() - 1.0;
    BOOST_TEST(std::abs(error) < allowed, name << " differs by " << error);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_line_in_time)

// The half width is proportional to the square root of the load: the final state is the steady line contact at half
// the load, on the same nodes.
BOOST_AUTO_TEST_CASE(half_of_the_load) {
  const TemporaryFolder folder;
  const double root = std::sqrt(2.0);
  const nlohmann::json film = steady(folder, contact(10, -4.5 * root, 1.5 * root));
  for (const char* cavitation : {"", "cavitation = content\n"}) {
    const InTime run =
        in_time(folder, contact(20, -4.5, 1.5), "end_time = 8\nload = 0:1 1:0.5\n" + std::string(cavitation));
    check_same(run.rows.front(), steady(folder, contact(20, -4.5, 1.5)), 1.0, 1e-6);
    check_same(run.rows.back(), film, 2.0, 2e-5);
    for (const std::vector<double>& row : run.rows) BOOST_TEST(row[load_error] < 1e-12);
    if (*cavitation) BOOST_TEST(std::abs(run.json["transient"]["oil_lost"].get<double>()) < 1e-9);
  }
}

// In some of these cases the first cycles may separate the bodies, and without pressure there is no residual. The far
// field is closed in the steady state and zero in time, which causes the difference that is allowed.
BOOST_AUTO_TEST_CASE(begins_with_the_steady_film) {
  const TemporaryFolder folder;
  const std::string light =
      "[contact]\nkind = line\nM = 2\nL = 2\n[lubricant]\nviscosity = roelands\nalpha = "
      "2.2e-8\nz = 0.68\n";
  const std::string isoviscous =
      "[contact]\nkind = line\nM = 50\nL = 0\n[lubricant]\nviscosity = isoviscous\ndensity "
      "= incompressible\n";
  for (const std::string& deck : {light, isoviscous}) {
    const InTime run = in_time(folder, deck, "end_time = 0.1\nload_wave = 0.3 2\n");
    check_same(run.rows.front(), steady(folder, deck), 1.0, 3e-3);
    BOOST_TEST(run.json["transient"]["not_solved"].get<int>() == 0);
  }
}

// A ridge on the surface at rest is part of the steady film, so nothing changes in time.
BOOST_AUTO_TEST_CASE(a_ridge_at_rest) {
  const TemporaryFolder folder;
  const std::string smooth = contact(20, -4.5, 1.5);
  const std::string ridge = smooth + "[surface1]\nshape = ridge\nheight = 0.05\nwidth = 0.5\nx = -1.1\n";
  const nlohmann::json with = steady(folder, ridge + "at_rest = yes\n");
  BOOST_TEST(with["Hc"].get<double>() < 0.97 * steady(folder, smooth)["Hc"].get<double>());
  for (const std::vector<double>& row : in_time(folder, ridge, "end_time = 3\nu1 = 0:0\nu2 = 0:2\n").rows)
    check_same(row, with, 1.0, 1e-5);
  // The deck of the result also gives the Y position of the ridge, which is 0.
  folder.write("own.ini", ehl(folder, "extract time.h5 deck").out);
  const Ended own = ehl(folder, "check own.ini");
  BOOST_TEST(own.status == 0, own.err);
  folder.write("beside.ini", ridge + "at_rest = yes\ny = 0.5\n");
  const Ended beside = ehl(folder, "check beside.ini");
  BOOST_TEST(beside.status == 2);
  BOOST_TEST(beside.says({"[surface1] y"}), beside.err);
}

// A film formed in the inlet passes through the contact at the mean speed, here 1.2 times that of the start. The front
// of the new film, where it is half way between old and new, is observed upstream and downstream of the centre.
BOOST_AUTO_TEST_CASE(the_new_film_goes_with_the_mean_speed) {
  const TemporaryFolder folder;
  const std::string deck = contact(200, -2.5, 1.5) + "[output]\nprobe = -0.5 0, 0.5 0\n";
  const std::vector<std::vector<double>> rows = in_time(folder, deck, "end_time = 5\nu1 = 0.2:1 0.2:1.4\n").rows;
  const auto passes = [&](std::size_t column) {
    const double middle = 0.5 * (rows.front()[column] + rows.back()[column]);
    const auto after = std::ranges::find_if(rows, [&](const auto& row) { return row[column] > middle; });
    const double share = (middle - after[-1][column]) / (after[0][column] - after[-1][column]);
    return after[-1][T] + share * (after[0][T] - after[-1][T]);
  };
  const std::size_t last = rows[0].size() - 1;  // P_1 H_1 P_2 H_2
  BOOST_TEST(rows.back()[last] / rows.front()[last] > 1.08);
  const double way = 1.2 * (passes(last) - passes(last - 2));
  BOOST_TEST(std::abs(way - 1.0) < 0.02, "in the time from one probe to the other the oil goes " << way);
}

BOOST_AUTO_TEST_SUITE_END()
