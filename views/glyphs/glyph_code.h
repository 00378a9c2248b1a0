// Chromaglyphs: three concentric discs in three of six colours, 120 glyphs in all (S1-24).
#pragma once

#include <array>
#include <optional>

#include <glassbox/images/image.h>

namespace glassbox::views {

inline constexpr int kPrototypes = 6, kGlyphs = 120;

// Red, green, blue, cyan, magenta and yellow, a little less than pure, so that they avoid a
// photograph's brightest and darkest codes. The distance from each colour to the nearest other one
// is 192 codes, and the mixture of any two colours is more than 0.4 of that distance (the threshold
// of prototype_of) from every third colour.
inline constexpr std::array<Rgba8, kPrototypes> kPrototypeColors{{{224, 32, 32, 255},
                                                                  {32, 224, 32, 255},
                                                                  {32, 32, 224, 255},
                                                                  {32, 224, 224, 255},
                                                                  {224, 32, 224, 255},
                                                                  {224, 224, 32, 255}}};

// Indices of three different colours, from the inside to the outside.
using GlyphCode = std::array<int, 3>;

// Radii of the discs, as fractions of the glyph's radius. The bands' areas are 0.13, 0.31 and 0.56
// of the glyph. All bands lose pixels along their borders to mixtures, but the order of the bands
// by number of pixels stays the same in glyphs down to a diameter of about 10 px.
inline constexpr std::array<double, 3> kDiscRadii{0.36, 0.66, 1};

// Codes are numbered in the order of (inner, middle, outer): identity 0 is (0, 1, 2), 119 is (5, 4,
// 3).
GlyphCode code_of(int identity);
// None unless the three colours are different.
std::optional<int> identity_of(const GlyphCode& code);

}  // namespace glassbox::views
