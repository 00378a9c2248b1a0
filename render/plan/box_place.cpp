#include <glassbox/render/plan/box_place.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace glassbox {

namespace {

// The least and the greatest distance of the box's corners from a plane.
struct Distances {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
};

Distances distances_from(const ClipPlane& plane, const Box<Object>& box,
                         const Transform<Clip, Object, float>& clip_from_object) {
  const std::array<double, 4> coefficients{plane.a, plane.b, plane.c, plane.d};
  Distances distances;
  for (int i = 0; i < 8; ++i) {
    const Point<Object, double> p = box.corner(i);
    double distance = plane.e;
    for (int row = 0; row < 4; ++row) {
      const double coordinate =
          double(clip_from_object.at(row, 0)) * p.x + double(clip_from_object.at(row, 1)) * p.y +
          double(clip_from_object.at(row, 2)) * p.z + double(clip_from_object.at(row, 3));
      distance += coefficients[std::size_t(row)] * coordinate;
    }
    distances.least = std::min(distances.least, distance);
    distances.greatest = std::max(distances.greatest, distance);
  }
  return distances;
}

}  // namespace

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

BoxPlace place_box(const Draw& draw, const View& view, double margin_px) {
  BoxPlace place;
  if (!draw.prepared->all_finite) return place;
  const Box<Object> box = anchored_box(draw);
  if (box.empty()) {
    place.outside_of = "nothing";
    return place;
  }
  const auto verdict = [&](std::span<const ClipPlane> planes) {
    return classify_box(box, draw.clip_from_anchored, planes);
  };
  const auto find_rejecting = [&](std::span<const ClipPlane> planes) {
    if (verdict(planes) != ClipVerdict::kReject) return;
    const auto rejects = [&](const ClipPlane& plane) {
      return verdict({&plane, 1}) == ClipVerdict::kReject;
    };
    const auto plane = std::ranges::find_if(planes, rejects);
    place.outside_of = plane->name;
    place.distance = -distances_from(*plane, box, draw.clip_from_anchored).greatest;
  };

  const auto planes = render_planes(view);
  const std::span<const ClipPlane> near_eye_far(planes.data(), 3);
  find_rejecting(near_eye_far);
  if (place.outside_of == nullptr) find_rejecting(picture_edges(view.viewport, margin_px));
  if (place.outside_of != nullptr) return place;

  place.in_guard_band = verdict(std::span(planes).subspan(3)) == ClipVerdict::kAccept;
  place.inside = place.in_guard_band && verdict(near_eye_far) == ClipVerdict::kAccept;
  if (place.inside) {
    place.distance = std::numeric_limits<double>::infinity();
    for (const ClipPlane& plane : near_eye_far) {
      place.distance =
          std::min(place.distance, distances_from(plane, box, draw.clip_from_anchored).least);
    }
  }
  return place;
}

}  // namespace glassbox
