#include "views/glyphs/glyph_score.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <glassbox/base/trig.h>

namespace glassbox::views {

std::vector<VisibleGlyph> visible_glyphs(const Wall& wall, const PinholeCamera& camera, int width,
                                         int height, const Image<std::uint8_t>& covered) {
  std::vector<VisibleGlyph> visible;
  for (const WallGlyph& glyph : wall.glyphs) {
    const WallPanel& panel = wall.panels[std::size_t(glyph.panel)];
    const Vector3d out = panel.down.cross(panel.right);
    if (!(out.dot(camera.centre - glyph.centre) > 0)) continue;
    const Vector3d centre = project(camera, glyph.centre);
    if (!(centre.z() > 0)) continue;
    constexpr int kPoints = 16;
    bool is_whole = true;
    double area = 0, shortest = INFINITY;
    Vector2d before = Vector2d::Zero();
    std::vector<Vector2d> border;
    for (int i = 0; i <= kPoints; ++i) {
      const SinCos turn = sin_cos_degrees(360.0 * i / kPoints);
      const Vector3d at =
          glyph.centre + wall.radius() * (turn.cos * panel.right + turn.sin * panel.down);
      const Vector2d pixel = project(camera, at).head<2>();
      is_whole = is_whole && pixel.x() > 1 && pixel.y() > 1 && pixel.x() < width - 1 &&
                 pixel.y() < height - 1;
      if (i > 0) area += (before.x() * pixel.y() - before.y() * pixel.x()) / 2;
      before = pixel;
      border.push_back(pixel);
    }
    if (!is_whole) continue;
    for (std::size_t i = 0; i < kPoints / 2; ++i)
      shortest = std::min(shortest, (border[i] - border[i + kPoints / 2]).norm());
    // The area of an ellipse, divided by that of the polygon with sixteen corners on its border.
    const double missing = 2 * kPi / kPoints / sin_cos_degrees(360.0 / kPoints).sin;
    const double diameter = 2 * std::sqrt(missing * std::abs(area) / kPi);
    if (!covered.pixels.empty()) {
      int all = 0, hidden = 0;
      const int reach = int(diameter);
      for (int y = std::max(0, int(centre.y()) - reach);
           y <= std::min(height - 1, int(centre.y()) + reach); ++y) {
        for (int x = std::max(0, int(centre.x()) - reach);
             x <= std::min(width - 1, int(centre.x()) + reach); ++x) {
          if ((Vector2d(x + 0.5, y + 0.5) - centre.head<2>()).norm() > diameter / 2) continue;
          ++all;
          hidden += covered.at(x, y) != 0;
        }
      }
      if (10 * hidden > all) continue;
    }
    visible.push_back({glyph.identity, centre.head<2>(), diameter, shortest});
  }
  return visible;
}

GlyphScore glyph_score(const FoundGlyphs& found, const Wall& wall, const PinholeCamera& camera,
                       const std::vector<VisibleGlyph>& visible) {
  GlyphScore score;
  score.visible = int(visible.size());
  for (const GlyphRegion& region : found.regions) {
    if (region.broken) continue;
    const WallGlyph* glyph = wall.find(region.identity);
    const Vector3d seen = glyph == nullptr ? Vector3d::Zero() : project(camera, glyph->centre);
    const bool is_there =
        glyph != nullptr && seen.z() > 0 &&
        (seen.head<2>() - region.ellipse.centre).norm() < region.ellipse.diameter() / 2;
    const bool is_visible = std::ranges::any_of(
        visible, [&](const VisibleGlyph& one) { return one.identity == region.identity; });
    if (!is_there)
      ++score.wrong;
    else if (is_visible)
      ++score.right;
    else
      ++score.partly;
  }
  return score;
}

}  // namespace glassbox::views
