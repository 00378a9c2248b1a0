#include <glassbox/render/draw_pass.h>

#include <algorithm>
#include <array>
#include <optional>

#include <glassbox/render/fragments.h>
#include <glassbox/render/primitives.h>
#include <glassbox/render/stopwatch.h>
#include <glassbox/render/vertex_stage.h>

namespace glassbox {

namespace {

// Triangles are carried through the stages in batches, so that each stage can be timed and memory stays small.
constexpr std::size_t kBatch = 1024;

void count_input(const Draw& draw, Statistics& statistics) {
  ++statistics.instances;
  statistics.triangles += draw.triangulation->numbered;
  statistics.degenerate += draw.triangulation->numbered - draw.triangulation->triangles.size();
  statistics.lines += draw.mesh->lines.size();
  statistics.points += draw.mesh->points.size();
}

// The stages of one eye after the vertices, and what is on its way between them.
struct EyeStages {
  PrimitiveStage primitives;
  FragmentStage fragments;
  std::vector<ReadyTriangle> triangles;
  std::vector<ReadyLine> lines;
  std::vector<ReadyPoint> points;
};

EyeStages make_stages(const EyePass& eye, std::size_t index, const std::vector<Point<Clip>>& clip,
                      const VertexTables& tables, const Lighting& lighting) {
  const Draw& draw = eye.draws[index];
  return {
      {draw, clip, tables, eye.view, eye.settings, lighting, render_planes(eye.view),
       eye.statistics, eye.observer},
      {draw, eye.view, eye.settings, lighting, eye.target, eye.color, eye.statistics, eye.observer},
      {},
      {},
      {}};
}

template <class Primitive>
void rasterise_all(const FragmentStage& stage, std::vector<Primitive>& primitives) {
  for (const Primitive& primitive : primitives) rasterise(stage, primitive);
  primitives.clear();
}

void rasterise_ready(std::span<EyeStages> eyes) {
  for (EyeStages& eye : eyes) {
    const Stopwatch watch(eye.fragments.statistics.fragment_ms);
    rasterise_all(eye.fragments, eye.triangles);
    rasterise_all(eye.fragments, eye.lines);
    rasterise_all(eye.fragments, eye.points);
  }
}

void ready_batch(std::span<EyeStages> eyes, std::span<const Triangle> batch) {
  const Stopwatch watch(eyes.front().primitives.statistics.triangle_ms);
  for (const Triangle& triangle : batch) {
    TriangleAttributes attributes;
    for (EyeStages& eye : eyes) {
      ready_triangle(eye.primitives, triangle, attributes, eye.triangles, eye.lines);
    }
  }
}

}  // namespace

void render_draw(std::size_t index, const Lighting& lighting, std::span<const EyePass> eyes) {
  const EyePass& first = eyes.front();
  const Draw& draw = first.draws[index];
  for (const EyePass& eye : eyes) {
    count_input(draw, eye.statistics);
    if (eye.observer != nullptr) eye.observer->draw(eye.draws[index]);
  }

  VertexTables tables;
  std::vector<Point<Clip>> other_clip;
  {
    const Stopwatch watch(first.statistics.vertex_ms);
    tables = transform_vertices(draw, first.settings, first.observer);
    first.statistics.vertices += tables.clip.size();
    if (eyes.size() > 1) {
      other_clip = transform_other_eye(eyes[1].draws[index], tables.clip, eyes[1].observer);
      eyes[1].statistics.moved_in_x += other_clip.size();
    }
  }
  std::vector<EyeStages> stages;
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    stages.push_back(
        make_stages(eyes[i], index, i == 0 ? tables.clip : other_clip, tables, lighting));
  }

  const std::span<const Triangle> all(draw.triangulation->triangles);
  for (std::size_t at = 0; at < all.size(); at += kBatch) {
    ready_batch(stages, all.subspan(at, std::min(kBatch, all.size() - at)));
    rasterise_ready(stages);
  }
  for (EyeStages& eye : stages) {
    for (const auto& line : draw.mesh->lines) ready_line(eye.primitives, line, eye.lines);
    for (const Corner& point : draw.mesh->points) ready_point(eye.primitives, point, eye.points);
  }
  rasterise_ready(stages);
}

}  // namespace glassbox
