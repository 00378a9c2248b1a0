// NDC to pixels (S3-17).
#pragma once

#include <glassbox/pipeline/formulas.h>
#include <glassbox/pipeline/stages.h>

namespace glassbox {

// The rectangle of the screen that NDC's square is mapped to, in pixels, y down. Any rectangle is
// legal; the usual one is (0, 0) .. (width, height).
struct Viewport {
  float left = 0, top = 0, right = 1, bottom = 1;

  float width() const { return right - left; }
  float height() const { return bottom - top; }
};

// X = x (right - left)/2 + (right + left)/2 and Y = y (top - bottom)/2 + (top + bottom)/2: the sign
// of y changes because screens count rows downwards. Exact where sizes are powers of two and x, y
// have few enough bits.
inline ScreenVertex to_screen(const NdcVertex& ndc, const Viewport& viewport) {
  return {{to_pixels(ndc.position.x, viewport.left, viewport.right),
           to_pixels(ndc.position.y, viewport.bottom, viewport.top), ndc.position.z},
          ndc.inverse_w};
}

}  // namespace glassbox
