// Finds glyphs in a picture: regions that are not paper, and the rules by which a region is a glyph
// (S1-25, S1-26).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <glassbox/images/image.h>

#include "views/glyphs/glyph_code.h"
#include "views/two_view/camera.h"

namespace glassbox::views {

// In the order in which the rules are applied.
enum class GlyphRule {
  kWhole,       // the region does not touch the picture's border
  kSize,        // its shorter diameter is long enough
  kPrototypes,  // enough of its pixels have prototype colours, apart from mixtures along borders
  kOthers,      // few of those have a fourth colour
  kAreas,       // the three colours' shares are those of concentric discs
  kCentroids,   // the three colours have one centre
  kSpread,      // the wider a band, the further its pixels are spread
  kRanks,       // the colours have the same order by number of pixels and by spread
  kSheet,       // the code is on the wall
};
inline constexpr int kGlyphRules = 9;
std::string_view name_of(GlyphRule rule);

struct FindSettings {
  float threshold = 0.4f;     // for colours (prototype_of)
  double least_diameter = 8;  // px
  // Share of the region's pixels. In a glyph of 20 px about half of the pixels are not mixtures.
  double least_prototypes = 0.3;
  // Share of the pixels with prototype colours. The slides have 5 %; it is 15 % here, as if they
  // had lost a digit.
  double most_others = 0.15;
  // Shares of the third, second and first colour by area. Discs have 0.13, 0.31 and 0.56; they lose
  // pixels along their borders, small discs more.
  std::array<double, 3> least_shares{0.02, 0.15, 0.4}, most_shares{0.26, 0.5, 0.83};
  double max_centroid_distance = 0.08;  // share of the diameter; half a pixel is added
  // Least ratio of a band's standard deviation to that of the next band inside; discs have 2.1 and
  // 1.6.
  double spread_ratio = 1.12;
  // Least ratio of a band's pixels to those of the next band inside: at this ratio a band still
  // counts as equal or larger.
  double rank_ratio = 0.8;
  // Colours are relative to the paper around each glyph; else they are used as they are.
  bool balances = true;
  std::array<bool, kGlyphRules> enabled_rules{true, true, true, true, true, true, true, true, true};

  bool is_enabled(GlyphRule rule) const { return enabled_rules[std::size_t(rule)]; }
};

// Position and shape of a region, from the moments of the pixels that are not paper: the filled
// ellipse with the same moments.
struct Ellipse {
  Vector2d centre = Vector2d::Zero();  // px; the centre of the top left pixel is (1/2, 1/2)
  Eigen::Matrix2d moments = Eigen::Matrix2d::Identity();
  double area = 0;  // px

  double diameter() const;          // of a circle of equal area, px
  double shorter_diameter() const;  // px
  // The pixel's distance from the centre in units of the ellipse's radius in that direction: 1 on
  // the border.
  double radius_of(const Vector2d& pixel) const;
};

struct GlyphRegion {
  Ellipse ellipse;
  std::optional<GlyphRule> broken;  // the first rule that it breaks; none: it is a glyph
  int identity = -1;                // from its colours, even if a rule is broken; -1: unknown
  GlyphCode code{-1, -1, -1};
  double classified = 0, others = 0;  // shares (kPrototypes, kOthers)
  std::array<double, 3> shares{};     // of the three colours, ascending
  double centroid_distance = 0;       // px (kCentroids)
};

struct FoundGlyphs {
  std::vector<GlyphRegion> regions;  // all regions of at least 9 px, from the top left
  int glyphs() const;
};

// `is_on_wall` has kGlyphs entries.
FoundGlyphs find_glyphs(const Image<Rgba8>& picture, const FindSettings& settings,
                        const std::array<bool, kGlyphs>& is_on_wall);

}  // namespace glassbox::views
