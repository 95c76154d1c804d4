#pragma once
// A field as a picture in colours with lines of equal value.
#include "page/drawing.hpp"
#include "page/png.hpp"
#include "report/field_on_grid.hpp"

namespace ehl::program {

/// Pale to dark for what is at least zero; dark (thin) to pale for films: those of the pictures of postprocess/.
enum class Colours { pressure, film, temperature };

/// in: a field on lines as dense as the points of the picture; the scale of the colours; the values of lines of equal
/// value. Values beyond the scale have the colour of its end, what is no number is white.
IndexedPicture coloured(const FieldOnGrid& field, const Axis& scale, Colours colours, const std::vector<double>& lines);

/// The values of lines: ticks of the scale, and between them.
std::vector<double> lines_of(const Axis& scale);

/// The colours themselves as a picture, the highest value at the top.
IndexedPicture colour_scale(Colours colours);

/// The part of a field that is drawn.
struct Window {
  double left = 0.0, right = 1.0, bottom = 0.0, top = 1.0;
};

/// The field in the window, on lines as dense as the points of a picture `width` points wide; its height keeps the
/// shape, between a third of the width and 1.4 times it.
FieldOnGrid drawn_part(const FieldOnGrid& field, const Window& window, std::size_t width);

}  // namespace ehl::program
