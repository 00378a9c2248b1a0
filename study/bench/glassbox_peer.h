// Runs Glassbox for the benchmark: everything that a program has to set up only once is set up
// once, then frames are drawn.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/render/engine/prepared_scene.h>
#include <glassbox/render/renderer.h>

#include "study/scenes/picture_match.h"
#include "study/scenes/scenes.h"
#include "views/layers/second_eye_error.h"

namespace glassbox::study {

struct EngineOptions {
  EngineKind engine = EngineKind::kTile;
  // Only for the tile engine; the staged engine has neither threads nor tiles.
  TileOptions tile{.threads = 1};
};

class GlassboxPeer {
public:
  // `bench` must outlive this object.
  explicit GlassboxPeer(const BenchScene& bench, const EngineOptions& options = {});

  // Draws all passes. Returns the time from an empty picture to a finished one, in milliseconds.
  double frame_ms();

  // The picture of a frame, from a run that also keeps the ids of the triangles.
  EnginePicture picture();

private:
  void draw(const RenderSettings& settings);
  // Draws on top of the picture that the earlier passes have left.
  void draw_over(const BenchPass& pass, const RenderSettings& settings, Rendering& into);

  void mark_edges_of_samples(Image<std::uint8_t>& edge) const;
  void mark_edges_behind_glass(Image<std::uint8_t>& edge) const;

  const BenchScene& bench_;
  PreparedScene prepared_;
  std::unique_ptr<Engine> engine_;
  std::vector<Rendering> drawn_;  // one per pass; the first one holds the colours of all passes
};

// The cost of the second eye: draws both eyes of an anaglyph in one run that shares their work, and
// compares this with one eye's picture by the same engine. The times are medians of frames; the two
// kinds of frames are drawn alternately.
struct StereoCost {
  double mono_ms = 0, shared_ms = 0;
  // the second picture if it is not drawn but warped from one layer of the first; absent if the
  // scene cannot be warped
  std::optional<views::SecondEyeError> warped;
};
StereoCost stereo_cost(const BenchScene& bench, const EngineOptions& options, int frames);

}  // namespace glassbox::study
