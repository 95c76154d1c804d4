#include "effects/roller/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/interpolators/makima.hpp>
#include <cmath>
#include <memory>
#include <utility>

#include "deck/record.hpp"
#include "deck/text_table.hpp"
#include "effects/roller/trace.hpp"

namespace ehl::roller {
namespace {

deck::Condition of(const char* shape) { return {.name = "profile", .words = {shape}}; }

deck::Records<Profile> shape_records() {
  using namespace deck::record;
  return {
      key("end_length", in_SI("_m", "m", "0.0005"), positive, required("give it, or end_length_m for a contact in SI"),
          of("straight"), example("4"), "Length of each rounded end of a straight roller, in half widths a."),
      key("end_radius", in_SI("_m", "m", "0.05"), positive, required("give it, or end_radius_m for a contact in SI"),
          of("straight"), example("5"),
          "Radius of the rounded ends over R_x. An end falls by the square of the distance from the straight part, "
          "over twice this radius. The radius must not be smaller than end_length."),
      key("crown_radius", in_SI("_m", "m", "10"), positive, required("give it, or crown_radius_m for a contact in SI"),
          of("crowned"), example("2000"),
          "Radius of a crowned roller along its axis, over R_x. It must be at least half of the roller's length."),
      key("design_load", in_SI("_N", "N", "3000", positive), up_to(10.0), of("logarithmic"), example("1.5"),
          otherwise("the load of the contact"),
          "Load for which a logarithmic profile is designed, over the load of the contact.",
          remedy("a profile for more than ten times the load does not belong to this contact"),
          source("Lundberg 1939; Johns and Gohar 1981")),
      key("shortest_wave", in_SI("_m", "m", "2.5e-4"), positive, of("table"), example("4"),
          "Cut-off wavelength of a measured profile, in half widths a. A Gaussian filter "
          "removes shorter waves; a wave of this length keeps half of its height. The form "
          "is kept up to the ends. Without this key the profile is not filtered.",
          source("ISO 16610-31, second order, not robust")),
      key("levelling", by_default("none"), words({"none", "line"}), of("table"),
          "What is subtracted from a measured profile. none: nothing. line: the straight line of least squares, "
          "which is the tilt of the roller in the instrument."),
      key("file", of("table"), required("give the table of y and drop"), example("profile.csv"), file,
          "Profile as a table with the columns y and drop, the distance by which the surface lies below the middle "
          "of the roller, in m; in a and a^2/R for a contact without units. A heading may name other units, y [mm] "
          "and drop [um]. It needs at least four rows with rising y, from end to end or from the middle to one end "
          "(then mirrored), and must not reach beyond ten times half of the length. Values between the rows are "
          "interpolated smoothly.")};
}

deck::Records<Profile> records() {
  using namespace deck::record;
  using enum Profile::Shape;
  return deck::together<deck::Record<Profile>>(
      {{key("profile", &Profile::shape,
            {{"straight", straight}, {"crowned", crowned}, {"logarithmic", logarithmic}, {"table", table}},
            example("logarithmic"),
            "Profile of the roller along its axis. straight: with rounded ends, by end_length and end_radius. "
            "crowned: a circular arc of crown_radius. logarithmic: the profile that gives a uniform dry pressure "
            "at the design load. table: from a file. The gap ends at the ends of the roller; the bodies deform as "
            "half-spaces, which is not accurate at a sharp end. Used only with [contact] kind = roller, or with "
            "[case] kind = roller_race or gear_mesh (the face width of a tooth).",
            source("modules/effects/roller/README.md"))},
       shape_records(),
       {key("tilt", in_SI("_mrad", "mrad", "0.5"), Range{-100.0, 100.0}, by_default("0"), needs("profile"),
            example("0.01"),
            "Misalignment of the roller, as the slope dH/dY of the gap; the unit is a/R of an angle. The gap opens "
            "towards y > 0. At least a tenth of the roller's length must carry load, estimated by a slice "
            "model.")}});
}

// Reads the table. returns what is wrong with the file; empty if nothing is.
std::string read_table(const std::string& path, const Scales& scales, Profile& profile) {
  const double unit_Y = scales.in_SI ? scales.a : 1.0;
  const double unit_H = scales.in_SI ? scales.a * scales.a / scales.radius : 1.0;
  std::vector<double> Y, H;
  const deck::ReadColumns read =
      deck::read_columns(path, {{{"y"}, scales.in_SI ? "m" : "a"}, {{"drop", "z"}, scales.in_SI ? "m" : "a^2/R"}});
  if (const auto* wrong = std::get_if<std::string>(&read)) return *wrong;
  for (const deck::ColumnRow& row : std::get<deck::ColumnTable>(read).rows) {
    const std::vector<double>& value = row.values;
    if (!Y.empty() && value[0] / unit_Y <= Y.back()) return row.place + ": y must rise from row to row";
    Y.push_back(value[0] / unit_Y);
    H.push_back(value[1] / unit_H);
  }
  if (Y.size() < 4) return path + ": a table needs at least four rows";
  const double half = 0.5 * profile.length;
  constexpr double rounding = 1e-9, most_halves = 10.0;
  if (std::max(-Y.front(), Y.back()) > most_halves * half)
    return fmt::format(
        "{}: y goes from {:.4g} to {:.4g}, more than ten times half of the roller's length, {:.4g}; y and drop must be "
        "in {}",
        path, Y.front() * unit_Y, Y.back() * unit_Y, half * unit_Y, scales.in_SI ? "metres" : "half widths and a^2/R");
  const char* unit = scales.in_SI ? "m" : "half widths";
  const bool mirrored = std::abs(Y.front()) <= rounding * half;
  if (Y.back() < half * (1.0 - rounding) || (!mirrored && Y.front() > -half * (1.0 - rounding)))
    return fmt::format(
        "{}: y goes from {:.7g} to {:.7g} {}, but the roller reaches from {:.7g} to {:.7g}, {:.2g} {} further: give "
        "its whole length, or one half from y = 0 on",
        path, Y.front() * unit_Y, Y.back() * unit_Y, unit, -half * unit_Y, half * unit_Y,
        std::max(half - Y.back(), mirrored ? 0.0 : Y.front() + half) * unit_Y, unit);
  condition(Y, H, mirrored, profile);
  const double first = Y.front(), last = Y.back();
  const auto curve =
      std::make_shared<const boost::math::interpolators::makima<std::vector<double>>>(std::move(Y), std::move(H));
  profile.table = [=](double at) { return (*curve)(std::clamp(mirrored ? std::abs(at) : at, first, last)); };
  return {};
}

void read_straight(const deck::Part& part, const Scales& scales, Profile& profile) {
  profile.end_length = part.number_in("end_length", {"_m", scales.a, scales.in_SI});
  profile.end_radius = part.number_in("end_radius", {"_m", scales.radius, scales.in_SI});
  if (!(profile.end_length > 0.5 * profile.length)) return;
  const bool plain = part.given("end_length");
  const double unit = plain ? 1.0 : scales.a;
  part.complain(plain ? "end_length" : "end_length_m",
                fmt::format("is {:.4g} {}, more than half of the roller's {:.4g}", unit * profile.end_length,
                            plain ? "half widths" : "m", unit * profile.length));
}

}  // namespace

std::vector<deck::Key> keys() { return deck::keys_of("roller", records()); }

Profile read(deck::Deck& deck, const Scales& scales) {
  using enum Profile::Shape;
  const deck::Part part{deck, "roller"};
  Profile profile;
  profile.length = scales.length;
  deck::read(part, records(), profile);
  if (profile.shape == straight) read_straight(part, scales, profile);
  if (profile.shape == crowned)
    profile.crown_radius = part.number_in("crown_radius", {"_m", scales.radius, scales.in_SI});
  if (const double Q = part.number_in("design_load", {"_N", scales.load, scales.in_SI}); !std::isnan(Q)) {
    profile.design_load = Q;
    const deck::Key& key = part.key("design_load");
    if (!part.given("design_load") && !key.range.contains(Q))
      part.complain("design_load_N",
                    fmt::format("is {:.4g} times the load, which must be {}: {}", Q, deck::allowed(key), key.remedy));
  }
  if (const double tilt = part.number_in("tilt", {"_mrad", 1e3 * scales.a / scales.radius, scales.in_SI});
      !std::isnan(tilt))
    profile.tilt = tilt;
  if (profile.shape != table || !deck.errors.empty()) return profile;
  profile.trace.level = part.word("levelling") == "line";
  if (const double wave = part.number_in("shortest_wave", {"_m", scales.a, scales.in_SI}); !std::isnan(wave))
    profile.trace.shortest_wave = wave;
  const std::string wrong = read_table(deck::found_beside(deck, "roller", "file"), scales, profile);
  if (!wrong.empty()) part.complain("file", wrong);
  return profile;
}

}  // namespace ehl::roller
