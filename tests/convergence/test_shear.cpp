// Contacts with a shear-thinning oil, over meshes, loads and slide-roll ratios.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "contact/groups.hpp"
#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_shear)

using namespace ehl;

namespace {

constexpr double a_over_R_of_p_h = 3.141592653589793 / 2.26e11;  // pi/E', steel on steel

steady::Scene scene_of(double M, double L, int n) {
  return tests::roelands_scene(
      M, L, M < 200 ? core::Grid{n, n, -4.5, 1.5, -3.0, 3.0} : core::Grid{n, n, -2.5, 1.5, -2.0, 2.0});
}

// The dimensionless stress eta_0 (u1 - u2) R/(a^2 tau_0) = lambda (a/R) srr/12 p_h/tau_0.
rheology::ShearThinning eyring(const steady::Scene& scene, double srr, double tau_0) {
  const double p_h = contact::from_moes(scene.contact.M, scene.contact.L).alpha_bar / 2.2e-8;
  return {rheology::Eyring{}, scene.lambda * a_over_R_of_p_h * p_h * srr / 12.0 * p_h / tau_0};
}

}  // namespace

BOOST_AUTO_TEST_CASE(second_order_in_the_mesh) {
  for (const auto& law : {rheology::ShearLaw{rheology::Eyring{}}, rheology::ShearLaw{rheology::Carreau{0.46}}}) {
    double Hc[4]{};
    int k = 0;
    for (const int n : {64, 128, 256, 512}) {
      steady::Scene scene = scene_of(50, 10, n);
      scene.thinning = rheology::ShearThinning{law, eyring(scene, 1.0, 5e6).k};
      scene.solver.tolerance = 1e-8;
      const steady::Solution solution = steady::solve(scene);
      BOOST_TEST(solution.converged);
      Hc[k++] = solution.levels.back().Hc;
    }
    const double coarse = std::log2((Hc[1] - Hc[0]) / (Hc[2] - Hc[1]));
    const double fine = std::log2((Hc[2] - Hc[1]) / (Hc[3] - Hc[2]));
    BOOST_TEST_MESSAGE("law " << law.index() << ": Hc " << Hc[0] << ", " << Hc[1] << ", " << Hc[2] << ", " << Hc[3]
                              << ": orders " << coarse << ", " << fine << " (2 +- 0.25, the last)");
    BOOST_TEST(std::abs(fine - 2.0) < 0.25);
  }
}

// The film decreases with increasing sliding, the more the lower the Eyring stress. The convergence factors are at most
// 0.05 above those of the Newtonian oil at the same load.
BOOST_AUTO_TEST_CASE(films_and_cycles_over_loads_and_sliding) {
  for (const double M : {50.0, 200.0, 1000.0}) {
    steady::Scene scene = scene_of(M, 10, 128);
    scene.solver.tolerance = 1e-7;
    const steady::Solution newtonian = steady::solve(scene);
    double worst = 0.0;
    for (const double tau_0 : {2e6, 10e6}) {
      double before = newtonian.levels.back().Hc;
      for (const double srr : {0.1, 0.3, 1.0}) {
        scene.thinning = eyring(scene, srr, tau_0);
        const steady::Solution solution = steady::solve(scene);
        const double Hc = solution.levels.back().Hc;
        BOOST_TEST_MESSAGE("M = " << M << ", tau_0 = " << tau_0 << ", srr = " << srr << ": Hc " << Hc << ", "
                                  << solution.levels.back().cycles << " cycles, " << solution.cycle_factor
                                  << " per cycle (Newtonian " << newtonian.levels.back().Hc << ", "
                                  << newtonian.levels.back().cycles << ", " << newtonian.cycle_factor << ")");
        BOOST_TEST((solution.converged && solution.method == "full multigrid"));
        // On a coarse mesh the central film is accurate to one part in a thousand only.
        BOOST_TEST(Hc < before * 1.001);
        before = Hc;
        worst = std::max(worst, solution.cycle_factor);
      }
      BOOST_TEST(before < newtonian.levels.back().Hc);
    }
    scene.thinning.reset();
    BOOST_TEST(worst <= newtonian.cycle_factor + 0.05);
  }
}

BOOST_AUTO_TEST_SUITE_END()
