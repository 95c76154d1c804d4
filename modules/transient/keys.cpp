#include "transient/keys.hpp"

#include "transient/march.hpp"

namespace ehl::transient {
namespace {

using deck::Key;
using deck::Type;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr deck::Range positive{0.0, infinity, true, true};
const deck::Condition timed{.name = "end_time", .words = {}};

std::vector<Key> time_keys() {
  return {
      Key{.section = "transient",
          .name = "end_time",
          .range = positive,
          .remedy = "the time at which the run ends",
          .meaning =
              "How long, from the steady state at time 0, in the unit that time_unit says. Without it the contact "
              "is steady.",
          .example = "5"},
      Key{.section = "transient",
          .name = "time_unit",
          .type = Type::word,
          .default_text = "contact",
          .words = {"contact", "seconds"},
          .meaning =
              "Unit of all times of this section: contact is a/u_m, in which the oil crosses half of the contact; "
              "seconds need a contact in SI.",
          .needs = timed},
      Key{.section = "transient",
          .name = "rtol",
          .default_text = "1e-4",
          .range = {1e-7, 1e-1},
          .meaning = "Relative tolerance of the time integration's error test for pressure and film.",
          .source = "modules/transient/README.md",
          .needs = timed},
      Key{.section = "transient",
          .name = "max_step",
          .default_note = "from what varies: a quarter of a feature's width at its speed, a quarter of a ramp (of one "
                          "shorter than 0.04 a/u_m only within it), a twentieth "
                          "of a period",
          .range = positive,
          .meaning = "Longest step of time.",
          .needs = timed,
          .example = "0.05"},
      Key{.section = "transient",
          .name = "max_steps",
          .type = Type::integer,
          .default_text = "100000",
          .range = {1, 100000000},
          .meaning = "Steps after which the run ends as failed.",
          .needs = timed},
      Key{.section = "transient",
          .name = "output_interval",
          .default_note = "none: the fields of the first and the last time",
          .range = positive,
          .remedy = "a longer time between two fields keeps fewer of them",
          .meaning = "Time between two fields of P and H in the result. The numbers of every step are always kept.",
          .needs = timed,
          .example = "0.1"},
  };
}

std::vector<Key> output_keys() {
  return {
      Key{.section = "output",
          .name = "checkpoint",
          .default_note = "60 in a run in time",
          .unit = "s",
          .range = positive,
          .meaning = "Time by the clock between the moments at which a run in time writes its result so far, from "
                     "which `ehl resume` goes on.",
          .needs = {.name = "end_time", .section = "transient"},
          .example = "60"},
      Key{.section = "output",
          .name = "probe",
          .type = Type::text,
          .default_note = "none",
          .meaning = "Points 'X Y, X Y, ...' in Hertz radii at which a run in time keeps P and H at every step, as the "
                     "columns P_1, H_1, P_2, ... of /transient: of a node where there is one, else by bicubic "
                     "interpolation, P no less than 0.",
          .needs = {.name = "end_time", .section = "transient"},
          .example = "0 0, 0.7 0.2"}};
}

std::vector<Key> varying_keys() {
  return {
      Key{.section = "transient",
          .name = "load",
          .type = Type::text,
          .default_note = "constant",
          .meaning =
              "Load over that of [contact], at times: 'time:value ...', linear between them; the same time twice is "
              "a jump. Or a file .csv with two columns, where the program runs or beside the deck.",
          .needs = timed,
          .example = "1:1 1.1:1.3"},
      Key{.section = "transient",
          .name = "load_wave",
          .type = Type::text,
          .default_note = "none",
          .meaning = "'amplitude period [start]': multiplies the load by 1 + amplitude sin(2 pi (t - start)/period).",
          .needs = timed,
          .example = "0.3 2"},
      Key{.section = "transient",
          .name = "u1",
          .type = Type::text,
          .default_note = "constant: from [motion], else 1",
          .meaning =
              "Speed of surface 1 over the entrainment speed u_m of [motion] (of M, L where there is none), written "
              "like load. The film is carried by (u1 + u2)/2, which must not be negative.",
          .needs = timed,
          .example = "1:1 2:0 3:0 4:1"},
      Key{.section = "transient",
          .name = "u1_wave",
          .type = Type::text,
          .default_note = "none",
          .meaning = "Like load_wave, of u1.",
          .needs = timed,
          .example = "0.5 4"},
      Key{.section = "transient",
          .name = "u2",
          .type = Type::text,
          .default_note = "constant: from [motion], else 1",
          .meaning = "Speed of surface 2, like u1.",
          .needs = timed,
          .example = "1:1 2:0 3:0 4:1"},
      Key{.section = "transient",
          .name = "u2_wave",
          .type = Type::text,
          .default_note = "none",
          .meaning = "Like load_wave, of u2.",
          .needs = timed,
          .example = "0.5 4"},
      Key{.section = "transient",
          .name = "stop_film",
          .default_note = "none",
          .range = positive,
          .meaning = "End where the smallest film falls to this, H = hR/a^2.",
          .needs = timed,
          .example = "0.02"},
      Key{.section = "transient",
          .name = "stop_steady",
          .default_note = "none",
          .range = {1e-12, 0.1},
          .meaning = "End where Hc, Hm and P_max have changed by less than this, relative, for a time of a/u_m.",
          .needs = timed,
          .example = "1e-6"},
  };
}

std::vector<Key> body_keys() {
  const deck::Condition in_time{.name = "end_time", .words = {}, .section = "transient"};
  const auto key = [&](const char* name, const char* note, const deck::Range& range, const char* meaning,
                       const char* example) {
    return Key{.section = "body",
               .name = name,
               .default_note = note,
               .range = range,
               .meaning = meaning,
               .needs = in_time,
               .example = example};
  };
  const Key mass =
      key("mass", "none: the load is imposed", positive,
          "Mass of the body that moves, in F R/u_m^2: with it H00 follows mass H00'' + damping H00' = load "
          "that the film carries - load that acts, both over that of [contact], and the load that acts may "
          "be zero.",
          "2");
  const Key damping = key("damping", "0", {0.0, infinity}, "Damping of the body, in F R/(a u_m).", "0.1");
  const Key gap = key("gap", "none: starts from the steady film", positive,
                      "H00 at time 0, in a^2/R: the bodies start apart, without pressure.", "2");
  const Key velocity =
      key("velocity", "0", {-infinity, infinity}, "H00' at time 0, in a u_m/R; negative: the bodies approach.", "-1");
  return {mass, in_SI(mass, "_kg", "kg", "0.1"), damping,  in_SI(damping, "_Nspm", "N s/m", "100"),
          gap,  in_SI(gap, "_m", "m", "1e-6"),   velocity, in_SI(velocity, "_mps", "m/s", "-0.1")};
}

}  // namespace

std::vector<Key> keys() {
  std::vector<Key> all;
  for (const auto& list : {time_keys(), varying_keys(), output_keys(), body_keys()})
    all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace ehl::transient
