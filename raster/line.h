// Which pixels a line covers: the diamond-exit rule of OpenGL and Direct3D, decided exactly on integers.
//
// A pixel is drawn where the line leaves the diamond |x - xc| + |y - yc| < 1/2 around its centre. Lines that join end
// to end draw no pixel twice. Ties are broken as OpenGL does, by thinking of the line as moved by (-e, +e^2) pixels
// with e infinitely small (y down).
#pragma once

#include <cstdint>

#include <glassbox/raster/stages.h>

namespace glassbox {

// A pixel of a line, `step` of `steps` of the way from its first end to its second (0 <= step <= steps), measured at
// the pixel's centre along the longer axis.
struct LinePixel {
  int x = 0, y = 0;
  std::int64_t step = 0, steps = 1;
};

// Inside the diamond of pixel (i, j), after the move. On its border |x - xc| + |y - yc| = 1/2 the move by -e along x
// decides: inwards on the right of the centre, outwards elsewhere.
inline bool in_diamond(const SnappedVertex& p, std::int64_t i, std::int64_t j) {
  const std::int64_t dx = p.x - (i * kSubpixels + kPixelCentre);
  const std::int64_t dy = p.y - (j * kSubpixels + kPixelCentre);
  const std::int64_t distance = (dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy);
  return distance < kPixelCentre || (distance == kPixelCentre && dx > 0);
}

inline std::int64_t floor_divide(std::int64_t n, std::int64_t positive) {
  return n >= 0 ? n / positive : -((-n + positive - 1) / positive);
}

// The row in which a mostly horizontal line passes the centre of column i. Exactly between two rows the move decides:
// up for a line that rises on the screen, else down.
inline std::int64_t row_at_column(const SnappedVertex& a, const SnappedVertex& b, std::int64_t i) {
  std::int64_t dx = b.x - a.x;
  std::int64_t dy = b.y - a.y;
  if (dx < 0) dx = -dx, dy = -dy;
  const std::int64_t centre = i * kSubpixels + kPixelCentre;
  const std::int64_t y_dx = std::int64_t(a.y) * dx + (centre - a.x) * dy;  // y * dx, exact
  const std::int64_t row = floor_divide(y_dx, dx * kSubpixels);
  const bool on_border = y_dx == row * dx * kSubpixels;
  return on_border && dy < 0 ? row - 1 : row;
}

// The column in which a mostly vertical line passes the centre of row j. Exactly between two columns: the left one.
inline std::int64_t column_at_row(const SnappedVertex& a, const SnappedVertex& b, std::int64_t j) {
  std::int64_t dx = b.x - a.x;
  std::int64_t dy = b.y - a.y;
  if (dy < 0) dx = -dx, dy = -dy;
  const std::int64_t centre = j * kSubpixels + kPixelCentre;
  const std::int64_t x_dy = std::int64_t(a.x) * dy + (centre - a.y) * dx;
  const std::int64_t column = floor_divide(x_dy, dy * kSubpixels);
  const bool on_border = x_dy == column * dy * kSubpixels;
  return on_border ? column - 1 : column;
}

// Calls visit(LinePixel) for the pixels of the line from a to b within `window`, in no particular direction.
template <class Visit>
void for_each_line_pixel(const SnappedVertex& a, const SnappedVertex& b, const PixelRect& window,
                         Visit&& visit) {
  const std::int64_t dx = b.x - a.x;
  const std::int64_t dy = b.y - a.y;
  const std::int64_t length_x = dx < 0 ? -dx : dx;
  const std::int64_t length_y = dy < 0 ? -dy : dy;
  const bool horizontal = length_x >= length_y;
  const std::int64_t steps = horizontal ? length_x : length_y;
  if (steps == 0) return;

  const auto draw = [&](std::int64_t i, std::int64_t j) {
    if (in_diamond(b, i, j)) return;  // the line ends here: it does not leave
    if (i < window.x0 || i >= window.x1 || j < window.y0 || j >= window.y1) return;
    std::int64_t step = horizontal ? (i * kSubpixels + kPixelCentre - a.x) * (dx < 0 ? -1 : 1)
                                   : (j * kSubpixels + kPixelCentre - a.y) * (dy < 0 ? -1 : 1);
    if (step < 0) step = 0;
    if (step > steps) step = steps;
    visit(LinePixel{int(i), int(j), step, steps});
  };

  // A line that starts inside a diamond, but past its centre, leaves it without crossing the centre.
  const std::int64_t start_i = floor_divide(a.x, kSubpixels);
  const std::int64_t start_j = floor_divide(a.y, kSubpixels);

  if (horizontal) {
    // Columns whose centre c satisfies min <= c < max: the move by -e puts a centre at the left end inside, one at the
    // right end outside.
    const std::int64_t low = dx < 0 ? b.x : a.x;
    const std::int64_t high = dx < 0 ? a.x : b.x;
    std::int64_t first = floor_divide(low - kPixelCentre + kSubpixels - 1, kSubpixels);
    std::int64_t end = floor_divide(high - kPixelCentre + kSubpixels - 1, kSubpixels);
    const auto crossed = [&](std::int64_t i) { return i >= first && i < end; };
    for (std::int64_t i = start_i - 1; i <= start_i + 1; ++i) {
      for (std::int64_t j = start_j - 1; j <= start_j + 1; ++j) {
        if (in_diamond(a, i, j) && !crossed(i)) draw(i, j);
      }
    }
    if (first < window.x0) first = window.x0;
    if (end > window.x1) end = window.x1;
    for (std::int64_t i = first; i < end; ++i) draw(i, row_at_column(a, b, i));
  } else {
    // Rows whose centre c satisfies min < c <= max: the move by +e^2 goes down.
    const std::int64_t low = dy < 0 ? b.y : a.y;
    const std::int64_t high = dy < 0 ? a.y : b.y;
    std::int64_t first = floor_divide(low - kPixelCentre, kSubpixels) + 1;
    std::int64_t end = floor_divide(high - kPixelCentre, kSubpixels) + 1;
    const auto crossed = [&](std::int64_t j) { return j >= first && j < end; };
    for (std::int64_t i = start_i - 1; i <= start_i + 1; ++i) {
      for (std::int64_t j = start_j - 1; j <= start_j + 1; ++j) {
        if (in_diamond(a, i, j) && !crossed(j)) draw(i, j);
      }
    }
    if (first < window.y0) first = window.y0;
    if (end > window.y1) end = window.y1;
    for (std::int64_t j = first; j < end; ++j) draw(column_at_row(a, b, j), j);
  }
}

}  // namespace glassbox
