// Finds the pixels that a line covers by the diamond-exit rule of OpenGL and Direct3D, exactly,
// with integers.
//
// A pixel is drawn if the line leaves the diamond |x - xc| + |y - yc| < 1/2 around its centre. Two
// lines that continue each other, for example to the right, do not draw the pixel of their joint
// twice. Ties are broken as in OpenGL, as if the line were moved by (-e, +e^2) pixels with e
// infinitely small (y down).
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include <glassbox/raster/stages.h>

namespace glassbox {

// A pixel of a line. step / steps is its position on the line: 0 at the first end and 1 at the
// second, measured at the pixel's centre along the longer axis.
struct LinePixel {
  int x = 0, y = 0;
  std::int64_t step = 0, steps = 1;
};

// Whether p, after the infinitely small move, is inside the diamond of pixel (x, y). On the
// diamond's border |x - xc| + |y - yc| = 1/2 the move by -e along x decides: inwards on the right
// of the centre, outwards elsewhere.
inline bool in_diamond(const SnappedVertex& p, int x, int y) {
  const std::int64_t dx = p.x - (std::int64_t(x) * kSubpixels + kPixelCentre);
  const std::int64_t dy = p.y - (std::int64_t(y) * kSubpixels + kPixelCentre);
  const std::int64_t distance = std::abs(dx) + std::abs(dy);
  return distance < kPixelCentre || (distance == kPixelCentre && dx > 0);
}

inline std::int64_t floor_divide(std::int64_t n, std::int64_t positive) {
  return n >= 0 ? n / positive : -((-n + positive - 1) / positive);
}

// A line prepared for drawing. Its longer axis is called major (x or y), the other one minor. For
// every pixel of the major axis between its ends, the line passes the centre of one diamond, from
// one half of it into the other.
struct LineSetup {
  bool x_major = true;
  bool ascending = true;    // the second end is not before the first along the major axis
  SnappedVertex low, high;  // the ends in ascending order; .x is along the major axis, .y across it
  int first = 0, end = 0;   // the pixels of the major axis whose centre is passed: first .. end - 1
  // Whether a line that passes exactly between two pixels covers the pixel of lower index.
  bool border_is_low = true;

  std::int64_t steps() const { return high.x - low.x; }

  // The distance of pixel `major`'s centre from the first end along the major axis.
  std::int64_t step_at(int major) const {
    const std::int64_t centre = std::int64_t(major) * kSubpixels + kPixelCentre;
    return std::clamp<std::int64_t>(ascending ? centre - low.x : high.x - centre, 0, steps());
  }

  // The index along the minor axis of the pixel through which the line passes where it is at the
  // centre of pixel `major` along the major axis; major < end.
  int minor_at(int major) const {
    const std::int64_t run = high.x - low.x;
    const std::int64_t rise = high.y - low.y;
    const std::int64_t centre = std::int64_t(major) * kSubpixels + kPixelCentre;
    const std::int64_t minor_run = low.y * run + (centre - low.x) * rise;  // minor * run, exact
    return int(floor_divide(minor_run - (border_is_low ? 1 : 0), run * kSubpixels));
  }
};

inline LineSetup setup_line(const SnappedVertex& a, const SnappedVertex& b) {
  LineSetup line;
  line.x_major = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
  line.low = line.x_major ? a : SnappedVertex{a.y, a.x};
  line.high = line.x_major ? b : SnappedVertex{b.y, b.x};
  line.ascending = line.low.x <= line.high.x;
  if (!line.ascending) std::swap(line.low, line.high);

  // The infinitely small move along x goes to the left, so a centre exactly at the low end is
  // passed and a centre exactly at the high end is not. For a mostly vertical line the same choice
  // is harmless: an end exactly at the height of a centre is inside a diamond, and the diamond test
  // decides.
  line.first = (line.low.x + kPixelCentre - 1) >> kSubpixelBits;
  line.end = (line.high.x + kPixelCentre - 1) >> kSubpixelBits;

  // Seen at a fixed x, the infinitely small move (-e, +e^2) moves a mostly horizontal line of slope
  // m by m e + e^2 in y: upwards only if the line rises to the right (m < 0). Seen at a fixed y, it
  // moves a mostly vertical line to the left.
  line.border_is_low = !line.x_major || line.high.y < line.low.y;
  return line;
}

// Calls visit(LinePixel) for the pixels of the line from a to b within `window`, in no particular
// order.
template <class Visit>
void for_each_line_pixel(const SnappedVertex& a, const SnappedVertex& b, const PixelRect& window,
                         Visit&& visit) {
  const LineSetup line = setup_line(a, b);
  if (line.steps() == 0) return;

  const auto draw = [&](int x, int y) {
    if (in_diamond(b, x, y)) return;  // the line ends inside this diamond, so it does not leave it
    if (x < window.x0 || x >= window.x1 || y < window.y0 || y >= window.y1) return;
    visit(LinePixel{x, y, line.step_at(line.x_major ? x : y), line.steps()});
  };

  // A line that starts inside a diamond, but past its centre, leaves it without passing the centre.
  // The start, after the infinitely small move, can only be inside the diamond of the pixel that
  // contains it.
  const int start_x = (a.x - 1) >> kSubpixelBits;
  const int start_y = a.y >> kSubpixelBits;
  const int start = line.x_major ? start_x : start_y;
  const bool passes_start = start >= line.first && start < line.end;
  if (in_diamond(a, start_x, start_y) && !passes_start) draw(start_x, start_y);

  const int first = std::max(line.first, line.x_major ? window.x0 : window.y0);
  const int end = std::min(line.end, line.x_major ? window.x1 : window.y1);
  for (int major = first; major < end; ++major) {
    const int minor = line.minor_at(major);
    line.x_major ? draw(major, minor) : draw(minor, major);
  }
}

}  // namespace glassbox
