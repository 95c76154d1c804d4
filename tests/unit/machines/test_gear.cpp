// Two spur gears along their path of contact.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/constants.hpp"
#include "machines/gear.hpp"

using namespace ehl::machines;

namespace {

void check(const char* what, double computed, double expected, double tolerance = 1e-13) {
  const double error = std::abs(computed - expected) / std::max(1.0, std::abs(expected));
  BOOST_TEST_MESSAGE(what << " = " << computed << ", expected " << expected << ", difference " << error);
  BOOST_TEST(error <= tolerance, what << " = " << computed << ", expected " << expected);
}

// In mm. The second is the gear pair of the FZG test, type C.
const Gears plain{4.0, 24, 48};
const Gears fzg{4.5, 16, 24, 20.0, 0.1817, 0.1715};

}  // namespace

BOOST_AUTO_TEST_SUITE(test_bearing_gear)

// By hand, with 30 digits of `bc`: base circles 48 cos 20, 96 cos 20; tips 52 and 100; T1T2 = 144 sin 20.
BOOST_AUTO_TEST_CASE(path_by_hand) {
  const PathOfContact path = path_of_contact(plain);
  check("centre distance", path.centre_distance, 144.0);
  check("working angle", path.working_angle, 20.0);
  check("base radius 1", path.base_radius1, 45.105245797723602434597);
  check("base radius 2", path.base_radius2, 90.210491595447204869194);
  check("tip thickness 1", path.tip_thickness1, 2.86220173406786406556);  // 104 [pi/48 + inv 20 - inv acos(r_b1/52)]
  check("tip thickness 2", path.tip_thickness2, 3.09168977742906132291);  // 200 [pi/96 + inv 20 - inv acos(r_b2/100)]
  check("T1T2", path.length_T1T2, 49.250900638896297558350);
  check("A", path.A, 6.099223891546731631224);
  check("E", path.E, 25.875022734810056654271);
  check("C", path.C, 16.416966879632099186117);
  check("base pitch", path.base_pitch, 11.808525736374196876993);
  check("contact ratio", path.contact_ratio, 1.674705148191977111232);
  check("B", path.B, path.E - 11.808525736374196876993);
  check("D", path.D, path.A + 11.808525736374196876993);
}

// Published for the FZG test (DIN ISO 14635-1): centre distance 91.5 mm, working pressure angle 22.44 degrees, tip
// diameters 82.46 and 118.36 mm.
BOOST_AUTO_TEST_CASE(fzg_type_c) {
  const PathOfContact path = path_of_contact(fzg);
  check("centre distance", path.centre_distance, 91.5, 1e-5);
  check("working angle", path.working_angle, 22.44, 1e-4);
  check("tip 1", 2.0 * path.tip_radius1, 82.46, 1e-4);
  check("tip 2", 2.0 * path.tip_radius2, 118.36, 1e-4);
  // The clearance between tip and root is that without profile shift, m (c* + h_a - h_a); the
  // roots are m (z/2 - 1.25 + x).
  const double root2 = 4.5 * (12.0 - 1.25 + 0.1715);
  check("clearance", path.centre_distance - path.tip_radius1 - root2, 0.25 * 4.5);
}

// On the reference circle the tooth thickness is that of the rack, m (pi/2 + 2 x tan(alpha)); the addendum here ends
// the tooth on this circle. Profile shifts that cancel do not change the tips.
BOOST_AUTO_TEST_CASE(thickness_of_teeth) {
  const Gears low{4.0, 30, 50, 20.0, 0.3, -0.3, -0.3};
  const double tangent = std::tan(ehl::core::pi / 9.0);
  check("wheel 1", path_of_contact(low).tip_thickness1, 4.0 * (0.5 * ehl::core::pi + 0.6 * tangent));
  const Gears other{4.0, 50, 30, 20.0, -0.3, 0.3, -0.3};
  check("wheel 2", path_of_contact(other).tip_thickness2, 4.0 * (0.5 * ehl::core::pi + 0.6 * tangent));
}

// Nothing slides at the pitch point. Elsewhere the sliding speed is (omega1 + omega2) times the distance from it, the
// relative speed of the wheels about that point. The radii of curvature add up to the length of T1T2.
BOOST_AUTO_TEST_CASE(sliding_along_the_path) {
  for (const Gears& gears : {plain, fzg}) {
    const PathOfContact path = path_of_contact(gears);
    const double omega1 = 150.0, omega2 = omega1 * gears.teeth1 / gears.teeth2;
    for (int k = 0; k <= 10; ++k) {
      const double s = path.A + 0.1 * k * (path.E - path.A);
      const Mesh mesh = mesh_at(gears, path, s, omega1);
      check("sliding", mesh.u1 - mesh.u2, (omega1 + omega2) * (s - path.C), 1e-12);
      check("rho1 + rho2", mesh.rho1 + mesh.rho2, path.length_T1T2);
      check("1/R", 1.0 / mesh.R, 1.0 / mesh.rho1 + 1.0 / mesh.rho2);
    }
    // Both surfaces move along the line of action with rho/r_b times the speed of the base circle.
    const Mesh pitch = mesh_at(gears, path, path.C, omega1);
    check("no sliding at the pitch point", (pitch.u1 - pitch.u2) / pitch.u1, 0.0);
    check("rolling at the pitch point", pitch.u1,
          omega1 * path.centre_distance * gears.teeth1 / (gears.teeth1 + gears.teeth2) *
              std::sin(path.working_angle * ehl::core::pi / 180.0));
  }
}

// With exchanged wheels, the position A becomes E and vice versa.
BOOST_AUTO_TEST_CASE(swapped_wheels) {
  const Gears other{4.5, 24, 16, 20.0, 0.1715, 0.1817};
  const PathOfContact path = path_of_contact(fzg), back = path_of_contact(other);
  check("E", back.E, path.length_T1T2 - path.A);
  check("A", back.A, path.length_T1T2 - path.E);
  const Mesh here = mesh_at(fzg, path, path.A, 30.0), there = mesh_at(other, back, back.E, 20.0);
  check("R", there.R, here.R);
  check("u2", there.u2, here.u1);
}

// Two pairs, one base pitch apart, carry the whole load together; a single pair carries it between B and D.
BOOST_AUTO_TEST_CASE(shares_sum_up_to_one) {
  const PathOfContact path = path_of_contact(plain);
  const auto of = [&](double s) { return share(path, s, Sharing::linear); };
  for (int k = 0; k < 20; ++k) {
    const double s = path.A + 0.05 * (k + 0.5) * (path.B - path.A);
    check("two pairs", of(s) + of(s + path.base_pitch), 1.0);
  }
  check("at A", of(path.A), 1.0 / 3.0);
  check("below B", of(path.B - 1e-9), 2.0 / 3.0, 1e-8);
  check("at C", of(path.C), 1.0);
  check("above D", of(path.D + 1e-9), 2.0 / 3.0, 1e-8);
  check("at E", of(path.E), 1.0 / 3.0);
  BOOST_TEST(share(path, path.A, Sharing::none) == 1.0);
}

BOOST_AUTO_TEST_CASE(what_cannot_mesh) {
  BOOST_TEST(path_of_contact({4.0, 8, 100}).A < 0.0);                                      // interference
  BOOST_TEST(std::isnan(path_of_contact({4.0, 24, 48, 20.0, -2.0, -2.0}).working_angle));  // the teeth would overlap
}

BOOST_AUTO_TEST_SUITE_END()
