#include "results/one_line.hpp"

namespace ehl::results {

OneLine::OneLine(const Content& of) : content(of) {
  content.grid.ny = 0;
  const auto line_of = [this](const core::Field*& field) {
    core::Field& line = kept.emplace_back(field->nodes_x(), 1);
    for (int i = 0; i < line.nodes_x(); ++i) line(i, 0) = (*field)(i, 1);
    field = &line;
  };
  for (NamedField& one : content.fields) line_of(one.field);
  content.volume.grid.ny = 0;
  for (std::vector<Series>* series : {&content.frames.series, &content.volume.series})
    for (Series& one : *series)
      for (const core::Field*& field : one.fields) line_of(field);
}

}  // namespace ehl::results
