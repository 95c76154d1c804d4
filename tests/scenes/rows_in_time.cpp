// Numbers over a run in time: the rows of a sweep, the window of extremes and means, error bars, published waves.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "results/read.hpp"
#include "support/json.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

namespace {

using support::contains;
using Row = support::NamedRow;

// A line contact whose load rises, solved within a tenth of a second.
const std::string deck =
    "[contact]\nkind = line\nM = 20\nL = 5\na_over_R = 0.01\n[motion]\nsrr = 0.2\n[lubricant]\nalpha = 2e-8\n[grid]\n"
    "cells = 128\n[friction]\ncavitated = striated\n[transient]\nend_time = 2\nload = 0:1 0.5:1 1:1.5\n";

struct Scene {
  support::TemporaryFolder folder;
  Scene() { folder.write("d.ini", deck); }
  support::Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }
};

struct Course {
  std::vector<double> T, values;
  std::size_t least() const { return static_cast<std::size_t>(std::ranges::min_element(values) - values.begin()); }
  std::size_t largest() const { return static_cast<std::size_t>(std::ranges::max_element(values) - values.begin()); }
  double mean() const {
    double sum = 0.0;
    for (std::size_t k = 1; k < T.size(); ++k) sum += 0.5 * (T[k] - T[k - 1]) * (values[k] + values[k - 1]);
    return sum / (T.back() - T.front());
  }
};

Course course(const ehl::results::ResultFile& file, const std::string& name) {
  return {file.numbers("/transient/time").values, file.numbers("/transient/" + name).values};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_rows_in_time)

// The numbers of a row follow from the steps of the same run.
BOOST_AUTO_TEST_CASE(a_row_has_the_extremes_and_means_of_its_run) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("sweep d.ini --vary contact.M=20 --quiet").status == 0);
  const support::Ended more = scene.ehl("sweep d.ini --vary contact.M=20,30 --quiet");
  BOOST_TEST(contains(more.out, "2: 1 kept, 1 computed"), more.out);  // an interrupted sweep goes on
  const std::vector<Row> rows = support::named_rows(scene.folder.read("d_sweep.csv"));
  BOOST_REQUIRE(rows.size() == 2u);
  BOOST_REQUIRE(scene.ehl("run d.ini --set contact.M=30 --threads 1 --quiet --output one.h5").status == 0);
  const ehl::results::ResultFile file(scene.folder / "one.h5");
  const auto agrees = [&](const std::string& name, double wanted) {
    BOOST_TEST(std::stod(rows[1].at(name)) == wanted,
               name << " is " << rows[1].at(name) << ", of the steps " << wanted);
  };
  for (const std::string name : {"Hc", "Hm", "P_max", "mu"}) {
    const Course of = course(file, name);
    agrees("least_" + name, of.values[of.least()]);
    agrees("largest_" + name, of.values[of.largest()]);
    BOOST_TEST(std::abs(std::stod(rows[1].at("mean_" + name)) / of.mean() - 1.0) < 1e-7, name);
    if (name == "mu") continue;
    agrees("time_of_least_" + name, of.T[of.least()]);
    agrees("time_of_largest_" + name, of.T[of.largest()]);
  }
  agrees("steps", static_cast<double>(course(file, "Hc").T.size() - 1));
  agrees("mean_abs_mu", std::stod(rows[1].at("mean_mu")));  // mu is positive
  BOOST_TEST((rows[1].at("completed") == "1" && rows[1].at("status") == "converged"));
  BOOST_TEST(rows[1].at("Hc") != rows[1].at("mean_Hc"));  // the former is that of the start
}

// Keys of the run can be varied; shards give the same table; a run that fails is no converged row.
BOOST_AUTO_TEST_CASE(keys_of_the_run_are_varied) {
  const Scene scene;
  const std::string vary = "sweep d.ini --quiet --vary transient.end_time=0.5,1,2 --output ";
  BOOST_REQUIRE(scene.ehl(vary + "whole.csv").status == 0);
  const std::vector<Row> rows = support::named_rows(scene.folder.read("whole.csv"));
  BOOST_TEST((rows[0].at("end_time") == "0.5" && rows[2].at("end_time") == "2"));
  // Before the load rises the film is steady.
  BOOST_TEST(std::abs(std::stod(rows[0].at("least_Hc")) / std::stod(rows[0].at("Hc")) - 1.0) < 1e-3);
  BOOST_TEST(std::stod(rows[2].at("largest_P_max")) > 1.1 * std::stod(rows[0].at("largest_P_max")));
  for (const char* part : {"1/2", "2/2"}) BOOST_TEST(scene.ehl(vary + "part.csv --shard " + part).status == 0);
  BOOST_TEST(scene.ehl("sweep --merge part.1of2.csv part.2of2.csv --output merged.csv").status == 0);
  const std::vector<Row> merged = support::named_rows(scene.folder.read("merged.csv"));
  BOOST_REQUIRE(merged.size() == 3u);
  for (std::size_t k = 0; k < merged.size(); ++k) BOOST_TEST(merged[k].at("least_Hm") == rows[k].at("least_Hm"));

  const support::Ended failed = scene.ehl(
      "sweep d.ini --quiet --vary transient.max_steps=30,1000 --set transient.max_step=0.05 --set "
      "transient.stop_film=1e-4 --output failed.csv");
  BOOST_TEST(failed.status == 3, failed.err);
  const Row row = support::named_rows(scene.folder.read("failed.csv"))[0];
  BOOST_TEST((row.at("status") == "not-converged" && contains(row.at("reason"), "30 steps")), row.at("reason"));
  BOOST_TEST(row.at("least_Hc") == "NaN");
}

BOOST_AUTO_TEST_CASE(means_begin_where_the_deck_says) {
  const Scene scene;
  const std::string late = " --set transient.start_of_means=1.5";
  const support::Ended ended = scene.ehl("run d.ini --quiet --json --output late.h5" + late);
  const nlohmann::json json = support::parsed(ended.out);
  const ehl::results::ResultFile file(scene.folder / "late.h5");
  const Course of = course(file, "P_max");
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < of.T.size(); ++k)
    if (of.T[k] >= 1.5) least = std::min(least, of.values[k]);
  BOOST_TEST(support::number_at(json, "/transient/least_P_max") == least);
  BOOST_TEST(least > of.values[0]);
  const support::Ended refused = scene.ehl("check d.ini --set transient.start_of_means=2");
  BOOST_TEST((refused.status == 2 && contains(refused.err, "start_of_means = 2: must be less than end_time = 2")),
             refused.err);
}

// The bars of a run hold against twice the cells and a tenth of the tolerance.
BOOST_AUTO_TEST_CASE(error_bars_hold) {
  const Scene scene;
  const support::Ended ended = scene.ehl("run d.ini --quiet --json --output bars.h5 --set transient.error=on");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  BOOST_REQUIRE(scene.ehl("run d.ini --quiet --output fine.h5 --set grid.cells=256 --set transient.rtol=1e-5").status ==
                0);
  const nlohmann::json json = support::parsed(ended.out);
  const ehl::results::ResultFile file(scene.folder / "bars.h5"), fine(scene.folder / "fine.h5");
  std::size_t all_held = 0, all = 0;
  for (const std::string name : {"Hc", "Hm", "P_max", "mu"}) {
    const Course own = course(file, name), bars = course(file, "error_" + name), better = course(fine, name);
    std::size_t held = 0;
    double worst = 0.0;
    for (std::size_t k = 0; k < own.T.size(); ++k) {
      const auto after = static_cast<std::size_t>(std::ranges::lower_bound(better.T, own.T[k]) - better.T.begin());
      const std::size_t n = std::clamp<std::size_t>(after, 1, better.T.size() - 1);
      const double share = std::clamp((own.T[k] - better.T[n - 1]) / (better.T[n] - better.T[n - 1]), 0.0, 1.0);
      const double truth = better.values[n - 1] + share * (better.values[n] - better.values[n - 1]);
      const double error = std::abs(own.values[k] - truth) / std::abs(own.values[k]);
      held += error <= bars.values[k] ? 1 : 0;
      worst = std::max(worst, error / bars.values[k]);
    }
    BOOST_TEST_MESSAGE(name << ": " << held << " of " << own.T.size() << " bars hold, the worst error is " << worst
                            << " bars; error of the mean "
                            << support::number_at(json, "/transient/errors/mean_" + name));
    all_held += held;
    all += own.T.size();
    BOOST_TEST(static_cast<double>(held) >= 0.9 * static_cast<double>(own.T.size()), name);
    const double bar = support::number_at(json, "/transient/errors/mean_" + name);
    BOOST_TEST(std::abs(own.mean() / better.mean() - 1.0) <= bar, name);
    BOOST_TEST(bar < 0.1, name);
  }
  BOOST_TEST(static_cast<double>(all_held) >= 0.95 * static_cast<double>(all));
  const support::Ended coarse = scene.ehl("check d.ini --set transient.error=on --set grid.cells=32");
  BOOST_TEST((coarse.status == 2 && contains(coarse.err, "[transient] error = on")), coarse.err);
}

// A moving map needs 30 cells per wave: its waves are 0.6 radii long, and 64 and 256 cells give 8.5 and 34 to each.
BOOST_AUTO_TEST_CASE(short_waves_of_a_moving_map_are_told) {
  const support::TemporaryFolder folder;
  std::string map;
  for (int l = 0; l < 40; ++l) {
    for (int k = 0; k < 48; ++k) {
      if (k > 0) map += ',';
      map += std::to_string(std::sin(0.5236 * k));
    }
    map += "\n";
  }
  folder.write("m.csv", map);
  folder.write("m.ini",
               "[contact]\nM = 20\nL = 5\n[lubricant]\nalpha = 2e-8\n[domain]\nx_inlet = -3\nx_outlet = 1.5\ny_half = "
               "2\n[grid]\ncells = 64\n[surface1]\nshape = map\nfile = m.csv\nunit = 1e-3\ndx = 0.05\nx = -2\n"
               "[transient]\nend_time = 3\n");
  const support::Ended coarse = support::ehl(folder, "check m.ini"),
                       fine = support::ehl(folder, "check m.ini --set grid.cells=256");
  BOOST_TEST((contains(coarse.out, "[short-waves]") && contains(coarse.out, "use at least 256 cells")), coarse.out);
  BOOST_TEST((fine.status == 0 && !contains(fine.out, "[short-waves]")), fine.out << fine.err);
}

// Venner, Couhier, Lubrecht and Greenwood 1997, Table 1: A_d/A_i of waves in pure rolling.
BOOST_AUTO_TEST_CASE(waves_keep_the_published_share_of_their_height) {
  const support::TemporaryFolder folder;
  struct Wave {
    const char* settings;
    double published;
  };
  for (const Wave& wave : {Wave{" --set surface1.width=1 --set transient.end_time=5", 0.183},
                           {"", 0.394},
                           {" --set surface1.width=0.25 --set transient.end_time=4 --set transient.start_of_means=3.5 "
                            "--set grid.cells=768",
                            0.660}}) {
    const support::Ended ended =
        support::ehl(folder, "run " EHL_INPUTS
                             "/line/venner1997_waves.ini --json --quiet --overwrite --output w.h5 --set "
                             "transient.output_interval=1" +
                                 std::string(wave.settings));
    const nlohmann::json json = support::parsed(ended.out);
    constexpr double height = 0.001428;
    const double kept =
        0.5 / height *
        (support::number_at(json, "/transient/largest_Hc") - support::number_at(json, "/transient/least_Hc"));
    BOOST_TEST_MESSAGE("A_d/A_i " << kept << ", published " << wave.published);
    BOOST_TEST(std::abs(kept / wave.published - 1.0) < 0.03, kept << ", published " << wave.published);
  }
}

BOOST_AUTO_TEST_SUITE_END()
