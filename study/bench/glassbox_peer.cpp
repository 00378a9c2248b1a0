#include "study/bench/glassbox_peer.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include <glassbox/raster/blend.h>
#include <glassbox/render/engine/stopwatch.h>
#include <glassbox/render/plan/plan.h>
#include <glassbox/render/stereo/render_pair.h>

#include "study/bench/statistics.h"
#include "study/scenes/edges.h"

namespace glassbox::study {

namespace {

const Material& material_of(const Scene& scene, const Instance& instance) {
  return scene.materials[scene.meshes[instance.mesh].material];
}

std::ptrdiff_t count_draws(const Scene& scene, AlphaMode mode) {
  return std::ranges::count_if(scene.instances, [&](const Instance& instance) {
    return material_of(scene, instance).alpha_mode == mode;
  });
}

bool has_levels(const Scene& scene) {
  return std::ranges::any_of(scene.textures, [](const Texture& texture) {
    return texture.sampler.mip != MipFilter::kNone;
  });
}

// Allows an additional fraction `share` of the pixels to differ from the peer's picture by up to
// `by` levels (of 255).
void widen(MatchBounds& bounds, double share, int by) {
  bounds.beyond_share += share;
  bounds.beyond = std::max(bounds.beyond, by);
}

// How much the pictures of Glassbox and OpenGL may differ; docs/benchmark.md lists the measured
// differences.
MatchBounds bounds_of(const BenchScene& bench) {
  MatchBounds bounds;
  bounds.samples = bench.settings.samples;
  bounds.eyes = int(bench.passes.size());
  bounds.beyond = bounds.same_color;
  // OpenGL computes one mipmap level for a block of 2 x 2 pixels, from the differences between
  // these pixels; Glassbox computes a level for each pixel.
  if (has_levels(bench.scene)) widen(bounds, 0.02, 16);
  // The colour is rounded to a byte after each blended layer, and with alphas of 1/8 up to 8 such
  // errors add up. With fewer than 8 layers they add up in few pixels; with 8 or more it may happen
  // in any pixel, because llvmpipe always rounds to the same side on some processors.
  constexpr std::ptrdiff_t kLayersThatAddUp = 8;
  if (const auto layers = count_draws(bench.scene, AlphaMode::kBlend); layers > 0) {
    widen(bounds, layers < kLayersThatAddUp ? 0.001 : 1, 10);
  }
  // An alpha mask may discard some samples of a pixel even where no triangle's edge is near its
  // centre.
  const bool cuts_samples = bounds.samples > 1 && count_draws(bench.scene, AlphaMode::kMask) > 0;
  if (cuts_samples) widen(bounds, 0.0001, 64);
  return bounds;
}

// Plans to draw every object, even one outside the frustum; its triangles and pixels are then
// rejected later in the pipeline.
std::vector<Plan> plan_all_draws(std::span<const PlannedEye> eyes, bool leave_out) {
  std::vector<Plan> plans = make_plans(eyes, leave_out);
  for (Plan& plan : plans) {
    plan.order.resize(plan.methods.size());
    std::iota(plan.order.begin(), plan.order.end(), 0u);
    for (DrawMethod& method : plan.methods) method.drawn = true;
  }
  return plans;
}

}  // namespace

GlassboxPeer::GlassboxPeer(const BenchScene& bench, const EngineOptions& options)
    : bench_(bench),
      prepared_(prepare_scene(bench.scene, bench.settings.transfer)),
      drawn_(bench.passes.size()) {
  TileOptions tile = options.tile;
  if (!bench.reject_objects) tile.planner = plan_all_draws;
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

EnginePicture GlassboxPeer::picture() {
  RenderSettings settings = bench_.settings;
  settings.want_id = true;
  settings.want_depth = true;
  draw(settings);
  EnginePicture drawn;
  drawn.bounds = bounds_of(bench_);
  drawn.picture.color = drawn_[0].buffers.color;
  drawn.picture.covered = Image<std::uint8_t>(bench_.width(), bench_.height());
  drawn.edge = Image<std::uint8_t>(bench_.width(), bench_.height());
  for (const Rendering& pass : drawn_) mark_edges(pass.buffers.id, drawn.edge);
  mark_covered(drawn_.back().buffers.depth, drawn.picture.covered);
  if (settings.samples > 1) mark_edges_of_samples(drawn.edge);
  if (count_draws(bench_.scene, AlphaMode::kBlend) > 0) mark_edges_behind_glass(drawn.edge);
  return drawn;
}

// An object so small that it lies between pixel centres covers samples, but no pixel centre. So
// edges are also marked in pictures that are drawn at the sample positions.
void GlassboxPeer::mark_edges_of_samples(Image<std::uint8_t>& edge) const {
  RenderSettings settings = with_one_sample(bench_.settings);
  settings.want_id = true;
  for (std::size_t i = 0; i < bench_.passes.size(); ++i) {
    for (const SampleOffset& offset : sample_offsets(bench_.settings.samples)) {
      Rendering seen;
      const View view = view_at_sample(bench_.passes[i].view, offset);
      const EyePicture eye{view, settings, seen.buffers, seen.buffers.color, seen.statistics};
      engine_->draw({bench_.scene, prepared_, {&eye, 1}});
      mark_edges(seen.buffers.id, edge);
      mark_differences(seen.buffers.id, drawn_[i].buffers.id, edge);
    }
  }
}

// Where several blended triangles overlap, the image of triangle ids keeps only the last triangle
// and hides the edges of the triangles behind it. So all edges of blended triangles are drawn as
// lines, in an opaque wireframe, where only lines can hide parts of lines.
void GlassboxPeer::mark_edges_behind_glass(Image<std::uint8_t>& edge) const {
  Scene lines = bench_.scene;
  std::erase_if(lines.instances, [&](const Instance& instance) {
    return material_of(lines, instance).alpha_mode != AlphaMode::kBlend;
  });
  for (Material& material : lines.materials) {
    Material plain;
    plain.double_sided = material.double_sided;
    plain.unlit = true;
    material = plain;
  }
  const PreparedScene prepared = prepare_scene(lines, bench_.settings.transfer);
  RenderSettings settings = with_one_sample(bench_.settings);
  settings.wireframe = true;
  settings.want_depth = true;
  for (const BenchPass& pass : bench_.passes) {
    Rendering seen;
    const EyePicture eye{pass.view, settings, seen.buffers, seen.buffers.color, seen.statistics};
    engine_->draw({lines, prepared, {&eye, 1}});
    mark_edges(seen.buffers.depth, edge);
  }
}

StereoCost stereo_cost(const BenchScene& bench, const EngineOptions& options, int frames) {
  // a named variable: clang 14 cannot capture a structured binding in a lambda
  const View& centre = bench.stereo->centre;
  const StereoPair& pair = bench.stereo->pair;
  const AnaglyphMasks masks{bench.passes[0].mask, bench.passes[1].mask};
  const StereoSettings both_settings{bench.settings};
  Rendering one;
  StereoRendering both;
  const PreparedScene prepared = prepare_scene(bench.scene, bench.settings.transfer);
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
  StereoCost cost{median(std::move(mono)), median(std::move(shared)), {}};
  if (views::check_second_eye(bench.scene, bench.settings, 1)) {
    Renderer renderer(bench.scene, bench.settings.transfer,
                      make_engine(options.engine, options.tile));
    const int threads = options.tile.threads > 0 ? options.tile.threads : default_threads();
    cost.warped = views::second_eye_error(renderer, centre, pair, bench.settings,
                                          {.threads = threads, .target = options.tile.target});
  }
  return cost;
}

}  // namespace glassbox::study
