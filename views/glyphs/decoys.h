// Decoys: figures that are nearly glyphs. Each breaks one rule for glyphs and follows all other
// rules (S1-26).
#pragma once

#include <array>
#include <vector>

#include <glassbox/images/image.h>

#include "views/glyphs/find_glyphs.h"

namespace glassbox::views {

struct Decoy {
  std::optional<GlyphRule> breaks;  // none: it is a glyph
  int identity = 0;                 // the glyph that it could be mistaken for
  double x = 0, y = 0;              // its centre, px
};

// Rows of figures on white paper: first twelve glyphs, then twelve decoys for each rule (for kWhole
// only two, which the border cuts off). Identities from 60 on are not on the sheet, so they break
// kSheet.
struct DecoyPicture {
  Image<Rgba8> picture;
  std::vector<Decoy> decoys;
  std::array<bool, kGlyphs> is_on_sheet{};
};
DecoyPicture draw_decoys();

// How many decoys are taken for glyphs, and how many glyphs are found with the right identity.
struct DecoyScore {
  int glyphs = 0, found = 0;
  std::array<int, kGlyphRules> accepted{};  // decoys taken for glyphs, for each rule

  int all_accepted() const;
};
DecoyScore score_decoys(const DecoyPicture& picture, const FindSettings& settings);

}  // namespace glassbox::views
