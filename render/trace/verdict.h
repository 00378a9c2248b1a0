// What became of a triangle: the stage, the test and the numbers that decided.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/back_face.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/trace/end.h>
#include <glassbox/render/trace/ledger.h>
#include <glassbox/render/trace/numbering.h>
#include <glassbox/render/trace/reach.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

// ---- the view ----

// What the matrices of a view agree on. Those of make_view agree on everything; those that somebody composed may not.
struct ViewConventions {
  bool right_handed_eye = true;  // det(eye_from_world) > 0
  bool gaze_is_minus_z = true;   // what the projection takes for the gaze: +z otherwise
  bool hands_mixed = false;      // the two do not belong together (SPEC E12, C-07)
  double near_depth = 0;  // z/w of the point `near` along the gaze; 0, or 1 for a reversed range
  // `near_depth` is closer to -1: the projection is made for -w <= z <= w (E16).
  bool opengl_range = false;
};
ViewConventions conventions_of(const View& view);

// ---- assembly ----

enum class NoArea : std::uint8_t {
  kRepeatedPosition,  // corners of the face are at the same place
  kCollinear,         // the triangle's corners lie on a line
  kWholeFace,  // more than three corners whose outline encloses nothing: on a line, or crossing itself
};

struct NoAreaVerdict {
  NoArea reason = NoArea::kCollinear;
  std::vector<Point<Object>> corners;  // of the whole face
};

// ---- clip ----

struct ClippedCorner {
  Point<Clip> clip;
  double along_gaze = 0;  // -z of eye space: world units in front of the eye
  double inside = 0;      // signed distance from the deciding plane; negative: outside
  std::optional<Point<Screen, double>> screen;  // px, and depth of NDC; where w > 0
};

struct ClipCount {
  const char* plane = "";
  int vertices_left = 0;
};

struct ClippingVerdict {
  // Index into Trace::planes: all corners lie outside of it, or it left nothing of the rest.
  std::size_t plane = 0;
  ClipPlane equation;
  std::array<ClippedCorner, 3> corners;
  std::vector<ClipCount> steps;      // of kClippedAway: up to the deciding plane
  bool inside_opengl_depth = false;  // all corners have -w <= z <= w (E16)
};

// ---- setup and cull ----

struct NoScreenAreaVerdict {
  double area_px2 = 0;  // before snapping, unsigned
  std::array<Point<Screen>, 3> screen;
  std::array<SnappedVertex, 3> snapped;  // 1/256 px
};

struct CullVerdict {
  double area_px2 = 0;  // as snapped, exactly; positive: counter-clockwise as seen on the screen
  bool front = false;
  bool mirrored = false;  // the model matrix mirrors: fronts run clockwise
  Cull rule = Cull::kMaterial;
  bool double_sided = false;
  // (P - eye) . m; none where the model matrix has no inverse.
  std::optional<BackFaceTest> object_space;
};

// ---- the whole ----

struct TriangleVerdict {
  NumberedTriangle triangle;
  End end = End::kNoArea;
  ViewConventions conventions;
  std::optional<TracedTriangle> traced;  // none: no area as modelled
  int pieces_without_area = 0, pieces_turned_away = 0, pieces_set_up = 0;
  // What the stage that decided has found:
  std::optional<NoAreaVerdict> no_area;
  std::optional<ClippingVerdict> clipping;  // kBehindEye, kOutsidePlane, kClippedAway
  std::optional<NoScreenAreaVerdict> no_screen_area;
  std::optional<CullVerdict> cull;  // wherever a piece is turned away
  std::optional<Outside> outside;
  std::optional<Miss> nearest_centre;  // of those in the picture
  FragmentTally fragments;
  FragmentDetails details;
  std::uint64_t line_pixels = 0;  // of kLines: where its edges are seen
};

// Runs the staged reference once, and again where there are fragments to follow. An error where there is no such number.
Result<TriangleVerdict> triangle_verdict(const Scene& scene, const View& view,
                                         const RenderSettings& settings, std::uint64_t number);

// How many triangles end where.
struct SceneVerdict {
  struct Group {
    std::uint64_t triangles = 0;
    // Of what is seen, the one with the most visible pixels; else the first.
    std::uint32_t example = 0;
    std::uint32_t example_pixels = 0;
  };
  std::array<Group, kEnds> groups;
  std::uint64_t triangles = 0;
  ViewConventions conventions;

  const Group& at(End end) const { return groups[std::size_t(end)]; }
  // The end of the most triangles among those that are not seen.
  std::optional<End> commonest_loss() const;
  bool all_lost() const;
};

SceneVerdict scene_verdict(const Scene& scene, const View& view, const RenderSettings& settings);

}  // namespace glassbox
