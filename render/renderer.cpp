#include <glassbox/render/renderer.h>

#include <utility>

#include <glassbox/render/engine/stopwatch.h>
#include <glassbox/render/tile/tile_pair.h>

namespace glassbox {

Renderer::Renderer(const Scene& scene, Transfer transfer, Engine engine, const TileOptions& options)
    : scene_(scene) {
  if (engine == Engine::kStaged) return;
  const Stopwatch watch(prepare_ms_);
  prepared_ = prepare(scene, transfer);
  tiles_ = std::make_unique<TileEngine>(options);
}

void Renderer::count_preparation(Statistics& statistics) {
  statistics.prepare_ms += std::exchange(prepare_ms_, 0);
}

Rendering Renderer::render(const View& view, const RenderSettings& settings) {
  if (!tiles_) return render_staged(scene_, view, settings);
  Rendering rendering;
  tiles_->render(scene_, prepared_, view, settings, rendering);
  count_preparation(rendering.statistics);
  return rendering;
}

StereoRendering Renderer::render_pair(const View& centre, const StereoPair& pair,
                                      const StereoSettings& settings) {
  if (!tiles_) return glassbox::render_pair(scene_, centre, pair, settings);
  StereoRendering both;
  glassbox::render_pair(*tiles_, scene_, prepared_, centre, pair, settings, both);
  count_preparation(both.left_statistics);
  return both;
}

StereoRendering Renderer::render_masked_anaglyph(const View& centre, const StereoPair& pair,
                                                 const StereoSettings& settings,
                                                 const AnaglyphMasks& masks) {
  if (!tiles_) return glassbox::render_masked_anaglyph(scene_, centre, pair, settings, masks);
  StereoRendering both;
  glassbox::render_masked_anaglyph(*tiles_, scene_, prepared_, centre, pair, settings, masks, both);
  count_preparation(both.left_statistics);
  return both;
}

}  // namespace glassbox
