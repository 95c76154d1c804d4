#pragma once
// A field as a coloured picture with lines of equal value.
#include "page/drawing.hpp"
#include "page/png.hpp"
#include "report/field_on_grid.hpp"

namespace ehl::program {

/// Pressures and temperatures run from pale (low) to dark (high), films from dark (thin) to pale. The colours are those
/// of the pictures of postprocess/.
enum class Colours { pressure, film, temperature };

/// in: a field sampled at the points of the picture; the scale of the colours; the values of the lines of equal value.
/// A value outside the scale gets the colour of the nearer end; NaN is white.
IndexedPicture coloured(const FieldOnGrid& field, const Axis& scale, Colours colours, const std::vector<double>& lines);

/// The values at which lines are drawn: the ticks of the scale and values between them.
std::vector<double> lines_of(const Axis& scale);

/// The scale of the colours as a picture, with the highest value at the top.
IndexedPicture colour_scale(Colours colours);

/// The part of a field that is drawn.
struct Window {
  double left = 0.0, right = 1.0, bottom = 0.0, top = 1.0;
};

/// The part of the field inside the window, sampled for a picture `width` points wide. The height follows the shape of
/// the window, between a third of the width and 1.4 times the width.
FieldOnGrid drawn_part(const FieldOnGrid& field, const Window& window, std::size_t width);

}  // namespace ehl::program
