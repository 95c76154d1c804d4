#include "tables/si_columns.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/constants.hpp"

namespace ehl::program {
namespace {

using core::unknown;
constexpr double nm = 1e-9, um = 1e-6, GPa = 1e9;

// The film of a published formula [m].
double by_formula(const SiRow& row, const std::string& code, double Formula::*film) {
  const auto found = std::ranges::find(row.formulas, code, &Formula::code);
  return found == row.formulas.end() || !row.physics.si ? unknown : (*found).*film * row.physics.si->hertz.h_scale;
}

// in: code and name of the formula, "h_c" or "h_m".
void add_formula(const std::string& code, const std::string& name, double Formula::*of_formula, double SiRow::*film,
                 std::vector<Column<SiRow>>& columns) {
  const std::string column = code + (film == &SiRow::hc ? "_h_c" : "_h_m");
  columns.push_back({column + "_nm", "nm", "film by " + name,
                     [=](const SiRow& row) { return by_formula(row, code, of_formula) / nm; }});
  columns.push_back({column + "_deviation", "-", "of the formula from the film computed, over that",
                     [=](const SiRow& row) { return deviation(by_formula(row, code, of_formula), row.*film); }});
}

// A column that holds a number of the contact.
template <class Get>
auto of_contact(Get get) {
  return [get](const SiRow& row) { return row.physics.si ? get(*row.physics.si) : unknown; };
}

void add_formulas(Bodies bodies, std::vector<Column<SiRow>>& columns) {
  const auto add_both = [&](const char* code, const char* name) {
    add_formula(code, name, &Formula::Hc, &SiRow::hc, columns);
    add_formula(code, name, &Formula::Hm, &SiRow::hm, columns);
  };
  if (bodies == Bodies::line) {
    add_formula("moes", "Moes 1992", &Formula::Hc, &SiRow::hc, columns);
    add_both("dh", "Dowson, Higginson 1968; Toyoda 1979");
    return;
  }
  add_formula("nvm", "Nijenbanning, Venner, Moes 1994", &Formula::Hc, &SiRow::hc, columns);
  add_both("hd", "Hamrock, Dowson 1977");
  if (bodies == Bodies::elliptic) add_both("chittenden", "Chittenden et al. 1985");
}

Column<SiRow> load_column(Bodies bodies) {
  const auto load = of_contact([](const SiInput& si) { return si.contact.load; });
  if (bodies == Bodies::line) return {"load_N_per_m", "N/m", "normal load over the length", load};
  return {"load_N", "N", "normal load", load};
}

}  // namespace

std::vector<Column<SiRow>> si_columns(Bodies bodies, bool rough) {
  std::vector<Column<SiRow>> columns{
      {"h_c_nm", "nm", "film at (0,0)", [](const SiRow& row) { return row.hc / nm; }},
      {"h_c_error_nm", "nm", "its error bar, mesh and cycles",
       [](const SiRow& row) { return row.hc * row.error_hc / nm; }},
      {"h_m_nm", "nm", "smallest film of all nodes", [](const SiRow& row) { return row.hm / nm; }},
      {"h_m_error_nm", "nm", "its error bar, mesh and cycles",
       [](const SiRow& row) { return row.hm * row.error_hm / nm; }},
      {"p_max_GPa", "GPa", "highest pressure of all nodes", [](const SiRow& row) { return row.p_max / GPa; }}};
  if (rough) {
    columns.push_back({"Sq_nm", "nm", "roughness of both surfaces together", [](const SiRow& row) {
                         return row.roughness ? row.roughness->Sq * row.physics.si->hertz.h_scale / nm : unknown;
                       }});
    columns.push_back({"lambda_ratio", "-", "smallest film of smooth surfaces over it",
                       [](const SiRow& row) { return row.roughness ? row.roughness->lambda_ratio() : unknown; }});
  }
  add_formulas(bodies, columns);
  columns.insert(
      columns.end(),
      {{"p_h_GPa", "GPa", "Hertz pressure", of_contact([](const SiInput& si) { return si.hertz.p_h / GPa; })},
       {"a_um", "um", "Hertz radius along R_x", of_contact([](const SiInput& si) { return si.hertz.a / um; })},
       {"E_prime_GPa", "GPa", "reduced modulus",
        of_contact([](const SiInput& si) { return si.contact.E_prime / GPa; })},
       load_column(bodies),
       {"u_m", "m/s", "mean of the surface speeds", of_contact([](const SiInput& si) { return 0.5 * si.contact.u_s; })},
       {"eta0_mPa_s", "mPa s", "viscosity at ambient pressure",
        of_contact([](const SiInput& si) { return 1e3 * si.contact.eta0; })},
       {"alpha_per_GPa", "1/GPa", "pressure coefficient of the viscosity",
        of_contact([](const SiInput& si) { return GPa * si.contact.alpha; })}});
  return columns;
}

}  // namespace ehl::program
