// Friction, flow thinning, heat, and stresses below the surface.
#include <cmath>

#include "case/numbers/records.hpp"
#include "case/thermal_report.hpp"

namespace ehl::program::numbers {
namespace {

using friction::Friction;

const Friction& rubbed(Of s) { return *s.computed.friction; }

bool beyond(Of s) { return rubbed(s).counts_outside; }
bool upstream(Of s) { return beyond(s) && rubbed(s).line; }
bool around(Of s) { return beyond(s) && !rubbed(s).line; }
bool has_meniscus(Of s) { return std::isfinite(rubbed(s).parameters.meniscus); }
bool has_outer(Of s) { return rubbed(s).outer != 0.0; }
bool has_side(Of s) { return std::isfinite(rubbed(s).side); }

const HeatResult& heated(Of s) { return *s.computed.heat; }
const HeatResult& thinned(Of s) { return *s.computed.flow; }
double kelvin(Of s, double theta) { return s.input.heat->T0 * theta; }
double watts(Of s, double share) { return s.input.heat->power * share; }

std::string meaning_of_isothermal(Of s) {
  return std::string("the same of the isothermal contact") +
         (heated(s).unlikely_isothermal ? "; no oil carries it" : "");
}

const subsurface::StressField& stresses(Of s) { return *s.computed.stresses; }

}  // namespace

std::vector<Number> friction_numbers() {
  const auto of = [](double Friction::*part) { return [part](Of s) { return rubbed(s).*part; }; };
  return {
      number(id::mu, "-", "sliding friction over the load, positive if surface 1 is the faster one", bar(id::error_mu),
             label("friction coefficient μ"), column(401), on_page(9), sweep_page(OfSweep::as_curve),
             of(&Friction::sliding)),
      number(id::error_mu, "-", "estimated relative error of mu on this domain", column(402),
             of(&Friction::error_sliding)),
      number("mu_rolling", "-", "rolling friction over the load, the same on both surfaces", bar("error_mu_rolling"),
             label("rolling friction"), column(403), on_page(11), of(&Friction::rolling)),
      number("error_mu_rolling", "-", "estimated relative error of mu_rolling on this domain", column(404),
             of(&Friction::error_rolling)),
      number("mu_1", "-", "force of the film on surface 1 along +x over the load", column(405), of(&Friction::on_1)),
      number("mu_2", "-", "force of the film on surface 2 along +x over the load", column(406), of(&Friction::on_2)),
      number("mu_cavitated", "-", "part of mu from the cavitated region", of(&Friction::cavitated)),
      number("largest_shear_stress", "p_h", "largest shear stress of sliding, in the pressurized film",
             json("largest_stress"), of(&Friction::largest_stress)),
      number("limited_share", "-", "share of the load on which the limiting stress acts", of(&Friction::limited_share)),
      number("mu_beyond", "-", "part of mu from outside the domain", only_if(beyond), of(&Friction::beyond)),
      number("mu_upstream", "-", "part of mu_rolling from upstream of the domain", only_if(upstream),
             of(&Friction::rolling_beyond)),
      number("mu_rolling_beyond", "-", "part of mu_rolling from outside of the domain, up to the meniscus",
             only_if(around), of(&Friction::rolling_beyond)),
      number("meniscus", "a", "distance of the inlet meniscus up to which friction is counted", only_if(has_meniscus),
             [](Of s) { return rubbed(s).parameters.meniscus; }),
      number("mu_rolling_outer", "-",
             "part of mu_rolling from the outer half of the inlet; a domain of twice the length adds about as much if "
             "it is full of oil",
             only_if(has_outer), of(&Friction::outer)),
      number("mu_side", "-", "force of the film on each surface along +y over the load", only_if(has_side),
             of(&Friction::side)),
      number("slide_roll_ratio", "-", "(u1 - u2)/u_m", not_json, [](Of s) { return s.input.physics.srr; })};
}

std::vector<Number> shear_numbers() {
  return {number("Hc_without", "a^2/R", "film at (0,0), thinned by the sliding alone",
                 [](Of s) { return thinned(s).Hc_isothermal; }),
          number("Hm_without", "a^2/R", "minimum film, thinned by the sliding alone",
                 [](Of s) { return thinned(s).Hm_isothermal; }),
          number("mu_without", "-", "sliding friction over the load, thinned by the sliding alone",
                 [](Of s) { return thinned(s).mu_isothermal; }),
          number(id::mu, "-", "sliding friction over the load", bar(id::error_mu), [](Of s) { return thinned(s).mu; }),
          number(id::error_mu, "-", "estimated relative discretization error of mu",
                 [](Of s) { return thinned(s).error_mu; })};
}

std::vector<Number> thermal_numbers() {
  std::vector<Number> list{
      number(id::mu, "-", "sliding friction over the load, with heat", bar(id::error_mu), column(501),
             [](Of s) { return heated(s).mu; }),
      number("mu_isothermal", "-", "the same of the isothermal contact", meaning_here(meaning_of_isothermal),
             label("the same, isothermal"), column(503), on_page(10), [](Of s) { return heated(s).mu_isothermal; }),
      number(id::error_mu, "-", "estimated relative discretization error of mu", column(502),
             [](Of s) { return heated(s).error_mu; })};
  const auto hottest = [&](const std::string& name, const std::string& meaning, const std::string& words, int place,
                           int on_page_at, OfSweep of_sweep, heat::Hottest heat::Solution::*part) {
    const auto at = [part](Of s) -> const heat::Hottest& { return heated(s).found.*part; };
    list.push_back(number(name, "K", meaning + ": highest temperature above T_oil", bar("error_" + name), label(words),
                          column(place), on_page(on_page_at), sweep_page(of_sweep),
                          [=](Of s) { return kelvin(s, at(s).theta); }));
    list.push_back(number(name + "_x", "a", "its position", [=](Of s) { return at(s).X; }));
    list.push_back(number(name + "_y", "a", "its position", [=](Of s) { return at(s).Y; }));
    list.push_back(number("error_" + name, "-", "estimated relative discretization error of the rise",
                          [=](Of s) { return at(s).error; }));
  };
  hottest(id::T_film_max, "film", "hottest film above T_{oil}", 504, 12, OfSweep::as_curve, &heat::Solution::in_film);
  hottest(id::T1_max, "surface 1", "hottest place of surface 1 above T_{oil}", 506, 13, OfSweep::hidden,
          &heat::Solution::on_1);
  hottest(id::T2_max, "surface 2", "hottest place of surface 2 above T_{oil}", 507, 14, OfSweep::hidden,
          &heat::Solution::on_2);
  const Unit watt{"W", "W/m"};
  const std::vector<Number> rest{
      number("T_film_mean", "K", "middle of the film above T_oil, mean weighted with the pressure", column(505),
             [](Of s) { return kelvin(s, heated(s).found.mean); }),
      number("T_inlet", "K", "middle of the film above T_oil at x = -a, y = 0",
             [](Of s) { return kelvin(s, heated(s).found.inlet); }),
      number("heat_made", watt, "heat made in the film by shear and compression",
             [](Of s) { return watts(s, heated(s).found.balance.heat); }),
      number(id::heat_1, watt, "heat into body 1", column(508),
             [](Of s) { return watts(s, heated(s).found.balance.into_1); }),
      number("heat_2", watt, "heat into body 2", column(509),
             [](Of s) { return watts(s, heated(s).found.balance.into_2); }),
      number("heat_carried", watt, "heat carried out of the domain by the oil",
             [](Of s) { return watts(s, heated(s).found.balance.carried); }),
      number(id::heat_imbalance, "-", "heat made less heat led away, over heat made", column(510),
             [](Of s) { return heated(s).found.balance.defect; }),
      number("nahme", "-", "largest beta tau_m |u1 - u2| h/k", column(512), [](Of s) { return heated(s).found.nahme; }),
      number("peclet_1", "-", "u1 a over the diffusivity of body 1",
             [](Of s) { return s.input.heat->setup.body_1.Pe; }),
      number("peclet_2", "-", "u2 a over the diffusivity of body 2",
             [](Of s) { return s.input.heat->setup.body_2.Pe; }),
      number("Hc_isothermal", "a^2/R", "film at (0,0) of the isothermal contact",
             [](Of s) { return heated(s).Hc_isothermal; }),
      number("Hm_isothermal", "a^2/R", "its minimum film", [](Of s) { return heated(s).Hm_isothermal; }),
      number("film_reduction", "-", "Hc over Hc_isothermal", label("film over the isothermal one"), column(511),
             on_page(15), [](Of s) { return film_reduction(heated(s)); }),
      number("wilson_sheu", "-", "the same by Wilson and Sheu 1983",
             [](Of s) { return thermal::wilson_sheu(inlet_groups(s.input)); }),
      number("gupta", "-", "the same by Gupta et al. 1992", [](Of s) { return thermal::gupta(inlet_groups(s.input)); }),
      number("murch_wilson", "-", "the same by Murch and Wilson 1975, pure rolling", [](Of s) {
        return s.input.physics.srr == 0.0 ? thermal::murch_wilson(inlet_groups(s.input)) : core::unknown;
      })};
  list.insert(list.end(), rest.begin(), rest.end());
  return list;
}

Group stress_numbers() {
  Group group{.name = "stresses", .home = "/subsurface"};
  group.on = [](Of s) { return s.computed.stresses.has_value(); };
  std::vector<Number>& list = group.numbers;
  const auto add_maximum = [&](const std::string& name, const std::string& words, int place,
                               subsurface::Maximum subsurface::StressField::*part) {
    const std::string file = "largest_" + name;
    const auto of = [part](double subsurface::Maximum::*what) { return [=](Of s) { return stresses(s).*part.*what; }; };
    using M = subsurface::Maximum;
    list.push_back(number(file, "p_h", "largest value, interpolated by parabolas between nodes and planes",
                          json(name + "/value"), label(words), on_page(place), of(&M::value)));
    list.push_back(number(file + "_x", "a", "its position", json(name + "/X"), of(&M::X)));
    list.push_back(number(file + "_y", "a", "its position", json(name + "/Y"), of(&M::Y)));
    list.push_back(number(file + "_z", "a", "its position: depth", json(name + "/Z"), of(&M::Z)));
    list.push_back(number(file + "_on_node", "p_h", "largest value of all nodes", json(name + "/on_node"), not_in_file,
                          of(&M::on_node)));
  };
  add_maximum("sigma_mises", "largest von Mises stress below the surface", 18, &subsurface::StressField::mises);
  add_maximum("tau_max", "largest shear stress below the surface", 19, &subsurface::StressField::shear);
  list.push_back(number("poisson", "-", "Poisson's ratio of the body", [](Of s) { return stresses(s).parameters.nu; }));
  list.push_back(number("friction", "-", "shear traction along +x over pressure",
                        [](Of s) { return stresses(s).parameters.friction; }));
  list.push_back(number(id::seconds, "s", "time of the stresses", [](Of s) { return stresses(s).seconds; }));
  return group;
}

}  // namespace ehl::program::numbers
