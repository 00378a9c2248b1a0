// The history of a pixel: everything that touched it, or would have, in the order in which it was drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/render/trace/reach.h>
#include <glassbox/render/trace/tracer.h>

namespace glassbox {

// In the order of the stages.
enum class Touch : std::uint8_t {
  kClipped,     // a plane cut off the part that would have covered the pixel's centre
  kTurnedAway,  // culled; would have covered it
  kHidden,      // the depth test failed
  kDiscarded,   // alpha below the cutoff
  kMasked,      // the colour mask lets nothing through
  kBlended,
  kWritten,
};
// "turned-away": stable
const char* name_of(Touch touch);

struct PixelEvent {
  Touch touch = Touch::kWritten;
  FragmentSource source;       // its number means nothing for lines and points
  std::uint32_t instance = 0;  // index into Scene::instances
  std::uint32_t face = 0;      // index into Mesh::faces; of triangles
  float distance = 0;          // along the gaze, world units

  // kClipped: the first plane that has the point outside, and the signed distance from it in clip space.
  const char* plane = "";
  double inside = 0;

  // kClipped, kTurnedAway: which side it shows, or would show.
  bool front = false;

  // kTurnedAway: as snapped; positive: counter-clockwise on the screen.
  double area_px2 = 0;

  // Fragments: the depth test is code < stored (depth_code: the smaller is nearer).
  std::uint32_t code = 0, stored = 0;
  std::optional<std::size_t> stored_by;  // the event that wrote `stored`; none: the cleared buffer
  bool writes_depth = false;

  // kDiscarded and what comes after it.
  float alpha = 1, cutoff = 0;
  // kMasked, kBlended, kWritten: linear light before blending, and the pixel's bytes, the mask applied.
  Rgba light;
  Rgba8 before, after;
  std::optional<std::size_t> overwritten_by;  // the event
};

inline bool is_fragment(const PixelEvent& event) {
  return event.touch >= Touch::kHidden;
}
// Whether the picture still shows it.
inline bool survives(const PixelEvent& event) {
  return event.touch >= Touch::kBlended && !event.overwritten_by;
}

// A triangle whose box reaches into the pixel, and which does not cover its centre.
struct PixelMiss {
  std::uint32_t number = 0;
  std::uint32_t instance = 0;
  std::uint32_t face = 0;
  Miss miss;
};

struct PixelHistory {
  int x = 0, y = 0;
  Rgba8 cleared;  // what the pixel held at first
  std::vector<PixelEvent> events;
  std::vector<PixelMiss> misses;     // the nearest first
  std::uint32_t without_area = 0;    // triangles that reach into it and have no area after snapping
  std::optional<std::size_t> shows;  // the uppermost event that survives; none: the background
  Rgba8 shown;                       // the picture's pixel
  // False where RenderSettings::show paints the picture anew in the end (depth, numbers, overdraw): then `shown` is no
  // event's bytes.
  bool shows_bytes = true;
  bool complete = true;  // false: the trace ran out of room
};

// The trace has all triangles and fragments of the pixel.
PixelHistory pixel_history(const Scene& scene, const TracedRun& run, int x, int y);

// Runs the staged reference for it. `run`, if not null, gets what it made.
PixelHistory pixel_history(const Scene& scene, const View& view, const RenderSettings& settings,
                           int x, int y, Rendering* rendering = nullptr);

}  // namespace glassbox
