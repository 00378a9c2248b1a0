// Glassbox as the benchmark runs it: everything that a program makes once is made once, then frames are drawn.
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
  // Of the tile engine; the staged one has neither threads nor tiles.
  TileOptions tile{.threads = 1};
};

class GlassboxPeer {
public:
  // The scene must outlive it.
  explicit GlassboxPeer(const BenchScene& bench, const EngineOptions& options = {});

  // Draws all passes; the time from nothing to a finished picture, in milliseconds.
  double frame_ms();

  // What a frame shows, from a run that keeps the triangles' numbers too.
  JudgedPicture picture();

private:
  void draw(const RenderSettings& settings);
  // Over the picture that the passes before have left.
  void draw_over(const BenchPass& pass, const RenderSettings& settings, Rendering& into);

  void mark_edges_of_samples(Image<std::uint8_t>& edge) const;
  void mark_edges_behind_glass(Image<std::uint8_t>& edge) const;

  const BenchScene& bench_;
  PreparedScene prepared_;
  std::unique_ptr<Engine> engine_;
  std::vector<Rendering> drawn_;  // by pass; the first one has the colours of all
};

// What the second eye costs: both eyes of an anaglyph in one run that shares their work, against one eye's picture by the same
// engine. Medians of frames drawn by turns.
struct StereoCost {
  double mono_ms = 0, shared_ms = 0;
  std::optional<views::SecondEyeError> warped;  // from one layer; absent where it cannot be
};
StereoCost stereo_cost(const BenchScene& bench, const EngineOptions& options, int frames);

}  // namespace glassbox::study
