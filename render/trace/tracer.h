// Records what a run does, as far as a filter asks for it.
#pragma once

#include <cstdint>
#include <optional>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/staged.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

// All conditions have to hold. Empty ones hold always.
struct TraceFilter {
  std::optional<std::uint32_t> instance;  // index into Scene::instances
  std::optional<std::uint32_t> triangle;  // number in the whole scene
  // Fragments of these pixels, and triangles whose box on the screen reaches into them, or would if they had not been
  // clipped at the near and far planes.
  std::optional<PixelRect> pixels;
  bool triangles = true;
  bool fragments = true;
  std::uint64_t max_bytes = std::uint64_t(256) << 20;
};

struct TracedRun {
  Rendering rendering;  // the same bytes as those of a run that nobody watches
  Trace trace;
};

// One run of the staged reference. Time beyond that of the run is in proportion to what is recorded, plus a few
// comparisons for each triangle and fragment.
TracedRun trace(const Scene& scene, const View& view, const RenderSettings& settings,
                const TraceFilter& filter);

}  // namespace glassbox
