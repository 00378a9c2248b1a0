#include "views/glyphs/decoys.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glassbox/base/elementary.h>
#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/images/srgb.h>

#include "views/glyphs/colors.h"

namespace glassbox::views {

namespace {

constexpr int kColumns = 12, kCell = 84;

Light light_of_prototype(int color) {
  return light_of(kPrototypeColors[std::size_t(color)]);
}

// The three prototypes that the code does not use.
std::array<int, 3> others_of(const GlyphCode& code) {
  std::array<int, 3> others{};
  std::size_t count = 0;
  for (int color = 0; color < kPrototypes; ++color) {
    if (std::ranges::find(code, color) == code.end()) others[count++] = color;
  }
  return others;
}

// The light at (x, y) of a decoy of radius 1; none outside of it.
std::optional<Light> light_at_decoy(const Decoy& decoy, double x, double y) {
  const GlyphCode code = code_of(decoy.identity);
  const double radius = hypotenuse(x, y);
  const auto within = [&](double inner, double middle) {
    return light_of_prototype(code[radius < inner ? 0u : radius < middle ? 1u : 2u]);
  };
  if (radius >= 1) return std::nullopt;
  if (!decoy.breaks) return within(kDiscRadii[0], kDiscRadii[1]);
  switch (*decoy.breaks) {
    // A brown disc, whose colour is no prototype, around three small discs.
    case GlyphRule::kPrototypes: {
      if (radius >= 0.5) return light_of({120, 100, 84, 255});
      return within(1.0 / 6, 1.0 / 3);
    }
    // Six wedges in the outer band, in the three prototypes that the glyph does not use.
    case GlyphRule::kOthers: {
      const double turn = arctan2(y, x) / 6.283185307179586 + 0.5;  // 0 .. 1
      const int wedge = int(6 * turn);
      if (radius >= kDiscRadii[1] && 6 * turn - wedge < 0.4)
        return light_of_prototype(others_of(code)[std::size_t(wedge % 3)]);
      return within(kDiscRadii[0], kDiscRadii[1]);
    }
    // Three bands of nearly a third of the area each.
    case GlyphRule::kAreas:
      return within(0.56, 0.79);
    // The inner discs have other centres than the outer disc.
    case GlyphRule::kCentroids: {
      if (hypotenuse(x - 0.55, y) < 1.0 / 3) return light_of_prototype(code[0]);
      if (hypotenuse(x - 0.3, y) < 2.0 / 3) return light_of_prototype(code[1]);
      return light_of_prototype(code[2]);
    }
    // The three colours in small squares, spread evenly over the disc: none of them is clearly
    // further from the centre than another.
    case GlyphRule::kSpread: {
      const int column = int(std::floor(8 * (x + 1))), row = int(std::floor(8 * (y + 1)));
      const int place = (column * 5 + row * 7 + decoy.identity) % 9;
      return light_of_prototype(code[place < 1 ? 0u : place < 4 ? 1u : 2u]);
    }
    // The inner band has the largest area, the outer band the smallest.
    case GlyphRule::kRanks:
      return within(std::sqrt(0.5), std::sqrt(0.83));
    case GlyphRule::kWhole:
    case GlyphRule::kSize:
    case GlyphRule::kSheet:
      return within(kDiscRadii[0], kDiscRadii[1]);
  }
  return std::nullopt;
}

}  // namespace

DecoyPicture draw_decoys() {
  DecoyPicture result;
  constexpr int kRows = kGlyphRules + 1;
  result.picture = Image<Rgba8>(kColumns * kCell, kRows * kCell, {255, 255, 255, 255});
  std::ranges::fill_n(result.is_on_sheet.begin(), kGlyphs / 2, true);
  Random random(26);
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      Decoy decoy;
      if (row > 0) decoy.breaks = GlyphRule(row - 1);
      decoy.identity = int(random.integer(0, kGlyphs / 2 - 1));
      if (decoy.breaks == GlyphRule::kSheet) decoy.identity += kGlyphs / 2;
      double radius = random.between(22, 30);
      if (decoy.breaks == GlyphRule::kSize) radius = random.between(3, 3.6);
      decoy.x = (column + 0.5) * kCell + random.between(-4, 4);
      decoy.y = (row + 0.5) * kCell + random.between(-4, 4);
      // The picture's border cuts off only half a pixel of the disc.
      if (decoy.breaks == GlyphRule::kWhole) {
        decoy.y = row * kCell + kCell / 2.0;
        decoy.x = column % 2 == 0 ? radius - 0.5 : kColumns * kCell - radius + 0.5;
        if (column > 1) continue;
      }
      result.decoys.push_back(decoy);
      for (int y = int(decoy.y - radius) - 1; y <= int(decoy.y + radius) + 1; ++y) {
        for (int x = std::max(0, int(decoy.x - radius) - 1);
             x <= std::min(result.picture.width - 1, int(decoy.x + radius) + 1); ++x) {
          constexpr int kPoints = 4;
          Light sum = Light::Zero();
          for (int i = 0; i < kPoints * kPoints; ++i) {
            const double across = (x + (i % kPoints + 0.5) / kPoints - decoy.x) / radius,
                         down = (y + (i / kPoints + 0.5) / kPoints - decoy.y) / radius;
            sum += light_at_decoy(decoy, across, down).value_or(Light(1, 1, 1));
          }
          sum /= float(kPoints * kPoints);
          result.picture.at(x, y) = {encode_srgb(sum[0]), encode_srgb(sum[1]), encode_srgb(sum[2]),
                                     255};
        }
      }
    }
  }
  return result;
}

int DecoyScore::all_accepted() const {
  return std::accumulate(accepted.begin(), accepted.end(), 0);
}

DecoyScore score_decoys(const DecoyPicture& picture, const FindSettings& settings) {
  const FoundGlyphs found = find_glyphs(picture.picture, settings, picture.is_on_sheet);
  DecoyScore score;
  for (const Decoy& decoy : picture.decoys) {
    score.glyphs += !decoy.breaks;
    for (const GlyphRegion& region : found.regions) {
      const double off =
          hypotenuse(region.ellipse.centre.x() - decoy.x, region.ellipse.centre.y() - decoy.y);
      if (region.broken || off > kCell / 4.0) continue;
      if (decoy.breaks)
        ++score.accepted[std::size_t(*decoy.breaks)];
      else if (region.identity == decoy.identity)
        ++score.found;
    }
  }
  return score;
}

}  // namespace glassbox::views
