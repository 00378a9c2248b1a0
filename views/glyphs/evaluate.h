// What was found, held against what there is.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/images/image.h>

#include "views/glyphs/find.h"
#include "views/glyphs/wall.h"

namespace glassbox::views {

struct VisibleGlyph {
  int identity = 0;
  Vector2d centre;      // px
  double diameter = 0;  // px, of a circle as large
  double shorter = 0;   // px: across
};

// Those that a camera sees from the front and whole, by 16 points of their border; of the pixels of `covered`, where there is one, at
// most a tenth may be covered.
std::vector<VisibleGlyph> visible_glyphs(const Wall& wall, const PinholeCamera& camera, int width,
                                         int height, const Image<std::uint8_t>& covered = {});

struct GlyphScore {
  int visible = 0, right = 0;
  int wrong = 0;   // said to be one that is not there
  int partly = 0;  // right, of those that are not wholly visible: no part of recall
  double precision() const {
    return right + partly + wrong > 0 ? 1 - double(wrong) / (right + partly + wrong) : 1;
  }
  double recall() const { return visible > 0 ? double(right) / visible : 1; }
};

// A region is right if the centre of its glyph is within half a diameter of its own.
GlyphScore score_of(const FoundGlyphs& found, const Wall& wall, const PinholeCamera& camera,
                    const std::vector<VisibleGlyph>& visible);

}  // namespace glassbox::views
