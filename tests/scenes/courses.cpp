// Machines in time, through the program: cams, pairs of teeth, strokes and impacts become the table of a cycle.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "support/refused.hpp"
#include "support/solved.hpp"

using namespace ehl;

namespace {

const double pi = std::acos(-1.0), degree = pi / 180.0;
const std::string oil = "[lubricant]\neta0 = 0.02\nalpha = 2e-8\n[contact]\nE_prime = 2.26e11\n";
const std::string states = "[transient]\ncycle = machine\nmode = quasi_steady\n";
const std::string line = "[domain]\nx_inlet = -4\nx_outlet = 4\n[grid]\ncells = 64\n";

using Of = std::function<double(double seconds)>;

/// The columns of a run against closed forms. in: scale of the times of the file [s].
struct Truth {
  const char* column;
  double scale;  ///< of the contact
  Of value;
  double allowed;  ///< relative to the scale
};

void compare(const results::ResultFile& file, const std::vector<Truth>& truths) {
  const auto column = [&](const char* name) { return file.numbers(std::string("/transient/") + name).values; };
  const std::vector<double> times = column("time");
  const double second = file.numbers("/scales/time").values.at(0);
  BOOST_TEST(times.size() > 10);
  for (const Truth& truth : truths) {
    const std::vector<double> values = column(truth.column);
    double worst = 0.0;
    for (std::size_t k = 0; k < times.size(); ++k)
      worst = std::max(worst, std::abs(values[k] - truth.value(second * times[k]) / truth.scale));
    BOOST_TEST_MESSAGE(truth.column << " of " << times.size() << " states differs by at most " << worst << " (allowed "
                                    << truth.allowed << ")");
    BOOST_TEST(worst <= truth.allowed, truth.column << " differs by " << worst);
  }
}

std::string eccentric_lift() {
  std::string table = "angle [deg];lift [mm]\n";
  char row[80];
  for (int k = 0; k <= 360; k += 2) {
    std::snprintf(row, sizeof row, "%d;%.9f\n", k, 5.0 * (1.0 - std::cos(k * degree)));
    table += row;
  }
  return table;
}

const std::string cam =
    "[case]\nkind = cam\n[cam]\nbase_radius = 20e-3\nlift = lift.csv\nface_width = 10e-3\nrpm = 600\nspring_force = "
    "300\n"
    "spring_stiffness = 2e4\nmass = 0.4\n";
const std::string gear =
    "[case]\nkind = gear_mesh\n[gear]\nmodule = 4.5e-3\nteeth1 = 16\nteeth2 = 24\nshift1 = 0.1817\nshift2 = 0.1715\n"
    "face_width = 14e-3\ntorque1 = 135.5\nrpm1 = 2250\n";
const std::string stroke =
    "[case]\nkind = reciprocating\n[stroke]\nlength = 4e-3\nfrequency = 10\n[contact]\nload = 10\nradius_x = 0.01\n";
const std::string impact =
    "[case]\nkind = impact\n[impact]\nmass = 0.0329\nvelocity = 0.1\ngap = 2e-6\n[contact]\nradius_x = 0.01\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(test_courses)

// An eccentric disc: R = 25 mm, u1 = omega R, u2 = omega 5 mm cos(phi); spring, mass and lift give the load. It begins
// at 90 degrees.
BOOST_AUTO_TEST_CASE(an_eccentric_cam) {
  const support::TemporaryFolder folder;
  folder.write("lift.csv", eccentric_lift());
  const results::ResultFile file =
      support::solved(folder, "d", cam + "angle = 90\nstates = 36\n" + oil + states + line);
  const double omega = 20.0 * pi;
  const auto phi = [=](double t) { return 0.5 * pi + omega * t; };
  const auto load = [=](double t) {
    return 300.0 + 100.0 * (1.0 - std::cos(phi(t))) + 0.4 * omega * omega * 5e-3 * std::cos(phi(t));
  };
  compare(file,
          {{"radius_x", 0.025, [](double) { return 0.025; }, 1e-4},
           {"load", load(0.0), load, 1e-4},
           {"speed", omega * 0.0125, [=](double t) { return 0.5 * omega * (0.025 + 5e-3 * std::cos(phi(t))); }, 1e-4}});
  BOOST_TEST(std::abs(file.numbers("/scales/time").values.at(0) * file.numbers("/transient/time").values.back() - 0.1) <
             1e-9);
}

// Involutes: rho1 = s grows with omega r_b1 along the path, rho1 + rho2 is the distance of the base circles' tangent
// points. Load by AGMA 925, outside of the transitions at the steps.
BOOST_AUTO_TEST_CASE(teeth_along_their_path_in_time) {
  const support::TemporaryFolder folder;
  const results::ResultFile file = support::solved(
      folder, "d", gear + "states = 40\nsharing = none\n" + oil + states + line + "[multigrid]\ncycles = 4\n");
  // Centre distance and tip diameter are those published for the FZG test, type C.
  const double base1 = 36e-3 * std::cos(20.0 * degree), base2 = 1.5 * base1, omega = 75.0 * pi;
  const double length = std::sqrt(std::pow(91.5e-3, 2) - std::pow(base1 + base2, 2));
  const double begin = length - std::sqrt(std::pow(59.18e-3, 2) - base2 * base2);
  const auto rho = [=](double t) { return begin + omega * base1 * t; };
  const auto R = [=](double t) { return rho(t) * (length - rho(t)) / length; };
  const double pitch = (91.5e-3 / 2.5) * std::sin(std::acos((base1 + base2) / 91.5e-3));
  const double R_C = pitch * (length - pitch) / length;
  compare(file,
          {{"radius_x", R_C, R, 5e-4},
           {"load", 1.0, [](double) { return 1.0; }, 1e-12},
           {"speed", omega * pitch, [=](double t) { return 0.5 * omega * (rho(t) + (length - rho(t)) / 1.5); }, 5e-4}});
}

BOOST_AUTO_TEST_CASE(the_load_of_a_pair_of_teeth) {
  const support::TemporaryFolder folder;
  const results::ResultFile file = support::solved(folder, "d", gear + "states = 20\n" + oil + states + line);
  const std::vector<double> loads = file.numbers("/transient/load").values,
                            times = file.numbers("/transient/time").values;
  const auto near = [](double value, double truth) { return std::abs(value - truth) < 1e-9; };
  BOOST_TEST_MESSAGE("shares " << loads.front() << " at the beginning and " << loads.back() << " at the end (1/3)");
  BOOST_TEST((near(loads.front(), 1.0 / 3.0) && near(loads.back(), 1.0 / 3.0)));
  BOOST_TEST(near(std::ranges::max(loads), 1.0));
  double steepest = 0.0, shortest = times.back();
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double step = times[k] - times[k - 1];
    shortest = std::min(shortest, step / times.back());
    steepest = std::max(steepest, (loads[k] - loads[k - 1]) / step * times.back());
  }
  BOOST_TEST_MESSAGE("steps of " << shortest << " of the path (0.01), slope there " << steepest << " (30 to 34.5)");
  BOOST_TEST(shortest <= 0.01 + 1e-9);
  BOOST_TEST((steepest > 30.0 && steepest < 34.5));
}

BOOST_AUTO_TEST_CASE(a_stroke_is_a_cosine) {
  const support::TemporaryFolder folder;
  for (const auto& [word, share] : {std::pair{"rests", 0.5}, {"rolls", 1.0}}) {
    const results::ResultFile file = support::solved(
        folder, word,
        stroke + "E_prime = 2.26e11\n[lubricant]\neta0 = 0.5\nalpha = 2e-8\n[stroke]\nsecond_body = " + word +
            "\nstates = 20\n" + states + "[domain]\nx_inlet = -3\nx_outlet = 3\n[grid]\ncells = 64\n");
    const double fastest = 0.04 * pi;
    compare(file,
            {{"speed", fastest * share, [&](double t) { return fastest * share * std::cos(20.0 * pi * t); }, 1e-9}});
    BOOST_TEST(file.numbers("/transient/speed").values[5] == 0.0);
  }
}

// The thinner the oil, the drier the impact: by Aitken's extrapolation over three viscosities, the largest load is that
// of the dry impact and the ball leaves with its velocity. The work of the film is the change of the kinetic energy.
BOOST_AUTO_TEST_CASE(an_impact_through_thin_oil_is_dry) {
  const support::TemporaryFolder folder;
  double loads[3], restitutions[3], duration = 0.0;
  const std::pair<const char*, const char*> oils[] = {{"1e-2", "64"}, {"5e-3", "96"}, {"2.5e-3", "128"}};
  for (int k = 0; k < 3; ++k) {
    const results::ResultFile file =
        support::solved(folder, "d",
                        impact + "E_prime = 226e9\n[lubricant]\nalpha = 2e-8\neta0 = " + oils[k].first +
                            "\n[grid]\ncells = " + oils[k].second + "\n");
    loads[k] = support::summary(file, "body_largest_load");
    restitutions[k] = support::summary(file, "body_restitution");
    duration = support::summary(file, "body_contact_time");
    const std::vector<double> carried = support::column(file, "carried"), H00 = support::column(file, "H00"),
                              velocity = support::column(file, "velocity");
    double work = 0.0;
    for (std::size_t n = 1; n < H00.size(); ++n) work += 0.5 * (carried[n] + carried[n - 1]) * (H00[n] - H00[n - 1]);
    const double mass = 0.8;  // m v^2 = (4/5) F delta in the units of the dry impact
    const double change = 0.5 * mass * (velocity.back() * velocity.back() - velocity.front() * velocity.front());
    BOOST_TEST_MESSAGE("eta0 = " << oils[k].first << ": load " << loads[k] << ", restitution " << restitutions[k]
                                 << ", contact " << duration << "; work of the film " << work
                                 << ", change of the kinetic energy " << change << " (2e-4)");
    BOOST_TEST(std::abs(work - change) <= 2e-4);
  }
  const auto limit = [](const double(&x)[3]) {
    const double first = x[1] - x[0], second = x[2] - x[1];
    return x[2] + second * second / (first - second);
  };
  BOOST_TEST_MESSAGE("without oil: load " << limit(loads) << " (1 within 0.01), restitution " << limit(restitutions)
                                          << " (1 within 0.005); contact with the thinnest oil " << duration
                                          << " (2.943 within 0.15)");
  BOOST_TEST(std::abs(limit(loads) - 1.0) <= 0.01);
  BOOST_TEST(std::abs(limit(restitutions) - 1.0) <= 0.005);
  BOOST_TEST(std::abs(duration - 2.943) <= 0.15);
}

BOOST_AUTO_TEST_CASE(wrong_machines_in_time_are_refused) {
  const support::TemporaryFolder folder;
  folder.write("lift.csv", eccentric_lift());
  folder.write("open.csv", "angle,lift [mm]\n0,0\n10,1\n20,2\n30,3\n40,3\n50,3\n60,3\n70,3\n80,2\n");
  folder.write("rough.csv", "angle,lift [mm]\n0,0\n1,0\n2,0.1\n3,0.1\n4,0.3\n5,0.3\n6,0.1\n7,0.1\n8,0\n");
  // The lift of the eccentric disc, rounded to 0.05 mm.
  std::string rounded = "angle [deg];lift [mm]\n";
  char row[80];
  for (int k = 0; k <= 360; k += 2) {
    std::snprintf(row, sizeof row, "%d;%.2f\n", k, 0.05 * std::round(100.0 * (1.0 - std::cos(k * degree))));
    rounded += row;
  }
  folder.write("rounded.csv", rounded);
  const std::string time = "[transient]\ncycle = machine\n";
  std::string heavy = cam, straight = gear;
  heavy.replace(heavy.find("mass = 0.4"), 10, "mass = 50");
  // A contact ratio near 1: two pairs share the load on a short part of the path.
  straight.replace(straight.find("shift1"), 32, "addendum = 0.63\n");
  const struct {
    const char* name;
    std::string deck;
    std::vector<std::string> parts;
  } slips[] = {
      {"no machine", "[contact]\nM = 20\nL = 5\n[lubricant]\nalpha = 2e-8\n" + time, {"cycle", "cam, gear_mesh"}},
      {"a bearing",
       "[case]\nkind = ball_race\n[bearing]\ndiameter = 9.525e-3\npitch_diameter = 46e-3\nload = 500\n"
       "rpm_inner = 3000\n" +
           oil + time,
       {"cycle", "cam, gear_mesh"}},
      {"a load that is computed", cam + oil + "[contact]\nload_per_length = 1e4\n", {"load_per_length", "[cam]"}},
      {"a tappet that lifts off", heavy + oil, {"lifts off", "degrees"}},
      {"states without time", cam + "states = 20\n" + oil, {"states", "cycle"}},
      {"speeds of a stroke", stroke + oil + "[motion]\nu1 = 1\nu2 = 1\n", {"u1", "[stroke]"}},
      {"another unit of time", stroke + oil + time + "time_unit = contact\n", {"time_unit", "seconds"}},
      {"a transition without steps", gear + "sharing = none\ntransition = 0.02\n" + oil + time, {"transition"}},
      {"a long transition", straight + "transition = 0.1\n" + oil + time, {"transition", "one pair"}},
      {"the mass of an impact", impact + oil + "[body]\nmass_kg = 1\n", {"mass_kg", "[impact]"}},
      {"the load of an impact", impact + oil + "[contact]\nload = 1\n", {"load", "[impact]"}},
      {"an impact of lines", impact + oil + "[contact]\nkind = line\n", {"kind", "point"}},
      {"an impact of coated bodies",
       impact + oil + "[contact]\ncoating1_E = 1e11\ncoating1_nu = 0.3\ncoating1_thickness = 1e-6\n",
       {"coating1_E", "impact"}},
      {"a contact that grows out of its domain",
       gear + "position = 0.05\n" + oil + time,
       {"cycle", "grows to", "x_outlet"}},
      {"a load that grows too much",
       "[contact]\nM = 20\nL = 5\n[lubricant]\nalpha = 2e-8\n[transient]\nend_time = 2\nload = 0:1 1:6\n",
       {"load", "1.82 Hertz radii"}},
      {"teeth that are out of mesh", gear + oil + time + "end_time = 4e-3\n", {"end_time", "[gear]"}},
      {"an impact without modulus", impact + "[lubricant]\neta0 = 0.02\nalpha = 2e-8\n", {"E_prime"}}};
  for (const auto& slip : slips) support::check_refused(folder, {slip.name, slip.deck, slip.parts});
  for (const auto& [file, part] :
       {std::pair{"open.csv", "must be 0"}, {"rough.csv", "convex"}, {"rounded.csv", "digits"}}) {
    std::string deck = cam + oil;
    deck.replace(deck.find("lift.csv"), 8, file);
    support::check_refused(folder, {file, deck, {"lift", part}});
  }
}

BOOST_AUTO_TEST_SUITE_END()
