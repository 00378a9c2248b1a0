// Culling before clipping, in object space (S4-01, S4-13): finds the triangles that certainly face
// the wrong way.
//
// Only the snapped area decides what a picture shows. So a triangle is removed here only if the
// test's value exceeds everything that could still change its sign: its own rounding error, the
// error of the viewer, and how far snapping and float move its corners on the screen (back_face.h
// has the proof). Triangles in doubt are kept. So are triangles that a plane cuts, because the
// pieces of a cut may be slivers, for which no margin of the whole triangle holds. The bytes are
// those of culling by the snapped area alone.
#pragma once

#include <array>
#include <optional>

#include <glassbox/pipeline/back_face.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/clusters.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox {

// The culling test for one draw and one eye.
struct ObjectCull {
  ObjectViewer viewer;
  bool removes_fronts = false;  // otherwise it removes back faces
  double value_per_px2 = 0;     // margin of the test's value per px^2 of area, where w is 1

  // A row of clip_from_object that the screen depends on, in double. The run's own coordinate of a
  // point p may differ from the exact one by error . (|p - anchor|, 1).
  struct Row {
    std::array<double, 4> exact{}, error{};
  };
  Row x, y, w;
  Vector<Object> anchor;
  double half_width_px = 0, half_height_px = 0;

  struct Evaluation {
    BackFaceTest test;
    // The margin that snapping and float need; infinite where it was not needed, and where no bound
    // is known.
    double margin = 0;
    bool removed = false;
  };
  // The triangle's three corners as modelled. A triangle that is removed has them in front of the
  // eye; the caller must check that no plane cuts it.
  Evaluation evaluate(const std::array<Point<Object>, 3>& triangle) const;

  bool removes(const std::array<Point<Object>, 3>& triangle) const {
    return evaluate(triangle).removed;
  }

  // Whether each triangle of a cluster can be removed, by the cone of their normals and the box.
  // Here too the caller must check that no plane cuts it.
  bool removes_all(const Cluster& cluster) const;
};

// The decision of --cull-stage object for a draw.
struct ObjectCulling {
  std::optional<ObjectCull> test;  // absent: nothing is removed early
  const char* because = "";        // why there is a test, or none
};
ObjectCulling object_culling(const Draw& draw, const View& view, const RenderSettings& settings);

// The same, independent of --cull-stage.
ObjectCulling certain_culling(const Draw& draw, const View& view, Cull cull);

}  // namespace glassbox
