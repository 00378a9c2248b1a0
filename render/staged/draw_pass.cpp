#include <glassbox/render/staged/draw_pass.h>

#include <algorithm>
#include <array>

#include <glassbox/render/engine/stopwatch.h>
#include <glassbox/render/staged/fragments.h>
#include <glassbox/render/staged/primitives.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {

namespace {

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

PixelRect whole(const Image<Rgba8>& picture) {
  return {0, 0, picture.width, picture.height};
}

EyeStages make_stages(std::size_t index, const EyePass& eye, const ClipTable& clip,
                      const EyeSpaceTables& eye_space, const Lighting& lighting) {
  const Draw& draw = eye.draws[index];
  // Whoever watches sees every triangle in all stages; the bytes are the same.
  const bool watched = eye.observer != nullptr;
  return {{draw, &clip, eye_space, eye.view, eye.settings, lighting, render_planes(eye.view),
           eye.statistics, eye.observer,
           watched ? std::nullopt : object_culling(draw, eye.view, eye.settings).test},
          {draw, shaded_channels(draw, eye.settings), eye.view, eye.settings, lighting, eye.target,
           eye.color, whole(eye.color), eye.statistics, eye.observer,
           eye.target.samples.empty() ? nullptr : &eye.target.samples},
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

DrawTables transform_draw(std::size_t index, std::span<const EyePass> eyes) {
  for (const EyePass& eye : eyes) {
    count_input(eye.draws[index], eye.statistics);
    if (eye.observer != nullptr) eye.observer->draw(eye.draws[index]);
  }
  const EyePass& first = eyes.front();
  const Stopwatch watch(first.statistics.vertex_ms);
  DrawTables tables;
  tables.clip.push_back(project_vertices(first.draws[index], first.view, first.observer));
  first.statistics.vertices += tables.clip.front().positions.size();
  for (const EyePass& eye : eyes)
    eye.statistics.plane_tests += tables.clip.front().positions.size();
  for (const EyePass& other : eyes.subspan(1)) {
    tables.clip.push_back(
        project_other_eye(other.draws[index], other.view, tables.clip.front(), other.observer));
    other.statistics.moved_in_x += tables.clip.back().positions.size();
  }
  tables.eye_space = make_eye_space_tables(first.draws[index], first.settings);
  first.statistics.normals +=
      tables.eye_space.normals.size() + tables.eye_space.face_normals.size();
  first.statistics.eye_positions += tables.eye_space.positions.size();
  return tables;
}

void draw_primitives(std::size_t index, const DrawTables& tables,
                     std::span<const Triangle> triangles, const Lighting& lighting,
                     std::span<const EyePass> eyes) {
  std::vector<EyeStages> stages;
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    stages.push_back(make_stages(index, eyes[i], tables.clip[i], tables.eye_space, lighting));
  }
  for (std::size_t at = 0; at < triangles.size(); at += kTriangleBatch) {
    ready_batch(stages, triangles.subspan(at, std::min(kTriangleBatch, triangles.size() - at)));
    rasterise_ready(stages);
  }
  const Mesh& mesh = *eyes.front().draws[index].mesh;
  for (EyeStages& eye : stages) {
    for (const auto& line : mesh.lines) ready_line(eye.primitives, line, eye.lines);
    for (const Corner& point : mesh.points) ready_point(eye.primitives, point, eye.points);
  }
  rasterise_ready(stages);
}

}  // namespace glassbox
