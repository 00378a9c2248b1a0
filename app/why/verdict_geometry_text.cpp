#include <algorithm>

#include <fmt/format.h>

#include "app/why/verdict_text.h"

namespace glassbox {

namespace {

std::string point_text(const Point<Object>& p) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", p.x, p.y, p.z);
}

// ---- assembly and vertices ----

std::string no_area_text(const NoAreaVerdict& found) {
  constexpr std::size_t kShown = 8;
  std::vector<std::string> corners;
  for (std::size_t i = 0; i < std::min(found.corners.size(), kShown); ++i) {
    corners.push_back(point_text(found.corners[i]));
  }
  if (found.corners.size() > kShown) {
    corners.push_back(fmt::format("{} more", found.corners.size() - kShown));
  }
  const char* why = "The triangle's corners lie on one line";
  if (found.reason == NoArea::kRepeatedPosition) why = "Corners of the face are at the same place";
  if (found.reason == NoArea::kWholeFace) {
    why =
        "The signed area of the face is 0: its corners lie on one line, or its outline crosses "
        "itself so that the areas of its parts cancel";
  }
  return fmt::format(
      "{}, so it has no area and is left out before anything is transformed. The face's corners: "
      "{}.",
      why, list_in_words(corners));
}

std::string not_finite_text(const TracedTriangle& triangle) {
  std::vector<std::string> corners;
  for (const TracedCorner& corner : triangle.corners) {
    const Point<Clip>& c = corner.clip;
    corners.push_back(fmt::format("{} -> ({:.9g}, {:.9g}, {:.9g}, {:.9g})",
                                  point_text(corner.object), c.x, c.y, c.z, c.w));
  }
  return fmt::format(
      "A corner overflows float (3.4e38) on the way to clip space: {}. Scale the model down.",
      list_in_words(corners));
}

// ---- clip ----

template <class Number>
std::string of_corners(const ClippingVerdict& clipping, const Number& number) {
  std::vector<std::string> texts;
  for (const ClippedCorner& corner : clipping.corners) {
    texts.push_back(fmt::format("{:.9g}", number(corner)));
  }
  return list_in_words(texts);
}

std::string w_text(const ClippingVerdict& clipping) {
  return of_corners(clipping, [](const ClippedCorner& c) { return c.clip.w; });
}

std::string behind_eye_text(const ClippingVerdict& clipping) {
  const bool all_negative =
      std::all_of(clipping.corners.begin(), clipping.corners.end(),
                  [](const ClippedCorner& corner) { return corner.clip.w < 0; });
  return fmt::format("{}: w = {}. w is the distance along the gaze, so {}.",
                     all_negative ? "Every w is negative" : "No w is positive", w_text(clipping),
                     all_negative ? "all of it is behind the eye"
                                  : "it lies in the plane of the eye (w = 0) and behind it");
}

// The side of the picture that a plane bounds; null for near and far.
const char* side_of(const ClipPlane& plane) {
  if (plane.a > 0) return "left of";
  if (plane.a < 0) return "right of";
  if (plane.b > 0) return "below";
  return plane.b < 0 ? "above" : nullptr;
}

std::string beside_text(const ClippingVerdict& clipping, const View& view) {
  const ClipPlane& plane = clipping.equation;
  std::string text =
      fmt::format("All corners lie {} the picture, beyond the guard band ({} px from its middle). ",
                  side_of(plane), kGuardBandPx);
  std::vector<std::string> places;
  for (const ClippedCorner& corner : clipping.corners) {
    if (!corner.screen) {
      places.push_back(fmt::format("behind the eye (w = {:.9g})", corner.clip.w));
    } else if (plane.a != 0) {
      places.push_back(fmt::format("x = {:.9g} px", corner.screen->x));
    } else {
      places.push_back(fmt::format("y = {:.9g} px", corner.screen->y));
    }
  }
  return text + fmt::format("They are at {}; the picture has {} x {} px.", list_in_words(places),
                            view.viewport.width(), view.viewport.height());
}

std::string depth_text(const ClippingVerdict& clipping, const View& view) {
  const std::string name = clipping.equation.name;
  const std::string distances =
      of_corners(clipping, [](const ClippedCorner& c) { return c.along_gaze; });
  const std::string z = of_corners(clipping, [](const ClippedCorner& c) { return c.clip.z; });
  if (name == "eye") {
    return fmt::format(
        "All corners are too close to the plane of the eye: w = {}, less than {:.9g}, half the "
        "distance of the near plane.",
        w_text(clipping), -clipping.equation.e);
  }
  const bool near = name == "near";
  return fmt::format(
      "All corners are {} than the {} plane, which is at {:.9g} along the gaze: they are at {}. In "
      "clip space z = {} and w = {}, and what is kept has {}.",
      near ? "nearer" : "further", near ? "near" : "far", near ? view.near : view.far, distances, z,
      w_text(clipping), clipping.equation.c > 0 ? "z >= 0" : "z <= w");
}

std::string depth_remedy(const ClippingVerdict& clipping) {
  const auto [least, greatest] =
      std::minmax_element(clipping.corners.begin(), clipping.corners.end(),
                          [](const auto& a, const auto& b) { return a.along_gaze < b.along_gaze; });
  if (std::string(clipping.equation.name) == "far") {
    return fmt::format("--far {:.4g} would let all of it in.", greatest->along_gaze * 1.01);
  }
  if (std::string(clipping.equation.name) != "near" || least->along_gaze <= 0) return {};
  return fmt::format("--near {:.4g} would let all of it in.", least->along_gaze * 0.99);
}

std::vector<std::string> outside_plane_texts(const TriangleVerdict& verdict, const View& view) {
  const ClippingVerdict& clipping = *verdict.clipping;
  if (side_of(clipping.equation) != nullptr) return {beside_text(clipping, view)};
  std::vector<std::string> texts{depth_text(clipping, view)};
  if (const std::string remedy = depth_remedy(clipping); !remedy.empty()) texts.push_back(remedy);
  if (clipping.inside_opengl_depth && verdict.conventions.opengl_range) {
    texts.push_back(
        "All corners have -w <= z <= w: with OpenGL's planes it would be kept (E16 in "
        "docs/references.md).");
  }
  return texts;
}

std::string clipped_away_text(const ClippingVerdict& clipping) {
  std::vector<std::string> steps;
  int before = 3;
  for (const ClipCount& step : clipping.steps) {
    if (step.vertices_left == 0) {
      steps.push_back(fmt::format("the {} plane leaves nothing of it", step.plane));
    } else if (step.vertices_left != before) {
      steps.push_back(
          fmt::format("after the {} plane it has {} vertices", step.plane, step.vertices_left));
    }
    before = step.vertices_left;
  }
  std::vector<std::string> corners;
  for (const ClippedCorner& corner : clipping.corners) {
    const Point<Clip>& c = corner.clip;
    corners.push_back(fmt::format("({:.6g}, {:.6g}, {:.6g}, {:.6g})", c.x, c.y, c.z, c.w));
  }
  return fmt::format(
      "No single plane has all of it outside, but together they leave nothing: {}. "
      "Its corners in clip space: {}.",
      list_in_words(steps), list_in_words(corners));
}

// ---- setup, cull, coverage ----

std::string no_screen_area_text(const NoScreenAreaVerdict& found) {
  std::vector<std::string> before, after;
  for (std::size_t k = 0; k < 3; ++k) {
    before.push_back(fmt::format("({:.9g}, {:.9g})", found.screen[k].x, found.screen[k].y));
    after.push_back(fmt::format("({}, {})", found.snapped[k].x, found.snapped[k].y));
  }
  return fmt::format(
      "It has an area of {:.4g} px^2 on the screen, but no area after snapping to {} steps per "
      "pixel: {} px become {} /{} px, {}.",
      found.area_px2, kSubpixels, list_in_words(before), list_in_words(after), kSubpixels,
      found.snapped[0] == found.snapped[1] && found.snapped[1] == found.snapped[2]
          ? "one point"
          : "which lie on one line");
}

const char* rule_text(const CullVerdict& found) {
  switch (found.rule) {
    case Cull::kBack:
      return "back faces are culled (--cull back)";
    case Cull::kFront:
      return "front faces are culled (--cull front)";
    default:
      return "back faces are culled, because the material is not double-sided";
  }
}

std::string cull_text(const CullVerdict& found) {
  return fmt::format(
      "It shows its {}: its corners run {} on the screen (signed area {:.9g} px^2){}; {}.",
      found.front ? "front" : "back", found.area_px2 < 0 ? "clockwise" : "counter-clockwise",
      found.area_px2,
      found.mirrored ? ", and the model matrix mirrors (det < 0), so that its front runs clockwise"
                     : "",
      rule_text(found));
}

std::string object_space_text(const BackFaceTest& test) {
  const char* meaning = "so the eye lies in its plane";
  if (test.facing == Facing::kBack) meaning = "greater than 0, so the eye is behind its plane";
  if (test.facing == Facing::kFront) meaning = "less than 0, so the eye is in front of its plane";
  return fmt::format(
      "In object space (P - eye) . m, where P is a corner and m the normal, is {:.9g} +- {:.1e}, "
      "{}.",
      test.value, test.bound + test.viewer_error_bound, meaning);
}

std::vector<std::string> cull_texts(const CullVerdict& found) {
  std::vector<std::string> texts{cull_text(found)};
  if (found.object_space) texts.push_back(object_space_text(*found.object_space));
  return texts;
}

std::string outside_text(const OutsideDistances& outside, const View& view) {
  const auto px = [](std::int64_t subpixels) {
    return fmt::format("{:.9g} px", double(subpixels) / kSubpixels);
  };
  if (outside.beyond_edge) {
    return fmt::format(
        "It lies beside a corner of the picture: its bounding box reaches into the picture, but "
        "all of the picture is outside one of its edges, by {:.9g} px or more.",
        *outside.beyond_edge / kSubpixels);
  }
  std::vector<std::string> sides;
  if (outside.left > 0) sides.push_back(px(outside.left) + " left of");
  if (outside.right > 0) sides.push_back(px(outside.right) + " right of");
  if (outside.top > 0) sides.push_back(px(outside.top) + " above");
  if (outside.bottom > 0) sides.push_back(px(outside.bottom) + " below");
  if (sides.empty()) sides.push_back("just beside");
  return fmt::format("It lies {} the picture of {} x {} px.", list_in_words(sides),
                     view.viewport.width(), view.viewport.height());
}

std::string between_text(const CentreMiss& miss) {
  if (miss.value == 0) {
    return fmt::format(
        "It owns no pixel's centre in the picture. That of pixel ({}, {}) lies exactly on one of "
        "its edges, and that edge is neither a top nor a left one, so the centre belongs to the "
        "neighbour.",
        miss.x, miss.y);
  }
  return fmt::format(
      "It covers no pixel's centre in the picture. The nearest is that of pixel ({}, {}), outside "
      "one of its edges by {} (edge function E = {} in 1/65536 px^2).",
      miss.x, miss.y, subpixels_text(miss.subpixels), miss.value);
}

}  // namespace

std::vector<std::string> explain_geometry(const View& view, const TriangleVerdict& verdict) {
  switch (verdict.result) {
    case TriangleResult::kNoArea:
      return {no_area_text(*verdict.no_area)};
    case TriangleResult::kNotFinite:
      return {not_finite_text(*verdict.traced)};
    case TriangleResult::kBehindEye:
      return {behind_eye_text(*verdict.clipping)};
    case TriangleResult::kOutsidePlane:
      return outside_plane_texts(verdict, view);
    case TriangleResult::kClippedAway:
      return {clipped_away_text(*verdict.clipping)};
    case TriangleResult::kNoScreenArea:
      return {no_screen_area_text(*verdict.no_screen_area)};
    case TriangleResult::kTurnedAway:
      return cull_texts(*verdict.cull);
    case TriangleResult::kOutsidePicture:
      return {outside_text(*verdict.outside, view)};
    case TriangleResult::kBetweenCentres:
      return {between_text(*verdict.nearest_centre)};
    default:
      return {};
  }
}

}  // namespace glassbox
