// The tile engine: makes the pictures of render_staged in less time. The bytes are the same, for
// every number of threads, tile size and target.
//
// Many vertices are transformed to the screen at once. Triangles are sorted into tiles, and each
// tile is drawn by one thread, with its depths and the references of what is seen at its pixels in
// that core's cache. The colour of each pixel is computed once, at the end (docs/performance.md).
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
  // The largest number of vertices and triangles that go to the screen together, or one draw: it
  // bounds the engine's memory.
  std::size_t round_size = std::size_t{1} << 23;
  Planner planner = make_plans;  // tests use wrong plans
};

// The engine keeps its threads and memory from one picture to the next.
class TileEngine : public Engine {
public:
  explicit TileEngine(const TileOptions& options);
  ~TileEngine() override;
  TileEngine(const TileEngine&) = delete;
  TileEngine& operator=(const TileEngine&) = delete;

  // The pictures of a pair share their vertices: for the other eye only x is computed anew. Nothing
  // is culled for both eyes beforehand.
  PairCullCounts draw(const PictureJob& job) override;

  // The same as render_staged. `prepared` was made from the scene with the settings' transfer. The
  // numbers are added to `report` unless it is null; this costs two readings of the clock for each
  // task.
  void render(const Scene& scene, const PreparedScene& prepared, const View& view,
              const RenderSettings& settings, Rendering& into, TileReport* report = nullptr);

  // The same for one eye, or for the two of a stereo pair, in this order. Their views differ only
  // in the x row of clip_from_eye, their settings only in the mask. Work done once for both is
  // counted and timed with the first.
  void render(const Scene& scene, const PreparedScene& prepared, std::span<const EyePicture> eyes,
              TileReport* report = nullptr);

private:
  struct State;
  std::unique_ptr<State> state_;
};

// Draws one picture; everything is made for this picture alone.
Rendering render_tiled(const Scene& scene, const View& view, const RenderSettings& settings,
                       const TileOptions& options = {});

}  // namespace glassbox
