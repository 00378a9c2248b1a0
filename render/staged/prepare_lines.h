// Computes vertices on the screen, and lines, points and the edges of triangles that are ready to
// be rasterised.
#pragma once

#include <vector>

#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/render/staged/corners.h>
#include <glassbox/render/staged/primitives.h>

namespace glassbox {

template <class Watch>
ScreenVertex screen_vertex_of(const PrimitiveStage& stage, const Watch& watch,
                              const ClipVertex& vertex) {
  NdcVertex ndc = divide(vertex);
  watch.notify(&Observer::divided, vertex, ndc);
  ScreenVertex screen = to_screen(ndc, stage.view.viewport);
  watch.notify(&Observer::mapped_to_screen, ndc, screen);
  return screen;
}

template <class Watch>
void prepare_segment(const PrimitiveStage& stage, const Watch& watch,
                     const std::array<ClipVertex, 2>& ends, const std::array<Varyings, 3>& corners,
                     std::uint32_t id, const FragmentSource& source,
                     std::vector<ReadyLine>& lines) {
  const std::optional<std::array<ClipVertex, 2>> kept = clip_segment(ends, stage.planes);
  if (!kept) return;
  const auto& [first, second] = *kept;
  const ScreenVertex begin = screen_vertex_of(stage, watch, first),
                     end = screen_vertex_of(stage, watch, second);
  lines.push_back({{begin, end},
                   {attributes_at(corners, first.weights), attributes_at(corners, second.weights)},
                   id,
                   source});
}

// Prepares the edges of a triangle, each clipped separately: the polygon that clipping leaves of
// the triangle also has edges along the clip planes, which are not edges of the triangle.
template <class Watch>
void prepare_edges(const PrimitiveStage& stage, const Watch& watch,
                   const std::array<ClipVertex, 3>& corners,
                   const std::array<Varyings, 3>& attributes, std::uint32_t number,
                   std::vector<ReadyLine>& lines) {
  for (std::size_t k = 0; k < 3; ++k) {
    prepare_segment(stage, watch, {corners[k], corners[(k + 1) % 3]}, attributes, number + 1,
                    {number, 0, false, LineKind::kEdge, std::uint8_t(k)}, lines);
  }
}

template <class Watch>
void prepare_line(const PrimitiveStage& stage, const Watch& watch, std::uint32_t number,
                  std::vector<ReadyLine>& lines) {
  const std::array<Corner, 2>& line = stage.draw.mesh->lines[number];
  std::array<ClipVertex, 2> ends;
  std::array<Varyings, 3> vertices;
  for (std::size_t k = 0; k < 2; ++k) {
    ends[k].position = clip_position(stage, line[k].position);
    ends[k].weights[k] = 1.0;
    vertices[k] = corner_attributes(stage, line[k]);
  }
  prepare_segment(stage, watch, ends, vertices, 0, {number, 0, false, LineKind::kLine}, lines);
}

template <class Watch>
void prepare_point(const PrimitiveStage& stage, const Watch& watch, std::uint32_t number,
                   std::vector<ReadyPoint>& points) {
  const Corner& point = stage.draw.mesh->points[number];
  ClipVertex vertex;
  vertex.position = clip_position(stage, point.position);
  if (!clip_point(vertex.position, stage.planes)) return;
  points.push_back({screen_vertex_of(stage, watch, vertex),
                    corner_attributes(stage, point),
                    {number, 0, false, LineKind::kPoint}});
}

}  // namespace glassbox
