#include <glassbox/render/staged/staged.h>

#include <algorithm>
#include <vector>

#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/show_plane.h>
#include <glassbox/render/engine/stopwatch.h>
#include <glassbox/render/staged/eyes.h>
#include <glassbox/render/staged/lines_points.h>
#include <glassbox/render/staged/reference.h>
#include <glassbox/render/staged/watch.h>

namespace glassbox {

namespace {

PixelRect picture_rect(const Image<Rgba8>& picture) {
  return {0, 0, picture.width, picture.height};
}

void count_input(const Draw& draw, Statistics& statistics) {
  ++statistics.instances;
  statistics.triangles += draw.triangulation->numbered;
  statistics.degenerate += draw.triangulation->numbered - draw.triangulation->triangles.size();
  statistics.lines += draw.mesh->lines.size();
  statistics.points += draw.mesh->points.size();
}

// ---- primitives ----

// The data of the stages for one draw and one eye, and the primitives that wait to be rasterised.
template <class Watch>
struct DrawStages {
  PrimitiveStage primitives;
  FragmentStage fragments;
  const Watch& watch;
  Statistics& statistics;
  std::vector<ReadyTriangle> triangles;
  std::vector<ReadyLine> lines;
  std::vector<ReadyPoint> points;
};

// Returns the test that culls triangles before clipping. With an observer there is none, because
// the observer is called for every triangle in all stages; the bytes are the same.
std::optional<ObjectCull> early_culling(const CountingWatch&, const Draw& draw,
                                        const EyePicture& eye) {
  return object_culling(draw, eye.view, eye.settings).test;
}
std::optional<ObjectCull> early_culling(const ObserverWatch&, const Draw&, const EyePicture&) {
  return std::nullopt;
}

template <class Watch>
DrawStages<Watch> make_stages(const Draw& draw, const EyePicture& eye, const Lighting& lighting,
                              const DrawTables& tables, const Watch& watch) {
  SamplePlanes& samples = eye.target.samples;
  return {.primitives = {.draw = draw,
                         .clip = &tables.clip,
                         .eye_space = tables.eye_space,
                         .view = eye.view,
                         .settings = eye.settings,
                         .lighting = lighting,
                         .planes = render_planes(eye.view),
                         .object_cull = early_culling(watch, draw, eye)},
          .fragments = {.draw = draw,
                        .channels = shaded_channels(draw, eye.settings),
                        .view = eye.view,
                        .settings = eye.settings,
                        .lighting = lighting,
                        .target = eye.target,
                        .color = eye.color,
                        .window = picture_rect(eye.color),
                        .samples = samples.empty() ? nullptr : &samples,
                        .behind_depth = eye.behind_depth},
          .watch = watch,
          .statistics = eye.statistics,
          .triangles = {},
          .lines = {},
          .points = {}};
}

template <class Watch, class Primitive>
void rasterise_all(const DrawStages<Watch>& stages, std::vector<Primitive>& primitives) {
  for (const Primitive& primitive : primitives) {
    rasterise(stages.fragments, stages.watch, primitive);
  }
  primitives.clear();
}

template <class Watch>
void rasterise_prepared(DrawStages<Watch>& stages) {
  const Stopwatch stopwatch(stages.statistics.fragment_ms);
  rasterise_all(stages, stages.triangles);
  rasterise_all(stages, stages.lines);
  rasterise_all(stages, stages.points);
}

template <class Watch>
void prepare_batch(DrawStages<Watch>& stages, std::span<const Triangle> batch) {
  const Stopwatch stopwatch(stages.statistics.triangle_ms);
  for (const Triangle& triangle : batch) {
    prepare_triangle(stages.primitives, stages.watch, triangle, stages.triangles, stages.lines);
  }
}

// Runs the stages after the vertex stage for the given triangles of the draw, in the order of the
// mesh, and for all its lines and points.
template <class Watch>
void draw_primitives(DrawStages<Watch>& stages, std::span<const Triangle> triangles,
                     const Mesh& mesh) {
  for (std::size_t at = 0; at < triangles.size(); at += kTriangleBatch) {
    prepare_batch(stages, triangles.subspan(at, std::min(kTriangleBatch, triangles.size() - at)));
    rasterise_prepared(stages);
  }
  for (std::uint32_t i = 0; i < mesh.lines.size(); ++i) {
    prepare_line(stages.primitives, stages.watch, i, stages.lines);
  }
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    prepare_point(stages.primitives, stages.watch, i, stages.points);
  }
  rasterise_prepared(stages);
}

// ---- the run ----

// Clears the framebuffer. If the run draws over an existing picture, the framebuffer has no colours
// of its own.
void clear(const EyePicture& eye) {
  const Stopwatch stopwatch(eye.statistics.prepare_ms);
  const Viewport& viewport = eye.view.viewport;
  eye.target = cleared_framebuffer(int(viewport.width()), int(viewport.height()), eye.settings,
                                   !eye.draws_over());
}

// Draws one eye's picture: one draw after the other through all stages. `Eye` is one of the classes
// of eyes.h.
template <class Watch, class Eye>
void draw_eye(const EyePicture& picture, Eye eye, const Lighting& lighting, const Watch& watch) {
  clear(picture);
  for (std::size_t i = 0; i < eye.draws().size(); ++i) {
    const Draw& draw = eye.draws()[i];
    count_input(draw, picture.statistics);
    watch.notify(&Observer::draw, draw);
    const DrawTables& tables = eye.vertices(i, picture, watch);
    DrawStages<Watch> stages = make_stages(draw, picture, lighting, tables, watch);
    draw_primitives(stages, eye.triangles(i), *draw.mesh);
  }
  resolve_samples(picture.settings, picture.target, picture.color);
  show_plane(picture.settings.show, picture.target);
}

// Chooses the type of `watch` once for the whole picture.
template <class Eye>
void draw_watched(const EyePicture& picture, const Eye& eye, const Lighting& lighting) {
  if (picture.observers.empty()) {
    draw_eye(picture, eye, lighting, CountingWatch(picture.statistics));
  } else {
    draw_eye(picture, eye, lighting, ObserverWatch(picture.statistics, picture.observers));
  }
}

PairCullCounts draw_pair(const PictureJob& job, const DrawList& list) {
  const EyePicture &left = job.eyes[0], &right = job.eyes[1];
  const std::vector<Draw> right_draws = draws_of_other_eye(list.draws, right.view);
  PairSharedData pair;
  if (job.culling != nullptr) {
    pair.culling.emplace(job.culling->how, job.culling->centre, list.draws, right_draws,
                         left.settings.wireframe);
  }
  draw_watched(left, FirstEyeOfPair(list.draws, pair), list.lighting);
  draw_watched(right, SecondEyeOfPair(right_draws, pair), list.lighting);
  const PairCullCounts left_out = pair.culling ? pair.culling->counts() : PairCullCounts{};
  for (const EyePicture& eye : job.eyes) eye.statistics.rejected += left_out.culled;
  return left_out;
}

}  // namespace

PairCullCounts StagedEngine::draw(const PictureJob& job) {
  for (const EyePicture& eye : job.eyes) eye.statistics = {};
  const EyePicture& first = job.eyes.front();
  DrawList list;
  {
    const Stopwatch stopwatch(first.statistics.prepare_ms);
    list = make_draw_list(job.scene, job.prepared, first.view);
  }
  if (job.eyes.size() > 1) return draw_pair(job, list);
  draw_watched(first, SingleEye(list.draws), list.lighting);
  return {};
}

Rendering render_staged(const Scene& scene, const View& view, const RenderSettings& settings,
                        const Observers& observers) {
  Rendering rendering;
  double prepare_ms = 0;
  PreparedScene prepared;
  {
    const Stopwatch stopwatch(prepare_ms);
    prepared = prepare_scene(scene, settings.transfer);
  }
  Framebuffer& buffers = rendering.buffers;
  const EyePicture eye{view, settings, buffers, buffers.color, rendering.statistics, observers};
  StagedEngine().draw({scene, prepared, {&eye, 1}});
  rendering.statistics.prepare_ms += prepare_ms;
  return rendering;
}

}  // namespace glassbox
