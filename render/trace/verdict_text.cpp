#include <glassbox/render/trace/verdict_text.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <glassbox/base/printable.h>
#include <glassbox/pipeline/convention_changes.h>

namespace glassbox {

namespace {

std::string point_text(const Point<Object>& p) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", p.x, p.y, p.z);
}

// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? " and " : ", ";
    text += parts[i];
  }
  return text;
}

std::string pixels_text(std::uint64_t pixels) {
  return fmt::format("{} pixel{}", pixels, pixels == 1 ? "" : "s");
}

// 3.25/256 px; the whole part of what is many pixels is easier to read.
std::string subpixels_text(double subpixels) {
  if (subpixels < kSubpixels) return fmt::format("{:.4g}/{} px", subpixels, kSubpixels);
  return fmt::format("{:.9g} px", subpixels / kSubpixels);
}

const char* slip_remedy(Change change) {
  const auto all = slips();
  return std::find_if(all.begin(), all.end(), [&](const Slip& s) { return s.change == change; })
      ->remedy;
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
        "The face's outline encloses nothing: it lies on one line, or crosses itself so that its "
        "parts cancel";
  }
  return fmt::format(
      "{}, so it has no area and is left out before anything is transformed. The face's corners: "
      "{}.",
      why, listed(corners));
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
      listed(corners));
}

// ---- clip ----

template <class Number>
std::string of_corners(const ClippingVerdict& clipping, const Number& number) {
  std::vector<std::string> texts;
  for (const ClippedCorner& corner : clipping.corners) {
    texts.push_back(fmt::format("{:.9g}", number(corner)));
  }
  return listed(texts);
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

// Which side a plane bounds: nothing for depth.
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
  return text + fmt::format("They are at {}; the picture has {} x {} px.", listed(places),
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
      "clip space z = {} "
      "and w = {}, and what is kept has {}.",
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
      listed(steps), listed(corners));
}

// ---- setup, cull, coverage ----

std::string no_screen_area_text(const NoScreenAreaVerdict& found) {
  std::vector<std::string> before, after;
  for (std::size_t k = 0; k < 3; ++k) {
    before.push_back(fmt::format("({:.9g}, {:.9g})", found.screen[k].x, found.screen[k].y));
    after.push_back(fmt::format("({}, {})", found.snapped[k].x, found.snapped[k].y));
  }
  return fmt::format(
      "It has an area of {:.4g} px^2 on the screen, and none after snapping to {} steps a pixel: "
      "{} px "
      "become {} /{} px, {}.",
      found.area_px2, kSubpixels, listed(before), listed(after), kSubpixels,
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
  return fmt::format("In object space (P - eye) . m = {:.9g} +- {:.1e}, {}.", test.value,
                     test.bound + test.viewer_error_bound, meaning);
}

std::string outside_text(const Outside& outside, const View& view) {
  const auto px = [](std::int64_t subpixels) {
    return fmt::format("{:.9g} px", double(subpixels) / kSubpixels);
  };
  if (outside.beyond_edge) {
    return fmt::format(
        "It passes a corner of the picture: its box reaches in, but all of the picture lies "
        "outside one "
        "of its edges, by {:.9g} px or more.",
        *outside.beyond_edge / kSubpixels);
  }
  std::vector<std::string> sides;
  if (outside.left > 0) sides.push_back(px(outside.left) + " left of");
  if (outside.right > 0) sides.push_back(px(outside.right) + " right of");
  if (outside.top > 0) sides.push_back(px(outside.top) + " above");
  if (outside.bottom > 0) sides.push_back(px(outside.bottom) + " below");
  if (sides.empty()) sides.push_back("just beside");
  return fmt::format("It lies {} the picture of {} x {} px.", listed(sides), view.viewport.width(),
                     view.viewport.height());
}

std::string between_text(const Miss& miss) {
  if (miss.value == 0) {
    return fmt::format(
        "It owns no pixel's centre in the picture. That of pixel ({}, {}) lies exactly on one of "
        "its edges, and "
        "that "
        "edge is neither a top nor a left one, so the centre belongs to the neighbour.",
        miss.x, miss.y);
  }
  return fmt::format(
      "It covers no pixel's centre in the picture. The nearest is that of pixel ({}, {}), outside "
      "one of its "
      "edges by "
      "{} (E = {} in 1/65536 px^2).",
      miss.x, miss.y, subpixels_text(miss.subpixels), miss.value);
}

// ---- fragments ----

std::string rival_text(std::optional<std::uint32_t> number) {
  return number ? fmt::format("triangle {}", *number) : std::string("lines or points");
}

std::string rivals_text(const std::vector<Rival>& rivals) {
  constexpr std::size_t kShown = 4;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(rivals.size(), kShown); ++i) {
    texts.push_back(fmt::format("{} ({})", rival_text(rivals[i].number), rivals[i].pixels));
  }
  if (rivals.size() > kShown) texts.push_back(fmt::format("{} others", rivals.size() - kShown));
  return listed(texts);
}

std::string closest_text(const FragmentDetails::Hidden& h) {
  const std::string where = fmt::format("The closest call is at pixel ({}, {}), against {}: ", h.x,
                                        h.y, rival_text(h.by));
  if (h.code == h.stored) {
    return where + fmt::format(
                       "both have depth code 0x{:08x} (distances {:.9g} and {:.9g}), and of equal "
                       "depths the "
                       "first drawn stays.",
                       h.code, h.distance, h.stored_distance);
  }
  return where + fmt::format(
                     "depth code 0x{:08x} is not below 0x{:08x}, by {} codes; distance {:.9g} "
                     "behind {:.9g}.",
                     h.code, h.stored, h.code - h.stored, h.distance, h.stored_distance);
}

// "all 12 fragments", "3 of 12 fragments".
std::string share_text(std::uint32_t part, std::uint32_t all) {
  if (part < all) return fmt::format("{} of {} fragments", part, all);
  return all == 1 ? "its only fragment" : fmt::format("all {} fragments", all);
}

std::string unchanged_text(const FragmentTally& t, const FragmentDetails::Unchanged& u) {
  return fmt::format(
      "Of these, {} left the bytes of their pixel as they were, at ({}, {}) for one: ({}, {}, {}, "
      "{}){}.",
      t.unchanged == t.visible ? std::string("all") : std::to_string(t.unchanged), u.x, u.y,
      u.bytes.r, u.bytes.g, u.bytes.b, u.bytes.a,
      u.blended ? fmt::format(", with alpha {:.9g}", u.alpha) : "");
}

void explain_fragments(const TriangleVerdict& verdict, std::vector<std::string>& text) {
  const FragmentTally& t = verdict.fragments;
  const FragmentDetails& d = verdict.details;
  const auto share = [&](std::uint32_t part) { return share_text(part, t.covered); };
  if (t.visible > 0) {
    const PixelRect& box = d.visible_box;
    text.push_back(fmt::format("In the picture: {}, in columns {} .. {} and rows {} .. {}.",
                               share(t.visible), box.x0, box.x1 - 1, box.y0, box.y1 - 1));
    if (t.veiled > 0) {
      text.push_back(fmt::format("Translucent surfaces lie over {} of these.", t.veiled));
    }
    if (t.unchanged > 0) text.push_back(unchanged_text(t, *d.unchanged));
  }
  if (t.hidden > 0) {
    text.push_back(fmt::format("Failed the depth test: {}, behind {}.", share(t.hidden),
                               rivals_text(d.hidden_by)));
    text.push_back(closest_text(*d.closest_hidden));
  }
  if (t.discarded > 0) {
    const FragmentDetails::Discarded& found = *d.closest_discarded;
    text.push_back(fmt::format(
        "Discarded, with an alpha below the material's cutoff of {:.9g}: {}. The highest alpha "
        "is {:.9g}, at pixel ({}, {}).",
        found.cutoff, share(t.discarded), found.alpha, found.x, found.y));
  }
  if (t.masked > 0) {
    text.push_back(fmt::format("Kept out by the colour mask, which lets no channel through: {}.",
                               share(t.masked)));
  }
  if (t.overwritten > 0) {
    text.push_back(fmt::format("Written, and then written over: {}, by {}.", share(t.overwritten),
                               rivals_text(d.overwritten_by)));
  }
}

// Of cut triangles, pieces may fare differently.
std::string pieces_text(const TriangleVerdict& verdict) {
  std::vector<std::string> parts;
  if (verdict.pieces_set_up > 0)
    parts.push_back(fmt::format("{} went on to coverage", verdict.pieces_set_up));
  if (verdict.pieces_turned_away > 0) {
    parts.push_back(fmt::format("{} turned away", verdict.pieces_turned_away));
  }
  if (verdict.pieces_without_area > 0) {
    parts.push_back(fmt::format("{} without area on the screen", verdict.pieces_without_area));
  }
  const int pieces =
      verdict.pieces_set_up + verdict.pieces_turned_away + verdict.pieces_without_area;
  return fmt::format("Clipping cut it into {} pieces: {}.", pieces, listed(parts));
}

}  // namespace

const char* words_for(End end) {
  constexpr const char* kWords[kEnds] = {"no area as modelled",
                                         "not finite",
                                         "behind the eye",
                                         "outside one plane",
                                         "clipped away",
                                         "no area on the screen",
                                         "turned away",
                                         "outside the picture",
                                         "between pixel centres",
                                         "hidden",
                                         "discarded",
                                         "masked",
                                         "overwritten",
                                         "unchanged bytes",
                                         "partly visible",
                                         "visible",
                                         "drawn as lines"};
  return kWords[std::size_t(end)];
}

const char* meaning_of(End end) {
  constexpr const char* kMeanings[kEnds] = {
      "their corners lie on a line or in a point, so they are never drawn",
      "a corner overflows float on the way to clip space",
      "every w, the distance along the gaze, is 0 or less: the camera looks the other way",
      "all corners lie outside one plane: near, far or the guard band",
      "several planes together leave nothing of them",
      "after snapping to 1/256 px they are lines or points",
      "they show the side that is culled",
      "they lie beside the picture",
      "they are so small or thin that they cover no pixel's centre",
      "something nearer was drawn before them wherever they are",
      "their alpha is below the material's cutoff",
      "the colour mask lets no channel through",
      "something nearer was drawn over them afterwards",
      "what they write are the bytes that were there",
      "some of their fragments are in the picture",
      "all their fragments are in the picture",
      "their edges are drawn, not their insides"};
  return kMeanings[std::size_t(end)];
}

std::string place_of(const Scene& scene, std::uint32_t instance, std::uint32_t face) {
  const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
  return fmt::format("face {} of mesh {} (instance {})", face, in_quotes(mesh.name), instance);
}

std::vector<std::string> explain(const ViewConventions& conventions) {
  std::vector<std::string> text;
  if (conventions.hands_mixed) {
    text.push_back(fmt::format(
        "Handedness is mixed: eye_from_world gives a {}-handed eye, which looks down {}z, but "
        "clip_from_eye takes {}z "
        "for the gaze. Whatever is in front of the camera gets w < 0, and what is behind it is "
        "drawn. Remedy: {}.",
        conventions.right_handed_eye ? "right" : "left", conventions.right_handed_eye ? "-" : "+",
        conventions.gaze_is_minus_z ? "-" : "+", slip_remedy(Change::kEyeHand)));
  }
  if (conventions.opengl_range) {
    text.push_back(
        fmt::format("The projection carries the near plane to depth {:.9g}, as OpenGL's -w <= z <= "
                    "w has it; here what is kept has "
                    "0 <= z <= w, so the nearest part of the scene is cut off. Remedy: {}.",
                    conventions.near_depth, slip_remedy(Change::kDepthRange)));
  }
  return text;
}

std::vector<std::string> explain(const View& view, const TriangleVerdict& verdict) {
  std::vector<std::string> text;
  switch (verdict.end) {
    case End::kNoArea:
      text.push_back(no_area_text(*verdict.no_area));
      break;
    case End::kNotFinite:
      text.push_back(not_finite_text(*verdict.traced));
      break;
    case End::kBehindEye:
      text.push_back(behind_eye_text(*verdict.clipping));
      break;
    case End::kOutsidePlane:
      if (side_of(verdict.clipping->equation) != nullptr) {
        text.push_back(beside_text(*verdict.clipping, view));
      } else {
        text.push_back(depth_text(*verdict.clipping, view));
        if (const std::string remedy = depth_remedy(*verdict.clipping); !remedy.empty()) {
          text.push_back(remedy);
        }
        if (verdict.clipping->inside_opengl_depth) {
          text.push_back(
              "All corners have -w <= z <= w: with OpenGL's planes it would be kept (E16).");
        }
      }
      break;
    case End::kClippedAway:
      text.push_back(clipped_away_text(*verdict.clipping));
      break;
    case End::kNoScreenArea:
      text.push_back(no_screen_area_text(*verdict.no_screen_area));
      break;
    case End::kTurnedAway:
      text.push_back(cull_text(*verdict.cull));
      if (verdict.cull->object_space)
        text.push_back(object_space_text(*verdict.cull->object_space));
      break;
    case End::kOutsidePicture:
      text.push_back(outside_text(*verdict.outside, view));
      break;
    case End::kBetweenCentres:
      text.push_back(between_text(*verdict.nearest_centre));
      break;
    case End::kLines:
      text.push_back(fmt::format(
          "The picture is a wireframe: of the triangle its edges are drawn, which are seen in {}.",
          pixels_text(verdict.line_pixels)));
      break;
    default:
      explain_fragments(verdict, text);
  }
  if (verdict.pieces_without_area + verdict.pieces_turned_away + verdict.pieces_set_up > 1) {
    text.push_back(pieces_text(verdict));
  }
  for (std::string& slip : explain(verdict.conventions)) text.push_back(std::move(slip));
  return text;
}

}  // namespace glassbox
