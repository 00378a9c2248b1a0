// Corners become primitives ready to be rasterised: cull in object space, where that is asked for, clip, divide, viewport,
// snap, setup, cull; then, for those that are left, the attributes of their vertices.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glassbox/pipeline/clip.h>
#include <glassbox/raster/stages.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/object_cull.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/statistics.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {

struct ReadyTriangle {
  TriangleSetup setup;
  std::array<Varyings, 3> vertices;  // in the order of the setup
  std::uint32_t number = 0;          // in the whole scene
  std::uint32_t piece = 0;           // of the fan that clipping left of the triangle
};

struct ReadyLine {
  std::array<ScreenVertex, 2> ends;
  std::array<Varyings, 2> vertices;
  std::uint32_t id = 0;  // what Framebuffer::id gets
};

struct ReadyPoint {
  ScreenVertex position;
  Varyings vertex;
};

// The attributes of a triangle's corners, front and back, gathered when the first visible piece asks for them: lit once,
// however many eyes look at the triangle.
struct TriangleAttributes {
  std::optional<std::array<Varyings, 3>> front, back;
};

// What one draw's primitives need to be made ready for one eye.
struct PrimitiveStage {
  const Draw& draw;
  const ClipTable* clip;  // null: vertices are projected as triangles ask for them
  EyeSpace eye_space;
  const View& view;
  const RenderSettings& settings;
  const Lighting& lighting;
  std::array<ClipPlane, kMaxClipPlanes> planes;  // render_planes(view)
  Statistics& statistics;
  Observer* observer = nullptr;
  std::optional<ObjectCull> object_cull;  // of what no plane cuts; absent: nothing is culled early
};

// Appends what is left of a triangle of the mesh: nothing, itself, or the fan of its clipped polygon. With
// RenderSettings::wireframe its edges are appended to `lines` instead. `attributes` belongs to the triangle: empty before
// the first eye, the same for the next one.
void ready_triangle(const PrimitiveStage& stage, const Triangle& triangle,
                    TriangleAttributes& attributes, std::vector<ReadyTriangle>& triangles,
                    std::vector<ReadyLine>& lines);

void ready_line(const PrimitiveStage& stage, const std::array<Corner, 2>& line,
                std::vector<ReadyLine>& lines);

void ready_point(const PrimitiveStage& stage, const Corner& point, std::vector<ReadyPoint>& points);

}  // namespace glassbox
