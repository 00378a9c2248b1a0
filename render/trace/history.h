// The history of a pixel: everything that touched it, or would have touched it, in the order of
// drawing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/render/trace/coverage_miss.h>
#include <glassbox/render/trace/tracer.h>

namespace glassbox {

// The effect of a triangle or fragment on the pixel, in the order of the stages.
enum class PixelEventKind : std::uint8_t {
  kClipped,     // a plane cut off the part that would have covered the pixel's centre
  kTurnedAway,  // culled; it would have covered the pixel's centre
  kHidden,      // the depth test failed
  kDiscarded,   // alpha below the cutoff
  kMasked,      // the colour mask lets nothing through
  kBlended,
  kWritten,
};
// A stable name, such as "turned-away".
const char* name_of(PixelEventKind kind);

struct PixelEvent {
  PixelEventKind kind = PixelEventKind::kWritten;
  FragmentSource source;       // its number has no meaning for lines and points
  std::uint32_t instance = 0;  // index into Scene::instances
  std::uint32_t face = 0;      // index into Mesh::faces; only for triangles
  float distance = 0;          // along the direction of view, world units

  // kClipped: the first plane that the point is outside of, and its signed distance from that plane
  // in clip space.
  const char* plane = "";
  double inside = 0;

  // kClipped, kTurnedAway: whether the front is seen, or would be.
  bool front = false;

  // kTurnedAway: the area after snapping; positive: counter-clockwise on the screen.
  double area_px2 = 0;

  // For fragments: the depth test is code < stored (depth_code: the smaller is nearer).
  std::uint32_t code = 0, stored = 0;
  std::optional<std::size_t> stored_by;  // the event that wrote `stored`; none: the cleared buffer
  bool writes_depth = false;

  // For kDiscarded and the kinds after it: the surface's alpha, and the material's cutoff.
  float alpha = 1, cutoff = 0;
  // kMasked, kBlended, kWritten: linear light before blending, and the pixel's bytes after applying
  // the mask.
  Rgba light;
  Rgba8 before, after;
  std::optional<std::size_t> overwritten_by;  // index of the event that overwrote it
};

inline bool is_fragment(const PixelEvent& event) {
  return event.kind >= PixelEventKind::kHidden;
}
// Whether the final picture still shows the event.
inline bool survives(const PixelEvent& event) {
  return event.kind >= PixelEventKind::kBlended && !event.overwritten_by;
}

// A triangle whose box reaches into the pixel, but which does not cover the pixel's centre.
struct PixelMiss {
  std::uint32_t number = 0;
  std::uint32_t instance = 0;
  std::uint32_t face = 0;
  CentreMiss miss;
};

struct PixelHistory {
  int x = 0, y = 0;
  Rgba8 cleared;  // what the pixel held at the beginning
  std::vector<PixelEvent> events;
  std::vector<PixelMiss> misses;  // the nearest first
  // Triangles whose box reaches into the pixel, and which have no area after snapping.
  std::uint32_t without_area = 0;
  std::optional<std::size_t> shows;  // the last event that is still visible; none: the background
  Rgba8 shown;                       // the picture's pixel
  // False if the picture is replaced at the end according to RenderSettings::show (depth, numbers,
  // overdraw): then `shown` is not the bytes of any event.
  bool shows_bytes = true;
  bool complete = true;  // false: the trace reached its memory limit
};

// Makes the history from a trace, which must have all triangles and fragments of the pixel.
PixelHistory pixel_history(const Scene& scene, const TracedRun& run, int x, int y);

// Runs the staged reference to find the history. `rendering`, if not null, receives the picture.
PixelHistory pixel_history(const Scene& scene, const View& view, const RenderSettings& settings,
                           int x, int y, Rendering* rendering = nullptr);

}  // namespace glassbox
