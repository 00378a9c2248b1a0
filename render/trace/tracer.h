// Records what a run does; a filter selects what is recorded.
#pragma once

#include <cstdint>
#include <optional>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

// A record must fulfil all conditions. Empty ones are always fulfilled: TraceFilter{.triangle = 4}
// has one condition.
struct TraceFilter {
  std::optional<std::uint32_t> instance{};  // index into Scene::instances
  std::optional<std::uint32_t> triangle{};  // number in the whole scene
  // Index into Mesh::positions: triangles with that vertex.
  std::optional<std::uint32_t> position{};
  // Fragments of these pixels, and triangles whose box on the screen reaches into them, or that
  // would reach into them if nothing clipped them.
  std::optional<PixelRect> pixels{};
  // By stage: whether triangles, fragments and the colours of fragments are recorded.
  bool triangles = true;
  bool fragments = true;
  bool colors = true;
  std::uint64_t max_bytes = std::uint64_t(256) << 20;
};

// Returns the record of a draw.
TracedDraw record_of(const Draw& draw, const Scene& scene);

// Receives records as soon as they are complete: all draws, and the triangles and fragments that
// pass the filter.
class TraceSink {
public:
  virtual ~TraceSink() = default;
  virtual void draw(const TracedDraw& /*draw*/) {}
  virtual void triangle(const TracedTriangle& /*triangle*/) {}
  virtual void fragment(const TracedFragment& /*fragment*/) {}
};

struct StreamedRun {
  Rendering rendering;   // the same bytes as those of a run without an observer
  bool complete = true;  // false: the filter's limit of bytes was reached
};

// Traces one run of the staged reference. The additional time is proportional to what is recorded,
// plus a few comparisons for each triangle and fragment.
StreamedRun trace(const Scene& scene, const View& view, const RenderSettings& settings,
                  const TraceFilter& filter, TraceSink& sink);

struct TracedRun {
  Rendering rendering;
  Trace trace;
};

// Traces one run of the staged reference and keeps all of its records.
TracedRun trace(const Scene& scene, const View& view, const RenderSettings& settings,
                const TraceFilter& filter);

}  // namespace glassbox
