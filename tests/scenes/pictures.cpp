// `ehl plot` in use: every picture without a message from gnuplot, in SI, at a given time, in the size of a journal.
#include <boost/algorithm/string/replace.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

#include "support/columns.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

namespace {

using support::contains;

const std::string steel =
    "[case]\ntitle = steel 'ball' on glass\n[contact]\nload = 20\nradius_x = 0.010\nE_prime = 1.2e11\n[motion]\nu_m = "
    "0.5\n"
    "[lubricant]\neta0 = 0.08\nalpha = 2e-8\n[domain]\nx_inlet = -4\ny_half = 3\n[grid]\ncells = 64\n";
// The load doubles, so the last field has another film than the start.
const std::string in_time =
    " --set transient.end_time=1.2e-3 --set transient.time_unit=seconds "
    "--set transient.output_interval=4e-4 --set 'transient.load=0:1 5e-4:2'";

struct Scene {
  support::TemporaryFolder folder;
  Scene() { folder.write("s.ini", steel); }
  support::Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }

  // Draws a picture; gnuplot must print nothing.
  std::string drawn(const std::string& arguments) const {
    const support::Ended ended = ehl("plot " + arguments);
    BOOST_TEST(ended.status == 0, arguments);
    BOOST_TEST(ended.err.empty(), arguments << " says\n" << ended.err);
    return ended.out;
  }
  // The film in nm at the centre, at a time of the run.
  double centre_nm(const std::string& step) const {
    std::istringstream lines(ehl("extract s.h5 /transient/frames/H --si --along x --at y=0 --step " + step).out);
    double nearest = 1e9, film = 0.0;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream numbers(line);
      double x = 0.0, h = 0.0;
      if (numbers >> x >> h && std::abs(x) < nearest) {
        nearest = std::abs(x);
        film = h;
      }
    }
    return film;
  }
};

// "h_c = 259 nm" in an interferogram; gnuplot writes subscripts as separate texts.
double film_said(const std::string& svg) {
  const std::size_t nm = svg.find(" nm");
  BOOST_REQUIRE(nm != std::string::npos);
  return std::stod(svg.substr(svg.rfind("= ", nm) + 2));
}

// The right-hand axis is that of the film; only its labels are left-aligned at their position.
int film_marks_below_zero(const std::string& svg) {
  int marks = 0;
  for (std::size_t at = svg.find("text-anchor=\"start\""); at != std::string::npos;
       at = svg.find("text-anchor=\"start\"", at + 1)) {
    const std::size_t text = svg.find("</tspan>", at);
    const std::size_t begin = svg.rfind('>', text) + 1;
    marks += svg[begin] == '-' && svg.find_first_of("0123456789", begin) == begin + 1;
  }
  return marks;
}

// The width in points of 1/72 inch.
double width_of_pdf(const std::string& pdf) {
  std::istringstream box(pdf.substr(pdf.find("/MediaBox [") + 11));
  double x0 = 0.0, y0 = 0.0, x1 = 0.0;
  box >> x0 >> y0 >> x1;
  return x1 - x0;
}

int width_of_png(const std::string& png) {
  int width = 0;
  for (std::size_t k = 16; k < 20; ++k) width = 256 * width + static_cast<unsigned char>(png.at(k));
  return width;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_pictures)

BOOST_AUTO_TEST_CASE(every_figure_of_every_kind_of_result_is_drawn_in_its_units) {
  const Scene scene;
  scene.folder.write("d.ini", "[case]\nkind = dry\n[subsurface]\ndepth = 2\n[grid]\ncells = 64\n");
  scene.folder.write("m.ini",
                     "[contact]\nM = 20\nL = 10\nradius_ratio = 0.5\n[motion]\nangle = 30\n[lubricant]\nalpha = "
                     "2.2e-8\n[grid]\ncells = 64\n[output]\nfields = P, H, error_map_Hc, error_map_Hm\n");
  BOOST_REQUIRE(scene.ehl("run d.ini").status == 0);
  BOOST_REQUIRE(scene.ehl("run m.ini").status == 0);
  BOOST_REQUIRE(scene
                    .ehl("run s.ini --output w.h5 --set motion.srr=2 --set surface2.shape=waviness --set "
                         "surface2.height_m=5e-8 --set surface2.width_m=6e-5")
                    .status == 0);
  BOOST_TEST(contains(scene.drawn("d.h5 --format svg"), "d_subsurface_stress.svg"));
  const std::string drawn = scene.drawn("m.h5 --format svg");
  BOOST_TEST(contains(drawn, "m_interferogram.svg"));
  BOOST_TEST(contains(drawn, "m_error_map.svg"));
  scene.drawn("w.h5 --format svg --figure roughness --figure film_contours --figure centre_lines");
  const std::string own = scene.folder.read("m_film_contours.svg"), si = scene.folder.read("w_film_contours.svg");
  BOOST_TEST(contains(own, "X = x/a"));
  BOOST_TEST(contains(si, "x [µm]"));
  BOOST_TEST(contains(si, "h [nm]"));
  BOOST_TEST(contains(scene.folder.read("w_centre_lines.svg"), "p [GPa]"));
  // Figures about the solver are drawn only if they are asked for.
  BOOST_TEST(scene.folder.read("m_level_ladder.svg").empty());
  BOOST_TEST(contains(scene.drawn("m.h5 --figure level_ladder --figure time_against_nodes"), "m_level_ladder.png"));
}

BOOST_AUTO_TEST_CASE(a_run_in_time_shows_its_last_field_or_the_one_asked_for) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run s.ini" + in_time).status == 0);
  BOOST_TEST(contains(scene.drawn("s.h5 --format svg"), "s_transient_map.svg"));
  const double start = scene.centre_nm("0"), second = scene.centre_nm("1"), last = scene.centre_nm("last");
  BOOST_TEST_MESSAGE("film at the centre " << start << ", " << second << ", at the end " << last << " nm");
  BOOST_REQUIRE(std::abs(start - last) > 5.0);
  const std::string svg = scene.folder.read("s_interferogram.svg");
  BOOST_TEST(contains(svg, "t = 1.2 ms"));
  BOOST_TEST(std::abs(film_said(svg) - last) <= 0.51);  // printed in whole nm
  scene.drawn("s.h5 --figure interferogram --time 3.5e-4 --output then.svg");
  const std::string then = scene.folder.read("then.svg");
  BOOST_TEST(contains(then, "t = 0.4 ms"));
  BOOST_TEST(std::abs(film_said(then) - second) <= 0.51);
  scene.drawn("s.h5 --figure transient_steps");
  BOOST_TEST(scene.ehl("plot s.h5 --figure transient_movie").status == 0);
  BOOST_TEST(scene.folder.read("s_transient_movie.gif").starts_with("GIF89a"));
}

// Every figure carries a red note, and a negative film stays visible: cut off at zero, the rest would
// look like a valid result.
BOOST_AUTO_TEST_CASE(a_result_that_did_not_converge_says_so_on_every_figure) {
  const Scene scene;
  const std::string mark = "NOT CONVERGED";
  BOOST_REQUIRE(scene.ehl("run s.ini").status == 0);
  BOOST_REQUIRE(scene
                    .ehl("run s.ini --output few.h5 --set subsurface.depth=2 --set multigrid.tolerance=1e-13 "
                         "--set multigrid.max_cycles=1 --set multigrid.cycles=1")
                    .status == 3);
  BOOST_REQUIRE(scene.ehl("run s.ini --output thin.h5 --set grid.cells=32 --set motion.u_m=0.001").status == 3);
  for (const char* file : {"s", "few", "thin"}) {
    const std::string one = file;
    std::istringstream names(scene.drawn(one + ".h5 --format svg") +
                             scene.drawn(one + ".h5 --format svg --figure level_ladder"));
    int figures = 0;
    for (std::string name; std::getline(names, name); ++figures)
      BOOST_TEST(contains(scene.folder.read(name), mark) == (one != "s"), name);
    BOOST_TEST(figures >= 5);
  }
  BOOST_TEST(film_marks_below_zero(scene.folder.read("thin_centre_lines.svg")) > 0);
  BOOST_TEST(film_marks_below_zero(scene.folder.read("s_centre_lines.svg")) == 0);
}

// Tick labels with many digits push the label of the axis no further than the edge of the page. Half of the last tick
// label lies beyond its axis.
BOOST_AUTO_TEST_CASE(words_beside_long_marks_stay_on_the_page) {
  const Scene scene;
  scene.folder.write("t.csv",
                     "# ehl sweep, table 1\n# vary: motion.u_m = 100,1000,10000\n# units: h_c_nm [nm]\n"
                     "motion.u_m,status,h_c_nm\n100,converged,95000\n1000,converged,200000\n"
                     "10000,converged,290000\n");
  for (const char* axes : {"linear", "log"}) {
    scene.drawn(std::string("t.csv --format svg --y h_c_nm --axes ") + axes);
    const std::string svg = scene.folder.read("t_curves.svg");
    const double letter = 10.67;  // px, the height of a line
    const std::size_t turned = svg.find(" rotate(270)");
    BOOST_REQUIRE(turned != std::string::npos);
    BOOST_TEST(std::stod(svg.substr(svg.rfind("translate(", turned) + 10)) > letter, axes);
    const std::size_t last = svg.find("10000</tspan>");
    BOOST_REQUIRE(last != std::string::npos);
    const double width = std::stod(svg.substr(svg.find("width=\"") + 7));
    const double half = 0.5 * 5 * 0.636 * letter;  // half the width of five digits
    BOOST_TEST(std::stod(svg.substr(svg.rfind("translate(", last) + 10)) + half < width, axes);
  }
}

// Separated bodies: no empty page for the pressure, and no label pushed off the page by long numbers.
BOOST_AUTO_TEST_CASE(bodies_that_are_apart_have_figures_of_their_own) {
  const Scene scene;
  BOOST_REQUIRE(
      scene
          .ehl("run s.ini --set transient.end_time=0.02 --set transient.load=0:0 --set body.mass_kg=0.03 "
               "--set body.gap_m=20e-6 --set body.velocity_mps=0.01 --set transient.u1=0:0 --set transient.u2=0:0")
          .status == 0);
  const std::string drawn = scene.drawn("s.h5 --format svg");
  BOOST_TEST(!contains(drawn, "pressure_contours"), drawn);
  BOOST_TEST(contains(drawn, "s_film_contours.svg"));
  BOOST_TEST(contains(scene.folder.read("s_interferogram.svg"), "630 nm"));
  const support::Ended asked = scene.ehl("plot s.h5 --figure pressure_contours");
  BOOST_TEST(asked.status == 2);
}

// The contact is 19 times as wide as long, and so is its map, including its grid of places for labels.
BOOST_AUTO_TEST_CASE(a_slender_contact_has_its_contours) {
  const Scene scene;
  BOOST_REQUIRE(scene
                    .ehl("run s.ini --set contact.radius_ratio=0.01 --unset domain.x_inlet --unset domain.y_half "
                         "--output r.h5")
                    .status == 0);
  const std::string drawn = scene.drawn("r.h5 --figure film_contours --figure pressure_contours --format svg");
  BOOST_TEST(drawn == "r_film_contours.svg\nr_pressure_contours.svg\n");
}

// A table without known errors: the films have no error bars.
BOOST_AUTO_TEST_CASE(a_sweep_without_error_bars_is_drawn) {
  const Scene scene;
  scene.folder.write("m.ini", "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2e-8\n[grid]\ncells = 64\n");
  BOOST_REQUIRE(scene.ehl("sweep m.ini --vary contact.M=20,50,100 --output t.csv").status == 0);
  std::string table = scene.folder.read("t.csv");
  for (const auto& row : support::named_rows(table))
    for (const char* name : {"error_Hc", "error_Hm"}) boost::replace_all(table, "," + row.at(name) + ",", ",NaN,");
  BOOST_REQUIRE(support::named_rows(table).at(2).at("error_Hc") == "NaN");
  scene.folder.write("t.csv", table);
  scene.drawn("t.csv --format svg");
}

BOOST_AUTO_TEST_CASE(pictures_have_the_size_and_the_name_asked_for) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run s.ini").status == 0);
  scene.drawn("s.h5 --figure film_contours --width 85mm --output fig3.pdf --title ''");
  const double width = width_of_pdf(scene.folder.read("fig3.pdf"));
  BOOST_TEST_MESSAGE("85 mm are " << width << " pt (240.9, whole points are enough)");
  BOOST_TEST(std::abs(width - 85.0 / 25.4 * 72.0) <= 1.0);
  scene.drawn("s.h5 --figure film_contours --width 1200px --output wide.png");
  BOOST_TEST(width_of_png(scene.folder.read("wide.png")) == 1200);
  scene.drawn("s.h5 --figure film_contours --width single --output own.png");
  BOOST_TEST(std::abs(width_of_png(scene.folder.read("own.png")) - 90.0 / 25.4 * 300.0) <= 1.0);
  BOOST_TEST(scene.drawn("s.h5 --figure film_contours --figure centre_lines --output f") ==
             "f_film_contours.png\nf_centre_lines.png\n");
  // A digit that follows an escaped character.
  BOOST_REQUIRE(support::shell(scene.folder, "cp s.h5 'a=0 (1).h5'").status == 0);
  BOOST_TEST(scene.drawn("'a=0 (1).h5' --figure centre_lines --format svg") == "a=0 (1)_centre_lines.svg\n");
  for (const std::string line : {"--width 85cm", "--width 5mm", "--width 800px --format pdf", "--format gif",
                                 "--figure film_contours --output a.eps", "--figure film_contours --output none/",
                                 "--figure film_contours --output none/a.png",
                                 "--figure film_contours --output a.pdf --format png", "--time 0", "--x motion.u_m"}) {
    const support::Ended ended = scene.ehl("plot s.h5 " + line);
    BOOST_TEST(ended.status == 2, line);
    BOOST_TEST(!ended.err.empty(), line);
  }
}

BOOST_AUTO_TEST_CASE(a_movie_is_a_gif_and_times_lie_in_the_run) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run s.ini --set transient.end_time=0.02").status == 0);
  const support::Ended movie = scene.ehl("plot s.h5 --figure transient_movie --format pdf");
  BOOST_TEST(movie.status == 2);
  BOOST_TEST(movie.says({"transient_movie"}), movie.err);
  const support::Ended late = scene.ehl("plot s.h5 --time 3");
  BOOST_TEST(late.status == 2);
  BOOST_TEST(late.says({"--time 3", "0.02 a/u_m"}), late.err);
}

BOOST_AUTO_TEST_CASE(help_lists_the_figures) {
  const Scene scene;
  const std::string help = scene.ehl("plot --help").out;
  for (const char* part : {"--width W", "90 mm", "film_contours", "/fields/H", "transient_movie", "motion.srr, mu"})
    BOOST_TEST(contains(help, part), part);
}

BOOST_AUTO_TEST_CASE(film_against_speed_is_one_picture_of_one_sweep) {
  const Scene scene;
  BOOST_REQUIRE(
      scene.ehl("sweep s.ini --vary motion.u_m=0.2,0.5,1 --vary contact.load=20,40 --set contact.Sq1=20e-9").status ==
      0);
  BOOST_TEST(scene.drawn("s_sweep.csv --format svg") == "s_sweep_curves.svg\n");
  const std::string svg = scene.folder.read("s_sweep_curves.svg");
  for (const char* part : {"h [nm]", "Hamrock, Dowson 1977", "= 40 N"}) BOOST_TEST(contains(svg, part), part);
  scene.drawn("s_sweep.csv --x contact.load --y lambda_ratio --by motion.u_m --axes linear");
  // Friction is drawn with linear axes and in per cent.
  BOOST_REQUIRE(scene
                    .ehl("sweep s.ini --vary motion.srr=0.01,0.1,0.5 --set shear.law=eyring --set shear.tau_0=5e6 "
                         "--set friction.cavitated=striated --output mtm.csv")
                    .status == 0);
  BOOST_TEST(scene.drawn("mtm.csv --format svg") == "mtm_traction_curve.svg\n");
  BOOST_TEST(contains(scene.folder.read("mtm_traction_curve.svg"), "[%]"));
  // Values that are all zero have an axis too.
  scene.folder.write("0.csv", "# ehl sweep, table 1\n# vary: motion.srr = 0\nmotion.srr,status,mu\n0,converged,0\n");
  BOOST_TEST(scene.drawn("0.csv --x motion.srr --y mu --format svg") == "0_curves.svg\n");
}

BOOST_AUTO_TEST_SUITE_END()
