// Finds where the triangles of a scene end, and, if little of the scene is seen, why: facts are
// counted in one run, each lost triangle is given to one cause, and the cause that costs the most
// triangles comes first.
//
// Many triangles of a picture are lost for no fault: half of a closed surface shows its back, and
// surfaces hide each other. They have no cause here. What counts as such depends on the object:
// backs are ordinary if other triangles of the same instance reach the picture, or if its surface
// is closed and its fronts are outside.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/trace/depth_fights.h>
#include <glassbox/render/trace/triangle_result.h>
#include <glassbox/render/trace/verdict.h>

namespace glassbox {

enum class Cause : std::uint8_t {
  kEmptyScene,        // there is nothing to draw
  kNoArea,            // faces without area as modelled
  kDegenerateMatrix,  // a model, view or projection matrix without inverse
  kMixedHands,        // view and projection are made for eyes of opposite handedness (E12)
  kNotFinite,         // corners overflow float
  kInside,            // the eye is inside a closed surface, whose fronts are outside
  kBehind,            // everything is behind the eye
  kLooksAway,         // the camera looks past it
  kNearPlane,         // nearer than the near plane
  kFarPlane,          // beyond the far plane
  kTooSmall,          // smaller than a pixel, or nearly so
  kInsideOut,         // all of a surface shows its back
  kMirroredNode,      // the same, and its node mirrors
  kAlphaTest,         // discarded by the alpha test
  kTransparent,       // blended with an alpha of 0
  kMasked,            // the colour mask lets nothing through
  kSameColor,         // drawn in the colours that were there
};
inline constexpr std::size_t kCauses = std::size_t(Cause::kSameColor) + 1;

// A name that stays the same, for programs that read it: "near-plane".
const char* name_of(Cause cause);

struct SceneCause {
  Cause cause = Cause::kEmptyScene;
  std::uint64_t triangles = 0;           // that are lost by it
  std::optional<std::uint32_t> example;  // one of them: a number in the scene
  std::uint32_t instance = 0;            // the instance of the example
};

// Where the scene is, as the camera sees it. World units; angles in degrees.
struct SceneExtent {
  Point<World, double> eye, middle;  // of the camera; of the scene's bounding box
  Vector<World, double> gaze, size;  // unit length; of the bounding box
  double nearest = 0, farthest = 0;  // along the gaze; negative: behind the eye
  double to_the_right = 0, up = 0;   // the direction of `middle`, from the gaze; parallel: units
  double half_width = 0, half_height = 0;  // where the picture ends, in the units of the line above
  double width_px = 0, height_px = 0;      // of what is in front of the eye, on the screen
};

struct SceneVerdict {
  // How many triangles have each result.
  struct Group {
    std::uint64_t triangles = 0;
    // The triangle with the most visible pixels; if none is visible, the first one.
    std::uint32_t example = 0;
    std::uint32_t example_pixels = 0;
  };
  std::array<Group, kTriangleResults> groups;
  std::uint64_t triangles = 0;
  std::uint64_t pixels = 0;        // of the picture
  std::uint64_t shown_pixels = 0;  // in which something is seen that changed their bytes
  ViewConventions conventions;
  SceneExtent extent;
  float highest_discarded_alpha = -1;  // among all discarded fragments; below 0: there are none
  std::vector<DepthFight> fights;      // z-fighting: the pairs with most pixels first
  // The causes, those that cost most triangles first; empty unless is_little_seen().
  std::vector<SceneCause> causes;

  const Group& at(TriangleResult result) const { return groups[std::size_t(result)]; }
  // The most frequent result among the triangles that are not seen.
  std::optional<TriangleResult> most_frequent_loss() const;
  bool all_lost() const;
  // Whether the scene is seen in less than a thousandth of the picture.
  bool is_little_seen() const { return shown_pixels * 1000 < pixels; }
};

// Runs the staged reference once.
SceneVerdict scene_verdict(const Scene& scene, const View& view, const RenderSettings& settings);

}  // namespace glassbox
