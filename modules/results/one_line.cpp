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

core::Field field_of(const Array& array) {
  const std::size_t lines = array.dims[0], length = array.dims[1];
  const int nodes_y = lines == 1 ? 3 : static_cast<int>(lines);
  core::Field field(static_cast<int>(length), nodes_y);
  for (int i = 0; i < field.nodes_x(); ++i)
    for (int j = 0; j < nodes_y; ++j)
      field(i, j) = array.values[(lines == 1 ? 0 : static_cast<std::size_t>(j)) * length + static_cast<std::size_t>(i)];
  return field;
}

}  // namespace ehl::results
