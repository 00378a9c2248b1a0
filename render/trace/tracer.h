// Records what a run does, as far as a filter asks for it.
#pragma once

#include <cstdint>
#include <optional>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

// All conditions have to hold. Empty ones hold always: TraceFilter{.triangle = 4}.
struct TraceFilter {
  std::optional<std::uint32_t> instance{};  // index into Scene::instances
  std::optional<std::uint32_t> triangle{};  // number in the whole scene
  std::optional<std::uint32_t> position{};  // into Mesh::positions: triangles with that vertex
  // Fragments of these pixels, and triangles whose box on the screen reaches into them, or would if they had not been
  // clipped at the near and far planes.
  std::optional<PixelRect> pixels{};
  // By stage: what there is of triangles, of fragments, and of the colours of fragments.
  bool triangles = true;
  bool fragments = true;
  bool colors = true;
  std::uint64_t max_bytes = std::uint64_t(256) << 20;
};

// What a trace keeps of a draw.
TracedDraw record_of(const Draw& draw, const Scene& scene);

// Where records go, as soon as they are complete: all draws come, the rest as the filter has it.
class TraceSink {
public:
  virtual ~TraceSink() = default;
  virtual void draw(const TracedDraw& /*draw*/) {}
  virtual void triangle(const TracedTriangle& /*triangle*/) {}
  virtual void fragment(const TracedFragment& /*fragment*/) {}
};

struct SunkRun {
  Rendering rendering;   // the same bytes as those of a run that nobody watches
  bool complete = true;  // false: the filter's bytes were used up
};

// One run of the staged reference. Time beyond that of the run is in proportion to what is recorded, plus a few
// comparisons for each triangle and fragment.
SunkRun trace(const Scene& scene, const View& view, const RenderSettings& settings,
              const TraceFilter& filter, TraceSink& sink);

struct TracedRun {
  Rendering rendering;
  Trace trace;
};

// Such a run with all of its records kept.
TracedRun trace(const Scene& scene, const View& view, const RenderSettings& settings,
                const TraceFilter& filter);

}  // namespace glassbox
