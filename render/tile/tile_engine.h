// The tile engine: makes the pictures of render_staged in less time. The bytes are the same, for
// every number of threads, tile size and target.
//
// Many vertices are transformed to the screen at once. Triangles are sorted into tiles, and each
// tile is drawn by one thread. The tile's depths, and for each pixel a reference to the triangle
// that is seen there, stay in that core's cache. The colour of each pixel is computed once, at the
// end (docs/performance.md).
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
  // The largest number of vertices or triangles that go through the stages together (a round); it
  // bounds the engine's memory. A single larger draw is a round by itself.
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

  // The pictures of a pair share their vertices: for the second eye only x is computed anew. No
  // triangle is culled for both eyes at once.
  PairCullCounts draw(const PictureJob& job) override;

  // Draws the same picture as render_staged. `prepared` was made from the scene with the transfer
  // function of the settings. The engine's own counts and times are added to `report` unless it is
  // null; this costs two readings of the clock for each task.
  void render(const Scene& scene, const PreparedScene& prepared, const View& view,
              const RenderSettings& settings, Rendering& into, TileReport* report = nullptr);

  // Draws the pictures of one eye, or of the two eyes of a stereo pair. Their views differ only in
  // the x row of clip_from_eye, their settings only in the mask. Work that is done once for both
  // eyes is counted and timed in the first eye's statistics.
  void render(const Scene& scene, const PreparedScene& prepared, std::span<const EyePicture> eyes,
              TileReport* report = nullptr);

private:
  struct State;
  std::unique_ptr<State> state_;
};

// Draws one picture; the engine and the prepared scene are made for this picture alone.
Rendering render_tiled(const Scene& scene, const View& view, const RenderSettings& settings,
                       const TileOptions& options = {});

}  // namespace glassbox
