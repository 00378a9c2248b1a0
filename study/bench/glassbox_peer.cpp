#include "study/bench/glassbox_peer.h"

#include <functional>
#include <utility>

#include <glassbox/raster/blend.h>
#include <glassbox/render/engine/stopwatch.h>
#include <glassbox/render/stereo/render_pair.h>

#include "study/bench/statistics.h"

namespace glassbox::study {

GlassboxPeer::GlassboxPeer(const BenchScene& bench, const EngineOptions& options)
    : bench_(bench),
      prepared_(prepare(bench.scene, bench.settings.transfer)),
      drawn_(bench.passes.size()) {
  TileOptions tile = options.tile;
  tile.plan = tile.plan && bench.reject_objects;
  engine_ = make_engine(options.engine, tile);
}

void GlassboxPeer::draw_over(const BenchPass& pass, const RenderSettings& settings,
                             Rendering& into) {
  Image<Rgba8>& picture = drawn_.front().buffers.color;
  const EyePicture eye{pass.view, settings, into.buffers, picture, into.statistics};
  engine_->draw({bench_.scene, prepared_, {&eye, 1}});
}

void GlassboxPeer::draw(const RenderSettings& settings) {
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    RenderSettings masked = settings;
    masked.mask = bench_.passes[i].mask;
    draw_over(bench_.passes[i], masked, drawn_[i]);
  }
}

double GlassboxPeer::frame_ms() {
  double elapsed = 0;
  {
    const Stopwatch watch(elapsed);
    draw(bench_.settings);
  }
  return elapsed;
}

JudgedPicture GlassboxPeer::picture() {
  RenderSettings settings = bench_.settings;
  settings.want_id = true;
  draw(settings);
  JudgedPicture judged;
  judged.picture.color = drawn_[0].buffers.color;
  judged.picture.covered = Image<std::uint8_t>(bench_.width(), bench_.height());
  judged.edge = Image<std::uint8_t>(bench_.width(), bench_.height());
  for (const Rendering& pass : drawn_) mark_edges(pass.buffers.id, judged.edge);
  mark_covered(drawn_.back().buffers.depth, judged.picture.covered);
  return judged;
}

StereoCost stereo_cost(const BenchScene& bench, const EngineOptions& options, int frames) {
  const View& centre = bench.stereo->centre;  // by name: a lambda takes no binding in clang 14
  const StereoPair& pair = bench.stereo->pair;
  const AnaglyphMasks masks{bench.passes[0].mask, bench.passes[1].mask};
  const StereoSettings both_settings{bench.settings};
  Rendering one;
  StereoRendering both;
  const PreparedScene prepared = prepare(bench.scene, bench.settings.transfer);
  const std::unique_ptr<Engine> engine = make_engine(options.engine, options.tile);
  const auto draw_one = [&] {
    const EyePicture eye{centre, bench.settings, one.buffers, one.buffers.color, one.statistics};
    engine->draw({bench.scene, prepared, {&eye, 1}});
  };
  const auto draw_both = [&] {
    render_masked_anaglyph(*engine, bench.scene, prepared, centre, pair, both_settings, masks,
                           both);
  };
  const auto timed = [](const std::function<void()>& draw) {
    double elapsed = 0;
    {
      const Stopwatch watch(elapsed);
      draw();
    }
    return elapsed;
  };
  timed(draw_one);
  timed(draw_both);
  std::vector<double> mono, shared;
  for (int i = 0; i < frames; ++i) {
    mono.push_back(timed(draw_one));
    shared.push_back(timed(draw_both));
  }
  return {median(std::move(mono)), median(std::move(shared))};
}

}  // namespace glassbox::study
