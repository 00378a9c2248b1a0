// The staged reference: every stage in order (reference.h), one primitive after the other. The
// picture it makes is the correct one by definition.
#pragma once

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/engine.h>

namespace glassbox {

// Triangles pass through the stages in batches, each followed by its fragments, so that each stage
// can be timed and memory stays small.
inline constexpr std::size_t kTriangleBatch = 1024;

// Draws pictures by the staged reference. The eyes of a pair are drawn in two runs. The second run
// reuses what is the same for both eyes: y, z and w of clip space, and eye space (S0-03).
class StagedEngine : public Engine {
public:
  PairCullCounts draw(const PictureJob& job) override;
  bool culls_as_centre() const override { return true; }
};

struct Rendering {
  Framebuffer buffers;
  Statistics statistics;
};

// Renders a picture of the viewport's size. The view comes from make_view (which checks the
// camera), with DepthRange::kReversed if and only if the settings' depth format is reversed.
// `observers` are called at every stage.
Rendering render_staged(const Scene& scene, const View& view, const RenderSettings& settings,
                        const Observers& observers = {});

}  // namespace glassbox
