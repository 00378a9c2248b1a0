// Things that are nearly glyphs: each breaks one rule and keeps the others (SPEC S1-26).
#pragma once

#include <array>
#include <vector>

#include <glassbox/images/image.h>

#include "views/glyphs/find.h"

namespace glassbox::views {

struct Decoy {
  std::optional<GlyphRule> breaks;  // none: a glyph
  int identity = 0;                 // what it would be taken for
  double x = 0, y = 0;              // its centre, px
};

// Twelve glyphs and twelve things for each rule (two of them cut off by the border), by rows, on white paper. Codes from 60 on are not on the sheet (kSheet).
struct DecoyPicture {
  Image<Rgba8> picture;
  std::vector<Decoy> decoys;
  std::array<bool, kGlyphs> is_on_sheet{};
};
DecoyPicture draw_decoys();

// What is taken for a glyph and is none, and glyphs that are found as what they are.
struct DecoyScore {
  int glyphs = 0, found = 0;
  std::array<int, kGlyphRules> taken{};  // by the rule that they break

  int all_taken() const;
};
DecoyScore score_decoys(const DecoyPicture& picture, const FindSettings& settings);

}  // namespace glassbox::views
