// Glyphs in a picture: regions that are not paper, and the rules by which a region is a glyph (SPEC S1-25, S1-26).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <glassbox/images/image.h>

#include "views/glyphs/code.h"
#include "views/two_view/camera.h"

namespace glassbox::views {

// In the order in which they are asked.
enum class GlyphRule {
  kWhole,  // the region does not touch the picture's border
  kSize,   // its shorter diameter is long enough
  kPrototypes,  // enough of its pixels have prototype colours: it is made of them, but for what borders mix
  kOthers,     // few of those that have are of a fourth colour
  kAreas,      // the three colours' shares are those of concentric discs
  kCentroids,  // the three have one centre
  kSpread,     // the wider a band, the further its pixels are spread
  kRanks,      // the colours have the same order by number of pixels and by spread
  kSheet,      // the code is on the wall
};
inline constexpr int kGlyphRules = 9;
std::string_view name_of(GlyphRule rule);

struct FindSettings {
  float threshold = 0.4f;     // of colours (prototype_of)
  double least_diameter = 8;  // px
  // Share of the region's pixels. Of a glyph of 20 px about half are of no mixture.
  double least_prototypes = 0.3;
  // Share of those with prototype colours: the slides' 5 %, or 15 where a digit is lost.
  double most_others = 0.15;
  // Shares of the third, second and first colour. Discs have 0.13, 0.31 and 0.56, and lose along their borders, small ones more.
  std::array<double, 3> least_shares{0.02, 0.15, 0.4}, most_shares{0.26, 0.5, 0.83};
  double centroids_apart = 0.08;  // of the diameter, and half a pixel
  // Of a band's deviation to that of the band within; discs have 2.1 and 1.6.
  double spread_ratio = 1.12;
  // Of a band's pixels to those of the band within: more is a higher rank, or one as high.
  double rank_ratio = 0.8;
  bool balances = true;  // colours by the paper around each glyph; else as they are
  std::array<bool, kGlyphRules> asks{true, true, true, true, true, true, true, true, true};

  bool does_ask(GlyphRule rule) const { return asks[std::size_t(rule)]; }
};

// Where a region is, from the moments of what is not paper; a filled ellipse with these moments has these axes.
struct Ellipse {
  Vector2d centre = Vector2d::Zero();  // px; the centre of the top left pixel is (1/2, 1/2)
  Eigen::Matrix2d moments = Eigen::Matrix2d::Identity();
  double area = 0;  // px

  double diameter() const;          // of a circle as large, px
  double shorter_diameter() const;  // px
  // 1 on its border.
  double radius_of(const Vector2d& pixel) const;
};

struct GlyphRegion {
  Ellipse ellipse;
  std::optional<GlyphRule> broken;  // the first rule that it breaks; none: it is a glyph
  int identity = -1;  // as its colours say, whatever rule is broken; -1: they say nothing
  GlyphCode code{-1, -1, -1};
  double classified = 0, others = 0;  // shares (kPrototypes, kOthers)
  std::array<double, 3> shares{};     // of the three colours, ascending
  double apart = 0;                   // px (kCentroids)
};

struct FoundGlyphs {
  std::vector<GlyphRegion> regions;  // all of at least 9 px, from the top left
  int glyphs() const;
};

// `is_on_wall` has kGlyphs entries.
FoundGlyphs find_glyphs(const Image<Rgba8>& picture, const FindSettings& settings,
                        const std::array<bool, kGlyphs>& is_on_wall);

}  // namespace glassbox::views
