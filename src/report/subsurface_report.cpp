#include "report/subsurface_report.hpp"

#include <fmt/core.h>

#include <cmath>

#include "deck/text.hpp"
#include "report/json.hpp"
#include "report/text_format.hpp"

namespace ehl::program {
namespace {

using subsurface::Maximum;
using subsurface::Parameters;
using subsurface::Quantity;
using subsurface::StressField;

constexpr const char* section = "subsurface";

std::string nodes(const core::Grid& grid, std::size_t planes) {
  return fmt::format("{} x {} nodes on {} planes to depth ", grid.nodes_x(), grid.nodes_y(), planes);
}

std::string body(const Parameters& parameters) {
  return fmt::format("Poisson's ratio {:.4g}, friction {:.4g}", parameters.nu, parameters.friction);
}

// Without the signs of zeros that rounding leaves.
double shown(double place) { return std::abs(place) < 5e-5 ? 0.0 : place; }

std::string maximum_line(const char* label, const Maximum& maximum, double p_h, const std::string& mark) {
  const std::string absolute = std::isfinite(p_h) ? ", " + pressure(maximum.value * p_h) : "";
  return fmt::format("{} {:.5f} p_h{}, at ({:.3f}, {:.3f}) a, depth {:.4f} a{}\n", label, maximum.value, absolute,
                     shown(maximum.X), shown(maximum.Y), maximum.Z, mark);
}

std::vector<results::Quantity> quantities(const StressField& field) {
  std::vector<results::Quantity> list;
  const auto add_maximum = [&](const std::string& name, const Maximum& maximum) {
    const std::string file = "largest_" + name;
    list.push_back(
        {file, maximum.value, "p_h", "largest value, by parabolas between nodes and planes", name + "/value"});
    list.push_back({file + "_x", maximum.X, "a", "where it is", name + "/X"});
    list.push_back({file + "_y", maximum.Y, "a", "where it is", name + "/Y"});
    list.push_back({file + "_z", maximum.Z, "a", "where it is: depth", name + "/Z"});
    list.push_back({"", maximum.on_node, "p_h", "largest value of all nodes", name + "/on_node"});
  };
  add_maximum("sigma_mises", field.mises);
  add_maximum("tau_max", field.shear);
  list.push_back({"poisson", field.parameters.nu, "-", "Poisson's ratio of the body"});
  list.push_back({"friction", field.parameters.friction, "-", "shear traction along +x over pressure"});
  list.push_back({"seconds", field.seconds, "s", "time of the stresses"});
  return list;
}

}  // namespace

std::string subsurface_plan(const Parameters& parameters, const core::Grid& contact) {
  return nodes(subsurface::stress_grid(contact, parameters), static_cast<std::size_t>(parameters.planes)) +
         fmt::format("{:.4g} a; ", parameters.depth) + body(parameters);
}

std::string subsurface_summary(const StressField& field, double p_h, const std::string& mark) {
  return maximum_line("von Mises   ", field.mises, p_h, mark) + maximum_line("tau_max     ", field.shear, p_h, mark) +
         "subsurface   " + nodes(field.grid, field.depths.size()) + fmt::format("{:.4g} a; ", field.depths.back()) +
         body(field.parameters) + fmt::format("; {:.3f} s\n", field.seconds) + warning_lines(field.warnings);
}

Json subsurface_json(const StressField& field) {
  Json report;
  add(quantities(field), report);
  report["depth"] = field.depths.back();
  report["planes"] = field.depths.size();
  report["nx"] = field.grid.nx;
  report["ny"] = field.grid.ny;
  report["warnings"] = field.warnings;
  return report;
}

void add_subsurface(const StressField& field, results::Content& content) {
  results::Volume& volume = content.volume;
  volume.group = "/subsurface";
  volume.meaning = "stresses below the contact, the body at z >= 0; tension positive";
  volume.warnings = deck::joined(field.warnings, "\n");
  volume.grid = field.grid;
  volume.depths = field.depths;
  for (const subsurface::Volume& kept : field.kept) {
    results::Series series{subsurface::name(kept.quantity), "p_h", subsurface::meaning(kept.quantity), {}, true};
    for (const core::Field& plane : kept.planes) series.fields.push_back(&plane);
    volume.series.push_back(std::move(series));
  }
  volume.section_meaning = "the section along x at y = " + deck::shortest(field.section_Y) + ": rows z, columns x";
  for (int k = 0; k < subsurface::quantities; ++k) {
    const auto quantity = static_cast<Quantity>(k);
    volume.section.push_back({subsurface::name(quantity), "p_h", subsurface::meaning(quantity),
                              &field.section[static_cast<std::size_t>(k)]});
  }
  volume.numbers = quantities(field);
}

}  // namespace ehl::program
