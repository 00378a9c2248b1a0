// Compares the glyphs that were found with the glyphs that are visible.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/images/image.h>

#include "views/glyphs/find_glyphs.h"
#include "views/glyphs/wall.h"

namespace glassbox::views {

struct VisibleGlyph {
  int identity = 0;
  Vector2d centre;      // px
  double diameter = 0;  // px, of a circle of equal area
  double shorter = 0;   // px: the shorter diameter
};

// The glyphs that a camera sees from the front and entirely inside the picture, tested with 16
// points of their border. If `covered` is given, at most a tenth of a glyph's pixels may be
// covered.
std::vector<VisibleGlyph> visible_glyphs(const Wall& wall, const PinholeCamera& camera, int width,
                                         int height, const Image<std::uint8_t>& covered = {});

struct GlyphScore {
  int visible = 0, right = 0;
  int wrong = 0;  // regions taken for a glyph that is not there
  // Regions with the right identity whose glyph is not wholly visible, so it does not count for the
  // recall.
  int partly = 0;
  double precision() const {
    return right + partly + wrong > 0 ? 1 - double(wrong) / (right + partly + wrong) : 1;
  }
  double recall() const { return visible > 0 ? double(right) / visible : 1; }
};

// A region is right if the glyph of its identity is there: the glyph's true centre is within half a
// diameter of the region's centre.
GlyphScore glyph_score(const FoundGlyphs& found, const Wall& wall, const PinholeCamera& camera,
                       const std::vector<VisibleGlyph>& visible);

}  // namespace glassbox::views
