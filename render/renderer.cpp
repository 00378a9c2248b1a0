#include <glassbox/render/renderer.h>

#include <utility>

#include <glassbox/render/engine/stopwatch.h>

namespace glassbox {

std::unique_ptr<Engine> make_engine(EngineKind kind, const TileOptions& options) {
  if (kind == EngineKind::kStaged) return std::make_unique<StagedEngine>();
  return std::make_unique<TileEngine>(options);
}

Renderer::Renderer(const Scene& scene, Transfer transfer, std::unique_ptr<Engine> engine)
    : scene_(scene), engine_(std::move(engine)) {
  const Stopwatch watch(prepare_ms_);
  prepared_ = prepare_scene(scene, transfer);
}

Renderer::Renderer(const Scene& scene, Transfer transfer, EngineKind kind,
                   const TileOptions& options)
    : Renderer(scene, transfer, make_engine(kind, options)) {}

void Renderer::count_preparation(Statistics& statistics) {
  statistics.prepare_ms += std::exchange(prepare_ms_, 0);
}

Rendering Renderer::render(const View& view, const RenderSettings& settings) {
  Rendering rendering;
  render(view, settings, rendering);
  return rendering;
}

void Renderer::render(const View& view, const RenderSettings& settings, Rendering& into,
                      const Image<std::uint32_t>* behind_depth) {
  Framebuffer& buffers = into.buffers;
  // `behind_depth` has one depth per pixel, which does not say anything about its samples.
  RenderSettings used = settings;
  if (behind_depth != nullptr) used.samples = 1;
  const EyePicture eye{view, used, buffers, buffers.color, into.statistics, {}, behind_depth};
  engine_->draw({scene_, prepared_, {&eye, 1}});
  count_preparation(into.statistics);
}

StereoRendering Renderer::render_pair(const View& centre, const StereoPair& pair,
                                      const StereoSettings& settings) {
  StereoRendering both;
  render_pair(centre, pair, settings, both);
  return both;
}

void Renderer::render_pair(const View& centre, const StereoPair& pair,
                           const StereoSettings& settings, StereoRendering& into) {
  glassbox::render_pair(*engine_, scene_, prepared_, centre, pair, settings, into);
  count_preparation(into.left_statistics);
}

StereoRendering Renderer::render_masked_anaglyph(const View& centre, const StereoPair& pair,
                                                 const StereoSettings& settings,
                                                 const AnaglyphMasks& masks) {
  StereoRendering both;
  glassbox::render_masked_anaglyph(*engine_, scene_, prepared_, centre, pair, settings, masks,
                                   both);
  count_preparation(both.left_statistics);
  return both;
}

}  // namespace glassbox
