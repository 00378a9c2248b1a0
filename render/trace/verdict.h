// Finds why a triangle ended as it did: the stage, the test and the numbers that decided.
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
#include <glassbox/render/trace/coverage_miss.h>
#include <glassbox/render/trace/depth_fights.h>
#include <glassbox/render/trace/numbering.h>
#include <glassbox/render/trace/records.h>
#include <glassbox/render/trace/result_counter.h>
#include <glassbox/render/trace/triangle_result.h>

namespace glassbox {

// ---- the view ----

// The conventions that the matrices of a view follow. The matrices of make_view agree with each
// other; matrices combined by hand may not.
struct ViewConventions {
  bool right_handed_eye = true;  // det(eye_from_world) > 0
  bool gaze_is_minus_z = true;   // the projection's gaze is along -z; otherwise +z
  bool hands_mixed = false;      // the two fields above contradict each other (E12, C-07)
  // z/w of the point at distance `near` along the gaze; should be 0, or 1 for a reversed range.
  double near_depth = 0;
  // Whether `near_depth` is closer to -1: the projection is then made for -w <= z <= w (E16).
  bool opengl_range = false;
};
ViewConventions conventions_of(const View& view);

// ---- assembly ----

enum class NoArea : std::uint8_t {
  kRepeatedPosition,  // corners of the face are at the same place
  kCollinear,         // the triangle's corners are on a line
  kWholeFace,         // a face of more than three corners without area: a line, or crossing itself
};

struct NoAreaVerdict {
  NoArea reason = NoArea::kCollinear;
  std::vector<Point<Object>> corners;  // all corners of the face
};

// ---- clip ----

struct ClippedCorner {
  Point<Clip> clip;
  double along_gaze = 0;  // -z in eye space: world units in front of the eye
  double inside = 0;      // signed distance from the deciding plane; negative: outside
  std::optional<Point<Screen, double>> screen;  // px, and depth in NDC; set if w > 0
};

struct ClipCount {
  const char* plane = "";
  int vertices_left = 0;
};

struct ClippingVerdict {
  // Index into Trace::planes: all corners are outside this plane, or nothing was left after it.
  std::size_t plane = 0;
  ClipPlane equation;
  std::array<ClippedCorner, 3> corners;
  std::vector<ClipCount> steps;      // for kClippedAway: up to the deciding plane
  bool inside_opengl_depth = false;  // all corners have -w <= z <= w (E16)
};

// ---- setup and cull ----

struct NoScreenAreaVerdict {
  double area_px2 = 0;  // before snapping, unsigned
  std::array<Point<Screen>, 3> screen;
  std::array<SnappedVertex, 3> snapped;  // 1/256 px
};

struct CullVerdict {
  double area_px2 = 0;  // after snapping, exact; positive: counter-clockwise as seen on the screen
  bool front = false;
  bool mirrored = false;  // the model matrix mirrors: front faces run clockwise
  Cull rule = Cull::kMaterial;
  bool double_sided = false;
  // The back-face test in object space, the sign of (P - eye) . m, where P is a corner and m the
  // Newell vector; none if the model matrix has no inverse.
  std::optional<BackFaceTest> object_space;
};

// ---- the whole ----

struct TriangleVerdict {
  NumberedTriangle triangle;
  TriangleResult result = TriangleResult::kNoArea;
  ViewConventions conventions;
  std::optional<TracedTriangle> traced;  // none: no area as modelled
  int pieces_without_area = 0, pieces_turned_away = 0, pieces_set_up = 0;
  // The results of the stage that decided:
  std::optional<NoAreaVerdict> no_area;
  std::optional<ClippingVerdict> clipping;  // for kBehindEye, kOutsidePlane, kClippedAway
  std::optional<NoScreenAreaVerdict> no_screen_area;
  std::optional<CullVerdict> cull;  // set if one triangle of the fan is turned away
  std::optional<OutsideDistances> outside;
  // The centre in the picture that is missed by the least.
  std::optional<CentreMiss> nearest_centre;
  TriangleFragmentCounts fragments;
  FragmentDetails details;
  std::vector<DepthFight> fights;  // z-fighting with other triangles: those with most pixels first
  std::uint64_t line_pixels = 0;   // for kLines: the pixels in which its edges are seen
};

// Runs the staged reference once, and a second time if there are fragments to follow. Returns an
// error if there is no triangle with this number.
Result<TriangleVerdict> triangle_verdict(const Scene& scene, const View& view,
                                         const RenderSettings& settings, std::uint64_t number);

}  // namespace glassbox
