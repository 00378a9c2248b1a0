// A scene and the engine that draws it. The data that all pictures of the scene share is made once.
#pragma once

#include <memory>
#include <string_view>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/prepared_scene.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/stereo/render_pair.h>
#include <glassbox/render/tile/tile_engine.h>

namespace glassbox {

// The engines of the library. Both draw the same bytes.
enum class EngineKind { kTile, kStaged };

std::unique_ptr<Engine> make_engine(EngineKind kind, const TileOptions& options = {});

constexpr std::string_view name_of(EngineKind engine) {
  return engine == EngineKind::kTile ? "tile" : "staged";
}

class Renderer {
public:
  // The scene must outlive the renderer and not change. `transfer` must be the transfer function of
  // the settings that pictures are rendered with.
  Renderer(const Scene& scene, Transfer transfer, std::unique_ptr<Engine> engine);

  // `options` are for the tile engine.
  Renderer(const Scene& scene, Transfer transfer, EngineKind kind = EngineKind::kTile,
           const TileOptions& options = {});

  // Draws the same picture as render_staged; the depths are stored only if they are wanted.
  Rendering render(const View& view, const RenderSettings& settings);
  // Does the same, but writes to memory that is reused. `behind_depth`: see
  // EyePicture::behind_depth.
  void render(const View& view, const RenderSettings& settings, Rendering& into,
              const Image<std::uint32_t>* behind_depth = nullptr);

  // Do the same as the functions of these names in render_pair.h, with this engine and scene.
  StereoRendering render_pair(const View& centre, const StereoPair& pair,
                              const StereoSettings& settings);
  void render_pair(const View& centre, const StereoPair& pair, const StereoSettings& settings,
                   StereoRendering& into);
  StereoRendering render_masked_anaglyph(const View& centre, const StereoPair& pair,
                                         const StereoSettings& settings,
                                         const AnaglyphMasks& masks);

private:
  // Adds the time of preparing the scene to the statistics of the first picture.
  void count_preparation(Statistics& statistics);

  const Scene& scene_;
  double prepare_ms_ = 0;
  PreparedScene prepared_;
  std::unique_ptr<Engine> engine_;
};

}  // namespace glassbox
