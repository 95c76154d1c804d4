// The decks of inputs/hard through the program: they must converge, pass the checks, and agree with a
// reference or with finer meshes.
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "hard/deck_run.hpp"

BOOST_AUTO_TEST_SUITE(test_hard_decks)

namespace {

using hard::Report;
using hard::run_deck;

/// A deck that is compared with its own refinement, on cells, 2 cells and 4 cells. The deck's own grid is one of
/// them if it costs no more.
struct Refined {
  std::string deck;
  int cells;
};
const Refined refined[] = {
    {"M2_L0", 512},     {"M5_L25", 128},    {"M20_L20", 128},   {"M20_L25", 128},         {"M1000_L2", 256},
    {"M1000_L20", 128}, {"M2000_L25", 256}, {"M5000_L10", 256}, {"steel_ball_4GPa", 256}, {"mesh_aspect_M20_L10", 128}};
/// Decks that have a test of their own below. The map is the deck of a sweep.
const std::string others[] = {"load_continuation", "sharp_outlet_M50_L10_barus", "short_domain_M20_L10",
                              "stability_map"};

/// The case must be solved, and all checks of the final state must be within the limits that the program promises
/// (modules/steady/README.md).
void require_verified(const Report& report) {
  BOOST_TEST(report.status == 0, report.err);
  BOOST_TEST_REQUIRE(!report.json.empty());
  BOOST_TEST(report.text("converged") == "true");
  BOOST_TEST(report.text("failed_check") == "");
  BOOST_TEST(report.number("verification/residual") <= 4e-3);
  BOOST_TEST(report.number("load_error") <= 1e-4);
  BOOST_TEST(report.number("verification/least_P") >= 0.0);
  BOOST_TEST(report.number("verification/Hm") > 0.0);
  BOOST_TEST(report.number("verification/dry_violation") <= 2e-2);
  BOOST_TEST(std::abs(report.number("verification/flow_imbalance")) <= 1.25e-2);
  // The README promises an algebraic error of at most a tenth of the discretization error.
  for (const char* film : {"Hc", "Hm"})
    BOOST_TEST(report.number(std::string("verification/algebraic_error_") + film) <=
               0.1 * report.of_last_level(std::string("mesh_error_") + film));
}

std::string path_with_factor(const Report& report) {
  return report.text("method") + ", factor " + report.text("cycle_factor") + ", " + report.text("seconds") + " s";
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_deck_is_tested) {
  for (const auto& entry : std::filesystem::directory_iterator(std::string(EHL_INPUTS) + "/hard")) {
    if (entry.path().extension() != ".ini") continue;
    const std::string name = entry.path().stem();
    const bool known = std::ranges::any_of(refined, [&](const Refined& one) { return one.deck == name; }) ||
                       std::ranges::find(others, name) != std::end(others);
    BOOST_TEST(known, name << ".ini has no test here");
  }
}

// With the second-order scheme and P = 0 on the boundary, halving the cells divides the change of Hc and Hm by about 4;
// the largest errors are not yet asymptotic, and the minimum is that of a node. The estimate for n cells must cover the
// change to 2 n cells, but by a factor of at most ten: otherwise an estimate of 100 % everywhere would pass.
BOOST_AUTO_TEST_CASE(refinement_is_monotone_and_the_error_estimate_covers_it) {
  for (const Refined& one : refined) {
    BOOST_TEST_CONTEXT(one.deck) {
      const Report as_it_is = run_deck(one.deck);
      require_verified(as_it_is);
      if (as_it_is.json.empty()) continue;
      // With the default scheme, the changes are smaller than the errors of the second-order
      // scheme, and their sign varies.
      const Report coarser = run_deck(one.deck, {"grid.cells=" + std::to_string(as_it_is.cells() / 2)});
      for (const std::string film : {"Hc", "Hm"}) {
        const double change = std::abs(as_it_is.number(film) / coarser.number(film) - 1.0);
        BOOST_TEST_MESSAGE("  " << film << " on " << coarser.cells() << " cells: estimated error "
                                << coarser.number("error_" + film) << ", change to the next mesh " << change);
        BOOST_TEST(coarser.number("error_" + film) >= change);
      }
      std::array<Report, 3> meshes;
      for (int k = 0; k < 3; ++k) {
        const int cells = one.cells << k;
        meshes[static_cast<std::size_t>(k)] = run_deck(
            one.deck,
            {"grid.cells=" + std::to_string(cells), "discretization.wedge=upstream2", "domain.far_field=zero"});
        require_verified(meshes[static_cast<std::size_t>(k)]);
      }
      BOOST_TEST_MESSAGE(one.deck << ": as it is " << as_it_is.cells() << " cells, Hc " << as_it_is.number("Hc")
                                  << ", Hm " << as_it_is.number("Hm") << "; " << path_with_factor(as_it_is));
      for (const std::string film : {"Hc", "Hm"}) {
        const double first = meshes[1].number(film) - meshes[0].number(film);
        const double second = meshes[2].number(film) - meshes[1].number(film);
        BOOST_TEST_MESSAGE("  " << film << " " << meshes[0].number(film) << ", " << meshes[1].number(film) << ", "
                                << meshes[2].number(film) << " on " << one.cells
                                << " cells and finer: changes in ratio " << first / second << " (allowed 2.5 to 6)");
        BOOST_TEST(first / second >= 2.5);
        BOOST_TEST(first / second <= 6.0);
        for (std::size_t k = 0; k < 2; ++k) {
          const double change = std::abs(meshes[k + 1].number(film) / meshes[k].number(film) - 1.0);
          const double estimate = meshes[k].of_last_level("mesh_error_" + film);
          BOOST_TEST_MESSAGE("    on " << meshes[k].cells() << " cells: estimated error " << estimate
                                       << ", change to the next mesh " << change);
          BOOST_TEST(estimate >= change);
          BOOST_TEST(estimate <= 10.0 * change);
        }
      }
    }
  }
}

// Reference values for this grid from an independent program, fully converged. The tolerance is half a unit of
// the last digit, plus 1e-6.
BOOST_AUTO_TEST_CASE(sharp_outlet_has_the_reference_digits) {
  const Report report = run_deck("sharp_outlet_M50_L10_barus");
  require_verified(report);
  BOOST_TEST(report.cells() == 256);
  BOOST_TEST(report.number("residual") <= 1e-10);
  const std::map<std::string, std::pair<double, double>> expected = {
      {"Hc", {0.2659092, 1e-6}}, {"Hm", {0.1431564, 1e-6}}, {"H00", {-0.7512240, 1e-6}}, {"P_max", {1.65490, 1e-5}}};
  for (const auto& [name, value] : expected) {
    BOOST_TEST_MESSAGE(name << " " << report.text(name) << ", reference " << value.first << " (allowed " << value.second
                            << ")");
    BOOST_TEST(std::abs(report.number(name) - value.first) <= value.second);
  }
}

// The warning states how much thicker the film is on a domain twice as long and wide, estimated on coarse grids. The
// test solves that domain with the same mesh size. The tolerance accounts for the different meshes.
BOOST_AUTO_TEST_CASE(short_domain_is_called_starved_by_as_much_as_it_is) {
  const Report report = run_deck("short_domain_M20_L10");
  require_verified(report);
  const std::string warning = report.warning("domain is too short");
  BOOST_TEST_REQUIRE(warning != "");
  const std::size_t end = warning.find(" %");
  BOOST_TEST_REQUIRE(end != std::string::npos);
  const double said = std::stod(warning.substr(warning.rfind(' ', end - 1)));
  const Report large = run_deck("short_domain_M20_L10", {"domain.x_inlet=-4.5", "domain.y_half=6", "grid.cells=256"});
  require_verified(large);
  const double growth = 100.0 * (large.number("Hc") / report.number("Hc") - 1.0);
  BOOST_TEST_MESSAGE("Hc " << report.number("Hc") << ", on the double domain " << large.number("Hc") << ": larger by "
                           << growth << " %; the warning said " << said << " % (allowed 20 % of it)");
  BOOST_TEST(std::abs(said - growth) <= 0.2 * growth);
  BOOST_TEST(run_deck("M20_L20").warning("domain is too short") == "");
}

// In the first three cases the coarsest grid resolves the contact with only a few cells, on which relaxation may
// oscillate. In the last case the film at the start is so thick that the pressure responds late. None of this
// may slow down the cycles.
BOOST_AUTO_TEST_CASE(the_coarsest_grid_does_not_hold_up_the_cycles) {
  constexpr double worst_factor = 0.23;  // largest allowed convergence factor
  for (const auto& [M, L] : {std::pair{"1000", "2"}, {"410", "2.28"}, {"200", "0"}, {"10", "20"}}) {
    const Report report = run_deck("stability_map", {std::string("contact.M=") + M, std::string("contact.L=") + L,
                                                     "grid.cells=256", "multigrid.tolerance=1e-8"});
    BOOST_TEST_MESSAGE("(" << M << ", " << L << "): " << path_with_factor(report) << " (allowed " << worst_factor
                           << ")");
    require_verified(report);
    BOOST_TEST(report.text("method") == "full multigrid");
    BOOST_TEST(report.number("cycle_factor") <= worst_factor);
  }
}

// A contact in SI, and the warnings that belong to this pressure.
BOOST_AUTO_TEST_CASE(four_gigapascal_come_with_their_warnings) {
  const Report report = run_deck("steel_ball_4GPa", {"grid.cells=128"});
  require_verified(report);
  // Hertz: a^3 = 3 F R/(2 E'), E' = 206e9/(1 - 0.09); h = H a^2/R.
  const double a = std::cbrt(1.5 * 1040.0 * 6.35e-3 / (206e9 / 0.91));
  const double h_of_H = a * a / 6.35e-3;
  BOOST_TEST_MESSAGE("h_c " << report.number("hc_m") << " m, H a^2/R " << report.number("Hc") * h_of_H);
  BOOST_TEST(std::abs(report.number("hc_m") / (report.number("Hc") * h_of_H) - 1.0) <= 1e-12);
  BOOST_TEST(report.warning("p_h = 4 GPa exceeds the yield limit of steel") != "");
  BOOST_TEST(report.warning("Roelands' law is used outside its range") != "");
  BOOST_TEST(report.warning("mesh does not resolve the film") != "");
}

// The equations at the nodes are solved, but the film is negative between them.
BOOST_AUTO_TEST_CASE(a_film_that_is_negative_between_the_nodes_is_told) {
  const Report report =
      run_deck("stability_map", {"contact.M=100", "contact.L=5", "contact.radius_ratio=50", "grid.cells=128"});
  BOOST_TEST(report.text("converged") == "true");
  BOOST_TEST_MESSAGE("Hm " << report.number("Hm") << " at a node, " << report.number("Hm_fitted") << " between them");
  BOOST_REQUIRE(report.number("Hm") > 0.0);
  BOOST_REQUIRE(report.number("Hm_fitted") < 0.0);
  BOOST_TEST(report.warning("minimum of the film lies between the nodes and is negative") != "");
}

// Standard coarsening in both directions would diverge on these cells.
BOOST_AUTO_TEST_CASE(cells_four_times_as_long_as_wide_take_cycles) {
  const Report report = run_deck("mesh_aspect_M20_L10", {"grid.cells=128"});
  require_verified(report);
  const double nx = report.of_last_level("nx"), ny = report.of_last_level("ny");
  BOOST_TEST_MESSAGE(nx << " x " << ny << " cells on 24 x 3: " << path_with_factor(report));
  BOOST_TEST(24.0 / nx == 4.0 * 3.0 / ny);
  BOOST_TEST(report.text("method").starts_with("full multigrid"));
  const Report finer = run_deck("mesh_aspect_M20_L10", {"multigrid.tolerance=1e-9"});
  BOOST_TEST_MESSAGE("to 1e-9 on " << finer.of_last_level("nx") << " cells: " << path_with_factor(finer)
                                   << " (at most 0.4)");
  BOOST_TEST(finer.text("method").starts_with("full multigrid"));
  BOOST_TEST(finer.number("cycle_factor") < 0.4);
  BOOST_TEST(finer.number("Hc") == 0.4185, boost::test_tools::tolerance(1e-3));
}

// M = 20 to 5000 in one run: every load is reported, and the result is that of a direct solution.
BOOST_AUTO_TEST_CASE(load_continuation_is_told_and_ends_where_the_direct_way_does) {
  const Report report = run_deck("load_continuation", {"grid.cells=256"});
  require_verified(report);
  BOOST_TEST(report.text("method") == "load continuation");
  const std::vector<hard::Step> steps = report.continuation();
  BOOST_TEST_REQUIRE(steps.size() >= 4U);
  BOOST_TEST(steps.front().M == 20.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(steps.back().M == 5000.0);
  BOOST_TEST(steps.back().converged);
  const Report direct = run_deck("M5000_L10", {"grid.cells=256"});
  BOOST_TEST(report.cells() == direct.cells());
  BOOST_TEST_MESSAGE(steps.size() << " loads; " << path_with_factor(report));
  for (const std::string film : {"Hc", "Hm"}) {
    const double apart = std::abs(report.number(film) / direct.number(film) - 1.0);
    const double allowed = 0.1 * direct.of_last_level("mesh_error_" + film);
    BOOST_TEST_MESSAGE(film << " " << report.number(film) << ", directly " << direct.number(film) << ": apart by "
                            << apart << " (allowed " << allowed << ", what the cycles may leave)");
    BOOST_TEST(apart <= allowed);
  }
}

// The spike of an incompressible oil is one cell wide: a bilinear correction of its top is far too much for its flank.
BOOST_AUTO_TEST_CASE(a_spike_of_one_cell) {
  const Report report =
      run_deck("M1000_L20", {"contact.M=1046", "contact.L=20.4", "lubricant.alpha=2.555e-8", "lubricant.z=0.5746",
                             "lubricant.density=incompressible", "domain.far_field=zero", "domain.x_inlet=-1.5",
                             "domain.x_outlet=1.1666666666666667", "domain.y_half=1.3333333333333333",
                             "grid.cells=1024", "multigrid.tolerance=1e-3", "multigrid.max_cycles=16",
                             "multigrid.polish=off", "continuation.path=off"});
  BOOST_TEST_MESSAGE("residual " << report.number("residual") << " (allowed 1e-3), " << path_with_factor(report));
  BOOST_TEST(report.status == 0, report.err);
  BOOST_TEST(report.number("residual") <= 1e-3);
}

BOOST_AUTO_TEST_CASE(a_continuation_without_enough_steps_is_not_converged) {
  const Report report =
      run_deck("load_continuation", {"grid.cells=256", "continuation.max_steps=2", "multigrid.polish=off"});
  BOOST_TEST_MESSAGE("exit status " << report.status << ": " << report.err);
  BOOST_TEST(report.status == 3);
  BOOST_TEST(report.text("converged") == "false");
  BOOST_TEST(report.text("failed_check").find("2 steps (max_steps) reached M = 40") != std::string::npos);
  BOOST_TEST(report.err.find("2 steps (max_steps) reached M = 40") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
