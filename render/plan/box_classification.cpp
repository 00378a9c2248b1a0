#include <glassbox/render/plan/box_classification.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace glassbox {

std::array<ClipPlane, 4> picture_edges(const Viewport& viewport, double margin_px) {
  const double x = 1 + 2 * margin_px / std::abs(double(viewport.width()));
  const double y = 1 + 2 * margin_px / std::abs(double(viewport.height()));
  return {{{1, 0, 0, x, 0, "left edge"},
           {-1, 0, 0, x, 0, "right edge"},
           {0, 1, 0, y, 0, "bottom edge"},
           {0, -1, 0, y, 0, "top edge"}}};
}

Box<Object> anchored_box(const Draw& draw) {
  Box<Object> box = draw.prepared->bounds;
  if (box.empty()) return box;
  const Vector<Object>& a = draw.anchor;
  box.low = {box.low.x - double(a.x), box.low.y - double(a.y), box.low.z - double(a.z)};
  box.high = {box.high.x - double(a.x), box.high.y - double(a.y), box.high.z - double(a.z)};
  return box;
}

BoxClassification classify_draw_box(const Draw& draw, const View& view, double margin_px) {
  BoxClassification classification;
  if (!draw.prepared->all_finite) return classification;
  const Box<Object> box = anchored_box(draw);
  if (box.empty()) {
    classification.outside_of = "nothing";
    return classification;
  }
  if (may_overflow(box, draw.clip_from_anchored)) return classification;
  // Returns how far the whole box is inside all of the planes; negative if a part of it is outside.
  // Also records the first plane that the whole box is outside of.
  const auto least_distance = [&](std::span<const ClipPlane> planes) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const ClipPlane& plane : planes) {
      const auto [least, greatest] =
          PlaneOverBoxes(plane, draw.clip_from_anchored).distance_range(box);
      nearest = std::min(nearest, least);
      if (greatest < 0 && classification.outside_of == nullptr) {
        classification.outside_of = plane.name;
        classification.distance = -greatest;
      }
    }
    return nearest;
  };
  const auto planes = render_planes(view);
  const double near_eye_far = least_distance(std::span(planes).first(3));
  classification.in_picture = least_distance(picture_edges(view.viewport, margin_px)) >= 0;
  if (classification.outside_of != nullptr) return classification;

  classification.in_guard_band = least_distance(std::span(planes).subspan(3)) >= 0;
  classification.inside = classification.in_guard_band && near_eye_far >= 0;
  if (classification.inside) classification.distance = near_eye_far;
  return classification;
}

}  // namespace glassbox
