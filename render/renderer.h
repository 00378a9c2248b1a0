// A scene and the engine that draws it. What all of its pictures have in common is made once.
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

// Both make the same bytes.
enum class EngineKind { kTile, kStaged };

std::unique_ptr<Engine> make_engine(EngineKind kind, const TileOptions& options = {});

constexpr std::string_view name_of(EngineKind engine) {
  return engine == EngineKind::kTile ? "tile" : "staged";
}

class Renderer {
public:
  // The scene must outlive it and not change. `transfer` is that of the settings rendered with.
  Renderer(const Scene& scene, Transfer transfer, std::unique_ptr<Engine> engine);

  // `options` are the tile engine's.
  Renderer(const Scene& scene, Transfer transfer, EngineKind kind = EngineKind::kTile,
           const TileOptions& options = {});

  // As render_staged; the depth plane only if it is asked for.
  Rendering render(const View& view, const RenderSettings& settings);
  // The same into memory that has had a picture. `behind`: as EyePicture has it.
  void render(const View& view, const RenderSettings& settings, Rendering& into,
              const Image<std::uint32_t>* behind = nullptr);

  // As the functions of the same names.
  StereoRendering render_pair(const View& centre, const StereoPair& pair,
                              const StereoSettings& settings);
  void render_pair(const View& centre, const StereoPair& pair, const StereoSettings& settings,
                   StereoRendering& into);
  StereoRendering render_masked_anaglyph(const View& centre, const StereoPair& pair,
                                         const StereoSettings& settings,
                                         const AnaglyphMasks& masks);

private:
  // The first picture's time has what was made for all.
  void count_preparation(Statistics& statistics);

  const Scene& scene_;
  double prepare_ms_ = 0;
  PreparedScene prepared_;
  std::unique_ptr<Engine> engine_;
};

}  // namespace glassbox
