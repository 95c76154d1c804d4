// Friction at every step of a run in time: the steady friction, mirrored contacts, the balance of power, resume.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

#include "support/columns.hpp"
#include "support/program.hpp"
#include "support/refused.hpp"
#include "support/solved.hpp"
#include "support/stopped.hpp"
#include "support/text.hpp"

using namespace ehl;
using support::column;
using support::distance;
using support::largest;
using support::solved;
using support::summary;

namespace {

const std::string oil = "a_over_R = 0.01\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n";
const std::string point = "[contact]\nM = 50\nL = 10\n" + oil + "[grid]\ncells = 64\n";
const std::string ellipse = "[contact]\nM = 50\nL = 10\nradius_ratio = 0.3\n" + oil + "[grid]\ncells = 64\n";
const std::string line =
    "[contact]\nkind = line\nM = 20\nL = 5\n" + oil + "[grid]\ncells = 256\n[multigrid]\ntolerance = 1e-10\n";
const std::string rubs = "[friction]\ncavitated = striated\nlimit = 0.08\nfields = tau1, tau2\n";
const std::string thins = "[shear]\nlaw = eyring\ntau_0 = 5e6\n";
const std::string small = "[domain]\nfar_field = zero\nx_inlet = -2.5\nx_outlet = 1.5\ny_half = 2\n";

std::string sliding(double srr) {
  std::ostringstream text;
  text << "[motion]\nsrr = " << srr << "\n";
  return text.str();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_friction_in_time)

BOOST_AUTO_TEST_CASE(a_steady_run_keeps_the_steady_friction) {
  const support::TemporaryFolder folder;
  const std::string time = "[transient]\nend_time = 1\noutput_interval = 0.5\n";
  for (const std::string& contact : {point, ellipse, line, point + thins, line + thins}) {
    const results::ResultFile file = solved(folder, "steady", contact + sliding(0.4) + rubs + time);
    for (const std::string figure : {"transient_friction", "traction_lines"}) {
      const support::Ended drawn = support::ehl(folder, "plot steady.h5 --format svg --figure " + figure);
      BOOST_TEST(drawn.status == 0, drawn.err);
    }
    for (const char* const name : {"mu", "mu_rolling", "mu_1", "mu_2"}) {
      const double steady = summary(file, name);
      double worst = 0.0;
      for (const double mu : column(file, name)) worst = std::max(worst, std::abs(mu / steady - 1.0));
      BOOST_TEST_MESSAGE(name << " = " << steady << ", largest relative change in time " << worst << " (1e-6)");
      BOOST_TEST(worst < 1e-6);
    }
    BOOST_TEST(distance(column(file, "force_1"), column(file, "mu_1")) < 1e-9);  // the load is that of the contact
    const std::vector<double> of_frame = file.frame("/transient/frames/tau1", 2).values;
    BOOST_TEST(distance(of_frame, file.numbers("/fields/tau1").values) < 1e-6 * largest(of_frame));
  }
}

// A dimple on a surface at rest is a steady contact, whose friction a deck without [transient] gives.
BOOST_AUTO_TEST_CASE(a_feature_at_rest_has_the_steady_friction) {
  const support::TemporaryFolder folder;
  const std::string dimple = "[surface1]\nshape = dimple\nheight = 0.05\nwidth = 0.6\nx = -0.3\n";
  const std::string deck = point + small + sliding(-2.0) + "[friction]\ncavitated = striated\n" + dimple;
  const results::ResultFile steady = solved(folder, "rest", deck + "at_rest = yes\n");
  const results::ResultFile timed = solved(folder, "timed", deck + "[transient]\nend_time = 8\nrtol = 1e-5\n");
  for (const char* const name : {"mu", "mu_rolling", "mu_1"}) {
    const double is = column(timed, name).back(), wanted = summary(steady, name), smooth = summary(timed, name);
    BOOST_TEST_MESSAGE(name << " = " << is << ", steady " << wanted << ", smooth " << smooth);
    BOOST_TEST(std::abs(is / wanted - 1.0) <
               3e-4);  // the time integration, rtol = 1e-5, where mu depends strongly on H
    BOOST_TEST(std::abs(smooth / wanted - 1.0) > 2e-3);  // the dimple matters
  }
}

BOOST_AUTO_TEST_CASE(exchanged_speeds_mirror_the_friction) {
  const support::TemporaryFolder folder;
  const auto of = [](const char* u1, const char* u2) {
    return point + rubs + "[transient]\nend_time = 1\nload_wave = 0.2 1\n" + u1 + u2;
  };
  const std::string fast = "0:1.3 1:1.1", slow = "0:0.7 1:0.6";
  const results::ResultFile one =
      solved(folder, "one", of(("u1 = " + fast + "\n").c_str(), ("u2 = " + slow + "\n").c_str()));
  const results::ResultFile other =
      solved(folder, "other", of(("u1 = " + slow + "\n").c_str(), ("u2 = " + fast + "\n").c_str()));
  const std::pair<std::string, std::string> pairs[] = {{"mu", "mu"}, {"slide_roll_ratio", "slide_roll_ratio"}};
  for (const auto& [name, same] : pairs) BOOST_TEST(distance(column(one, name), column(other, same), -1.0) < 1e-12);
  BOOST_TEST(distance(column(one, "mu_rolling"), column(other, "mu_rolling")) < 1e-12);
  BOOST_TEST(distance(column(one, "force_1"), column(other, "force_2")) < 1e-12);
  BOOST_TEST(distance(column(one, "friction_power"), column(other, "friction_power")) < 1e-12);
  BOOST_TEST(largest(column(one, "mu")) > 0.01);
}

BOOST_AUTO_TEST_CASE(threads_and_resume_keep_the_columns) {
  const support::TemporaryFolder folder;
  const std::string deck = "[contact]\nM = 50\nL = 10\n" + oil + small + "[grid]\ncells = 128\n" + sliding(0.5) + rubs +
                           "[surface1]\nshape = bump\nheight = 0.05\nwidth = 0.5\nx = -1.5\n"
                           "[transient]\nend_time = 0.4\noutput_interval = 0.1\n";
  solved(folder, "one", deck, "--threads 1");
  solved(folder, "two", deck, "--threads 2");
  for (const std::string what : {"/transient/mu", "/transient/mu_1", "/transient/force_2", "/transient/friction_power"})
    BOOST_TEST((support::rows_of(support::ehl(folder, "extract one.h5 " + what).out) ==
                support::rows_of(support::ehl(folder, "extract two.h5 " + what).out)));
  BOOST_TEST_REQUIRE(
      support::stopped_where(folder, "run one.ini --output half.h5 --quiet", support::between_two_steps).status == 130);
  const support::Ended resumed = support::ehl(folder, "resume half.h5 --quiet");
  BOOST_TEST_REQUIRE(resumed.status == 0, resumed.err);
  const results::ResultFile whole(folder / "one.h5"), half(folder / "half.h5");
  BOOST_TEST((whole.names("/transient") == half.names("/transient")));
  BOOST_TEST((whole.names("/transient/frames") == half.names("/transient/frames")));
  const double mu = column(whole, "mu").back(), again = column(half, "mu").back();
  BOOST_TEST_MESSAGE("mu at the end " << mu << ", after a stop " << again << " (1e-4: another choice of steps)");
  BOOST_TEST(std::abs(again / mu - 1.0) < 1e-4);
  const std::vector<double> tau = whole.frame("/transient/frames/tau1", 1).values;
  BOOST_TEST(distance(tau, half.frame("/transient/frames/tau1", 1).values) < 1e-3 * largest(tau));
}

BOOST_AUTO_TEST_CASE(what_is_refused) {
  const support::TemporaryFolder folder;
  const std::string time = "[transient]\nend_time = 1\n";
  support::check_refused(folder, {"thinning by the flow and a checkpoint",
                                  point + time + sliding(0.5) + thins + "flow = on\n[output]\ncheckpoint = 60\n",
                                  {"[output] checkpoint", "flow = on"}});
  support::check_refused(folder, {"two values of the sliding",
                                  point + sliding(0.5) + rubs + time + "u1 = 0:1.1 1:1\n",
                                  {"[transient] u1", "[motion]"}});
  support::check_refused(
      folder, {"no size", "[contact]\nM = 50\nL = 10\n[lubricant]\nalpha = 1.7e-8\n" + rubs + time, {"a_over_R"}});
}

// Work of the friction and of the load against the heat of the film, with an incompressible oil, in F_0 a:
//   int (friction power) dt + int load (-dH00) a/R - change of the elastic energy (1/2) int P w = int heat dt,
// heat = stress (u1 - u2)^2 eta_bar/H + (a/R) H^3 |grad P|^2/(lambda eta_bar) at every node, from the stored fields.
struct Balance {
  double work = 0.0, heat = 0.0;
};

Balance balance(const support::TemporaryFolder& folder, int cells, double srr, const std::string& more) {
  std::ostringstream deck;
  deck << "[contact]\nM = 20\nL = 5\na_over_R = 0.01\n[lubricant]\nviscosity = barus\nalpha = 1.7e-8\ndensity = "
          "incompressible\n"
       << small << "[grid]\ncells = " << cells << "\n"
       << sliding(srr)
       << "[friction]\ncavitated = full\n[transient]\nend_time = 1\noutput_interval = 0.01\nrtol = 1e-5\n"
       << more;
  const results::ResultFile file = solved(folder, "balance", deck.str());
  const double lambda = file.numbers("/scales/lambda").values[0], alpha = file.numbers("/scales/alpha_bar").values[0];
  constexpr double slope = 0.01, W = 2.0 * 3.14159265358979 / 3.0;
  const std::vector<double> x = file.numbers("/grid/x").values, y = file.numbers("/grid/y").values;
  const double h = x[1] - x[0];
  const std::vector<double> T = column(file, "time"), power = column(file, "friction_power");
  const std::vector<double> H00 = column(file, "H00"), load = column(file, "load");
  Balance sum;
  for (std::size_t k = 1; k < T.size(); ++k)
    sum.work += 0.5 * (power[k] + power[k - 1]) * (T[k] - T[k - 1]) -
                slope * 0.5 * (load[k] + load[k - 1]) * (H00[k] - H00[k - 1]);
  const std::vector<double> times = file.numbers("/transient/frames/time").values;
  double before = 0.0, elastic_at_start = 0.0;
  for (std::size_t frame = 0; frame < times.size(); ++frame) {
    const std::vector<double> P = file.frame("/transient/frames/P", frame).values;
    const std::vector<double> H = file.frame("/transient/frames/H", frame).values;
    const std::size_t nx = x.size(), ny = y.size();
    const auto at = std::ranges::min_element(T, {}, [&](double t) { return std::abs(t - times[frame]); });
    const double rigid = H00[static_cast<std::size_t>(at - T.begin())];
    double heat = 0.0, elastic = 0.0;
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i) {
        const std::size_t n = j * nx + i;
        const double slip = srr > 0.0 ? srr + 0.2 * times[frame] : 0.0;  // of the schedule below
        const double edge = (i == 0 || i == nx - 1 ? 0.5 : 1.0) * (j == 0 || j == ny - 1 ? 0.5 : 1.0);
        heat += edge * h * h * (lambda * slope / 12.0) * slip * slip * std::exp(alpha * P[n]) / (H[n] * W);
        elastic += edge * h * h * 0.5 * slope / W * P[n] * (H[n] - rigid - 0.5 * (x[i] * x[i] + y[j] * y[j]));
        // The flow through the faces, as the Reynolds equation has it: the mean of both nodes.
        const auto face = [&](std::size_t m, double share) {
          const double H_face = 0.5 * (H[n] + H[m]), dP = (P[m] - P[n]) / h;
          heat += share * h * h * slope / (lambda * W) * H_face * H_face * H_face *
                  std::exp(-0.5 * alpha * (P[n] + P[m])) * dP * dP;
        };
        if (i + 1 < nx) face(n + 1, j == 0 || j == ny - 1 ? 0.5 : 1.0);
        if (j + 1 < ny) face(n + nx, i == 0 || i == nx - 1 ? 0.5 : 1.0);
      }
    if (frame == 0) elastic_at_start = elastic;
    if (frame > 0) sum.heat += 0.5 * (heat + before) * (times[frame] - times[frame - 1]);
    if (frame + 1 == times.size()) sum.work -= elastic - elastic_at_start;
    before = heat;
  }
  return sum;
}

BOOST_AUTO_TEST_CASE(power_is_balanced) {
  const support::TemporaryFolder folder;
  for (const std::string& more :
       std::vector<std::string>{"", "load_wave = 0.3 1.3\n", "u1 = 0:1.2 1:1.5\nu2 = 0:0.8 1:0.9\n"}) {
    const double srr = more.starts_with("u1") ? 0.4 : 0.0;
    double error[2] = {};
    for (int k = 0; k < 2; ++k) {
      const Balance found = balance(folder, 64 << k, srr, more);
      error[k] = std::abs(found.work / found.heat - 1.0);
      BOOST_TEST_MESSAGE((64 << k) << " cells, " << more << " work " << found.work << ", heat " << found.heat
                                   << ", relative difference " << error[k]);
    }
    BOOST_TEST(error[1] < 0.005);
    BOOST_TEST(error[1] < 0.5 * error[0]);
  }
}

BOOST_AUTO_TEST_SUITE_END()
