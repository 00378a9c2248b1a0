#include "study/bench/glassbox_peer.h"

#include <bit>
#include <cstdint>

#include <glassbox/render/stereo/render_pair.h>
#include <glassbox/render/stopwatch.h>

#include "study/bench/statistics.h"

namespace glassbox::study {

namespace {

// The masked channels of `from` into the picture.
void merge(const ColorMask& mask, const Image<Rgba8>& from, Image<Rgba8>& into) {
  const auto all = [](bool on) { return std::uint8_t(on ? 255 : 0); };
  const auto taken =
      std::bit_cast<std::uint32_t>(Rgba8{all(mask.r), all(mask.g), all(mask.b), all(mask.a)});
  for (std::size_t i = 0; i < into.pixels.size(); ++i) {
    const auto kept = std::bit_cast<std::uint32_t>(into.pixels[i]) & ~taken;
    const auto added = std::bit_cast<std::uint32_t>(from.pixels[i]) & taken;
    into.pixels[i] = std::bit_cast<Rgba8>(kept | added);
  }
}

}  // namespace

GlassboxPeer::GlassboxPeer(const BenchScene& bench, const EngineOptions& options)
    : bench_(bench), drawn_(bench.passes.size()) {
  if (options.engine == Engine::kStaged) return;
  TileOptions tile = options.tile;
  tile.plan = tile.plan && bench.reject_objects;
  prepared_ = prepare(bench.scene, bench.settings.transfer);
  tiles_ = std::make_unique<TileEngine>(tile);
}

void GlassboxPeer::draw_pass(const View& view, const RenderSettings& settings, Rendering& into) {
  if (tiles_ == nullptr) {
    into = render_staged(bench_.scene, view, settings);
  } else {
    tiles_->render(bench_.scene, prepared_, view, settings, into);
  }
}

void GlassboxPeer::draw(const RenderSettings& settings) {
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    RenderSettings masked = settings;
    masked.mask = bench_.passes[i].mask;
    draw_pass(bench_.passes[i].view, masked, drawn_[i]);
    if (i > 0) merge(masked.mask, drawn_[i].buffers.color, drawn_[0].buffers.color);
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

StereoCost stereo_cost(const BenchScene& bench, int frames) {
  const auto& [centre, pair] = *bench.stereo;
  const AnaglyphMasks masks{bench.passes[0].mask, bench.passes[1].mask};
  std::vector<double> mono, shared;
  for (int i = 0; i < frames; ++i) {
    const Stopwatch watch(mono.emplace_back());
    (void)render_staged(bench.scene, centre, bench.settings);
  }
  for (int i = 0; i < frames; ++i) {
    const Stopwatch watch(shared.emplace_back());
    (void)render_masked_anaglyph(bench.scene, centre, pair, {bench.settings}, masks);
  }
  return {median(std::move(mono)), median(std::move(shared))};
}

}  // namespace glassbox::study
