// Oil supply, rollers, and contacts in time.
#include <algorithm>
#include <cmath>

#include "case/numbers/records.hpp"
#include "case/roller_report.hpp"
#include "case/starvation_report.hpp"
#include "effects/starvation/formulas.hpp"

namespace ehl::program::numbers {
namespace {

const steady::Starvation& starved(Of s) { return *solution(s).starvation; }
const Unit flow{"rho0 u_m a^3/R", "rho0 u_m a^2/R"};

std::string meaning_of_through(Of s) {
  return of_line(s) ? "oil through the contact" : "oil through the contact, |y| <= 1 at x = 0";
}
std::string meaning_of_factor(Of s) {
  return of_line(s) ? "the lesser of r and 1: nothing flows aside" : "r/(1 + r^3)^(1/3)";
}
bool has_passes(Of s) { return !solution(s).passes.empty(); }

const roller::Analysis& rolled(Of s) { return *s.computed.roller; }
RollerBars roller_bars(Of s) { return bars_of(rolled(s)); }
const roller::Trace& trace(Of s) { return s.input.roller->trace; }
bool traced(Of s) { return s.input.roller->shape == roller::Profile::Shape::table; }
bool stressed(Of s) { return std::isfinite(rolled(s).mises.end); }

const TransientResult& in_time(Of s) { return *s.computed.in_time; }
const transient::MarchReport& march(Of s) { return in_time(s).report; }
bool counts_oil_in_time(Of s) { return s.input.transient->conditions.conserves_mass; }

}  // namespace

std::vector<Number> starvation_numbers() {
  const auto of = [](double steady::Starvation::*part) { return [part](Of s) { return starved(s).*part; }; };
  using X = steady::Starvation;
  return {number(id::starvation_factor, "-", "rho H at the centre over that of the flooded contact",
                 label("starvation factor"), column(601), on_page(16, "", "film over the flooded one"),
                 sweep_page(OfSweep::as_curve), of(&X::factor)),
          number(id::supply_ratio, "-", "r: what is brought on y = 0 over rho H at the centre of the flooded contact",
                 column(602), of(&X::supply_ratio)),
          number("Hc_flooded", "a^2/R", "film at (0,0) of the flooded contact on the same grid", column(603),
                 of(&X::Hc_flooded)),
          number("Hm_flooded", "a^2/R", "its minimum film", of(&X::Hm_flooded)),
          number(id::meniscus_x, "a", "where the inlet becomes full on y = 0", json("meniscus_X"), column(604),
                 of(&X::meniscus_X)),
          number("meniscus_cells", "-", "cells from the inlet to the first full node",
                 [](Of s) { return starved(s).cells_to_inlet; }),
          number(id::oil_in, flow, "oil through the inlet boundary", of(&X::in)),
          number("oil_through", flow, "oil through the contact", meaning_here(meaning_of_through), of(&X::through)),
          number("oil_around", flow, "oil that leaves by the outlet and has passed beside the contact",
                 [](Of s) { return starved(s).around(); }),
          number(id::oil_aside, flow, "oil through the sides of the domain", of(&X::aside)),
          number(id::mass_imbalance, "-", "(out + aside - in)/in", label("imbalance of oil"), column(606), on_page(17),
                 of(&X::imbalance)),
          number("gamma", "-", "exponent for which r/(1 + r^gamma)^(1/gamma) is the factor", column(605),
                 [](Of s) {
                   return of_line(s) ? core::unknown : starvation::gamma_of(starved(s).supply_ratio, starved(s).factor);
                 }),
          number("factor_by_supply", "-", "of the supply alone", meaning_here(meaning_of_factor),
                 [](Of s) { return factor_by_supply(s.input, starved(s)); }),
          number("factor_by_meniscus", "-", "Hamrock and Dowson 1977; of circles",
                 [](Of s) { return factor_by_meniscus(s.input, starved(s)); }),
          number("flooded_inlet", "a", "inlet of a flooded film by the same",
                 [](Of s) { return of_line(s) ? core::unknown : starvation::flooded_inlet(starved(s).Hc_flooded); }),
          number("passes", "-", "number of passes; the numbers are those of the last", only_if(has_passes),
                 [](Of s) { return solution(s).passes.back().number; })};
}

Group roller_numbers() {
  const auto bar_of = [](double RollerBars::*part) { return [part](Of s) { return roller_bars(s).*part; }; };
  Group group{.name = "roller", .prefix = "roller_"};
  group.on = [](Of s) { return s.computed.roller.has_value(); };
  group.asked = [](const deck::Deck& deck) { return deck::called_for(deck, "roller"); };
  group.numbers = {
      number("length", "a", "length of the roller", [](Of s) { return s.input.roller->length; }),
      number("P_middle", "p_h", "highest pressure on the line y = 0", column(701),
             [](Of s) { return rolled(s).found.middle.P_max; }),
      number("error_P_middle", "-", "its relative error by the grid of half as many cells",
             bar_of(&RollerBars::P_middle)),
      number("P_middle_dry", "p_h", "the same without oil", [](Of s) { return rolled(s).dry.middle.P_max; }),
      number("load_middle", "-", "load per length there over the mean",
             [](Of s) { return rolled(s).found.middle.load; }),
      number("P_end", "p_h", "highest pressure on the outer tenth of the length", column(702),
             [](Of s) { return harder(rolled(s).found).P; }),
      number("P_end_y", "a", "its position", [](Of s) { return harder(rolled(s).found).P_Y; }),
      number("error_P_end", "-", "its relative error by the grid of half as many cells", bar_of(&RollerBars::P_end)),
      number("P_end_dry", "p_h", "the same without oil", [](Of s) { return harder(rolled(s).dry).P; }),
      number("H_end", "a^2/R", "least film on the outer tenth of the length", column(703),
             [](Of s) { return least_at_ends(rolled(s).found); }),
      number("error_H_end", "-", "its relative error by the grid of half as many cells", bar_of(&RollerBars::H_end)),
      number("load_centre", "a", "y of the resultant of the pressure", column(704),
             [](Of s) { return rolled(s).found.load_centre; }),
      number("moment", "N m", "moment of the pressure about the x axis", column_only_si(705),
             [](Of s) { return moment_Nm(s.input, rolled(s).found); }),
      number("Rq", "a^2/R", "roughness of the traced profile without its form", only_if(traced),
             [](Of s) { return trace(s).rough; }),
      number("Rq_before_filter", "a^2/R", "the same before short waves were taken away", only_if(traced),
             [](Of s) { return trace(s).rough_before; }),
      number("levelled_slope", "-", "dH/dY that was taken away of the trace", only_if(traced),
             [](Of s) { return trace(s).slope; }),
      number("mises_middle", "p_h", "largest von Mises stress below the middle half", only_if(stressed),
             [](Of s) { return rolled(s).mises.middle; }),
      number("error_mises_middle", "-", "its relative error by the grid of half as many cells", only_if(stressed),
             bar_of(&RollerBars::mises_middle)),
      number("mises_end", "p_h", "the same below the outer tenth of the length", only_if(stressed),
             [](Of s) { return rolled(s).mises.end; }),
      number("error_mises_end", "-", "its relative error", only_if(stressed), bar_of(&RollerBars::mises_end))};
  return group;
}

std::vector<Number> transient_numbers() {
  const auto count = [](int transient::MarchReport::*part) { return [part](Of s) { return march(s).*part; }; };
  using R = transient::MarchReport;
  using transient::StepRow;
  std::vector<Number> list{
      number(id::completed, "-", "1: the run in time is complete, 0: it is not",
             [](Of s) { return completed(in_time(s)); }),
      number(id::ended, "", "how the run in time ended", [](Of s) { return how_it_ended(march(s)); }),
      number("start_converged", "-", "only a converged start is followed in time", [](Of) { return true; }),
      number("end_time", "a/u_m", "time reached", [](Of s) { return march(s).T; }),
      number(id::Hc, "a^2/R", "film at (0,0) at the end", [](Of s) { return in_time(s).rows.back().Hc; }),
      number(id::Hm, "a^2/R", "minimum film at the end", [](Of s) { return in_time(s).rows.back().Hm; }),
      number("least_Hm", "a^2/R", "minimum film of all times",
             [](Of s) { return std::ranges::min(in_time(s).rows, {}, &StepRow::Hm).Hm; }),
      number("largest_P_max", "p_h", "highest pressure of all times",
             [](Of s) { return std::ranges::max(in_time(s).rows, {}, &StepRow::P_max).P_max; }),
      number("steps", "-", "number of time steps", count(&R::steps)),
      number(id::cycles, "-", "cycles of all steps", count(&R::cycles)),
      number("newton_steps", "-", "Newton steps of all attempts", count(&R::newton_steps)),
      number("rejected", "-", "attempts that failed the error test", count(&R::rejected)),
      number("not_solved", "-", "attempts that were not solved", count(&R::not_solved)),
      number("jumps", "-", "jumps of load or speed", count(&R::restarts)),
      number("worst_load_error", "-", "largest relative error of the load",
             [](Of s) { return march(s).worst_load_error; }),
      number(id::seconds, "s", "time of the run in time", [](Of s) { return march(s).seconds; }),
      number("worst_oil_error", "-", "largest share of oil from nowhere in a step", only_if(counts_oil_in_time),
             [](Of s) { return march(s).worst_oil_error; }),
      number("oil_lost", "-", "since the start, over what the inlet brings then in a/u_m", only_if(counts_oil_in_time),
             [](Of s) { return in_time(s).rows.back().oil.lost; })};
  // The file contains how the run ended; the other numbers follow from its table of steps.
  for (Number& one : list) one.in_file = one.name == id::completed || one.name == id::ended;
  return list;
}

std::vector<Number> step_numbers() {
  return {number(id::time, "a/u_m", "time reached"),
          number(id::load, "-", "prescribed load over that of the contact", label("load F/F_0")),
          number(id::speed, "-", "entrainment speed (u1 + u2)/2 over u_m", label("entrainment speed over u_m"))};
}

}  // namespace ehl::program::numbers
