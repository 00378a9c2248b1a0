#include <glassbox/render/staged/staged.h>

#include <algorithm>
#include <vector>

#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/show.h>
#include <glassbox/render/engine/stopwatch.h>
#include <glassbox/render/staged/culling_list.h>
#include <glassbox/render/staged/lines_points.h>
#include <glassbox/render/staged/reference.h>
#include <glassbox/render/staged/watch.h>

namespace glassbox {

namespace {

template <class Watch>
struct EyeRun {
  const EyePicture& picture;
  const std::vector<Draw>& draws;
  const Watch& watch;
};

PixelRect whole(const Image<Rgba8>& picture) {
  return {0, 0, picture.width, picture.height};
}

void count_input(const Draw& draw, Statistics& statistics) {
  ++statistics.instances;
  statistics.triangles += draw.triangulation->numbered;
  statistics.degenerate += draw.triangulation->numbered - draw.triangulation->triangles.size();
  statistics.lines += draw.mesh->lines.size();
  statistics.points += draw.mesh->points.size();
}

// ---- vertices ----

// Transforms the vertices of one draw. Work done for all eyes at once is counted and timed with the
// first.
template <class Watch>
DrawTables transform_draw(std::size_t index, const std::vector<EyeRun<Watch>>& eyes) {
  const EyeRun<Watch>& first = eyes.front();
  Statistics& counts = first.picture.statistics;
  const Stopwatch stopwatch(counts.vertex_ms);
  DrawTables tables;
  for (const EyeRun<Watch>& eye : eyes) {
    const Draw& draw = eye.draws[index];
    const View& view = eye.picture.view;
    const bool is_first = &eye == &first;
    tables.clip.push_back(is_first ? project_vertices(draw, view, eye.watch)
                                   : project_other_eye(draw, view, tables.clip.front(), eye.watch));
    const std::size_t positions = tables.clip.back().positions.size();
    Statistics& own = eye.picture.statistics;
    (is_first ? own.vertices : own.moved_in_x) += positions;
    own.plane_tests += positions;
  }
  tables.eye_space = make_eye_space_tables(first.draws[index], first.picture.settings);
  counts.normals += tables.eye_space.normals.size() + tables.eye_space.face_normals.size();
  counts.eye_positions += tables.eye_space.positions.size();
  return tables;
}

// ---- primitives ----

// The stages of one draw for one eye, and the primitives between them.
template <class Watch>
struct EyeStages {
  PrimitiveStage primitives;
  FragmentStage fragments;
  const Watch& watch;
  Statistics& statistics;
  std::vector<ReadyTriangle> triangles;
  std::vector<ReadyLine> lines;
  std::vector<ReadyPoint> points;
};

// An observer is called for every triangle in all stages, so nothing is culled early for it; the
// bytes are the same.
std::optional<ObjectCull> early_culling(const Counting&, const Draw& draw, const EyePicture& eye) {
  return object_culling(draw, eye.view, eye.settings).test;
}
std::optional<ObjectCull> early_culling(const Observed&, const Draw&, const EyePicture&) {
  return std::nullopt;
}

template <class Watch>
EyeStages<Watch> make_stages(std::size_t index, const EyeRun<Watch>& eye, const ClipTable& clip,
                             const EyeSpaceTables& eye_space, const Lighting& lighting) {
  const Draw& draw = eye.draws[index];
  const EyePicture& picture = eye.picture;
  SamplePlanes& samples = picture.target.samples;
  return {.primitives = {.draw = draw,
                         .clip = &clip,
                         .eye_space = eye_space,
                         .view = picture.view,
                         .settings = picture.settings,
                         .lighting = lighting,
                         .planes = render_planes(picture.view),
                         .object_cull = early_culling(eye.watch, draw, picture)},
          .fragments = {.draw = draw,
                        .channels = shaded_channels(draw, picture.settings),
                        .view = picture.view,
                        .settings = picture.settings,
                        .lighting = lighting,
                        .target = picture.target,
                        .color = picture.color,
                        .window = whole(picture.color),
                        .samples = samples.empty() ? nullptr : &samples,
                        .behind = picture.behind},
          .watch = eye.watch,
          .statistics = picture.statistics,
          .triangles = {},
          .lines = {},
          .points = {}};
}

template <class Watch, class Primitive>
void rasterise_all(const EyeStages<Watch>& eye, std::vector<Primitive>& primitives) {
  for (const Primitive& primitive : primitives) rasterise(eye.fragments, eye.watch, primitive);
  primitives.clear();
}

template <class Watch>
void rasterise_ready(std::vector<EyeStages<Watch>>& eyes) {
  for (EyeStages<Watch>& eye : eyes) {
    const Stopwatch stopwatch(eye.statistics.fragment_ms);
    rasterise_all(eye, eye.triangles);
    rasterise_all(eye, eye.lines);
    rasterise_all(eye, eye.points);
  }
}

template <class Watch>
void ready_batch(std::vector<EyeStages<Watch>>& eyes, std::span<const Triangle> batch) {
  const Stopwatch stopwatch(eyes.front().statistics.triangle_ms);
  for (const Triangle& triangle : batch) {
    TriangleAttributes attributes;
    for (EyeStages<Watch>& eye : eyes) {
      ready_triangle(eye.primitives, eye.watch, triangle, attributes, eye.triangles, eye.lines);
    }
  }
}

// Runs the stages after the vertex stage for some of the draw's triangles, in the order of the
// mesh, and for all its lines and points.
template <class Watch>
void draw_primitives(std::vector<EyeStages<Watch>>& eyes, std::span<const Triangle> triangles,
                     const Mesh& mesh) {
  for (std::size_t at = 0; at < triangles.size(); at += kTriangleBatch) {
    ready_batch(eyes, triangles.subspan(at, std::min(kTriangleBatch, triangles.size() - at)));
    rasterise_ready(eyes);
  }
  for (EyeStages<Watch>& eye : eyes) {
    for (std::uint32_t i = 0; i < mesh.lines.size(); ++i) {
      ready_line(eye.primitives, eye.watch, i, eye.lines);
    }
    for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
      ready_point(eye.primitives, eye.watch, i, eye.points);
    }
  }
  rasterise_ready(eyes);
}

// ---- the run ----

// Clears the framebuffer. If a run draws over an existing picture, it has no colours of its own.
void clear(const EyePicture& eye) {
  const Viewport& viewport = eye.view.viewport;
  eye.target = cleared_framebuffer(int(viewport.width()), int(viewport.height()), eye.settings,
                                   !eye.draws_over());
}

template <class Watch>
NotSubmitted draw_watched(const PictureJob& job, const std::vector<Watch>& watches) {
  const EyePicture& first = job.eyes.front();
  DrawList list;
  std::vector<Draw> of_second;
  {
    const Stopwatch stopwatch(first.statistics.prepare_ms);
    list = make_draw_list(job.scene, job.prepared, first.view);
    if (job.eyes.size() > 1) {
      of_second = draws_of_other_eye(list.draws, job.eyes[1].view);
    }
    for (const EyePicture& eye : job.eyes) clear(eye);
  }
  std::vector<EyeRun<Watch>> eyes{{first, list.draws, watches.front()}};
  if (job.eyes.size() > 1) eyes.push_back({job.eyes[1], of_second, watches[1]});
  std::optional<CullingList> pair;
  if (job.culling != nullptr) {
    pair.emplace(job.culling->how, job.culling->centre, list.draws, first.settings.wireframe);
  }

  for (std::size_t i = 0; i < list.draws.size(); ++i) {
    for (const EyeRun<Watch>& eye : eyes) {
      count_input(eye.draws[i], eye.picture.statistics);
      eye.watch.draw(eye.draws[i]);
    }
    const DrawTables tables = transform_draw(i, eyes);
    std::vector<EyeStages<Watch>> stages;
    for (std::size_t k = 0; k < eyes.size(); ++k) {
      stages.push_back(make_stages(i, eyes[k], tables.clip[k], tables.eye_space, list.lighting));
    }
    draw_primitives(stages,
                    pair ? pair->triangles_of(i, tables)
                         : std::span<const Triangle>(list.draws[i].triangulation->triangles),
                    *list.draws[i].mesh);
  }

  const NotSubmitted left_out = pair ? pair->left_out() : NotSubmitted{};
  for (const EyePicture& eye : job.eyes) {
    eye.statistics.rejected += left_out.culled;
    resolve_samples(eye.settings, eye.target, eye.color);
    show(eye.settings.show, eye.target);
  }
  return left_out;
}

}  // namespace

NotSubmitted StagedEngine::draw(const PictureJob& job) {
  for (const EyePicture& eye : job.eyes) eye.statistics = {};
  if (std::ranges::none_of(job.eyes, &EyePicture::observer)) {
    std::vector<Counting> watches;
    for (const EyePicture& eye : job.eyes) watches.emplace_back(eye.statistics);
    return draw_watched(job, watches);
  }
  Observer nobody;
  std::vector<Observed> watches;
  for (const EyePicture& eye : job.eyes) {
    watches.emplace_back(eye.statistics, eye.observer != nullptr ? *eye.observer : nobody);
  }
  return draw_watched(job, watches);
}

Rendering render_staged(const Scene& scene, const View& view, const RenderSettings& settings,
                        Observer* observer) {
  Rendering rendering;
  double prepare_ms = 0;
  PreparedScene prepared;
  {
    const Stopwatch stopwatch(prepare_ms);
    prepared = prepare(scene, settings.transfer);
  }
  Framebuffer& buffers = rendering.buffers;
  const EyePicture eye{view, settings, buffers, buffers.color, rendering.statistics, observer};
  StagedEngine().draw({scene, prepared, {&eye, 1}});
  rendering.statistics.prepare_ms += prepare_ms;
  return rendering;
}

}  // namespace glassbox
