// Glassbox as the benchmark runs it: everything that a program makes once is made once, then frames are drawn.
#pragma once

#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/render/staged.h>

#include "study/bench/picture_match.h"
#include "study/bench/scenes.h"

namespace glassbox::study {

struct EngineOptions {
  int threads = 1;
  int tile_side = 64;  // px
};

class GlassboxPeer {
public:
  // The scene must outlive it.
  explicit GlassboxPeer(const BenchScene& bench, const EngineOptions& options = {})
      : bench_(bench), options_(options), drawn_(bench.passes.size()) {}

  // Draws all passes; the time from nothing to a finished picture, in milliseconds.
  double frame_ms();

  // What a frame shows, from a run that keeps the triangles' numbers too.
  JudgedPicture picture();

private:
  void draw(const RenderSettings& settings);

  const BenchScene& bench_;
  const EngineOptions options_;
  std::vector<Rendering> drawn_;  // by pass; the first one's colours become the picture
};

// What the second eye costs: both eyes of an anaglyph in one run that shares their work, against one eye's picture.
struct StereoCost {
  double mono_ms = 0, shared_ms = 0;
};
StereoCost stereo_cost(const BenchScene& bench, const EngineOptions& options, int frames);

}  // namespace glassbox::study
