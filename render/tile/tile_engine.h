// The tile engine: what render_staged makes, in less time. Same bytes, for every number of threads, tile size and target.
//
// The scene is carried to the screen many vertices at a time; triangles are sorted into tiles; each tile is drawn by one
// thread, with its depths and what is seen at each of its pixels in that core's cache, and its colours are computed once for
// each pixel, at the end (docs/performance.md).
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/lanes/target.h>
#include <glassbox/render/engine/engine.h>
#include <glassbox/render/engine/threads.h>
#include <glassbox/render/plan/plan.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/tile/tile_report.h>

namespace glassbox {

struct TileOptions {
  int threads = 0;     // 0: default_threads()
  int tile_side = 64;  // pixels; a power of two, 16 .. 256
  Target target = best_target();
  bool plan = true;  // leave out what the scene does not need
  // Vertices and triangles that are carried to the screen together, or one draw: what bounds the engine's memory.
  std::size_t round_size = std::size_t{1} << 23;
  Planner planner = make_plans;  // tests plant wrong plans
};

// Keeps its threads and memory from one picture to the next.
class TileEngine : public Engine {
public:
  explicit TileEngine(const TileOptions& options);
  ~TileEngine() override;
  TileEngine(const TileEngine&) = delete;
  TileEngine& operator=(const TileEngine&) = delete;

  // Pictures of a pair share their vertices: the other eye's get an x of their own. Nothing is culled for both eyes beforehand.
  NotSubmitted draw(const PictureJob& job) override;

  // As render_staged. `prepared` was made from the scene with the settings' transfer. `report`, unless null, is added to, at the cost
  // of two looks at the clock for each task.
  void render(const Scene& scene, const PreparedScene& prepared, const View& view,
              const RenderSettings& settings, Rendering& into, TileReport* report = nullptr);

  // The same for one eye, or for the two of a stereo pair, in this order: their views differ in the row of x of clip_from_eye
  // alone, their settings in the mask. Work done once for both is counted and timed with the first.
  void render(const Scene& scene, const PreparedScene& prepared, std::span<const EyePicture> eyes,
              TileReport* report = nullptr);

private:
  struct State;
  std::unique_ptr<State> state_;
};

// One picture, with everything made for it alone.
Rendering render_tiled(const Scene& scene, const View& view, const RenderSettings& settings,
                       const TileOptions& options = {});

}  // namespace glassbox
